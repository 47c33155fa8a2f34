#pragma once

#include "core/simulation/gesture.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace knead {

/// What is to happen in a simulation at given times, beside what a person does: the events of a recipe that was opened.
/// SimulationThread asks it before each step. One thread at a time.
class ScriptedEvents {
public:
    virtual ~ScriptedEvents() = default;

    /// Carries out what is due before the next step, after what a person asked for.
    /// @return whether time is to stand still here, at the end of the script; said once
    virtual bool carryOutDue(Simulation& simulation) = 0;

    /// A gesture was ended: whoever comes to its moment again is as far in the script.
    virtual void ended(const Gesture& gesture) = 0;

    /// The simulation is at another moment.
    /// @param hash of the state there
    virtual void wentTo(const Moment& moment, std::uint64_t hash) = 0;
};

/// Makes a script for a simulation at the start of its scene. All that it makes know where any was when a gesture ended. Any
/// thread; empty: there is no script.
using ScriptedEventsMaker = std::function<std::unique_ptr<ScriptedEvents>()>;

} // namespace knead
