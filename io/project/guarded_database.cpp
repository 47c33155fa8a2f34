#include "io/project/guarded_database.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <algorithm>
#include <limits>

namespace knead {

namespace {

struct GuardSetting {
    int name;
    int value;
};

constexpr GuardSetting guardSettings[] = {
    {SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
    {SQLITE_DBCONFIG_ENABLE_TRIGGER, 0},
    {SQLITE_DBCONFIG_ENABLE_VIEW, 0},
    {SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0},
};

/// The longest statement of a project is that which makes the table of entries, 330 letters; it has 13 columns.
constexpr GuardSetting guardLimits[] = {
    {SQLITE_LIMIT_SQL_LENGTH, 20'000},  {SQLITE_LIMIT_COLUMN, 100},       {SQLITE_LIMIT_EXPR_DEPTH, 30},
    {SQLITE_LIMIT_COMPOUND_SELECT, 5},  {SQLITE_LIMIT_VDBE_OP, 20'000},   {SQLITE_LIMIT_FUNCTION_ARG, 8},
    {SQLITE_LIMIT_ATTACHED, 0},         {SQLITE_LIMIT_TRIGGER_DEPTH, 1},  {SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 100},
    {SQLITE_LIMIT_VARIABLE_NUMBER, 50}, {SQLITE_LIMIT_WORKER_THREADS, 0},
};

constexpr std::uint64_t leastLength = 1U << 20U; ///< of the longest value [bytes]
constexpr int stepsBetweenLooks = 10'000;        ///< of SQLite's machine, some ten million of which it does a second

int wasCancelled(void* control)
{
    return static_cast<const TaskControl*>(control)->isCancelled() ? 1 : 0;
}

} // namespace

void guardDatabase(SQLite::Database& database, std::uint64_t bytes)
{
    sqlite3* handle = database.getHandle();
    for (const GuardSetting& setting : guardSettings)
        sqlite3_db_config(handle, setting.name, setting.value, nullptr);
    for (const GuardSetting& most : guardLimits)
        sqlite3_limit(handle, most.name, most.value);
    constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<int>::max());
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, static_cast<int>(std::min(most, std::max(bytes, leastLength))));
}

void freezeSchema(SQLite::Database& database)
{
    sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    try {
        database.execAndGet("SELECT count(*) FROM sqlite_schema");
    } catch (const SQLite::Exception&) {
        sqlite3_db_config(database.getHandle(), SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
    }
}

bool holdsCode(SQLite::Database& database)
{
    SQLite::Statement statement(database, "SELECT count(*) FROM sqlite_schema WHERE type IN ('trigger', 'view') OR "
                                          "sql LIKE 'create virtual%'");
    return statement.executeStep() && statement.getColumn(0).getInt() > 0;
}

void endQueriesWith(const TaskControl& control, SQLite::Database& database)
{
    sqlite3_progress_handler(database.getHandle(), stepsBetweenLooks, wasCancelled, const_cast<TaskControl*>(&control));
}

} // namespace knead
