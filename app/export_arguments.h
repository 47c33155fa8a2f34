#pragma once

#include "core/model/export_options.h"

namespace CLI {
class App;
}

namespace knead {

/// Adds --write-unit, --ap214 and --text to a sub-command that writes a file.
/// @param options is written to when the command line is parsed, and must live until then
void addExportArguments(CLI::App& command, ExportOptions& options);

/// What a person wished, in the unit of a job where they wished none.
ExportOptions asWished(ExportOptions wished, const ExportOptions& ofJob);

} // namespace knead
