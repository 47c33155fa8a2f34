#pragma once

#include "core/model/import_options.h"

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace knead {

/// Adds --unit, --part and --no-heal to a sub-command that reads a file.
/// @param options is written to when the command line is parsed, and must live until then
void addImportArguments(CLI::App& command, ImportOptions& options);

/// The same without --part, for a command that needs all parts.
void addReadingArguments(CLI::App& command, ImportOptions& options);

/// An option that may be given several times, with one value each time.
CLI::Option* addRepeatedOption(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                               const std::string& help);

} // namespace knead
