#include "app/commands/trace_command.h"
#include "app/cad_process.h"

#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/exit_status.h"
#include "app/trace_services.h"
#include "core/message/message.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace knead {

namespace {

struct TraceOptions {
    std::string project;
    std::optional<std::uint32_t> entry;
    std::string output; ///< empty: stdout
};

std::string scriptOf(const TraceOptions& options, TerminalControl& control)
{
    const Project project = readProjectAfterTrial(options.project, control);
    const std::uint32_t entry = options.entry.value_or(project.current);
    if (entry >= project.entries.size() && !project.entries.empty())
        throw Problem(
            Message("Trace", "%1 has no entry %2; its last one is %3.")
                .with(std::filesystem::path(options.project).filename().string(), entry, project.entries.size() - 1));
    return traceScript(project, entry, options.project);
}

int trace(const TraceOptions& options)
{
    return carryOut([&](TerminalControl& control, int& failure) {
        const std::string text = scriptOf(options, control);
        control.clear();
        failure = exit_status::failed;
        putOut(options.output, text);
        return exit_status::done;
    });
}

} // namespace

void addTraceCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<TraceOptions>();
    CLI::App* command =
        program.add_subcommand("trace", "Write what was done in a project as a script for Python, which comes to the "
                                        "same bits");
    command->add_option("PROJECT", options->project, "Project file, saved by the window")->required();
    command->add_option("--entry", options->entry, "Entry of the history to come to; without it the present one")
        ->type_name("N");
    command->add_option("-o,--output", options->output, "Script to write; without it the script goes to the terminal")
        ->type_name("FILE");
    command->callback([options, &exitStatus] { exitStatus = trace(*options); });
}

} // namespace knead
