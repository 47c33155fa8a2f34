#include "app/command_line.h"

#include "app/commands/apply_command.h"
#include "app/commands/compare_command.h"
#include "app/commands/compensate_command.h"
#include "app/commands/convert_command.h"
#include "app/commands/describe_command.h"
#include "app/commands/fields_command.h"
#include "app/commands/info_command.h"
#include "app/commands/measure_command.h"
#include "app/commands/morph_command.h"
#include "app/commands/python_command.h"
#include "app/commands/recipe_command.h"
#include "app/commands/replay_command.h"
#include "app/commands/run_command.h"
#include "app/commands/sweep_command.h"
#include "app/commands/thumbnail_command.h"
#include "app/commands/trace_command.h"
#include "app/exit_status.h"
#include "app/gui.h"
#include "app/version_text.h"
#include "core/task/kept_memory.h"
#include "io/files/safe_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr const char* description = "A CAD workbench in which a part is a lump of real material.\n"
                                    "Without a sub-command it opens the window. Sub-commands need no display.";

constexpr const char* footer = "Exit status: 0 done, 1 the work failed, 2 wrong use or unreadable input, "
                               "130 interrupted.";

/// Help and version are "errors" to the parser too; they go to stdout with status 0.
int explain(const CLI::App& program, const CLI::ParseError& error)
{
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
        return program.exit(error);
    std::cerr << "knead: " << error.what() << "; knead --help shows what is possible.\n";
    return exit_status::wrongUse;
}

} // namespace

int runProgram(int argc, char** argv)
{
    keepFreedMemory();
    removeUnfinished();
    CLI::App program(description, "knead");
    program.footer(footer);
    bool isVerbose = false; // declared before the version, which is said as soon as it is found
    program.add_flag("--verbose", isVerbose,
                     "With --version: what it stands on, and how files of others are locked in");
    const auto version = [&isVerbose] { return isVerbose ? verboseVersionText() : versionText(); };
    program.set_version_flag("--version", version, "Print the version and exit");
    program.require_subcommand(0, 1);
    std::vector<std::string> files;
    program.add_option("FILE", files, "CAD or mesh files, a project, or a recipe, to open in the window")
        ->type_name("");

    std::vector<std::string> arguments(argv + 1, argv + argc);
    int status = exit_status::done;
    addInfoCommand(program, status);
    addConvertCommand(program, status);
    addRunCommand(program, status);
    addSweepCommand(program, status);
    addSweepPointCommand(program, status);
    addCompensateCommand(program, status);
    addCompensationWorkers(program, status);
    addRecipeCommand(program, status);
    addMeasureCommand(program, status);
    addCompareCommand(program, status);
    addMorphCommand(program, status);
    addReplayCommand(program, status);
    addTraceCommand(program, status);
    addPythonCommand(program, takeScriptArguments(arguments), status);
    addApplyCommand(program, status);
    addFieldsCommand(program, status);
    addThumbnailCommand(program, status);
    addDescribeCommand(program, status);

    try {
        std::ranges::reverse(arguments); // as the parser takes them
        program.parse(std::move(arguments));
    } catch (const CLI::ParseError& error) {
        return explain(program, error);
    }
    return program.get_subcommands().empty() ? runWindow(argc, argv, files) : status;
}

} // namespace knead
