#pragma once

namespace CLI {
class App;
}

namespace knead {

/// Adds `knead run RECIPE|PROJECT [--set PATH=VALUE ...] [--out FOLDER] [--threads N] [--json]`: carries out a recipe, or what was done in
/// a project, without a window.
/// When the sub-command was given, parsing the command line carries it out and stores its exit status.
void addRunCommand(CLI::App& program, int& exitStatus);

} // namespace knead
