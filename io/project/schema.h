#pragma once

#include <cstdint>
#include <span>

namespace SQLite {
class Database;
}

namespace knead {

/// A table of project files.
struct TableForm {
    const char* name;
    const char* sql; ///< that makes it
};

// What project files are made of. Any tool that reads SQLite shows names, numbers, materials and commands; see Row for checksums
// and Blobs for what is packed. Parts are for people only: what the program reads is the blob of the model.

constexpr std::int32_t applicationId = 0x4B6E6561; ///< "Knea"
constexpr int schemaVersion = 1;
/// Of files in which a start has parts of its own, deformed since they were opened: a program that does not know them would show others.
constexpr int versionWithModels = 2;

std::span<const TableForm> projectTables();
std::span<const TableForm> recoveryTables(); ///< which recovery files have besides

/// What entries are called in any language, as JSON of messages; the entries themselves have it in English. Files of this version
/// may be without it, and programs that do not know it need not: it came later.
constexpr TableForm entryWords{"entry_words", "CREATE TABLE IF NOT EXISTS entry_words (id INTEGER PRIMARY KEY, "
                                              "message TEXT, row_check INTEGER)"};

/// Per start the blob of the model that it was filled from; null: that of the project. Files of versions before may be without it.
constexpr TableForm startModels{"start_models", "CREATE TABLE IF NOT EXISTS start_models (id INTEGER PRIMARY KEY, "
                                                "model_blob INTEGER, row_check INTEGER)"};

/// Per start with a model of its own what made that of the parts of the project, as JSON, where a recipe can say it. Files may be
/// without it, and programs that do not know it need not: it came later.
constexpr TableForm startDeformations{"start_deformations",
                                      "CREATE TABLE IF NOT EXISTS start_deformations (id INTEGER PRIMARY KEY, "
                                      "deformations TEXT, row_check INTEGER)"};

void makeTables(SQLite::Database& database, std::span<const TableForm> tables);

/// Whether all of these tables are there and were made as makeTables() does.
bool hasTables(SQLite::Database& database, std::span<const TableForm> tables);

/// Brings a database of an older version to the present one. @throws DamagedData, SQLite::Exception
void migrate(SQLite::Database& database, int version);

} // namespace knead
