#include "io/project/project_file.h"

#include "core/message/message.h"
#include "io/files/safe_file.h"
#include "io/formats/cad_format.h"
#include "io/project/project_database.h"
#include "io/project/project_reader.h"
#include "io/project/project_tables.h"
#include "io/project/schema.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include <sys/stat.h>
#include <unistd.h>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr double writingShare = 0.9; // of the progress of saving; the rest is reading back

[[noreturn]] void failDamaged(const std::string& path, const Message& what)
{
    throw DamagedProject(Message("Project", "%1: the project is damaged: %2. What is whole can be rescued.")
                             .with(shortName(path), what));
}

/// Root may write everywhere, but a person who marked a file as read-only meant it.
void checkMayBeReplaced(const std::string& path)
{
    struct stat status {};
    if (stat(path.c_str(), &status) != 0)
        return;
    if (S_ISDIR(status.st_mode))
        failReading(path, Message("Project", "there is a folder of this name; choose another name."));
    if ((status.st_mode & 0222U) == 0 || access(path.c_str(), W_OK) != 0)
        failReading(path, Message("Project", "the file is read-only; save the project under another name."));
}

/// Where a link leads, so that the file behind it is replaced and not the link.
std::string followed(const std::string& path)
{
    std::error_code error;
    if (!fs::is_symlink(path, error))
        return path;
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? path : target.string();
}

/// What fails is not rolled back: nobody will look at the database, and the reason would be lost.
void fill(SQLite::Database& database, const Project& project, TaskControl& control)
{
    prepareProjectDatabase(database);
    database.exec("BEGIN");
    makeTables(database, projectTables());
    ProjectTables(database).addProject(project, control);
    database.exec("COMMIT");
}

/// @param choices all but the size of the file
Project readFrom(OpenProject& file, ReadingChoices choices, TaskControl& control)
{
    std::unique_ptr<SQLite::Database> copy;
    if (file.version < schemaVersion)
        copy = migratedCopy(file, control);
    SQLite::Database& database = copy != nullptr ? *copy : *file.database;
    if (!hasTables(database, projectTables()))
        throw DamagedData(Message("Project", "its tables are not those of a project"));
    choices.bytes = file.bytes;
    return ProjectReader(database, choices, control).read();
}

Project readWhole(const std::string& path, const ReadingChoices& choices, TaskControl& control)
{
    try {
        OpenProject file = openProject(path, control);
        if (file.version > versionWithModels)
            failReading(path, Message("Project", "a newer Knead saved this project (version %1 of the file; this "
                                                 "program reads up to %2). Update Knead to open it.")
                                  .with(file.version, versionWithModels));
        return readFrom(file, choices, control);
    } catch (const SQLite::Exception& error) {
        control.throwIfCancelled(); // then it was interrupted
        failDamaged(path, messageOf(error));
    } catch (const DamagedData& error) {
        failDamaged(path, messageOf(error));
    }
}

void readBack(const SafeFile& file, TaskControl& control)
{
    try {
        readWhole(file.pathForNow(), {.withMoments = false}, control);
    } catch (const Cancelled&) {
        throw;
    } catch (const std::runtime_error& error) {
        file.fail(Message("Project", "what was written cannot be read back: %1").with(messageOf(error)));
    }
}

} // namespace

void writeProject(const std::string& path, const Project& project, TaskControl& control)
{
    const std::string target = followed(path);
    checkMayBeReplaced(target);
    removeLeftOvers(target);
    SafeFile file(target);
    TaskPortion writing(control, 0, writingShare);
    SQLite::Database database(file.pathForNow(), SQLite::OPEN_READWRITE, 0, "unix-none");
    try {
        fill(database, project, writing);
    } catch (const SQLite::Exception& error) {
        file.fail(Message::verbatim(reasonOf(database, error)));
    }
    TaskPortion checking(control, writingShare, 1);
    readBack(file, checking);
    file.finish();
    control.throwIfCancelled();
    file.keep();
}

bool isProjectFile(const std::string& path)
{
    constexpr std::string_view mark("SQLite format 3\0", 16);
    std::error_code error;
    std::array<char, mark.size()> start{};
    std::ifstream file;
    if (fs::is_regular_file(path, error))
        file.open(path, std::ios::binary);
    return file.read(start.data(), start.size()) && std::string_view(start.data(), start.size()) == mark;
}

Project readProject(const std::string& path, TaskControl& control)
{
    return readWhole(path, {}, control);
}

namespace {

[[noreturn]] void failWithNothing(const std::string& path)
{
    failReading(
        path,
        Message("Project",
                "nothing of this project can be read any more; open a copy of it, or the part that it was made from."));
}

} // namespace

RescuedProject rescueProject(const std::string& path, TaskControl& control)
{
    try {
        OpenProject file = openProject(path, control);
        std::unique_ptr<SQLite::Database> copy;
        if (file.version >= 0 && file.version < schemaVersion)
            copy = migratedCopy(file, control);
        ProjectReader reader(copy != nullptr ? *copy : *file.database, {.rescues = true, .bytes = file.bytes}, control);
        RescuedProject rescued;
        rescued.project = reader.read();
        rescued.missing = reader.missing();
        if (rescued.project.model == nullptr && rescued.project.starts.empty() && !rescued.missing.empty())
            failWithNothing(path);
        return rescued;
    } catch (const DamagedData&) {
        failWithNothing(path);
    } catch (const SQLite::Exception&) {
        control.throwIfCancelled();
        failWithNothing(path);
    }
}

} // namespace knead
