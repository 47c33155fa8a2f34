#include "core/vicinity/brute_force.h"

namespace knead {

void BruteForce::build(std::span<const VicinitySphere> spheres, double margin)
{
    m_spheres.assign(spheres.begin(), spheres.end());
    m_margin = margin;
    m_statistics = {};
}

const std::vector<VicinityPair>& BruteForce::pairs()
{
    m_pairs.clear();
    for (std::uint32_t i = 0; i < m_spheres.size(); ++i)
        for (std::uint32_t j = i + 1; j < m_spheres.size(); ++j)
            if (closerThan(m_spheres[i], m_spheres[j], m_margin))
                m_pairs.push_back({i, j});
    const std::uint64_t count = m_spheres.size();
    m_statistics.sphereTests = count < 2 ? 0 : count * (count - 1) / 2;
    return m_pairs;
}

} // namespace knead
