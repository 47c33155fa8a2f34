#pragma once

#include <string>
#include <vector>

namespace knead {

/// Which Landlock the running kernel has: 1 since Linux 5.13, 7 since 6.15; 0: none, or it is switched off.
int landlockVersion();

/// Takes from the calling thread, and from all that it starts, every right to files but reading some: for good. Files that are open
/// already stay so. With newer kernels also TCP, sockets without names in the file system, and signals to other processes.
/// The process has said before that it wants no new privileges.
/// @param readable files, and folders with all below them; those that are not there are left out
/// @return false when the kernel cannot
bool restrictFiles(const std::vector<std::string>& readable);

} // namespace knead
