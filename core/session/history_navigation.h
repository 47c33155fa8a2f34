#pragma once

#include "core/document/history_replay.h"
#include "core/session/frame.h"
#include "core/session/history_start.h"

#include <memory>
#include <optional>

namespace knead {

/// What it takes to be at an entry of the history, found on another thread than the window's.
struct HistoryDestination {
    MomentPointer moment;
    std::shared_ptr<const FilledModel> content; ///< of the start of the entry
    std::optional<Simulation> simulation;       ///< at the moment, and its frame: where another start is shown before
    FramePointer frame;
    std::shared_ptr<const Bytes> found; ///< the moment packed anew, where it was not kept
};

/// A new way on from an entry, ended like a gesture.
struct Branch {
    Gesture gesture;
};

/// A navigation to an entry of the history: plain values for another thread.
struct HistoryNavigation {
    Way way;
    HistoryStart start;
    std::shared_ptr<const Model> model;
    Packing packing;
    bool changesStart = false; ///< another start is shown now

    /// Commands have to be repeated, or a content has to be prepared: seconds to minutes.
    bool isLong() const { return !way.commands.empty() || !start.content; }

    /// @throws std::runtime_error with a sentence; Cancelled
    HistoryDestination go(TaskControl& control) const;
    /// Goes there, and on as it went on then, up to a step. What a stroke would have taken away at its end, its fingers, is taken away
    /// there.
    /// @param run see commandsBefore()
    /// @throws as go()
    Branch branch(const std::vector<RecordedCommand>& commands, std::uint32_t run, std::uint64_t upToStep,
                  TaskControl& control) const;
};

} // namespace knead
