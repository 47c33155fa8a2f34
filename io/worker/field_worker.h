#pragma once

#include "core/model/field_file.h"
#include "io/worker/own_process.h"

#include <string>
#include <vector>

namespace knead {

/// What a process that reads a field or the nodes of a mesh is asked for.
struct FieldReadingRequest {
    std::string path;
    FieldChoice choice; ///< of a mesh only the unit counts
    bool isForMesh = false;
    OwnLimits limits{};
    bool namesOthers = false; ///< see readableFor()
};

/// The arguments of a program that calls runFieldWorker(), its name first.
std::vector<std::string> argumentsForField(const FieldReadingRequest& request);

/// Whether a program was started with argumentsForField() and should do nothing else.
bool isFieldWorker(int argc, char** argv);

/// Reads the file of the request and leaves a field, a mesh, or the reason why there is none: see serveParent().
[[noreturn]] int runFieldWorker(int argc, char** argv);

} // namespace knead
