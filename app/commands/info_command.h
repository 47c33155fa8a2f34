#pragma once

namespace CLI {
class App;
}

namespace knead {

/// Adds `knead info FILE [--json] [--unit UNIT] [--part PATH ...] [--no-heal]`: says what a CAD or mesh file holds.
/// When the sub-command was given, parsing the command line carries it out and stores its exit status.
void addInfoCommand(CLI::App& program, int& exitStatus);

} // namespace knead
