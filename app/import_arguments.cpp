#include "app/import_arguments.h"

#include "core/model/length_units.h"

#include <CLI/CLI.hpp>

namespace knead {

CLI::Option* addRepeatedOption(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                               const std::string& help)
{
    return command.add_option(name, values, help)
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void addImportArguments(CLI::App& command, ImportOptions& options)
{
    addReadingArguments(command, options);
    addRepeatedOption(
        command, "--part", options.parts,
        "Path of a part or assembly to read, as knead info --json lists them; may be given several times. "
        "All others are left out")
        ->type_name("PATH");
}

void addReadingArguments(CLI::App& command, ImportOptions& options)
{
    command
        .add_option("--unit", options.unit,
                    "Take the lengths in this unit, whatever the file says: " + lengthUnitNames())
        ->type_name("UNIT");
    command
        .add_option_function<double>(
            "--memory-limit", [&options](double gibibytes) { options.memoryLimit = gibibytes * (1U << 30U); },
            "Memory that reading may take")
        ->type_name("GIB")
        ->check(CLI::PositiveNumber);
    command
        .add_option_function<double>(
            "--time-limit", [&options](double minutes) { options.timeLimit = 60 * minutes; },
            "Processor time that reading may take")
        ->type_name("MINUTES")
        ->check(CLI::PositiveNumber);
    command.add_flag_callback(
        "--close-openings", [&options] { options.capsFlatOpenings = true; },
        "Close surfaces whose openings are all flat with plane faces");
    command.add_flag_callback(
        "--no-heal", [&options] { options.heal = false; }, "Leave shapes as they are in the file");
}

} // namespace knead
