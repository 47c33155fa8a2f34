#pragma once

namespace CLI {
class App;
}

namespace knead {

/// Adds `knead sweep RECIPE --vary PATH=VALUES ... --out FOLDER`: carries out a recipe with many values and makes one table.
/// When the sub-command was given, parsing the command line carries it out and stores its exit status.
void addSweepCommand(CLI::App& program, int& exitStatus);

/// Adds `knead sweep-point FOLDER POINT`, which tasks of Slurm call; help does not show it.
void addSweepPointCommand(CLI::App& program, int& exitStatus);

} // namespace knead
