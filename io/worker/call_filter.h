#pragma once

namespace knead {

/// Whether the running kernel filters system calls for its processes, and this program knows the numbers of the machine's calls
/// (x86-64 and 64-bit ARM).
bool canFilterCalls();

/// Takes from the process, with all threads that it has and will have, what no reader of files needs: for good. Refused with EPERM:
/// sockets, other programs and processes, files opened to be written, removed or renamed, mounts, what looks into other processes or
/// sends them signals, keys, io_uring, BPF, performance counters, clocks, modules, shared memory and queues. With ENOSYS: newer calls
/// that cannot be looked into, so that the C library takes the older ones. A call by the numbers of another machine ends the process.
/// The process has said before that it wants no new privileges.
/// @return false when the kernel cannot
bool filterCalls();

} // namespace knead
