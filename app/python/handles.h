#pragma once

#include "app/python/live_simulation.h"

#include <pybind11/pybind11.h>

#include <memory>

namespace knead::python {

using LivePointer = std::shared_ptr<LiveSimulation>;
using SimulationType = pybind11::class_<LiveSimulation, LivePointer>;

/// What a script holds of things in a simulation, which they keep alive.
struct BodyHandle {
    LivePointer simulation;
    BodyId body = 0;
};
struct ToolHandle {
    LivePointer simulation;
    ToolId tool = 0;
};
struct FixtureHandle {
    LivePointer simulation;
    FixtureId fixture = 0;
};

/// Without the interpreter's lock: others may go on while a state is looked at or a command is carried out.
template <typename Work>
auto withoutLock(Work&& work)
{
    const pybind11::gil_scoped_release released;
    return work();
}

} // namespace knead::python
