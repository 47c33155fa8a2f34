#pragma once

#include "core/task/parallel.h"
#include "core/task/task_control.h"

#include <string_view>

namespace knead {

/// forEachBlock with progress and cancellation. The control is used on the calling thread only.
/// @throws Cancelled
void forEachBlock(std::size_t count, std::size_t blockSize, TaskControl& control, std::string_view stage,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

} // namespace knead
