#pragma once

namespace CLI {
class App;
}

namespace knead {

/// "knead describe FOLDER", which the help leaves out: writes the manual pages and the completions of shells, made from what the
/// parser knows. Installing does so.
/// @param program must live until the command line is parsed, and is described as it is then
void addDescribeCommand(CLI::App& program, int& exitStatus);

} // namespace knead
