#include "app/commands/describe_command.h"

#include "app/commands/carry_out.h"
#include "app/describe/completions.h"
#include "app/describe/man_page.h"
#include "app/exit_status.h"
#include "io/files/safe_file.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace knead {

namespace fs = std::filesystem;

namespace {

void writeManPages(const fs::path& folder, const CommandWords& program)
{
    fs::create_directories(folder);
    writeFileSafely(folder / (program.name + ".1"), manPageOf(program, KNEAD_VERSION));
    for (const CommandWords& command : program.commands)
        writeFileSafely(folder / (program.name + '-' + command.name + ".1"),
                        manPageOf(program, command, KNEAD_VERSION));
}

void writeCompletions(const fs::path& folder, const CommandWords& program)
{
    fs::create_directories(folder);
    writeFileSafely(folder / program.name, bashCompletionOf(program));
    writeFileSafely(folder / ('_' + program.name), zshCompletionOf(program));
    writeFileSafely(folder / (program.name + ".fish"), fishCompletionOf(program));
}

} // namespace

void addDescribeCommand(CLI::App& program, int& exitStatus)
{
    auto folder = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("describe", "Write manual pages and completions")->group("");
    command->add_option("FOLDER", *folder)->required();
    command->callback([folder, &program, &exitStatus] {
        exitStatus = carryOut([&](TerminalControl&, int& failure) {
            failure = exit_status::failed;
            const CommandWords words = wordsOf(program);
            writeManPages(fs::path(*folder) / "man", words);
            writeCompletions(fs::path(*folder) / "completions", words);
            return exit_status::done;
        });
    });
}

} // namespace knead
