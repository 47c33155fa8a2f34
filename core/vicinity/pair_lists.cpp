#include "core/vicinity/pair_lists.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace knead {

namespace {

/// Writes the pairs of a sphere with some partners, sorted.
void writePairs(std::uint32_t sphere, std::span<const std::int32_t> partners, const sphere_kernels::Kernels& kernels,
                VicinityPair* pairs)
{
    static_assert(sizeof(VicinityPair) == 2 * sizeof(std::uint32_t));
    if (partners.size() <= sphere_kernels::few) {
        kernels.sortBehind(sphere, partners.data(), partners.size(), &pairs->first);
        return;
    }
    for (std::size_t i = 0; i < partners.size(); ++i)
        pairs[i] = {sphere, static_cast<std::uint32_t>(partners[i])};
    std::sort(pairs, pairs + partners.size());
}

} // namespace

std::int32_t* PairList::room(std::size_t more)
{
    if (used + more > partners.size())
        partners.resize(2 * (used + more));
    return partners.data() + used;
}

void PairList::clear()
{
    stretches.clear();
    used = 0;
    sphereTests = 0;
}

void PairLists::clear()
{
    m_count = 0;
}

std::size_t PairLists::append(std::size_t count)
{
    const std::size_t first = m_count;
    m_count += count;
    if (m_lists.size() < m_count)
        m_lists.resize(m_count);
    for (std::size_t list = first; list < m_count; ++list)
        m_lists[list].clear();
    return first;
}

std::uint64_t PairLists::sphereTests() const
{
    return std::accumulate(m_lists.begin(), m_lists.begin() + static_cast<std::ptrdiff_t>(m_count), std::uint64_t{0},
                           [](std::uint64_t sum, const PairList& list) { return sum + list.sphereTests; });
}

void PairLists::sort(std::size_t spheres, const sphere_kernels::Kernels& kernels, std::vector<VicinityPair>& pairs)
{
    m_begin.assign(spheres + 1, 0);
    bool split = false;
    for (std::size_t list = 0; list < m_count; ++list)
        for (const PairList::Stretch& stretch : m_lists[list].stretches) {
            split = split || m_begin[stretch.first + 1] > 0;
            m_begin[stretch.first + 1] += stretch.count;
        }
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    pairs.resize(m_begin.back());
    forEachBlock(m_count, 1, [&](std::size_t list, std::size_t) {
        const std::int32_t* partner = m_lists[list].partners.data();
        for (const PairList::Stretch& stretch : m_lists[list].stretches) {
            if (isWhole(stretch))
                writePairs(stretch.first, {partner, stretch.count}, kernels, pairs.data() + m_begin[stretch.first]);
            partner += stretch.count;
        }
    });
    if (split)
        joinStretches(pairs);
}

/// The pairs of those spheres whose partners are in several stretches.
void PairLists::joinStretches(std::vector<VicinityPair>& pairs)
{
    m_next.assign(m_begin.begin(), m_begin.end() - 1);
    for (std::size_t list = 0; list < m_count; ++list) {
        const std::int32_t* partner = m_lists[list].partners.data();
        for (const PairList::Stretch& stretch : m_lists[list].stretches) {
            if (!isWhole(stretch))
                for (std::uint32_t i = 0; i < stretch.count; ++i)
                    pairs[m_next[stretch.first]++] = {stretch.first, static_cast<std::uint32_t>(partner[i])};
            partner += stretch.count;
        }
    }
    forEachBlock(m_next.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t sphere = begin; sphere < end; ++sphere)
            std::sort(pairs.data() + m_begin[sphere], pairs.data() + m_next[sphere]);
    });
}

} // namespace knead
