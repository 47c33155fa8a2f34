#pragma once

#include <string>

namespace CLI {
class App;
}

namespace knead {

/// Whether a command throws away what it left in its folder before.
struct RestartChoice {
    bool isWanted = false;    ///< --restart
    bool isConfirmed = false; ///< --yes
};

/// Adds --restart and --yes to a command.
/// @param description of --restart
void addRestartChoice(CLI::App& command, RestartChoice& choice, const std::string& description);

/// Asks whether what is in a folder may be thrown away, on the terminal, unless that was said already.
/// @throws std::runtime_error, in a sentence, when the answer is no, or nobody is there to be asked
void confirmRestart(const RestartChoice& choice, const std::string& folder);

} // namespace knead
