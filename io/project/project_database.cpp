#include "io/project/project_database.h"

#include "core/message/message.h"
#include "io/formats/cad_format.h"
#include "io/project/guarded_database.h"
#include "io/project/schema.h"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace knead {

namespace fs = std::filesystem;

namespace {

/// A path as SQLite takes it in addresses.
std::string addressOf(const std::string& path)
{
    std::string address = "file:";
    for (const char c : fs::absolute(path).string())
        if (c == '%' || c == '?' || c == '#') {
            constexpr std::string_view digits = "0123456789abcdef";
            const auto code = static_cast<unsigned char>(c);
            address += {'%', digits[code >> 4U], digits[code & 15U]};
        } else
            address += c;
    return address + "?immutable=1"; // it is only ever replaced as a whole
}

void checkIsDatabase(const std::string& path)
{
    std::error_code error;
    if (!fs::exists(path, error))
        failReading(path, Message("Project", "there is no such file."));
    if (fs::is_directory(path, error))
        failReading(path, Message("Project", "this is a folder, not a project."));
    if (!fs::is_regular_file(path, error))
        failReading(path, Message("Project", "this is no file, and no project either."));
    std::ifstream file(path, std::ios::binary);
    std::array<char, 16> start{};
    file.read(start.data(), start.size());
    if (!file.good() && !file.eof())
        failReading(path, Message("Project", "the file cannot be read; check its permissions."));
    if (file.gcount() == 0)
        failReading(path, Message("Project", "the file is empty."));
    if (std::string_view(start.data(), start.size()) != std::string_view("SQLite format 3\0", 16))
        failReading(path, Message("Project", "this is not a Knead project."));
}

} // namespace

OpenProject openProject(const std::string& path, const TaskControl& control)
{
    checkIsDatabase(path);
    OpenProject project;
    project.bytes = fs::file_size(path);
    project.database = std::make_unique<SQLite::Database>(addressOf(path), SQLite::OPEN_READONLY | SQLite::OPEN_URI);
    SQLite::Database& database = *project.database;
    endQueriesWith(control, database);
    guardDatabase(database, project.bytes);
    database.exec("PRAGMA cell_size_check = ON; PRAGMA writable_schema = ON"); // looks at tables of a cut-off file, too
    if (holdsCode(database))
        failReading(path, Message("Project", "the file holds triggers, views or virtual tables, which no Knead writes: "
                                             "somebody else put them there. Nothing of it was opened."));
    freezeSchema(database);
    if (database.execAndGet("PRAGMA application_id").getInt() != applicationId && !hasTables(database, projectTables()))
        failReading(path, Message("Project", "this is a database of another program, not a Knead project."));
    project.version = database.execAndGet("PRAGMA user_version").getInt();
    return project;
}

std::unique_ptr<SQLite::Database> migratedCopy(OpenProject& project, const TaskControl& control)
{
    auto copy = std::make_unique<SQLite::Database>("", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    endQueriesWith(control, *copy);
    guardDatabase(*copy, project.bytes);
    freezeSchema(*copy);
    SQLite::Backup(*copy, *project.database).executeStep(-1);
    SQLite::Transaction transaction(*copy);
    migrate(*copy, project.version);
    transaction.commit();
    return copy;
}

void prepareProjectDatabase(SQLite::Database& database)
{
    database.exec("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; "
                  "PRAGMA locking_mode = EXCLUSIVE; PRAGMA application_id = " +
                  std::to_string(applicationId) + "; PRAGMA user_version = " + std::to_string(schemaVersion));
}

std::string reasonOf(const SQLite::Database& database, const SQLite::Exception& error)
{
    const int number = sqlite3_system_errno(database.getHandle());
    if (error.getErrorCode() == SQLITE_FULL)
        return std::strerror(ENOSPC);
    return error.getErrorCode() == SQLITE_IOERR && number != 0 ? std::strerror(number) : error.getErrorStr();
}

} // namespace knead
