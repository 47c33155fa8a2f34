#include "core/vicinity/uniform_grid.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace knead {

namespace {

// Cells per axis whose keys fit 64 bits. Spheres further out share the border cell: its contents are tested exactly anyway.
constexpr double farthestCell = (1 << 21) - 3;

// Cells are this much wider than two spheres: more than rounding shifts the border of the farthest cell. Otherwise two
// spheres a hair closer than the width of a cell could be numbered two cells apart, and never be tested.
constexpr double roundingSlack = 1 + 1e-8;

constexpr std::size_t blockSize = 2048; // of spheres
constexpr std::size_t cellBlock = 1024; // of cells

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
            .index = number[4][i]};
}

std::uint64_t UniformGrid::Level::keyOf(const Vec3& place) const
{
    const Vec3 cells = inCells(place);
    std::uint64_t key = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double cell = cells[static_cast<Eigen::Index>(axis)];
        const double inside = cell > 0 ? std::min(cell, lastCell[axis]) : 0;
        // By way of a signed number, which machines convert at once.
        key += static_cast<std::uint64_t>(1 + static_cast<std::int64_t>(inside)) * step[axis];
    }
    return key;
}

/// Nine rows of three cells. Keys of cells ascend, so that the
/// places where rows begin and end only move forward.
class UniformGrid::Surroundings {
public:
    /// @param onlyBehind leaves out cells with lower keys than the one in the middle, which is then first of the stretches
    Surroundings(const Level& level, std::uint64_t key, bool onlyBehind)
        : m_level(level)
        , m_firstRow(onlyBehind ? 4 : 0)
    {
        for (std::size_t row = m_firstRow; row < 9; ++row) {
            m_offset[row] = (row % 3) * level.step[1] + (row / 3) * level.step[2];
            if (row > 4 || !onlyBehind)
                m_offset[row] -= level.step[0];
            m_cells[row] = row == 4 && onlyBehind ? 2 : 3;
            const auto first = std::lower_bound(level.cellKey.begin(), level.cellKey.end(), firstOf(row, key));
            m_begin[row] = m_end[row] = static_cast<std::size_t>(first - level.cellKey.begin());
        }
    }

    void moveTo(std::uint64_t key)
    {
        m_count = 0;
        m_spheres = 0;
        const std::vector<std::uint64_t>& keys = m_level.cellKey;
        for (std::size_t row = m_firstRow; row < 9; ++row) {
            const std::uint64_t first = firstOf(row, key);
            while (m_begin[row] < keys.size() && keys[m_begin[row]] < first)
                ++m_begin[row];
            m_end[row] = std::max(m_end[row], m_begin[row]);
            while (m_end[row] < keys.size() && keys[m_end[row]] < first + m_cells[row])
                ++m_end[row];
            if (m_begin[row] == m_end[row])
                continue;
            m_stretches[m_count] = {m_level.cellBegin[m_begin[row]], m_level.cellBegin[m_end[row]]};
            m_spheres += m_stretches[m_count].end - m_stretches[m_count].begin;
            ++m_count;
        }
    }

    /// Leaves out the first sphere that is left of the first stretch.
    void dropFirst()
    {
        ++m_stretches[0].begin;
        --m_spheres;
    }

    std::span<const sphere_kernels::Stretch> stretches() const { return {m_stretches.data(), m_count}; }
    std::size_t spheres() const { return m_spheres; }

private:
    /// Key of the first cell of a row.
    std::uint64_t firstOf(std::size_t row, std::uint64_t key) const
    {
        return key + m_offset[row] - m_level.step[1] - m_level.step[2];
    }

    const Level& m_level;
    std::size_t m_firstRow;
    std::array<std::uint64_t, 9> m_offset{};
    std::array<std::uint64_t, 9> m_cells{}; // per row
    std::array<std::size_t, 9> m_begin{};   // of cells
    std::array<std::size_t, 9> m_end{};
    std::array<sphere_kernels::Stretch, 9> m_stretches{};
    std::size_t m_count = 0;
    std::size_t m_spheres = 0;
};

/// Finds the partners of one sphere after the other among those of a level.
class UniformGrid::Search {
public:
    Search(const UniformGrid& grid, const Level& level, PairBlock& found)
        : m_grid(grid)
        , m_level(level)
        , m_spheres(level.spheres.view())
        , m_found(found)
    {
    }

    void examine(const sphere_kernels::Query& query, const Surroundings& around)
    {
        const std::size_t most = around.spheres() + sphere_kernels::padding;
        if (m_doubtful.size() < most)
            m_doubtful.resize(2 * most);
        m_tests += around.spheres();
        static_assert(sizeof(VicinityPair) == 2 * sizeof(std::uint32_t));
        VicinityPair* const pairs = m_found.room(most);
        sphere_kernels::Partners partners{&pairs->first, 0, m_doubtful.data(), 0};
        const auto stretches = around.stretches();
        m_grid.m_kernels.findPartners(m_spheres, query, stretches.data(), stretches.size(),
                                      static_cast<float>(m_level.doubt), partners);
        const auto index = static_cast<std::uint32_t>(query.index);
        for (const std::int32_t doubtful : std::span(m_doubtful).first(partners.doubtfulCount)) {
            const auto other = static_cast<std::uint32_t>(doubtful);
            if (closerThan(m_grid.m_spheres[index], m_grid.m_spheres[other], m_grid.m_margin))
                pairs[partners.pairCount++] = {std::min(index, other), std::max(index, other)};
        }
        m_found.wrote(partners.pairCount);
    }

    /// Distances computed.
    std::uint64_t tests() const { return m_tests; }

private:
    const UniformGrid& m_grid;
    const Level& m_level;
    sphere_kernels::Spheres m_spheres;
    PairBlock& m_found;
    std::vector<std::int32_t> m_doubtful;
    std::uint64_t m_tests = 0;
};

UniformGrid::UniformGrid(const kernels::Kernels& kernels)
    : m_kernels(kernels)
{
}

/// Gives each sphere to the level of its radius. Levels keep their memory.
void UniformGrid::sortByRadius()
{
    for (auto& [octave, level] : m_levels) {
        level.members.clear();
        level.largestRadius = 0;
        level.box.setEmpty();
    }
    Level* level = nullptr;
    double radius = 0;
    for (std::uint32_t i = 0; i < m_spheres.size(); ++i) {
        const VicinitySphere& sphere = m_spheres[i];
        if (level == nullptr || sphere.radius != radius) {
            radius = sphere.radius;
            level = &m_levels[octaveOf(radius)];
            level->largestRadius = std::max(level->largestRadius, radius);
        }
        level->members.push_back(i);
        level->box.extend(sphere.center);
    }
    std::erase_if(m_levels, [](const auto& entry) { return entry.second.members.empty(); });
}

/// The place and size of a level's cells.
void UniformGrid::layOut(Level& level) const
{
    level.origin = level.box.min();
    // Cells no finer than the key can number; points without a margin would have none at all.
    const double finest = level.box.sizes().maxCoeff() / farthestCell;
    level.cellsPerMetre = 1 / std::max({roundingSlack * (2 * level.largestRadius + m_margin),
                                        std::isfinite(finest) ? finest : 0.0, std::numeric_limits<double>::min()});
    const Vec3 sides = level.inCells(level.box.max());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        level.lastCell[axis] = std::min(std::floor(sides[static_cast<Eigen::Index>(axis)]), farthestCell);
        if (axis < 2) // one more cell on either side
            level.step[axis + 1] = level.step[axis] * (3 + static_cast<std::uint64_t>(level.lastCell[axis]));
    }
    // Places are rounded to 2^-24 of themselves, on both sides of a difference; reaches and sums are about 1.
    level.doubt = 1e-6 + 4 * std::ldexp(sides.maxCoeff(), -24);
}

void UniformGrid::sortIn(Level& level)
{
    const std::vector<std::uint32_t>& members = level.members;
    level.entries.resize(members.size());
    forEachBlock(members.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            level.entries[i] = {level.keyOf(m_spheres[members[i]].center), members[i]};
    });
    sortByCell(level.entries, level.largestKey(), m_scratch);
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
            level.spheres.number[4][i] = sphere.index;
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
            .index = static_cast<std::int32_t>(index)};
}

/// Pairs of a level's own spheres: those of cells begin .. end, each with those behind it.
/// @return the number of distances computed
std::uint64_t UniformGrid::findPartners(const Level& level, std::size_t begin, std::size_t end, PairBlock& found) const
{
    Search search(*this, level, found);
    Surroundings around(level, level.cellKey[begin], true);
    for (std::size_t cell = begin; cell < end; ++cell) {
        around.moveTo(level.cellKey[cell]);
        for (std::uint32_t i = level.cellBegin[cell]; i < level.cellBegin[cell + 1]; ++i) {
            around.dropFirst(); // the sphere itself
            search.examine(level.spheres.query(i), around);
        }
    }
    return search.tests();
}

/// Pairs of spheres of a level with smaller ones, sorted into its cells.
/// @return the number of distances computed
std::uint64_t UniformGrid::findPartners(const Level& level, std::span<const CellEntry> smaller, PairBlock& found) const
{
    Search search(*this, level, found);
    std::uint64_t key = smaller.front().key;
    Surroundings around(level, key, false);
    around.moveTo(key);
    for (const CellEntry& entry : smaller) {
        if (entry.key != key)
            around.moveTo(key = entry.key);
        if (around.spheres() > 0)
            search.examine(queryOf(level, entry.sphere), around);
    }
    return search.tests();
}

/// Calls work(begin, end, found) for blocks of 0 .. count; it returns the number of distances computed.
template <typename Work>
void UniformGrid::inBlocks(std::size_t count, std::size_t size, const Work& work)
{
    const std::size_t first = m_pairs.append((count + size - 1) / size);
    std::vector<std::uint64_t> tests(m_pairs.blocks().size() - first, 0);
    forEachBlock(count, size, [&](std::size_t begin, std::size_t end) {
        tests[begin / size] = work(begin, end, m_pairs[first + begin / size]);
    });
    m_statistics.sphereTests += std::accumulate(tests.begin(), tests.end(), std::uint64_t{0});
}

const PairBlocks& UniformGrid::findPairs(std::span<const VicinitySphere> spheres, double margin)
{
    m_spheres = spheres;
    m_margin = margin;
    m_statistics = {};
    m_pairs.clear();
    m_smaller.clear();
    sortByRadius();
    for (auto& [octave, level] : m_levels) {
        layOut(level);
        sortIn(level);
        inBlocks(level.cellKey.size(), cellBlock, [&](std::size_t begin, std::size_t end, PairBlock& found) {
            return findPartners(level, begin, end, found);
        });
        // A smaller sphere reaches at most one cell of the larger ones to either side.
        forEachBlock(m_smaller.size(), blockSize, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                m_smaller[i].key = level.keyOf(spheres[m_smaller[i].sphere].center);
        });
        sortByCell(m_smaller, level.largestKey(), m_scratch);
        inBlocks(m_smaller.size(), blockSize, [&](std::size_t begin, std::size_t end, PairBlock& found) {
            return findPartners(level, std::span(m_smaller).subspan(begin, end - begin), found);
        });
        if (octave != m_levels.rbegin()->first)
            m_smaller.insert(m_smaller.end(), level.entries.begin(), level.entries.end());
    }
    m_spheres = {};
    return m_pairs;
}

} // namespace knead
