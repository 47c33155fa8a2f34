#include "ui/document/stall_watch.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double stretch = 4; // that is looked at [s]
constexpr double slowRatio = 0.01;

} // namespace

bool StallWatch::look(const Pace& now, double speed)
{
    if (!m_appearance.empty() && now.simulated < m_appearance.back().simulated) // time began anew
        m_appearance.clear();
    m_appearance.push_back(now);
    while (m_appearance.size() > 2 && now.wall - m_appearance[1].wall >= stretch)
        m_appearance.pop_front();
    if (now.wall - m_appearance.front().wall < stretch)
        return false;
    const Stall passed = stall();
    const bool isSlow = passed.simulated < slowRatio * std::min(1.0, speed) * passed.wall;
    const bool isNew = isSlow && !m_isSaid;
    m_isSaid = isSlow;
    return isNew;
}

StallWatch::Stall StallWatch::stall() const
{
    if (m_appearance.empty())
        return {};
    return {.wall = m_appearance.back().wall - m_appearance.front().wall,
            .simulated = m_appearance.back().simulated - m_appearance.front().simulated};
}

void StallWatch::stop()
{
    m_appearance.clear();
}

} // namespace knead
