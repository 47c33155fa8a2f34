#pragma once

namespace CLI {
class App;
}

namespace knead {

/// Adds `knead replay`: repeats what was done in a project and compares with what is kept.
/// @param exitStatus is written to when the command runs
void addReplayCommand(CLI::App& program, int& exitStatus);

} // namespace knead
