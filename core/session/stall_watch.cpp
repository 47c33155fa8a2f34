#include "core/session/stall_watch.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double stretch = 4; // that is looked at [s]
constexpr double slowRatio = 0.01;

} // namespace

bool StallWatch::look(const Pace& now, double speed)
{
    if (!m_looks.empty() && now.simulated < m_looks.back().simulated) // time began anew
        m_looks.clear();
    m_looks.push_back(now);
    while (m_looks.size() > 2 && now.wall - m_looks[1].wall >= stretch)
        m_looks.pop_front();
    if (now.wall - m_looks.front().wall < stretch)
        return false;
    const Stall passed = stall();
    const bool isSlow = passed.simulated < slowRatio * std::min(1.0, speed) * passed.wall;
    const bool isNew = isSlow && !m_isSaid;
    m_isSaid = isSlow;
    return isNew;
}

StallWatch::Stall StallWatch::stall() const
{
    if (m_looks.empty())
        return {};
    return {.wall = m_looks.back().wall - m_looks.front().wall,
            .simulated = m_looks.back().simulated - m_looks.front().simulated};
}

void StallWatch::stop()
{
    m_looks.clear();
}

} // namespace knead
