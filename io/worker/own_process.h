#pragma once

#include <cstdint>

namespace knead {

/// Called by the child: it ends when the thread that started it ends.
void endWithParent();

/// Limits that a child sets itself before it does anything else.
struct OwnLimits {
    std::uint64_t memory = 0;   ///< of address space [bytes]; 0: none
    unsigned processorTime = 0; ///< [s]; 0: none
};

/// Called by the child: limits itself, to few open files and no larger ones than its memory, too, and for good; leaves no core file,
/// gives way to the window, and ends when its parent ends.
void limitOwnProcess(const OwnLimits& limits);

} // namespace knead
