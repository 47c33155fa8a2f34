#include "core/vicinity/uniform_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace knead {

namespace {

// 21 bits per axis. Cells further out share the border cell: their contents are tested exactly anyway.
constexpr std::int64_t farthestCell = (1 << 21) - 3;

// Cells are this much wider than two spheres: more than rounding shifts the border of the farthest cell. Otherwise two
// spheres a hair closer than the width of a cell could be numbered two cells apart, and never be tested.
constexpr double roundingSlack = 1 + 1e-8;

std::uint64_t keyOf(std::int64_t x, std::int64_t y, std::int64_t z)
{
    // Sums, not bit sets: a key plus the key of a (possibly negative) step is the key of the neighbor.
    return (static_cast<std::uint64_t>(z) << 42U) + (static_cast<std::uint64_t>(y) << 21U) +
           static_cast<std::uint64_t>(x);
}

/// Which octave of radius a sphere belongs to; points have one of their own.
int octaveOf(double radius)
{
    return radius > 0 ? std::ilogb(radius) : std::numeric_limits<int>::min();
}

/// Sorts pairs by counting on the first index, then within each of its few partners.
void sortPairs(std::vector<VicinityPair>& pairs, std::size_t spheres)
{
    std::vector<std::uint32_t> first(spheres + 1, 0);
    for (const VicinityPair& pair : pairs)
        ++first[pair.first + 1];
    for (std::size_t s = 0; s < spheres; ++s)
        first[s + 1] += first[s];
    std::vector<VicinityPair> sorted(pairs.size());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (const VicinityPair& pair : pairs)
        sorted[next[pair.first]++] = pair;
    for (std::size_t s = 0; s < spheres; ++s)
        std::sort(sorted.begin() + first[s], sorted.begin() + first[s + 1]);
    pairs.swap(sorted);
}

} // namespace

UniformGrid::Cell UniformGrid::Level::cellOf(const Vec3& place) const
{
    Cell cell;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const double steps = std::floor((place[axis] - origin[axis]) / cellSize);
        // From 1, so that a neighbor's key never borrows from the next axis.
        cell[static_cast<std::size_t>(axis)] =
            1 + static_cast<std::int64_t>(std::clamp(steps, 0.0, static_cast<double>(farthestCell)));
    }
    return cell;
}

void UniformGrid::build(std::span<const VicinitySphere> spheres, double margin)
{
    m_spheres.assign(spheres.begin(), spheres.end());
    m_margin = margin;
    m_statistics = {};
    std::map<int, std::vector<std::uint32_t>> octaves;
    for (std::uint32_t i = 0; i < m_spheres.size(); ++i)
        octaves[octaveOf(m_spheres[i].radius)].push_back(i);
    m_levels.clear();
    for (const auto& [octave, members] : octaves) {
        Level level;
        Box box;
        for (const std::uint32_t s : members) {
            level.largestRadius = std::max(level.largestRadius, m_spheres[s].radius);
            box.extend(m_spheres[s].center);
        }
        level.origin = box.min();
        // Cells no finer than the key can number; points without a margin would have none at all.
        const double finest = box.sizes().maxCoeff() / static_cast<double>(farthestCell);
        level.cellSize = std::max({roundingSlack * (2 * level.largestRadius + margin),
                                   std::isfinite(finest) ? finest : 0.0, std::numeric_limits<double>::min()});
        level.entries.reserve(members.size());
        for (const std::uint32_t s : members) {
            const Cell cell = level.cellOf(m_spheres[s].center);
            level.entries.push_back({keyOf(cell[0], cell[1], cell[2]), s});
        }
        std::sort(level.entries.begin(), level.entries.end(),
                  [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.sphere < b.sphere; });
        m_levels.push_back(std::move(level));
    }
}

void UniformGrid::test(std::uint32_t a, std::uint32_t b, std::vector<VicinityPair>& found)
{
    ++m_statistics.sphereTests;
    if (closerThan(m_spheres[a], m_spheres[b], m_margin))
        found.push_back({std::min(a, b), std::max(a, b)});
}

void UniformGrid::findWithin(const Level& level, std::vector<VicinityPair>& found)
{
    // Half of the neighboring rows; the other half finds these pairs from the other side. Keys ascend, so the place
    // where each neighboring row begins only moves forward.
    constexpr std::array<std::array<int, 2>, 4> rows{{{1, 0}, {-1, 1}, {0, 1}, {1, 1}}}; // (y, z)
    std::array<std::size_t, 4> cursor{};
    const std::vector<Entry>& entries = level.entries;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::uint64_t key = entries[i].key;
        for (std::size_t j = i + 1; j < entries.size() && entries[j].key <= key + 1; ++j)
            test(entries[i].sphere, entries[j].sphere, found);
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const std::uint64_t middle = key + keyOf(0, rows[r][0], rows[r][1]);
            while (cursor[r] < entries.size() && entries[cursor[r]].key < middle - 1)
                ++cursor[r];
            for (std::size_t j = cursor[r]; j < entries.size() && entries[j].key <= middle + 1; ++j)
                test(entries[i].sphere, entries[j].sphere, found);
        }
    }
}

void UniformGrid::findAcross(const Level& small, const Level& large, std::vector<VicinityPair>& found)
{
    const auto before = [](const Entry& entry, std::uint64_t key) { return entry.key < key; };
    const std::vector<Entry>& entries = large.entries;
    for (const Entry& entry : small.entries) {
        // A small sphere reaches at most one cell of the large ones to either side.
        const VicinitySphere& sphere = m_spheres[entry.sphere];
        const Vec3 reach = Vec3::Constant(sphere.radius + large.largestRadius + m_margin);
        const Cell low = large.cellOf(sphere.center - reach);
        const Cell high = large.cellOf(sphere.center + reach);
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
            for (std::int64_t y = low[1]; y <= high[1]; ++y) {
                const std::uint64_t last = keyOf(high[0], y, z);
                for (auto j = std::lower_bound(entries.begin(), entries.end(), keyOf(low[0], y, z), before);
                     j != entries.end() && j->key <= last; ++j)
                    test(entry.sphere, j->sphere, found);
            }
    }
}

std::vector<VicinityPair> UniformGrid::pairs()
{
    std::vector<VicinityPair> found;
    m_statistics.sphereTests = 0;
    for (std::size_t level = 0; level < m_levels.size(); ++level) {
        findWithin(m_levels[level], found);
        for (std::size_t larger = level + 1; larger < m_levels.size(); ++larger)
            findAcross(m_levels[level], m_levels[larger], found);
    }
    sortPairs(found, m_spheres.size());
    return found;
}

std::vector<std::uint32_t> UniformGrid::inBox(const Box& box) const
{
    std::vector<std::uint32_t> found;
    for (const Level& level : m_levels) {
        const Cell low = level.cellOf(box.min());
        const Cell high = level.cellOf(box.max());
        const double rows = static_cast<double>(high[1] - low[1] + 1) * static_cast<double>(high[2] - low[2] + 1);
        const auto keepInside = [&](auto first, auto last) {
            for (; first != last; ++first)
                if (box.contains(m_spheres[first->sphere].center))
                    found.push_back(first->sphere);
        };
        if (rows > static_cast<double>(level.entries.size())) {
            keepInside(level.entries.begin(), level.entries.end());
            continue;
        }
        const auto before = [](const Entry& entry, std::uint64_t key) { return entry.key < key; };
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
            for (std::int64_t y = low[1]; y <= high[1]; ++y) {
                const auto first =
                    std::lower_bound(level.entries.begin(), level.entries.end(), keyOf(low[0], y, z), before);
                const auto last = std::lower_bound(first, level.entries.end(), keyOf(high[0], y, z) + 1, before);
                keepInside(first, last);
            }
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace knead
