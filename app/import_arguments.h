#pragma once

#include "core/model/import_options.h"

namespace CLI {
class App;
}

namespace knead {

/// Adds --unit, --part and --no-heal to a sub-command that reads a file.
/// @param options is written to when the command line is parsed, and must live until then
void addImportArguments(CLI::App& command, ImportOptions& options);

} // namespace knead
