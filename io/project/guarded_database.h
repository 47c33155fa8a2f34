#pragma once

#include "core/task/task_control.h"

#include <cstdint>

namespace SQLite {
class Database;
}

namespace knead {

/// For a connection to the file of a stranger, before anything is asked of it: SQLite runs no views, triggers and functions that the
/// file brings along, and takes no statements, values and tables larger than projects have.
/// @param bytes of the file: no value in it is longer
void guardDatabase(SQLite::Database& database, std::uint64_t bytes);

/// For good: not even this program changes what a file says its tables are. Does nothing for a file that was cut off, which SQLite then
/// no longer reads.
void freezeSchema(SQLite::Database& database);

/// Whether a file holds what no Knead writes and what could run in this program: triggers, views, virtual tables.
/// @throws SQLite::Exception
bool holdsCode(SQLite::Database& database);

/// Lets a task end what SQLite does: a query goes on for some milliseconds after it was cancelled, then SQLite::Exception says that it
/// was interrupted.
/// @param control lives longer than the connection
void endQueriesWith(const TaskControl& control, SQLite::Database& database);

} // namespace knead
