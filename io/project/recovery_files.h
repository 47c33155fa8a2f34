#pragma once

#include "io/project/file_lock.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

namespace SQLite {
class Database;
}

/// The files of one recovery, in a folder of its own.
namespace knead::recovery_files {

std::string lock(const std::string& folder);
std::string database(const std::string& folder);

/// The lock of a folder that is there. Waits while others have it: whoever only looks what could be recovered holds it for
/// milliseconds, too.
FileLock patientLock(const std::string& folder, std::chrono::milliseconds patience = std::chrono::milliseconds(500));

/// Makes it when it is not there. What was committed before a kill is there, and nothing else.
/// @throws SQLite::Exception
std::unique_ptr<SQLite::Database> open(const std::string& folder);

/// Moves what lies beside the database into it. What stands in the way does no harm.
void settle(SQLite::Database& database);

std::uint64_t size(const std::string& folder); ///< [bytes]

/// What tells whether a file has been written since; empty when it is not there.
std::string stampOf(const std::string& path);

/// The lock last, so that what a kill leaves over is found and removed.
void remove(const std::string& folder);

} // namespace knead::recovery_files
