#pragma once

#include "core/message/message.h"
#include "core/task/task_control.h"
#include "io/worker/child_process.h"

#include <functional>
#include <string>
#include <string_view>

namespace knead {

/// What a process started by another one does with its life: limits itself, works, and leaves the result, or a sentence why
/// there is none, in the file that child_descriptors::result is; stages of the work go through child_descriptors::lines.
/// Crashes when the work does: that is what the process is for.
/// @param subject what sentences are about: "part.step"
/// @param outOfMemory the sentence, without the subject, for work that wants more memory than it may have
/// @param work its result; what it throws becomes the sentence
[[noreturn]] void serveParent(const OwnLimits& limits, const std::string& subject, const Message& outOfMemory,
                              const std::function<std::string(TaskControl& control)>& work);

/// All that the parent left in the result file before it started this process.
/// @throws Problem
std::string requestOfParent();

/// A stage as it goes through the pipe, and back.
std::string stageLine(double fraction, std::string_view stage);
bool readStageLine(std::string_view line, double& fraction, std::string& stage);

} // namespace knead
