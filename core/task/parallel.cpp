#include "core/task/parallel.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

namespace knead {

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
    // TBB orders what comes before, within and after the loop, but its library is not instrumented for the thread sanitizer.
    // The two counters say the same in a way that it sees; next to a block's work they cost nothing.
    std::atomic<std::size_t> begun{0};
    std::atomic<std::size_t> done{0};
    begun.store(1, std::memory_order_release);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
        begun.load(std::memory_order_acquire);
        runBlock(block);
        done.fetch_add(1, std::memory_order_release);
    });
    done.load(std::memory_order_acquire);
}

} // namespace knead
