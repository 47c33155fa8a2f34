#include "io/worker/worker_process.h"

#include "core/message/message.h"
#include "io/worker/child_process.h"
#include "io/worker/confinement.h"
#include "io/worker/model_file.h"

#include <Standard_OutOfMemory.hxx>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>

#include <unistd.h>

namespace knead {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds interval{20};

/// @return false when the disk takes no more, or nobody listens
bool writeAll(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t count = write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

/// Tells the parent of every new stage, and of progress within one now and then.
class PipeControl final : public TaskControl {
public:
    void report(double fraction, std::string_view stage) override
    {
        const Clock::time_point now = Clock::now();
        if (stage == m_stage && now < m_next)
            return;
        m_stage = stage;
        m_next = now + interval;
        writeAll(child_descriptors::lines, stageLine(fraction, stage));
    }
    bool isCancelled() const override { return false; } // the parent ends this process

private:
    std::string m_stage;
    Clock::time_point m_next{};
};

/// Written before work begins, since there may be no memory left for it later.
std::string& outOfMemoryBytes()
{
    static std::string bytes;
    return bytes;
}

/// The CAD libraries lack memory in places that no exception may leave: that is no crash.
[[noreturn]] void endTerminated()
{
    static std::atomic_flag isEnding; // by a thread: what several write is no sentence
    while (isEnding.test_and_set())
        pause();
    try {
        if (const std::exception_ptr exception = std::current_exception())
            std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
        writeAll(child_descriptors::result, outOfMemoryBytes());
        _exit(0);
    } catch (const Standard_OutOfMemory&) {
        writeAll(child_descriptors::result, outOfMemoryBytes());
        _exit(0);
    } catch (...) {
    }
    std::abort();
}

std::string bytesOf(const std::function<std::string(TaskControl&)>& work)
{
    PipeControl control;
    try {
        return work(control);
    } catch (const std::bad_alloc&) {
        return outOfMemoryBytes();
    } catch (const std::exception& error) {
        return failureToBytes(messageOf(error));
    }
}

/// Makes the result file as if nothing had been written into it.
bool emptyResult()
{
    return ftruncate(child_descriptors::result, 0) == 0 && lseek(child_descriptors::result, 0, SEEK_SET) == 0;
}

} // namespace

void serveParent(const ServedWork& served)
{
    limitOwnProcess(served.limits);
    confineOwnProcess(served.readable);
    outOfMemoryBytes() = failureToBytes(Message::verbatim("%1: %2").with(served.subject, served.outOfMemory));
    std::set_terminate(endTerminated);
    const std::string bytes = bytesOf(served.work);
    if (!emptyResult() || !writeAll(child_descriptors::result, bytes)) {
        const std::string reason = std::generic_category().message(errno);
        if (emptyResult())
            writeAll(child_descriptors::result,
                     failureToBytes(Message("File", "%1: the folder for temporary files takes no more (%2); make room "
                                                    "there, or set TMPDIR to another folder.")
                                        .with(served.subject, reason)));
    }
    _exit(0); // the work is done; the CAD libraries may fall over while they tidy up
}

std::string requestOfParent()
{
    std::string bytes;
    std::array<char, 65536> block{};
    for (off_t place = 0;;) {
        const ssize_t count = pread(child_descriptors::result, block.data(), block.size(), place);
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            throw Problem(Message("Export", "What to write could not be handed over; try again."));
        if (count == 0)
            return bytes;
        bytes.append(block.data(), static_cast<std::size_t>(count));
        place += count;
    }
}

std::string stageLine(double fraction, std::string_view stage)
{
    return std::to_string(static_cast<int>(std::lround(1e6 * fraction))) + " " + std::string(stage) + "\n";
}

bool readStageLine(std::string_view line, double& fraction, std::string& stage)
{
    int millionths = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), millionths);
    if (error != std::errc() || end == line.data() + line.size() || *end != ' ' || millionths < 0 ||
        millionths > 1'000'000)
        return false;
    fraction = 1e-6 * millionths;
    stage = line.substr(static_cast<std::size_t>(end - line.data()) + 1);
    return true;
}

} // namespace knead
