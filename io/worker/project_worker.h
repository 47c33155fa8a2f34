#pragma once

#include "core/message/message.h"
#include "io/worker/own_process.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// What a process that reads a project on trial is asked for.
struct ProjectTrialRequest {
    std::string path;
    bool rescues = false; ///< as rescueProject() reads, else as readProject()
    OwnLimits limits{};
};

/// The arguments of a program that calls runProjectWorker(), its name first.
std::vector<std::string> argumentsForProject(const ProjectTrialRequest& request);

/// Whether a program was started with argumentsForProject() and should do nothing else.
bool isProjectWorker(int argc, char** argv);

/// Reads the project of the request, lets go of it, and leaves what is damaged in it, or that nothing is: see serveParent().
[[noreturn]] int runProjectWorker(int argc, char** argv);

/// What a process that ran runProjectWorker() left: the sentence on what is damaged, none for a project that can be read.
/// @throws std::runtime_error where it left nothing that can be understood
std::optional<Message> damageFromBytes(std::string_view bytes);

} // namespace knead
