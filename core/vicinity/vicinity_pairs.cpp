#include "core/vicinity/vicinity_pairs.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <numeric>

namespace knead {

VicinityPair* PairBlock::room(std::size_t more)
{
    if (m_count + more > m_room.size())
        m_room.resize(2 * (m_count + more));
    return m_room.data() + m_count;
}

std::size_t PairBlocks::append(std::size_t count)
{
    const std::size_t first = m_count;
    m_count += count;
    if (m_blocks.size() < m_count)
        m_blocks.resize(m_count);
    for (std::size_t block = first; block < m_count; ++block)
        m_blocks[block].clear();
    return first;
}

std::size_t PairBlocks::pairCount() const
{
    return std::accumulate(blocks().begin(), blocks().end(), std::size_t{0},
                           [](std::size_t sum, const PairBlock& block) { return sum + block.pairs().size(); });
}

std::vector<VicinityPair> PairBlocks::sorted(std::size_t spheres) const
{
    std::vector<VicinityPair> pairs;
    pairs.reserve(pairCount());
    for (const PairBlock& block : blocks())
        pairs.insert(pairs.end(), block.pairs().begin(), block.pairs().end());
    sortPairs(pairs, spheres);
    return pairs;
}

/// By counting on the first spheres, then each one's pairs by themselves.
void sortPairs(std::vector<VicinityPair>& pairs, std::size_t spheres)
{
    std::vector<std::uint32_t> next(spheres + 1, 0); // place of each sphere's next pair
    for (const VicinityPair& pair : pairs)
        ++next[pair.first + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<VicinityPair> ordered(pairs.size());
    for (const VicinityPair& pair : pairs)
        ordered[next[pair.first]++] = pair;
    pairs.swap(ordered);
    forEachBlock(spheres, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t sphere = begin; sphere < end; ++sphere) // each place has moved on to the next sphere's first
            std::sort(pairs.data() + (sphere == 0 ? 0 : next[sphere - 1]), pairs.data() + next[sphere]);
    });
}

} // namespace knead
