#include "app/commands/compensate_command.h"

#include "app/commands/carry_out.h"
#include "app/commands/command_output.h"
#include "app/commands/restart_choice.h"
#include "app/compensate/compensation_run.h"
#include "app/compensate/recipe_field.h"
#include "app/compensate/round_tables.h"
#include "app/complaint.h"
#include "app/exit_status.h"
#include "app/field_source.h"
#include "app/file_content.h"
#include "app/terminal_control.h"
#include "app/thread_limit.h"
#include "core/message/message.h"
#include "core/model/number_words.h"
#include "io/study/study_reader.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

namespace knead {

namespace {

constexpr std::size_t digitsOfName = 8; // of jobs

struct CompensateOptions {
    std::string study;
    std::string folder;
    std::string engine = "local";
    unsigned threads = 0;
    std::vector<std::string> slurmOptions;
    RestartChoice restart;
};

std::string wordsOf(const CompensationResult& result, const CompensationStudy& study)
{
    const CompensationRound& best = result.rounds[result.best];
    const std::string sentence = "the largest deviation is " + lengthWords(best.largest) + ", that of round " +
                                 std::to_string(best.number) + ", and not within " +
                                 lengthWords(study.method.tolerance);
    if (result.end == CompensationEnd::diverged)
        return sentence + "; it grew with half the factor, too. Try a smaller \"factor\", or smoothing.";
    return sentence + ". More \"rounds\" go on from there.";
}

int print(const CompensationResult& result, const CompensationStudy& study, const CompensationFolder& folder)
{
    for (const std::string& line : linesOf(result.points, result.rounds))
        std::printf("%s\n", line.c_str());
    std::printf("%zu rounds, %zu finished before\n", result.rounds.size(), result.finishedBefore);
    printWritten({folder.pathOf("rounds.csv"), folder.pathOf("rounds.svg"), result.written.file}, {result.written});
    if (result.end == CompensationEnd::within)
        return exit_status::done;
    return complain(wordsOf(result, study), exit_status::failed);
}

RoundEngine engineOf(const CompensateOptions& options, const CompensationFolder& folder)
{
    return {.isSlurm = options.engine == "slurm",
            .threads = std::max(1U, options.threads),
            .slurmOptions = options.slurmOptions,
            .jobName = "knead-" + digestOfText(folder.path()).substr(0, digitsOfName)};
}

int run(const CompensateOptions& options)
{
    const ThreadLimit limit(options.threads);
    return carryOut([&](TerminalControl& control, int& failure) {
        const CompensationStudy study = readStudy(options.study);
        const CompensationFolder folder(options.folder);
        if (options.restart.isWanted && folder.isBegun()) {
            confirmRestart(options.restart, folder.path());
            folder.clear();
        }
        folder.checkHasNoOther(factsOf(study));
        failure = exit_status::failed;
        const auto say = [&](const std::string& sentence) { control.say("knead: " + sentence); };
        const CompensationResult result =
            compensate(study, folder, engineOf(options, folder), readFieldSource, say, control);
        control.clear();
        return print(result, study, folder);
    });
}

struct RoundRecipeOptions {
    RecipeOfShape what;
    double spacing = 0; ///< [mm]
};

} // namespace

void addCompensateCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<CompensateOptions>();
    CLI::App* command = program.add_subcommand(
        "compensate", "Find the shape of a tool or print of which the target comes out, in rounds");
    command->footer("The shape is FOLDER/compensated.step. The same command goes on with what was interrupted.");
    command->add_option("STUDY", options->study, "What is to come out and how to find out what does, a JSON file")
        ->required();
    command->add_option("--out", options->folder, "Folder for the rounds, made when missing")
        ->type_name("FOLDER")
        ->required();
    command->add_option("--engine", options->engine, "Where commands run: local, or slurm for a job per round")
        ->check(CLI::IsMember({"local", "slurm"}))
        ->capture_default_str();
    command
        ->add_option("--slurm-option", options->slurmOptions,
                     "Option for sbatch, for example --slurm-option=--partition=long; may be given several times")
        ->type_name("OPTION")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_option("--threads", options->threads, "Number of threads, and of cores that a job asks for")
        ->type_name("N")
        ->check(CLI::Range(1U, 1024U));
    addRestartChoice(*command, options->restart, "Throw away what is in the folder, and begin anew");
    command->callback([options, &exitStatus] { exitStatus = run(*options); });
}

void addCompensationWorkers(CLI::App& program, int& exitStatus)
{
    auto folder = std::make_shared<std::string>();
    auto endsWithParent = std::make_shared<bool>(false);
    CLI::App* command = program.add_subcommand("compensate-command", "Become the command of a round")->group("");
    command->add_option("FOLDER", *folder)->required();
    command->add_flag("--end-with-parent", *endsWithParent);
    command->callback([folder, endsWithParent, &exitStatus] { exitStatus = becomeCommand(*folder, *endsWithParent); });

    auto options = std::make_shared<RoundRecipeOptions>();
    CLI::App* recipe = program.add_subcommand("compensate-recipe", "Carry out the recipe of a round")->group("");
    recipe->add_option("RECIPE", options->what.recipe)->required();
    recipe->add_option("--part", options->what.part)->required();
    recipe->add_option("--field", options->what.field)->required();
    recipe->add_option("--spacing", options->spacing);
    recipe->callback([options, &exitStatus] {
        exitStatus = carryOut([&](TerminalControl& control, int& failure) {
            failure = exit_status::failed;
            options->what.spacing = options->spacing / 1000;
            writeFieldOfRecipe(options->what, control);
            return exit_status::done;
        });
    });
}

} // namespace knead
