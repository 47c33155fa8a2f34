#pragma once

#include "core/aggregate/material.h"
#include "core/document/project.h"
#include "core/document/session_trace.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace knead {

/// How a session is to be told in Python.
struct PythonTraceChoices {
    std::string projectPath; ///< where the project was saved; empty: nowhere yet
    std::vector<MaterialPreset> presets;
};

/// A session as a script for Python that uses the module knead, one call per command in the order in which they were carried out:
///
///     model = knead.read("/home/ann/grip.step")
///     grip = knead.fill(model.parts[0], spacing=0.002, material=knead.Material("sponge-rubber"))
///     sim = knead.Simulation([grip], floor=0)
///     sim.keep()  # Import grip.step
///
///     ball_1 = sim.add_tool("ball", 0.02, (0, 0, 0.05), name="Ball 1")
///     ...
///
/// Run, it comes to the same state, bit for bit. What happens often, such as a hand that moves a tool, is a table. What the module
/// has no method for is carried out as what a project keeps of it, with Simulation.carry_out().
///
/// It begins where the part was filled last.
/// @param start of the project's list; what is added follows it
/// @throws Problem when the parts are in no file that is still there, and in no project that was saved
std::unique_ptr<SessionTrace> pythonTrace(const Project& project, std::uint32_t start,
                                          const PythonTraceChoices& choices);

/// What leads to an entry of a project, whole.
/// @throws Problem as above, and for a project in which nothing was done
std::string pythonTraceOf(const Project& project, std::uint32_t entry, const PythonTraceChoices& choices);

} // namespace knead
