#include "app/export_arguments.h"

#include "core/model/file_formats.h"

#include <CLI/CLI.hpp>

namespace knead {

void addExportArguments(CLI::App& command, ExportOptions& options)
{
    command.add_option("--write-unit", options.unit, "Length unit of a CAD file written: mm, cm, m, inch or ft")
        ->type_name("UNIT");
    command.add_flag("--ap214", options.useAp214, "Write STEP in AP214 instead of AP242");
    command.add_flag("--text", options.isText, "Write " + formatNames(" and ", [](const FileFormat& f) {
                                                   return f.text == FileFormat::Text::asAsked;
                                               }) + " as text");
}

ExportOptions asWished(ExportOptions wished, const ExportOptions& ofJob)
{
    if (wished.unit.empty())
        wished.unit = ofJob.unit;
    return wished;
}

} // namespace knead
