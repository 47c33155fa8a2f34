#pragma once

#include "core/task/task_control.h"

#include <string>
#include <vector>

namespace knead {

/// A command that is ready to run in the folder of a round.
struct RoundCommand {
    int round = 1;
    std::string folder; ///< absolute; the command runs in it
    std::vector<std::string> words;
    std::string field;    ///< name of the file that it is to write there
    double timeLimit = 0; ///< [s]
};

/// Where commands run.
struct RoundEngine {
    bool isSlurm = false;
    unsigned threads = 1;                  ///< that a task of Slurm asks for
    std::vector<std::string> slurmOptions; ///< for sbatch
    std::string jobName;                   ///< of tasks of this compensation
};

constexpr const char* roundLogName = "log.txt"; ///< what a command prints, in the folder of its round

/// Whether a command of an earlier call is still at work in Slurm on what lies in a folder, or has ended there; then the folder is to
/// be left as it is. @throws std::runtime_error, in a sentence, when there is no Slurm here
bool isAtWork(const RoundCommand& command, const RoundEngine& engine);

/// Runs a command to its end, which also comes when this process ends; on Slurm it goes on.
/// @throws std::runtime_error, in a sentence with the last lines of its log, when it fails, hangs, or leaves no field.
/// @throws Cancelled
void runCommand(const RoundCommand& command, const RoundEngine& engine, TaskControl& control);

/// What the process that runCommand() starts does: it becomes the command that is kept in a folder.
/// @param endsWithParent it ends when the process that started it does
/// @return the exit status when there is no such command
int becomeCommand(const std::string& folder, bool endsWithParent);

} // namespace knead
