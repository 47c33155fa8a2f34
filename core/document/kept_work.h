#pragma once

#include "core/document/project.h"
#include "core/message/message.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace knead {

/// What else there is to say about work, besides its project.
struct WorkState {
    std::string projectFile;              ///< that it was opened from or saved to; empty: none yet
    bool isFileReplaced = false;          ///< read(): somebody has written that file since
    bool isSaved = false;                 ///< nothing would be lost without the recovery
    std::vector<RecordedCommand> gesture; ///< given since the current entry
    std::uint64_t step = 0;               ///< that the simulation had reached then; 0 without a gesture
};

/// Work that a window which is gone did not save.
struct Recovery {
    std::string folder;      ///< where it is kept
    std::string projectFile; ///< as in WorkState
    std::string part;        ///< name of the first one; empty: it cannot be read
    double lastChange = 0;   ///< when the last entry was made [s since 1970]; 0: there is none, or it cannot be read
    std::uint32_t entries = 0;
};

struct RecoveredWork {
    Project project;
    WorkState state;
    std::vector<Message> missing; ///< as in RescuedProject
};

/// Keeps the work of a window while it goes on, so that it survives the window. It stays until discard(). One thread at a time;
/// everything waits for the disk.
///
/// All that changes it throws std::runtime_error in a sentence when the disk refuses; then what was kept before stays as it was,
/// nothing more is kept (calls do nothing), and begin() starts anew.
class KeptWork {
public:
    /// Lets go of it as a crash would; see discard().
    virtual ~KeptWork() = default;

    /// What is kept; as much as can be rescued when it is damaged.
    /// @throws std::runtime_error, in a sentence; Cancelled
    virtual RecoveredWork read(TaskControl& control) = 0;

    /// Keeps a whole project, in place of what was kept. @throws Cancelled; nothing has changed
    virtual void begin(const Project& project, const WorkState& state, TaskControl& control) = 0;
    virtual bool isGoingOn() const = 0; ///< false before begin(), and after a failure

    // What changes, one transaction each.
    virtual void append(const HistoryRecord& record) = 0; ///< the current entry from now on; the gesture has become it
    virtual void replaceEntry(std::uint32_t entry, const HistoryRecord& record) = 0;  ///< another name or mark
    virtual void replaceMoment(std::uint32_t entry, const HistoryRecord& record) = 0; ///< its only change, and no work
    virtual void addStart(const ProjectStart& start) = 0;
    virtual void setCurrent(std::uint32_t entry) = 0; ///< the gesture is forgotten
    virtual void setView(const ProjectView& view) = 0;
    virtual void setMarks(const std::vector<ProjectMark>& marks) = 0;
    virtual void setPanels(const std::map<std::string, std::string>& panels) = 0;

    /// Keeps a gesture while it goes on: those commands that are not kept yet.
    /// @param commands all since the current entry @param step that the simulation has reached
    virtual void keepGesture(std::span<const RecordedCommand> commands, std::uint64_t step) = 0;

    /// Goes up with each piece of work that is kept; a view or a moment is none.
    virtual std::uint64_t revision() const = 0;
    /// The work is in a project file as it was at a revision, when saving began; what came since is not.
    virtual void markSaved(const std::string& projectFile, std::uint64_t revision) = 0;

    /// Removes it: the work was saved, or the person does not want it.
    virtual void discard() = 0;

protected:
    KeptWork() = default;
    KeptWork(const KeptWork&) = default;
    KeptWork& operator=(const KeptWork&) = default;
};

} // namespace knead
