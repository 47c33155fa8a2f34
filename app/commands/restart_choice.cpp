#include "app/commands/restart_choice.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <stdexcept>

#include <unistd.h>

namespace knead {

void addRestartChoice(CLI::App& command, RestartChoice& choice, const std::string& description)
{
    command.add_flag("--restart", choice.isWanted, description);
    command.add_flag("-y,--yes", choice.isConfirmed, "Do not ask before --restart throws anything away");
}

void confirmRestart(const RestartChoice& choice, const std::string& folder)
{
    if (choice.isConfirmed)
        return;
    if (isatty(STDIN_FILENO) == 0 || isatty(STDERR_FILENO) == 0)
        throw std::runtime_error(folder + ": --restart throws away what is in this folder, and there is nobody to be "
                                          "asked; say --restart --yes, or choose another folder with --out.");
    std::cerr << "knead: " << folder << ": throw away what is in this folder, and begin anew? [y/N] " << std::flush;
    std::string answer;
    std::getline(std::cin, answer);
    if (answer != "y" && answer != "Y" && answer != "yes")
        throw std::runtime_error(folder + ": nothing was thrown away; without --restart the same command goes on.");
}

} // namespace knead
