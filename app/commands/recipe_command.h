#pragma once

namespace CLI {
class App;
}

namespace knead {

/// Adds `knead recipe FILE [--output RECIPE]`: writes a recipe to start from.
/// When the sub-command was given, parsing the command line carries it out and stores its exit status.
void addRecipeCommand(CLI::App& program, int& exitStatus);

} // namespace knead
