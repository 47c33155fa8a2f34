#pragma once

#include "core/model/import_options.h"
#include "io/worker/child_process.h"

#include <string>
#include <vector>

namespace knead {

enum class ReadingTask { import, preview };

/// What a process that reads a file is asked for.
struct ReadingRequest {
    ReadingTask task = ReadingTask::import;
    std::string path;
    ImportOptions options;
    OwnLimits limits;
};

/// The arguments of a program that calls runImportWorker(), its name first.
std::vector<std::string> argumentsFor(const ReadingRequest& request);

/// Whether a program was started with argumentsFor() and should do nothing else.
bool isImportWorker(int argc, char** argv);

/// Reads the file of the request and leaves a model, a preview, or the reason why there is none, in the file that
/// child_descriptors::result is; stages go through child_descriptors::lines. Crashes when the CAD reader does: that is what
/// this process is for.
/// @return the exit status
int runImportWorker(int argc, char** argv);

/// A stage as it goes through the pipe, and back.
std::string stageLine(double fraction, std::string_view stage);
bool readStageLine(std::string_view line, double& fraction, std::string& stage);

} // namespace knead
