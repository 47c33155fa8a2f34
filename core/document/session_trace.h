#pragma once

#include "core/simulation/command.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace knead {

/// A session as a text that grows with what is done: so much of it as has come is written once, and stays as it is. One thread at a
/// time.
class SessionTrace {
public:
    virtual ~SessionTrace() = default;

    /// The same so far, to be gone on with on its own: for what may be undone. What take() has given is not in it.
    virtual std::unique_ptr<SessionTrace> copy() const = 0;

    /// What was done next, in order.
    /// @param name of the gesture that ends with it; empty: it goes on
    /// @throws Problem when it cannot be told
    virtual void add(std::span<const RecordedCommand> commands, const std::string& name) = 0;

    /// The text since the last time, whole lines.
    virtual std::string take() = 0;

    /// How the text ends when no more comes; what comes next is written in its place.
    /// @param step that the simulation is at by now
    virtual std::string ending(std::uint64_t step) const = 0;
};

} // namespace knead
