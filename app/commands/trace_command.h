#pragma once

namespace CLI {
class App;
}

namespace knead {

/// `knead trace`: writes what was done in a project as a script for Python.
/// @param exitStatus that of the command, when it ran
void addTraceCommand(CLI::App& program, int& exitStatus);

} // namespace knead
