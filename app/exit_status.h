#pragma once

namespace knead {

/// Exit statuses of the program, the same for every sub-command.
namespace exit_status {
constexpr int done = 0;
constexpr int failed = 1;        ///< the work failed: an unhealthy simulation, a file that cannot be written
constexpr int wrongUse = 2;      ///< wrong use, or input that cannot be read
constexpr int interrupted = 130; ///< Ctrl+C, as shells expect it
} // namespace exit_status

} // namespace knead
