#pragma once

#include "core/document/kept_work.h"
#include "core/task/task_control.h"
#include "io/project/file_lock.h"
#include "io/project/project_tables.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace knead {

/// Where recoveries are kept: a folder in $XDG_STATE_HOME, or in ~/.local/state.
std::string recoveryFolder();

/// All of those whose windows are gone, as their locks tell, the latest first; never one that a window is working on. Those with
/// nothing in them to lose are removed.
std::vector<Recovery> findRecoveries(const std::string& folder = recoveryFolder());

/// Removes one that the person does not want. @throws Problem, when a window works on it
void dropRecovery(const Recovery& recovery);

/// Keeps work in a database that survives a kill at any moment, and so a second crash too.
class RecoveryFile final : public KeptWork {
public:
    /// Begins a new one.
    explicit RecoveryFile(const std::string& folder = recoveryFolder());
    /// Takes over what is left of a window that is gone. It stays as it is until begin().
    /// @throws Problem, when another window was quicker
    explicit RecoveryFile(const Recovery& recovery);
    ~RecoveryFile() override;
    RecoveryFile(const RecoveryFile&) = delete;
    RecoveryFile& operator=(const RecoveryFile&) = delete;

    RecoveredWork read(TaskControl& control = TaskControl::none()) override;
    void begin(const Project& project, const WorkState& state, TaskControl& control = TaskControl::none()) override;
    bool isGoingOn() const override { return m_tables.has_value(); }
    void append(const HistoryRecord& record) override;
    void replaceEntry(std::uint32_t entry, const HistoryRecord& record) override;
    void replaceMoment(std::uint32_t entry, const HistoryRecord& record) override;
    void addStart(const ProjectStart& start) override;
    void setCurrent(std::uint32_t entry) override;
    void setView(const ProjectView& view) override;
    void setMarks(const std::vector<ProjectMark>& marks) override;
    void setPanels(const std::map<std::string, std::string>& panels) override;
    void keepGesture(std::span<const RecordedCommand> commands, std::uint64_t step) override;
    std::uint64_t revision() const override { return m_revision; }
    void markSaved(const std::string& projectFile, std::uint64_t revision) override;
    void discard() override;

private:
    void inTransaction(const std::function<void()>& change);
    void change(const std::function<void(ProjectTables&)>& change, bool isWork = true);
    void giveUp();
    void putSession();
    void forgetGesture();
    void putGesture(std::span<const RecordedCommand> commands, std::uint64_t step);
    WorkState readState(const std::function<std::vector<RecordedCommand>(const std::string&)>& commands);

    FileLock m_lock; ///< of the folder
    std::string m_folder;
    std::unique_ptr<SQLite::Database> m_database;
    std::optional<ProjectTables> m_tables;
    WorkState m_state;       ///< without its gesture
    std::string m_fileStamp; ///< of the project file, when it was opened or saved last
    std::uint64_t m_revision = 0;
    std::size_t m_gestureKept = 0; ///< commands of it
    std::int64_t m_gestureRows = 0;
};

} // namespace knead
