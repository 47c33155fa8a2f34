#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace knead {

/// A job array of Slurm: task t carries out point `base + t`.
struct SlurmJob {
    std::string id; ///< digits, see isJobId()
    std::size_t base = 0;
};

/// What sbatch is to submit.
struct SlurmArray {
    std::string script; ///< path
    std::string folder; ///< for what the tasks print
    std::string name;
    std::size_t base = 0;
    std::vector<std::size_t> tasks;   ///< ascending, not empty
    unsigned throttle = 0;            ///< tasks at a time; 0: as many as there is room for
    unsigned threads = 1;             ///< cores of a task
    std::vector<std::string> options; ///< further ones of sbatch
};

/// Whether a text is the number of a job, as it may stand in commands and names of files: nothing but digits.
bool isJobId(const std::string& text);

/// A word for a shell.
std::string quotedForShell(const std::string& text);

/// "0-3,7,9-12", as sbatch takes them.
std::string rangesOf(const std::vector<std::size_t>& numbers);

/// @throws std::runtime_error, in a sentence, when there is no sbatch here, it refuses, or names no job
SlurmJob submit(const SlurmArray& array);

/// Points whose tasks wait or run. None when Slurm does not answer.
/// @param name of the jobs; others with the same number belong to somebody else
std::optional<std::set<std::size_t>> queuedPoints(const std::vector<SlurmJob>& jobs, const std::string& name);

/// Jobs that were kept in a file; none when there is no such file. What is no job in it is left out.
std::vector<SlurmJob> jobsIn(const std::string& path);

/// @throws Problem when the disk refuses
void keepJobs(const std::string& path, const std::vector<SlurmJob>& jobs);

/// Ends jobs with all their tasks. @return whether Slurm did
bool cancelJobs(const std::vector<SlurmJob>& jobs);

} // namespace knead
