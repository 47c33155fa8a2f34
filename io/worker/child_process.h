#pragma once

#include "core/message/message.h"
#include "io/files/nameless_file.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// Where a child finds what it inherits, besides an empty input and its outputs.
namespace child_descriptors {
constexpr int lines = 3;  ///< a pipe for lines of text
constexpr int result = 4; ///< the NamelessFile
} // namespace child_descriptors

/// A program to run as a child.
struct ChildProgram {
    std::string program;                  ///< path, or a name that is looked for in PATH
    std::vector<std::string> arguments;   ///< the first is the name of the program, by custom
    const NamelessFile* result = nullptr; ///< inherited as child_descriptors::result
    const NamelessFile* output = nullptr; ///< takes what the child prints; without it that leads nowhere
    const NamelessFile* errors = nullptr; ///< the same for its messages
    std::optional<std::vector<std::string>> environment{}; ///< "NAME=value" each; none: that of this process
};

/// How a child ended.
struct ChildEnd {
    enum class Kind {
        exited,   ///< number is its exit status
        signaled, ///< number is the signal that ended it
        tooLong,  ///< it was ended at the limit of wall time
        cancelled,
    };
    Kind kind = Kind::exited;
    int number = 0;
};

/// Runs a program to its end and passes on each line that it writes to its pipe. The child has a process group of its own,
/// so that Ctrl+C in a terminal reaches the parent alone, which then cancels. However this function is left, the child is gone.
///
/// @param wallTime [s] the child is ended after
/// @param isCancelled asked about twenty times a second; the child is ended when it says yes
/// @throws Problem, when the program cannot be started
ChildEnd runChild(const ChildProgram& program, double wallTime,
                  const std::function<void(std::string_view line)>& onLine, const std::function<bool()>& isCancelled);

/// Why a signal ends a process, in a few words: "memory access".
Message reasonOfSignal(int signal);

} // namespace knead
