#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// A file that has no name and is gone with the last process that holds it: nothing is left behind, whatever happens.
class NamelessFile {
public:
    /// @throws std::runtime_error, in a sentence, when the folder for temporary files takes none
    NamelessFile();
    ~NamelessFile();
    NamelessFile(const NamelessFile&) = delete;
    NamelessFile& operator=(const NamelessFile&) = delete;

    int descriptor() const { return m_descriptor; }

    /// Appends. @throws std::runtime_error, in a sentence, when the folder takes no more
    void write(std::string_view bytes);

    /// All that was written, by whomever. @throws std::runtime_error, in a sentence
    std::string content() const;

private:
    int m_descriptor = -1;
};

/// Where a child finds what it inherits, besides an empty input and outputs that lead nowhere.
namespace child_descriptors {
constexpr int lines = 3;  ///< a pipe for lines of text
constexpr int result = 4; ///< the NamelessFile
} // namespace child_descriptors

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
/// @param arguments the first is the name of the program, by custom
/// @param wallTime [s] the child is ended after
/// @param isCancelled asked about twenty times a second; the child is ended when it says yes
/// @throws std::runtime_error, in a sentence, when the program cannot be started
ChildEnd runChild(const std::string& program, const std::vector<std::string>& arguments, const NamelessFile& result,
                  double wallTime, const std::function<void(std::string_view line)>& onLine,
                  const std::function<bool()>& isCancelled);

/// Limits that a child sets itself before it does anything else.
struct OwnLimits {
    std::uint64_t memory = 0;   ///< of address space [bytes]; 0: none
    unsigned processorTime = 0; ///< [s]; 0: none
};

/// Called by the child: limits itself, leaves no core file, gives way to the window, and ends when its parent ends.
void limitOwnProcess(const OwnLimits& limits);

} // namespace knead
