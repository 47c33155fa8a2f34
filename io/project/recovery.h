#pragma once

#include "core/document/project.h"
#include "core/task/task_control.h"
#include "io/project/file_lock.h"
#include "io/project/project_tables.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace knead {

/// What else there is to say about work, besides its project.
struct WorkState {
    std::string projectFile;              ///< that it was opened from or saved to; empty: none yet
    bool isSaved = false;                 ///< nothing would be lost without the recovery
    std::vector<RecordedCommand> gesture; ///< given since the current entry
    std::uint64_t step = 0;               ///< that the simulation had reached then; 0 without a gesture
};

/// Work that a window which is gone did not save.
struct Recovery {
    std::string folder;      ///< where it is kept
    std::string projectFile; ///< as in WorkState
    double lastChange = 0;   ///< when the last entry was made [s since 1970]; 0: there is none, or it cannot be read
    std::uint32_t entries = 0;
};

struct RecoveredWork {
    Project project;
    WorkState state;
    std::vector<std::string> missing; ///< as in RescuedProject
};

/// Where recoveries are kept: a folder in $XDG_STATE_HOME, or in ~/.local/state.
std::string recoveryFolder();

/// All of those whose windows are gone, as their locks tell, the latest first; never one that a window is working on. Those with
/// nothing in them to lose are removed.
std::vector<Recovery> findRecoveries(const std::string& folder = recoveryFolder());

/// Removes one that the person does not want. @throws std::runtime_error, in a sentence, when a window works on it
void dropRecovery(const Recovery& recovery);

/// Keeps the work of a window while it goes on, in a database that survives a kill at any moment. It stays until discard(), so
/// that it survives a second crash too. One thread at a time; everything waits for the disk.
///
/// All that changes it throws std::runtime_error in a sentence when the disk refuses; then what was kept before stays as it was,
/// nothing more is kept (calls do nothing), and begin() starts anew.
class RecoveryFile {
public:
    /// Begins a new one.
    explicit RecoveryFile(const std::string& folder = recoveryFolder());
    /// Takes over what is left of a window that is gone. It stays as it is until begin().
    /// @throws std::runtime_error, in a sentence, when another window was quicker
    explicit RecoveryFile(const Recovery& recovery);
    /// Lets go of it as a crash would; see discard().
    ~RecoveryFile();
    RecoveryFile(const RecoveryFile&) = delete;
    RecoveryFile& operator=(const RecoveryFile&) = delete;

    /// What is kept; as much as can be rescued when it is damaged.
    /// @throws std::runtime_error, in a sentence; Cancelled
    RecoveredWork read(TaskControl& control = TaskControl::none());

    /// Keeps a whole project, in place of what was kept. @throws Cancelled; nothing has changed
    void begin(const Project& project, const WorkState& state, TaskControl& control = TaskControl::none());
    bool isGoingOn() const { return m_tables.has_value(); } ///< false before begin(), and after a failure

    // What changes, one transaction each.
    void append(const HistoryRecord& record); ///< the current entry from now on; the gesture has become it
    void replaceEntry(std::uint32_t entry, const HistoryRecord& record);
    void addStart(const ProjectStart& start);
    void setCurrent(std::uint32_t entry); ///< the gesture is forgotten
    void setView(const ProjectView& view);
    void setMarks(const std::vector<ProjectMark>& marks);
    void setPanels(const std::map<std::string, std::string>& panels);

    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds gestureInterval{5};

    /// Keeps a gesture while it goes on: those commands that are not kept yet, but no more often than each gestureInterval.
    /// @param commands all since the current entry @param step that the simulation has reached
    /// @return whether it was time
    bool keepGesture(std::span<const RecordedCommand> commands, std::uint64_t step,
                     Clock::time_point now = Clock::now());

    /// Goes up with each piece of work that is kept; a view is none.
    std::uint64_t revision() const { return m_revision; }
    /// The work is in a project file as it was at a revision, when saving began; what came since is not.
    void markSaved(const std::string& projectFile, std::uint64_t revision);

    /// Removes it: the work was saved, or the person does not want it.
    void discard();

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
    WorkState m_state; ///< without its gesture
    std::uint64_t m_revision = 0;
    std::size_t m_gestureKept = 0; ///< commands of it
    std::int64_t m_gestureRows = 0;
    std::optional<Clock::time_point> m_gestureAt;
};

} // namespace knead
