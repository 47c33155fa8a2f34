#include "app/commands/sweep_command.h"

#include "app/commands/restart_choice.h"
#include "app/complaint.h"
#include "app/exit_status.h"
#include "app/set_argument.h"
#include "app/sweep/local_engine.h"
#include "app/sweep/slurm_engine.h"
#include "app/sweep/sweep_run.h"
#include "io/files/safe_file.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <unistd.h>

namespace knead {

namespace {

struct SweepOptions {
    SweepRequest request;
    std::string folder;
    std::string engine = "local";
    unsigned jobs = 0;
    unsigned threads = 1;
    std::vector<std::string> slurmOptions;
    bool goTogether = false;
    RestartChoice restart;
};

/// A sweep that is ready to go.
struct Sweep {
    SweepFolder folder;
    SweepPlan plan;
    std::vector<std::size_t> missing;
};

LostPoints carryOutSweep(const Sweep& sweep, const SweepOptions& options, TerminalControl& control)
{
    if (sweep.missing.empty())
        return {};
    SweepProgress progress(control, sweep.plan.points.size(), sweep.plan.points.size() - sweep.missing.size());
    if (options.engine == "slurm")
        return runOnSlurm(sweep.folder, sweep.plan, sweep.missing,
                          {.throttle = options.jobs, .threads = options.threads, .options = options.slurmOptions},
                          progress);
    return runLocally(sweep.folder, sweep.plan, sweep.missing, {.jobs = options.jobs, .threads = options.threads},
                      progress);
}

std::size_t failuresOf(const Sweep& sweep)
{
    std::size_t failures = 0;
    for (std::size_t i = 0; i < sweep.plan.points.size(); ++i) {
        const std::optional<PointResult> result = sweep.folder.result(sweep.plan, i);
        failures += !result || result->status != exit_status::done ? 1 : 0;
    }
    return failures;
}

int writeTables(const Sweep& sweep, const LostPoints& lost)
{
    const std::string table = sweep.folder.pathOf("sweep.csv");
    const std::string timing = sweep.folder.pathOf("timing.csv");
    writeFileSafely(table, tableOf(sweep.folder, sweep.plan, lost));
    writeFileSafely(timing, timingOf(sweep.folder, sweep.plan));

    const std::size_t failures = failuresOf(sweep);
    const std::size_t points = sweep.plan.points.size();
    std::cout << points << (points == 1 ? " point" : " points") << ", " << points - sweep.missing.size()
              << " finished before, " << failures << " failed\n"
              << "wrote " << table << "\nwrote " << timing << '\n';
    return failures == 0 ? exit_status::done : exit_status::failed;
}

bool wantsJobsCancelled()
{
    if (isatty(STDIN_FILENO) == 0 || isatty(STDERR_FILENO) == 0)
        return false;
    std::cerr << "The jobs go on in Slurm. Cancel them? [y/N] " << std::flush;
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "Y" || answer == "yes";
}

/// What becomes of jobs that nobody waits for.
std::string fateOfJobs(const SweepFolder& folder)
{
    const std::vector<SlurmJob> jobs = jobsOf(folder);
    if (jobs.empty())
        return "";
    if (wantsJobsCancelled())
        return cancelJobs(jobs) ? " Its jobs in Slurm are cancelled." : " Slurm did not cancel its jobs; scancel does.";
    std::string ids;
    for (const SlurmJob& job : jobs)
        ids += " " + job.id;
    return " Its jobs go on in Slurm; scancel" + ids + " ends them.";
}

int interrupted(const Sweep& sweep, const SweepOptions& options)
{
    const std::string fate = options.engine == "slurm" ? fateOfJobs(sweep.folder) : "";
    const std::size_t done = sweep.plan.points.size() - sweep.folder.missing(sweep.plan).size();
    return complain("interrupted after " + std::to_string(done) + " of " + std::to_string(sweep.plan.points.size()) +
                        " points; the same command goes on from there." + fate,
                    exit_status::interrupted);
}

/// Takes away what a sweep left, and ends its jobs where there is a Slurm to ask.
void forget(const SweepFolder& folder)
{
    try {
        cancelJobs(jobsOf(folder));
    } catch (
        const std::runtime_error&) { // jobs that go on elsewhere find another plan, and what they leave is not taken
    }
    folder.clear();
}

/// Points and folder, before anything is written.
Sweep prepare(const SweepOptions& options)
{
    Sweep sweep{SweepFolder(options.folder), makePlan(options.request), {}};
    if (options.restart.isWanted && sweep.folder.plan()) {
        confirmRestart(options.restart, sweep.folder.path());
        forget(sweep.folder);
    }
    sweep.folder.checkHasNoOther(sweep.plan);
    sweep.missing = sweep.folder.missing(sweep.plan);
    return sweep;
}

int run(const Sweep& sweep, const SweepOptions& options)
{
    TerminalControl control;
    try {
        sweep.folder.begin(sweep.plan);
        const LostPoints lost = carryOutSweep(sweep, options, control);
        control.clear();
        return writeTables(sweep, lost);
    } catch (const Cancelled&) {
        control.clear();
        return interrupted(sweep, options);
    } catch (const std::exception& error) {
        control.clear();
        return complain(error.what(), exit_status::failed);
    }
}

int sweep(const SweepOptions& options)
{
    try {
        return run(prepare(options), options);
    } catch (const std::exception& error) {
        return complain(error.what(), exit_status::wrongUse);
    }
}

struct PointOptions {
    std::string folder;
    std::size_t point = 0;
    unsigned threads = 1;
};

int sweepPoint(const PointOptions& options)
{
    TerminalControl control;
    try {
        const SweepFolder folder(options.folder);
        const std::optional<SweepPlan> plan = folder.plan();
        if (!plan || options.point >= plan->points.size())
            return complain(options.folder + ": there is no such point.", exit_status::wrongUse);
        return runPoint(folder, *plan, options.point, options.threads, control).status;
    } catch (const Cancelled&) {
        return complain("interrupted.", exit_status::interrupted);
    } catch (const std::exception& error) {
        return complain(error.what(), exit_status::failed);
    }
}

void addVariations(CLI::App& command, SweepOptions& options)
{
    command
        .add_option(
            "--vary", options.request.variations,
            "What varies: PATH=A:B:lin:N or PATH=A:B:log:N for N values from A to B with equal steps or ratios, "
            "or a list PATH=V,W,...; paths are those of --set. Several make a grid, the last changing fastest")
        ->type_name("PATH=VALUES")
        ->required()
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_flag("--zip", options.goTogether,
                     "Take the first values of every --vary together, then the second ...");
    addSetArgument(command, options.request.settings);
}

void addEngine(CLI::App& command, SweepOptions& options)
{
    command
        .add_option("--jobs", options.jobs,
                    "Runs at a time: without it as many as fit on the cores, or as Slurm has room for")
        ->type_name("N")
        ->check(CLI::Range(1U, 1024U));
    command.add_option("--threads", options.threads, "Number of threads of each run; the result is the same for any")
        ->type_name("N")
        ->check(CLI::Range(1U, 1024U))
        ->capture_default_str();
    command.add_option("--engine", options.engine, "Where: local, or slurm for a job array with a task per point")
        ->check(CLI::IsMember({"local", "slurm"}))
        ->capture_default_str();
    command
        .add_option("--slurm-option", options.slurmOptions,
                    "Option for sbatch, for example --slurm-option=--partition=long; may be given several times")
        ->type_name("OPTION")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

} // namespace

void addSweepCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<SweepOptions>();
    CLI::App* command = program.add_subcommand("sweep", "Carry out a recipe with many values, and make one table");
    command->footer("Results are in FOLDER/sweep.csv. The same command goes on with a sweep that was interrupted.");
    command->add_option("RECIPE", options->request.recipe, "Recipe to carry out, a JSON file")->required();
    addVariations(*command, *options);
    command->add_option("--out", options->folder, "Folder for the results, made when missing")
        ->type_name("FOLDER")
        ->required();
    addEngine(*command, *options);
    command->add_flag("--exports", options->request.keepsExports,
                      "Write the exports of each point too, to FOLDER/points/NUMBER");
    addRestartChoice(*command, options->restart, "Throw away what a sweep left in the folder, and begin anew");
    command->callback([options, &exitStatus] {
        options->request.combination = options->goTogether ? Combination::together : Combination::grid;
        exitStatus = sweep(*options);
    });
}

void addSweepPointCommand(CLI::App& program, int& exitStatus)
{
    auto options = std::make_shared<PointOptions>();
    CLI::App* command = program.add_subcommand("sweep-point", "Carry out one point of a sweep")->group("");
    command->add_option("FOLDER", options->folder)->required();
    command->add_option("POINT", options->point)->required();
    command->add_option("--threads", options->threads)->check(CLI::Range(1U, 1024U));
    command->callback([options, &exitStatus] { exitStatus = sweepPoint(*options); });
}

} // namespace knead
