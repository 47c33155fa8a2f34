#include "core/vicinity/brute_force.h"

namespace knead {

const PairBlocks& BruteForce::findPairs(std::span<const VicinitySphere> spheres, double margin)
{
    m_pairs.clear();
    PairBlock& found = m_pairs[m_pairs.append(1)];
    for (std::uint32_t i = 0; i < spheres.size(); ++i)
        for (std::uint32_t j = i + 1; j < spheres.size(); ++j)
            if (closerThan(spheres[i], spheres[j], margin)) {
                *found.room(1) = {i, j};
                found.wrote(1);
            }
    const std::uint64_t count = spheres.size();
    m_statistics.sphereTests = count < 2 ? 0 : count * (count - 1) / 2;
    return m_pairs;
}

} // namespace knead
