#pragma once

#include "core/message/message.h"
#include "core/simulation/command.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace knead {

/// One entry of a document's history as a project file keeps it. Entries form a tree: the first is the start, every other
/// one follows an earlier one.
struct HistoryRecord {
    std::uint32_t parent = 0; ///< index of the entry it follows, lower than its own; of the first one: 0
    std::uint32_t start = 0;  ///< which start state (of the document's list) its steps count from
    std::string name;         ///< for the person, "Push with Block 1"; where `words` are, their English
    Message words;            ///< the same in any language; none where a person or an earlier version named it
    double wallTime = 0;      ///< when it was made [s since 1970]
    std::vector<RecordedCommand> commands; ///< that lead here from the parent, in order
    std::uint64_t step = 0;                ///< at its end
    double time = 0;                       ///< simulated, at its end [s]
    std::uint64_t hash = 0;                ///< Simulation::stateHash() at its end
    bool isKey = false;                    ///< marked by the person as a key moment

    /// The state at its end, packed; null when it was thinned out: then it follows from an earlier one and the commands.
    std::shared_ptr<const std::vector<std::byte>> moment;

    /// What it is called.
    Message label() const { return words.empty() ? Message::verbatim(name) : words; }
};

} // namespace knead
