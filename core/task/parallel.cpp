#include "core/task/parallel.h"

#include <algorithm>

#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#else
#include <tbb/parallel_for.h>
#endif

namespace knead {

namespace {

#ifdef __SANITIZE_THREAD__

/// TBB's library is not instrumented, so the thread sanitizer takes its every hand-over for a race. Builds for it run blocks
/// on two plain threads instead, whose order it understands; what it then reports is ours.
void runAll(std::size_t blocks, const std::function<void(std::size_t)>& runBlock)
{
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&] {
        try {
            for (std::size_t block = next++; block < blocks; block = next++)
                runBlock(block);
        } catch (...) {
            const std::lock_guard lock(mutex);
            failure = std::current_exception();
            next = blocks;
        }
    };
    {
        const std::jthread other(work);
        work();
    }
    if (failure)
        std::rethrow_exception(failure);
}

#else

template <typename RunBlock>
void runAll(std::size_t blocks, const RunBlock& runBlock)
{
    tbb::parallel_for(std::size_t{0}, blocks, runBlock);
}

#endif

} // namespace

void forEachBlock(std::size_t count, std::size_t blockSize,
                  const std::function<void(std::size_t begin, std::size_t end)>& body)
{
    const std::size_t blocks = (count + blockSize - 1) / blockSize;
    const auto runBlock = [&](std::size_t block) { body(block * blockSize, std::min(count, (block + 1) * blockSize)); };
    if (blocks <= 2) {
        for (std::size_t block = 0; block < blocks; ++block)
            runBlock(block);
        return;
    }
    runAll(blocks, runBlock);
}

void forEachBlock(std::size_t count, std::size_t blockSize, const TaskControl& control,
                  const std::function<void(std::size_t begin, std::size_t end)>& body)
{
    forEachBlock(count, blockSize, [&](std::size_t begin, std::size_t end) {
        control.throwIfCancelled();
        body(begin, end);
    });
}

} // namespace knead
