#pragma once

// Includes TBB: include this header before any of Qt, whose macro `emit` it would meet.
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace knead {

/// Runs a function whose parallel loops use `threads` threads, more than the machine has cores if need be.
template <typename Function>
auto onThreads(int threads, Function&& function)
{
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute(function);
}

} // namespace knead
