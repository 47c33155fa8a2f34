#pragma once

namespace CLI {
class App;
}

namespace knead {

/// knead measure: sizes and masses of the bodies of a file or a project, and what else is asked for.
void addMeasureCommand(CLI::App& program, int& exitStatus);

} // namespace knead
