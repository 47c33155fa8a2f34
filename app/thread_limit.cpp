#include "app/thread_limit.h"

#include <tbb/global_control.h>

namespace knead {

struct ThreadLimit::Control {
    tbb::global_control parallelism;
};

ThreadLimit::ThreadLimit(unsigned threads)
{
    if (threads > 0)
        m_control.reset(new Control{{tbb::global_control::max_allowed_parallelism, threads}});
}

ThreadLimit::~ThreadLimit() = default;

} // namespace knead
