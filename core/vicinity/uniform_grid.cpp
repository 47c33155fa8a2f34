#include "core/vicinity/uniform_grid.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace knead {

namespace {

// Cells per axis whose keys fit 64 bits. Spheres further out share the border cell: its contents are tested exactly anyway.
constexpr double farthestCell = (1 << 21) - 3;

// Cells are this much wider than two spheres: more than rounding shifts the border of the farthest cell. Otherwise two
// spheres a hair closer than the width of a cell could be numbered two cells apart, and never be tested.
constexpr double roundingSlack = 1 + 1e-8;

constexpr std::size_t blockSize = 2048; // of spheres

/// Which octave of radius a sphere belongs to; points have one of their own.
int octaveOf(double radius)
{
    return radius > 0 ? std::ilogb(radius) : std::numeric_limits<int>::min();
}

/// A loose sphere is a group of its own, below all others.
std::int32_t groupOf(const VicinitySphere& sphere, std::uint32_t index)
{
    return sphere.loose ? -1 - static_cast<std::int32_t>(index) : static_cast<std::int32_t>(sphere.group);
}

} // namespace

void UniformGrid::SphereArrays::resize(std::size_t count)
{
    for (std::vector<float>& values : place)
        values.resize(count + sphere_kernels::padding);
    for (std::vector<std::int32_t>& values : number)
        values.resize(count + sphere_kernels::padding);
}

sphere_kernels::Spheres UniformGrid::SphereArrays::view() const
{
    return {place[0].data(),  place[1].data(),  place[2].data(),  place[3].data(), number[0].data(),
            number[1].data(), number[2].data(), number[3].data(), number[4].data()};
}

/// For partners with a higher index.
sphere_kernels::Query UniformGrid::SphereArrays::query(std::size_t i) const
{
    return {.x = place[0][i],
            .y = place[1][i],
            .z = place[2][i],
            .reach = place[3][i],
            .group = number[0][i],
            .u = number[1][i],
            .v = number[2][i],
            .w = number[3][i],
            .after = number[4][i]};
}

std::uint64_t UniformGrid::Level::keyOf(const Vec3& place) const
{
    const Vec3 cells = inCells(place);
    std::uint64_t key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double cell = cells[static_cast<Eigen::Index>(axis)];
        const double inside = cell > 0 ? std::min(cell, lastCell[axis]) : 0;
        key += (1 + static_cast<std::uint64_t>(inside)) * step[axis];
    }
    return key;
}

/// Nine rows of three cells. Keys ascend, so that the places where the rows begin and end only move forward.
class UniformGrid::Surroundings {
public:
    Surroundings(const Level& level, std::uint64_t key)
        : m_level(level)
    {
        for (std::size_t row = 0; row < 9; ++row) {
            m_offset[row] = (row % 3) * level.step[1] + (row / 3) * level.step[2];
            const auto first = std::lower_bound(level.cellKey.begin(), level.cellKey.end(), firstOf(row, key));
            m_begin[row] = m_end[row] = static_cast<std::size_t>(first - level.cellKey.begin());
        }
        moveTo(key);
    }

    void moveTo(std::uint64_t key)
    {
        if (key == m_key)
            return;
        m_key = key;
        m_count = 0;
        m_spheres = 0;
        const std::vector<std::uint64_t>& keys = m_level.cellKey;
        for (std::size_t row = 0; row < 9; ++row) {
            const std::uint64_t first = firstOf(row, key);
            while (m_begin[row] < keys.size() && keys[m_begin[row]] < first)
                ++m_begin[row];
            m_end[row] = std::max(m_end[row], m_begin[row]);
            while (m_end[row] < keys.size() && keys[m_end[row]] <= first + 2)
                ++m_end[row];
            if (m_begin[row] == m_end[row])
                continue;
            m_stretches[m_count] = {m_level.cellBegin[m_begin[row]], m_level.cellBegin[m_end[row]]};
            m_spheres += m_stretches[m_count].end - m_stretches[m_count].begin;
            ++m_count;
        }
    }

    std::span<const sphere_kernels::Stretch> stretches() const { return {m_stretches.data(), m_count}; }
    std::size_t spheres() const { return m_spheres; }

private:
    /// Key of the first cell of a row.
    std::uint64_t firstOf(std::size_t row, std::uint64_t key) const
    {
        return key + m_offset[row] - m_level.step[0] - m_level.step[1] - m_level.step[2];
    }

    const Level& m_level;
    std::uint64_t m_key = std::numeric_limits<std::uint64_t>::max();
    std::array<std::uint64_t, 9> m_offset{};
    std::array<std::size_t, 9> m_begin{}; // of cells
    std::array<std::size_t, 9> m_end{};
    std::array<sphere_kernels::Stretch, 9> m_stretches{};
    std::size_t m_count = 0;
    std::size_t m_spheres = 0;
};

UniformGrid::UniformGrid(const sphere_kernels::Kernels& kernels)
    : m_kernels(kernels)
{
}

void UniformGrid::build(std::span<const VicinitySphere> spheres, double margin)
{
    m_spheres.assign(spheres.begin(), spheres.end());
    m_margin = margin;
    m_statistics = {};
    sortByRadius();
    for (Level& level : m_levels) {
        layOut(level);
        sortIn(level);
    }
}

/// Gives each sphere to the level of its radius. Levels keep their memory.
void UniformGrid::sortByRadius()
{
    std::map<int, Level*> levels; // by octave
    for (const VicinitySphere& sphere : m_spheres)
        if (levels.empty() || octaveOf(sphere.radius) != levels.begin()->first)
            levels.emplace(octaveOf(sphere.radius), nullptr);
    m_levels.resize(levels.size());
    auto place = m_levels.begin();
    for (auto& [octave, level] : levels) {
        level = &*place++;
        level->members.clear();
    }
    for (std::uint32_t i = 0; i < m_spheres.size(); ++i)
        (levels.size() == 1 ? levels.begin()->second : levels[octaveOf(m_spheres[i].radius)])->members.push_back(i);
}

/// The place and size of a level's cells.
void UniformGrid::layOut(Level& level) const
{
    Box box;
    level.largestRadius = 0;
    for (const std::uint32_t s : level.members) {
        level.largestRadius = std::max(level.largestRadius, m_spheres[s].radius);
        box.extend(m_spheres[s].center);
    }
    level.origin = box.min();
    // Cells no finer than the key can number; points without a margin would have none at all.
    const double finest = box.sizes().maxCoeff() / farthestCell;
    level.cellsPerMetre = 1 / std::max({roundingSlack * (2 * level.largestRadius + m_margin),
                                        std::isfinite(finest) ? finest : 0.0, std::numeric_limits<double>::min()});
    const Vec3 sides = level.inCells(box.max());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        level.lastCell[axis] = std::min(std::floor(sides[static_cast<Eigen::Index>(axis)]), farthestCell);
        if (axis < 2) // one more cell on either side
            level.step[axis + 1] = level.step[axis] * (3 + static_cast<std::uint64_t>(level.lastCell[axis]));
    }
    // Places are rounded to 2^-24 of themselves, on both sides of a difference; reaches and sums are about 1.
    level.doubt = 1e-6 + 4 * std::ldexp(sides.maxCoeff(), -24);
}

void UniformGrid::sortIn(Level& level) const
{
    const std::vector<std::uint32_t>& members = level.members;
    level.entries.resize(members.size());
    forEachBlock(members.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            level.entries[i] = {level.keyOf(m_spheres[members[i]].center), members[i]};
    });
    sortByCell(level.entries, level.largestKey());
    level.cellKey.clear();
    level.cellBegin.clear();
    for (std::size_t i = 0; i < level.entries.size(); ++i)
        if (i == 0 || level.entries[i].key != level.entries[i - 1].key) {
            level.cellKey.push_back(level.entries[i].key);
            level.cellBegin.push_back(static_cast<std::uint32_t>(i));
        }
    level.cellBegin.push_back(static_cast<std::uint32_t>(level.entries.size()));
    level.spheres.resize(level.entries.size());
    forEachBlock(level.entries.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const sphere_kernels::Query sphere = queryOf(level, level.entries[i].sphere);
            level.spheres.place[0][i] = sphere.x;
            level.spheres.place[1][i] = sphere.y;
            level.spheres.place[2][i] = sphere.z;
            level.spheres.place[3][i] = sphere.reach;
            level.spheres.number[0][i] = sphere.group;
            level.spheres.number[1][i] = sphere.u;
            level.spheres.number[2][i] = sphere.v;
            level.spheres.number[3][i] = sphere.w;
            level.spheres.number[4][i] = static_cast<std::int32_t>(level.entries[i].sphere);
        }
    });
}

sphere_kernels::Query UniformGrid::queryOf(const Level& level, std::uint32_t index) const
{
    const VicinitySphere& sphere = m_spheres[index];
    const Eigen::Vector3f place = level.inCells(sphere.center).cast<float>();
    return {.x = place.x(),
            .y = place.y(),
            .z = place.z(),
            .reach = static_cast<float>((sphere.radius + 0.5 * m_margin) * level.cellsPerMetre),
            .group = groupOf(sphere, index),
            .u = sphere.node[0],
            .v = sphere.node[1],
            .w = sphere.node[2],
            .after = -1};
}

/// Finds who is close to the spheres of a level: each sphere of a block among its own cell and those around it.
/// @param ofThisLevel the queries are the level's own spheres, and each pair is found from its lower one
void UniformGrid::findPartners(const Level& level, std::span<const CellEntry> queries, bool ofThisLevel,
                               PairList& found) const
{
    std::vector<std::int32_t> doubtful;
    const sphere_kernels::Spheres spheres = level.spheres.view();
    const auto doubt = static_cast<float>(level.doubt);
    Surroundings around(level, queries.front().key);
    for (const CellEntry& entry : queries) {
        around.moveTo(entry.key);
        if (around.spheres() == 0)
            continue;
        found.sphereTests += around.spheres();
        const std::size_t most = around.spheres() + sphere_kernels::padding;
        if (doubtful.size() < most)
            doubtful.resize(most);
        const sphere_kernels::Query query =
            ofThisLevel ? level.spheres.query(static_cast<std::size_t>(&entry - level.entries.data()))
                        : queryOf(level, entry.sphere);
        sphere_kernels::Partners partners{found.room(2 * most), 0, doubtful.data(), 0};
        m_kernels.findPartners(spheres, query, around.stretches().data(), around.stretches().size(), doubt, partners);
        for (std::size_t i = 0; i < partners.doubtfulCount; ++i)
            if (closerThan(m_spheres[entry.sphere], m_spheres[static_cast<std::size_t>(doubtful[i])], m_margin))
                partners.certain[partners.certainCount++] = doubtful[i];
        if (!ofThisLevel)
            for (std::size_t i = 0; i < partners.certainCount; ++i) {
                // The lower one comes first.
                const auto other = static_cast<std::uint32_t>(partners.certain[i]);
                partners.certain[i] = static_cast<std::int32_t>(std::max(entry.sphere, other));
                found.stretches.push_back({std::min(entry.sphere, other), 1});
            }
        else if (partners.certainCount > 0)
            found.stretches.push_back({entry.sphere, static_cast<std::uint32_t>(partners.certainCount)});
        found.used += partners.certainCount;
    }
}

void UniformGrid::findPartners(const Level& level, std::span<const CellEntry> queries, bool ofThisLevel)
{
    const std::size_t list = m_found.append((queries.size() + blockSize - 1) / blockSize);
    forEachBlock(queries.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        findPartners(level, queries.subspan(begin, end - begin), ofThisLevel, m_found[list + begin / blockSize]);
    });
}

const std::vector<VicinityPair>& UniformGrid::pairs()
{
    m_found.clear();
    std::vector<CellEntry> smaller; // than the spheres of a level, sorted into its cells
    for (const Level& level : m_levels) {
        findPartners(level, level.entries, true);
        // A smaller sphere reaches at most one cell of the larger ones to either side.
        forEachBlock(smaller.size(), blockSize, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                smaller[i].key = level.keyOf(m_spheres[smaller[i].sphere].center);
        });
        sortByCell(smaller, level.largestKey());
        findPartners(level, smaller, false);
        smaller.insert(smaller.end(), level.entries.begin(), level.entries.end());
    }
    m_statistics.sphereTests = m_found.sphereTests();
    m_found.sort(m_spheres.size(), m_kernels, m_pairs);
    return m_pairs;
}

} // namespace knead
