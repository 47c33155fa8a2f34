#include "io/project/recovery.h"

#include "core/message/message.h"
#include "io/files/safe_file.h"
#include "io/project/project_database.h"
#include "io/project/project_reader.h"
#include "io/project/recovery_files.h"
#include "io/project/schema.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace knead {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void failKeeping(const Message& reason)
{
    throw Problem(
        Message("Project", "The work cannot be kept for recovery (%1). Save the project, and make room in %2.")
            .with(reason, recoveryFolder()));
}

[[noreturn]] void failRescuing(const std::string& folder)
{
    throw Problem(
        Message(
            "Project",
            "Nothing of the work that was kept in %1 can be read any more. Discard it, and open what was saved last.")
            .with(folder));
}

/// A folder of its own that nobody sees under its final name before it is locked.
std::string newFolder(const std::string& parent, FileLock& lock)
{
    std::error_code error;
    fs::create_directories(parent, error);
    std::string name = (fs::path(parent) / "new-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        failKeeping(Message::verbatim(std::strerror(errno)));
    lock = FileLock(recovery_files::lock(name));
    const std::string ready = (fs::path(parent) / ("work-" + name.substr(name.size() - 6))).string();
    fs::rename(name, ready, error);
    if (error || !lock.isHeld()) {
        fs::remove_all(name, error);
        failKeeping(Message("Project", "its folder cannot be locked"));
    }
    for (const fs::path& folder : {fs::path(ready), fs::path(parent), fs::path(parent).parent_path()})
        syncFolder(folder.string());
    return ready;
}

void dropTables(SQLite::Database& database)
{
    for (const auto tables : {projectTables(), recoveryTables()})
        for (const TableForm& table : tables)
            database.exec(std::string("DROP TABLE IF EXISTS ") + table.name);
}

} // namespace

RecoveryFile::RecoveryFile(const std::string& folder)
    : m_folder(newFolder(folder, m_lock))
{
    try {
        m_database = recovery_files::open(m_folder);
    } catch (const SQLite::Exception& error) {
        recovery_files::remove(m_folder);
        failKeeping(Message::verbatim(error.what()));
    }
}

RecoveryFile::RecoveryFile(const Recovery& recovery)
    : m_lock(recovery_files::patientLock(recovery.folder))
    , m_folder(recovery.folder)
{
    if (!m_lock.isHeld())
        throw Problem(
            Message("Project", "Another window works on this already, or it was discarded: look for it there."));
    try {
        m_database = recovery_files::open(m_folder);
    } catch (const SQLite::Exception&) {
        failRescuing(m_folder);
    }
}

RecoveryFile::~RecoveryFile() = default;

RecoveredWork RecoveryFile::read(TaskControl& control)
{
    const std::uint64_t bytes = recovery_files::size(m_folder);
    for (const bool rescues : {false, true})
        try {
            ProjectReader reader(*m_database, {.rescues = rescues, .bytes = bytes}, control);
            RecoveredWork work;
            work.project = reader.read();
            const auto read = [&](const std::string& json) { return reader.commands(json, "gesture"); };
            reader.attempt(Message("Project", "what was done last"), [&] { work.state = readState(read); });
            work.missing = reader.missing();
            return work;
        } catch (const DamagedData&) {
        } catch (const SQLite::Exception&) {
        }
    failRescuing(m_folder);
}

WorkState RecoveryFile::readState(const std::function<std::vector<RecordedCommand>(const std::string&)>& commands)
{
    const Row session = rowAt(*m_database, "session", 0);
    WorkState state{.projectFile = session.text(1), .isSaved = session.integer(2) != 0};
    const std::string stamp = recovery_files::stampOf(state.projectFile);
    state.isFileReplaced = !stamp.empty() && stamp != session.text(4);
    for (std::int64_t id = 0; id < session.integer(3); ++id) {
        const Row row = rowAt(*m_database, "gesture", id);
        for (RecordedCommand& command : commands(row.text(2)))
            state.gesture.push_back(std::move(command));
        state.step = static_cast<std::uint64_t>(row.integer(1));
    }
    return state;
}

void RecoveryFile::inTransaction(const std::function<void()>& change)
{
    try {
        m_database->exec("BEGIN");
        change();
        m_database->exec("COMMIT");
    } catch (const SQLite::Exception& error) {
        const std::string reason = reasonOf(*m_database, error);
        giveUp();
        failKeeping(Message::verbatim(reason));
    } catch (...) {
        giveUp();
        throw;
    }
}

void RecoveryFile::giveUp()
{
    m_database->tryExec("ROLLBACK"); // which may have happened
    m_tables.reset();
}

void RecoveryFile::begin(const Project& project, const WorkState& state, TaskControl& control)
{
    inTransaction([&] {
        dropTables(*m_database);
        makeTables(*m_database, projectTables());
        makeTables(*m_database, recoveryTables());
        m_tables.emplace(*m_database).addProject(project, control);
        m_state = state;
        m_fileStamp = recovery_files::stampOf(state.projectFile);
        forgetGesture();
        if (!state.gesture.empty() || state.step > 0)
            putGesture(state.gesture, state.step);
        m_state.gesture.clear();
    });
    recovery_files::settle(*m_database);
}

void RecoveryFile::change(const std::function<void(ProjectTables&)>& change, bool isWork)
{
    if (!m_tables)
        return;
    inTransaction([&] {
        change(*m_tables);
        m_tables->finish();
        m_state.isSaved = m_state.isSaved && !isWork;
        m_revision += isWork ? 1 : 0;
        putSession();
    });
}

void RecoveryFile::putSession()
{
    putRow(*m_database, "session",
           {std::int64_t{0}, m_state.projectFile, std::int64_t{m_state.isSaved}, m_gestureRows, m_fileStamp});
}

void RecoveryFile::forgetGesture()
{
    m_database->exec("DELETE FROM gesture");
    m_gestureKept = 0;
    m_gestureRows = 0;
    putSession();
}

void RecoveryFile::putGesture(std::span<const RecordedCommand> commands, std::uint64_t step)
{
    const std::string text = m_tables->commandText(commands.subspan(m_gestureKept));
    putRow(*m_database, "gesture", {m_gestureRows++, static_cast<std::int64_t>(step), text});
    m_gestureKept = commands.size();
    m_tables->finish();
    putSession();
}

void RecoveryFile::append(const HistoryRecord& record)
{
    change([&](ProjectTables& tables) {
        tables.addEntries(std::span(&record, 1), TaskControl::none());
        tables.setCurrent(tables.entries() - 1);
        forgetGesture();
    });
}

void RecoveryFile::replaceEntry(std::uint32_t entry, const HistoryRecord& record)
{
    change([&](ProjectTables& tables) { tables.replaceEntry(entry, record); });
}

void RecoveryFile::replaceMoment(std::uint32_t entry, const HistoryRecord& record)
{
    change([&](ProjectTables& tables) { tables.replaceEntry(entry, record); }, false);
}

void RecoveryFile::addStart(const ProjectStart& start)
{
    change([&](ProjectTables& tables) { tables.addStart(start); });
}

void RecoveryFile::setCurrent(std::uint32_t entry)
{
    const auto set = [&](ProjectTables& tables) {
        tables.setCurrent(entry);
        forgetGesture();
    };
    change(set, false);
}

void RecoveryFile::setView(const ProjectView& view)
{
    change([&](ProjectTables& tables) { tables.setView(view); }, false);
}

void RecoveryFile::setMarks(const std::vector<ProjectMark>& marks)
{
    change([&](ProjectTables& tables) { tables.setMarks(marks); });
}

void RecoveryFile::setPanels(const std::map<std::string, std::string>& panels)
{
    change([&](ProjectTables& tables) { tables.setPanels(panels); }, false);
}

void RecoveryFile::keepGesture(std::span<const RecordedCommand> commands, std::uint64_t step)
{
    change([&](ProjectTables&) {
        if (commands.size() < m_gestureKept) // another gesture
            forgetGesture();
        putGesture(commands, step);
    });
}

void RecoveryFile::markSaved(const std::string& projectFile, std::uint64_t revision)
{
    const auto mark = [&](ProjectTables&) {
        m_state.projectFile = projectFile;
        m_fileStamp = recovery_files::stampOf(projectFile);
        m_state.isSaved = revision == m_revision;
    };
    change(mark, false);
}

void RecoveryFile::discard()
{
    m_tables.reset();
    m_database.reset();
    recovery_files::remove(m_folder);
}

} // namespace knead
