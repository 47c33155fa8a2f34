#pragma once

namespace CLI {
class App;
}

namespace knead {

/// knead compare: how far a project is from its original, or one file from another; as a table, and as a report.
void addCompareCommand(CLI::App& program, int& exitStatus);

} // namespace knead
