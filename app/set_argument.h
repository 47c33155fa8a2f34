#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace knead {

/// Adds --set to a sub-command that takes a recipe.
/// @param settings is written to when the command line is parsed, and must live until then; parseOverride() reads them
void addSetArgument(CLI::App& command, std::vector<std::string>& settings);

} // namespace knead
