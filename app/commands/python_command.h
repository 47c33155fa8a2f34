#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace knead {

/// `knead python SCRIPT`: runs a script with the Python of the system, which finds the module knead of this program.
/// @param scriptArguments that were taken from those of the program
/// @param exitStatus that of the script, when the command ran
void addPythonCommand(CLI::App& program, std::vector<std::string> scriptArguments, int& exitStatus);

/// Takes away what follows a script: it is the script's, as it is, and nothing for our parser.
/// @param arguments of the program, without its name
std::vector<std::string> takeScriptArguments(std::vector<std::string>& arguments);

} // namespace knead
