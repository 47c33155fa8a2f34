#include "core/task/parallel_progress.h"

#include <atomic>
#include <thread>

namespace knead {

void forEachBlock(std::size_t count, std::size_t blockSize, TaskControl& control, std::string_view stage,
                  const std::function<void(std::size_t begin, std::size_t end)>& body)
{
    control.throwIfCancelled();
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<std::size_t> done = 0;
    forEachBlock(count, blockSize, [&](std::size_t begin, std::size_t end) {
        body(begin, end);
        done += end - begin;
        if (std::this_thread::get_id() != caller)
            return;
        control.throwIfCancelled();
        control.report(static_cast<double>(done.load()) / static_cast<double>(count), stage);
    });
    control.throwIfCancelled();
    control.report(1, stage);
}

} // namespace knead
