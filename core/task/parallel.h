#pragma once

#include "core/task/task_control.h"

#include <cstddef>
#include <functional>

namespace knead {

/// Calls body(begin, end) for fixed blocks that cover 0..count. Blocks depend on count and size only, never on the number
/// of threads, so a result that is a function of its block has the same bits on any machine. Runs on TBB's threads;
/// a count of up to two blocks stays on the calling thread, where handing work over would cost more than it saves.
void forEachBlock(std::size_t count, std::size_t blockSize,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

/// The same; blocks that have not begun when a person asks to stop do not. @throws Cancelled
void forEachBlock(std::size_t count, std::size_t blockSize, const TaskControl& control,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

} // namespace knead
