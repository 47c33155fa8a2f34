#pragma once

namespace CLI {
class App;
}

namespace knead {

/// knead apply SESSION PART: what was done in a project, to another part.
void addApplyCommand(CLI::App& program, int& exitStatus);

} // namespace knead
