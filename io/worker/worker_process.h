#pragma once

#include "core/message/message.h"
#include "core/task/task_control.h"
#include "io/worker/own_process.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// Work of a process that was started for it.
struct ServedWork {
    OwnLimits limits;
    std::vector<std::string> readable; ///< files, and folders with all below them, that the work may read
    std::string subject;               ///< what sentences are about: "part.step"
    Message outOfMemory; ///< the sentence, without the subject, for work that wants more memory than it may have
    std::function<std::string(TaskControl& control)> work; ///< its result; what it throws becomes the sentence
};

/// What a process started by another one does with its life: limits itself, locks itself in (confineOwnProcess()), works, and leaves
/// the result, or a sentence why there is none, in the file that child_descriptors::result is; stages of the work go through
/// child_descriptors::lines. It writes nowhere else.
/// Crashes when the work does: that is what the process is for.
[[noreturn]] void serveParent(const ServedWork& served);

/// All that the parent left in the result file before it started this process.
/// @throws Problem
std::string requestOfParent();

/// A stage as it goes through the pipe, and back.
std::string stageLine(double fraction, std::string_view stage);
bool readStageLine(std::string_view line, double& fraction, std::string& stage);

} // namespace knead
