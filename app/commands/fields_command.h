#pragma once

namespace CLI {
class App;
}

namespace knead {

/// knead fields: what the material of a project does at the nodes of another program's mesh.
void addFieldsCommand(CLI::App& program, int& exitStatus);

} // namespace knead
