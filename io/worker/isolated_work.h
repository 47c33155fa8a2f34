#pragma once

#include "core/message/message.h"
#include "core/task/task_control.h"
#include "io/worker/child_process.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace knead {

/// Work for a process of its own, and the words for its failures.
struct IsolatedWork {
    std::string program;
    std::vector<std::string> arguments; ///< that make the program call serveParent()
    std::string path;                   ///< the file that it is about
    double processorTime = 0;           ///< [s] that it limits itself to; 0: none
    double wallTime = 0;                ///< [s]; 0: none

    Message worker;       ///< "the reader"
    Message work;         ///< "reading"
    Message outOfTime;    ///< what that means and what to do: "Nothing was imported; the file is damaged ..."
    Message afterFailure; ///< what a crash means and what to do
};

/// The process crashed by itself; the sentence says so.
class WorkerCrashed : public Problem {
public:
    using Problem::Problem;
};

/// Runs a program as serveParent() expects and returns what it left in the file. Cancelling ends it at once.
/// @param file what the program is given, and what it returns
/// @throws Problem: its own, or WorkerCrashed. @throws Cancelled
std::string runIsolated(const IsolatedWork& work, const NamelessFile& file, TaskControl& control);

} // namespace knead
