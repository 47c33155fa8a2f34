#pragma once

#include "core/model/import_options.h"
#include "io/worker/own_process.h"

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
    bool namesOthers = false; ///< see readableFor()
};

/// The arguments of a program that calls runImportWorker(), its name first.
std::vector<std::string> argumentsFor(const ReadingRequest& request);

/// Whether a program was started with argumentsFor() and should do nothing else.
bool isImportWorker(int argc, char** argv);

/// Reads the file of the request and leaves a model, a preview, or the reason why there is none: see serveParent().
[[noreturn]] int runImportWorker(int argc, char** argv);

} // namespace knead
