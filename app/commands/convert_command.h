#pragma once

namespace CLI {
class App;
}

namespace knead {

/// Adds `knead convert IN OUT [--deflection MM]`: writes a CAD or mesh file as STL, OBJ, PLY, or as a picture (PNG).
/// When the sub-command was given, parsing the command line carries it out and stores its exit status.
void addConvertCommand(CLI::App& program, int& exitStatus);

} // namespace knead
