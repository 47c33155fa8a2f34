#pragma once

#include "core/document/history_record.h"
#include "core/session/filled_model.h"
#include "core/simulation/snapshot.h"

#include <QString>

namespace knead {

/// What an entry of the history is about, as far as its icon tells.
enum class EntryKind {
    Start,
    Simulate,
    Push,
    AddTool,
    MoveTool,
    RemoveTool,
    Material,
    Fixture,
    Renormalize,
    Reset,
    Balance,
    Cut,
    Scene,
    Look
};

/// Of the first command that tells.
/// @param beginsStart whether steps begin to be counted at the entry: after opening or filling
EntryKind kindOf(const HistoryRecord& record, bool beginsStart);
/// Of a file in resources/icons.
const char* iconOf(EntryKind kind);

/// What a command does, in words for the history: "Add Block 1"; empty for one that is nothing by itself.
/// @param now as it was before the command
Message nameOf(const Command& command, const FilledModel& content, const Snapshot& now);

/// "Simulate 3.2 s"
Message simulatedName(double seconds);

/// "3.2 s", "41 ms": simulated time with as many digits as help.
Message timePhrase(double seconds);
QString timeText(double seconds); ///< the same, said

/// What commands have in common that are one entry when they follow each other within a second: moves of one tool. Empty for
/// others.
QString mergeKeyOf(const Command& command);

} // namespace knead
