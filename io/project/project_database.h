#pragma once

#include "core/task/task_control.h"

#include <cstdint>
#include <memory>
#include <string>

namespace SQLite {
class Database;
class Exception;
} // namespace SQLite

namespace knead {

/// A project file opened to read; no other program is disturbed by it, and nothing beside the file is read or made.
struct OpenProject {
    std::unique_ptr<SQLite::Database> database;
    int version = 0;
    std::uint64_t bytes = 0;
};

/// The file may be of a stranger: what it holds besides rows is not run, see guarded_database.h.
/// @param control ends what SQLite does; lives longer than the result
/// @throws Problem, when it is no file or no project, holds more than projects do, or cannot be read; SQLite::Exception
OpenProject openProject(const std::string& path, const TaskControl& control);

/// A copy that is gone with its connection, brought to the present version, guarded as the file is.
/// @throws SQLite::Exception, DamagedData
std::unique_ptr<SQLite::Database> migratedCopy(OpenProject& project, const TaskControl& control);

/// For a new database that is filled by one writer and then used by nobody under this name: no journal, no locks, no waiting
/// for the disk. @throws SQLite::Exception
void prepareProjectDatabase(SQLite::Database& database);

/// What the system or SQLite says about the last failure, in a few words.
std::string reasonOf(const SQLite::Database& database, const SQLite::Exception& error);

} // namespace knead
