#include "io/worker/own_process.h"

#include "io/worker/child_process.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace knead {

namespace {

constexpr rlim_t mostOpenFiles = 256;
constexpr rlim_t moreTasks = 1024; // of all programs of a person while a child works

/// For good: what is limited now cannot be raised again.
/// @param warning how much more than `value` ends the process, where the value itself warns it
void limit(__rlimit_resource_t resource, rlim_t value, rlim_t warning = 0)
{
    rlimit limits{};
    getrlimit(resource, &limits);
    limits.rlim_cur = std::min(value, limits.rlim_cur);
    limits.rlim_max = std::min(value + warning, limits.rlim_max);
    setrlimit(resource, &limits);
}

/// How many more threads and processes there may be than there are on this machine now. Threads are counted per person, not per
/// process.
rlim_t tasksFor(rlim_t more)
{
    std::ifstream load("/proc/loadavg"); // "0.20 0.18 0.12 1/80 11206"
    std::string word;
    for (int i = 0; i < 4; ++i)
        load >> word;
    const std::size_t slash = word.find('/');
    return slash == std::string::npos ? RLIM_INFINITY : std::strtoul(word.c_str() + slash + 1, nullptr, 10) + more;
}

} // namespace

void endWithParent()
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    pollfd parent{.fd = child_descriptors::lines, .events = POLLOUT, .revents = 0};
    if (poll(&parent, 1, 0) > 0 && (parent.revents & POLLERR) != 0) // it ended before the line above
        _exit(1);
}

void limitOwnProcess(const OwnLimits& limits)
{
    endWithParent();
    std::signal(SIGXFSZ, SIG_IGN); // a write that the disk refuses is told by its result
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_NOFILE, mostOpenFiles);
    limit(RLIMIT_NPROC, tasksFor(moreTasks));
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // whose address space is vast
    if (limits.memory > 0)
        limit(RLIMIT_AS, limits.memory);
#endif
    if (limits.memory > 0)
        limit(RLIMIT_FSIZE, limits.memory);
    if (limits.processorTime > 0)
        limit(RLIMIT_CPU, limits.processorTime, 10);
    setpriority(PRIO_PROCESS, 0, 5);
}

} // namespace knead
