#pragma once

#include "core/document/history.h"
#include "core/document/project.h"
#include "core/message/message.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace knead {

/// What repeating the commands that lead to an entry of a history came to.
struct RepeatedEntry {
    /// Everything at the entry, see momentHash(), beside the moment that is kept.
    enum class Whole : std::uint8_t { notKept, same, different };

    std::uint32_t entry = 0;
    std::uint64_t step = 0; ///< that was reached
    std::uint64_t hash = 0; ///< of positions and velocities there
    bool isSame = false;    ///< as all that is kept: step, hash, and the moment unless it was thinned out
    Whole whole = Whole::notKept;
    Message trouble; ///< why the entry was not reached, in a sentence; empty when it was
};

/// Proves the history of a project: repeats its commands from the scenes they began with, and compares: all of a moment where
/// it is kept, else positions and velocities. What entries have in common is repeated once. One thread at a time, which takes
/// as long as the steps took.
class HistoryReplay {
public:
    enum class From : std::uint8_t {
        starts,  ///< everything is repeated; moments that are kept are compared with, and not gone on from
        moments, ///< only what follows the nearest moment that is kept
    };

    /// @param project outlives this
    /// @throws Problem when it has no history, or none that hangs together
    explicit HistoryReplay(const Project& project, From from = From::starts, Packing packing = {});
    ~HistoryReplay();

    /// Goes to an entry. Entries in ascending order take the least time.
    /// @param next which others will be asked for: their branches begin with what is remembered now
    /// @throws Cancelled
    RepeatedEntry repeat(History::Entry entry, TaskControl& control, const std::set<History::Entry>& next = {});

    /// The state at the entry that was repeated last; null when it was not reached.
    std::shared_ptr<const Snapshot> snapshot();

    /// Steps that the commands of an entry itself took, those before it apart: for progress.
    std::uint64_t ownSteps(History::Entry entry) const;

private:
    std::vector<RecordedCommand> goToBegin(History::Entry entry);
    std::vector<RecordedCommand> goToWay(const Way& way);
    void remember(History::Entry entry, const std::set<History::Entry>& next);
    RepeatedEntry::Whole compareWhole(History::Entry entry);
    bool continuesAt(History::Entry entry) const;

    const Project& m_project;
    History m_history; ///< without moments where everything is repeated
    Packing m_packing;
    ToolParts m_parts;
    std::optional<Simulation> m_simulation; ///< at m_at; none when there was trouble
    History::Entry m_at = 0;
    std::map<History::Entry, MomentPointer> m_branches; ///< where others will go on from
    std::set<History::Entry> m_lost;                    ///< entries that were not reached
};

} // namespace knead
