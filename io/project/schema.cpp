#include "io/project/schema.h"

#include "io/project/rows.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <string>

namespace knead {

namespace {

constexpr TableForm tablesOfProjects[] = {
    {"contents", "CREATE TABLE contents (id INTEGER PRIMARY KEY, table_name TEXT, rows INTEGER, row_check INTEGER)"},
    {"project", "CREATE TABLE project (id INTEGER PRIMARY KEY, import TEXT, model_blob INTEGER, current_entry INTEGER, "
                "row_check INTEGER)"},
    {"parts",
     "CREATE TABLE parts (id INTEGER PRIMARY KEY, name TEXT, path TEXT, layer TEXT, volume_m3 REAL, area_m2 REAL, "
     "faces INTEGER, triangles INTEGER, row_check INTEGER)"},
    {"aggregates",
     "CREATE TABLE aggregates (id INTEGER PRIMARY KEY, objects INTEGER, connections INTEGER, spacing_m REAL, "
     "blob INTEGER, row_check INTEGER)"},
    {"tool_parts", "CREATE TABLE tool_parts (id INTEGER PRIMARY KEY, triangles INTEGER, place TEXT, mesh_blob INTEGER, "
                   "row_check INTEGER)"},
    {"starts", "CREATE TABLE starts (id INTEGER PRIMARY KEY, bodies INTEGER, first_body INTEGER, settings TEXT, "
               "row_check INTEGER)"},
    {"bodies", "CREATE TABLE bodies (id INTEGER PRIMARY KEY, start INTEGER, part INTEGER, name TEXT, material TEXT, "
               "state TEXT, aggregate INTEGER, row_check INTEGER)"},
    {"entries", "CREATE TABLE entries (id INTEGER PRIMARY KEY, parent INTEGER, start INTEGER, name TEXT, "
                "made_at_unix_s REAL, commands TEXT, step INTEGER, time_s REAL, state_hash INTEGER, is_key INTEGER, "
                "moment_bytes INTEGER, moment_blob INTEGER, row_check INTEGER)"},
    {"view", "CREATE TABLE view (id INTEGER PRIMARY KEY, camera TEXT, hidden_parts TEXT, thumbnail_png BLOB, "
             "row_check INTEGER)"},
    {"marks", "CREATE TABLE marks (id INTEGER PRIMARY KEY, entry INTEGER, words TEXT, row_check INTEGER)"},
    {"panels", "CREATE TABLE panels (id INTEGER PRIMARY KEY, name TEXT, json TEXT, row_check INTEGER)"},
    {"blobs",
     "CREATE TABLE blobs (id INTEGER PRIMARY KEY, piece INTEGER, pieces INTEGER, raw_bytes INTEGER, zstd BLOB, "
     "row_check INTEGER)"},
};

constexpr TableForm tablesOfRecoveries[] = {
    {"session",
     "CREATE TABLE session (id INTEGER PRIMARY KEY, project_file TEXT, is_saved INTEGER, gesture_rows INTEGER, "
     "file_stamp TEXT, row_check INTEGER)"},
    {"gesture", "CREATE TABLE gesture (id INTEGER PRIMARY KEY, step INTEGER, commands TEXT, row_check INTEGER)"},
};

/// Drafts of the format, version 0, had neither marks nor panels.
void addMarksAndPanels(SQLite::Database& database)
{
    for (const TableForm& table : tablesOfProjects) {
        const std::string name = table.name;
        if (name != "marks" && name != "panels")
            continue;
        database.exec(table.sql);
        const auto id = static_cast<std::int64_t>(&table - std::begin(tablesOfProjects));
        putRow(database, "contents", {id, name, std::int64_t{0}});
    }
}

} // namespace

std::span<const TableForm> projectTables()
{
    return tablesOfProjects;
}

std::span<const TableForm> recoveryTables()
{
    return tablesOfRecoveries;
}

void makeTables(SQLite::Database& database, std::span<const TableForm> tables)
{
    for (const TableForm& table : tables)
        database.exec(table.sql);
}

bool hasTables(SQLite::Database& database, std::span<const TableForm> tables)
{
    const auto isThere = [&](const TableForm& table) {
        SQLite::Statement statement(database, "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND sql = ?");
        statement.bind(1, std::string(table.sql));
        return statement.executeStep() && statement.getColumn(0).getInt() == 1;
    };
    return std::all_of(tables.begin(), tables.end(), isThere);
}

void migrate(SQLite::Database& database, int version)
{
    if (version < 1)
        addMarksAndPanels(database);
}

} // namespace knead
