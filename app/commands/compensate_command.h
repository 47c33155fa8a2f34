#pragma once

namespace CLI {
class App;
}

namespace knead {

/// Adds `knead compensate STUDY --out FOLDER`: finds the shape of which the target comes out.
/// When the sub-command was given, parsing the command line carries it out and stores its exit status.
void addCompensateCommand(CLI::App& program, int& exitStatus);

/// Adds `knead compensate-command FOLDER` and `knead compensate-recipe RECIPE`, which rounds call; help does not show them.
void addCompensationWorkers(CLI::App& program, int& exitStatus);

} // namespace knead
