#pragma once

namespace CLI {
class App;
}

namespace knead {

/// Adds `knead morph PART --field FILE --output OUT` and the like: deforms the parts of a file by fields and by numbers, and writes what
/// comes of it.
void addMorphCommand(CLI::App& program, int& exitStatus);

} // namespace knead
