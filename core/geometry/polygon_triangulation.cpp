#include "core/geometry/polygon_triangulation.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace knead {

namespace {

using Vec2 = Eigen::Vector2d;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Twice the area, positive when counter-clockwise.
double turn(const Vec2& a, const Vec2& b, const Vec2& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Whether the segments a b and c d cross in their insides.
bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

/// Area by the square of the longest side, negative when clockwise.
double quality(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return longest > 0 ? 0.5 * turn(a, b, c) / longest : 0;
}

/// Cuts corners off a loop that may pass through a corner twice, along bridges.
class EarCutter {
public:
    EarCutter(std::span<const Vec2> corners, std::vector<std::uint32_t> loop)
        : m_corners(corners)
        , m_loop(std::move(loop))
        , m_next(m_loop.size())
        , m_previous(m_loop.size())
        , m_quality(m_loop.size())
    {
        const std::size_t count = m_loop.size();
        for (std::size_t i = 0; i < count; ++i) {
            m_next[i] = (i + 1) % count;
            m_previous[i] = (i + count - 1) % count;
            m_left.push_back(i);
        }
        for (std::size_t i = 0; i < count; ++i)
            m_quality[i] = qualityAt(i);
    }

    std::vector<std::array<std::uint32_t, 3>> cut()
    {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        while (m_left.size() >= 3) {
            const auto best = std::ranges::max_element(
                m_left, [&](std::size_t i, std::size_t j) { return m_quality[i] < m_quality[j]; });
            const std::size_t ear = *best;
            triangles.push_back({m_loop[m_previous[ear]], m_loop[ear], m_loop[m_next[ear]]});
            m_left.erase(best);
            m_next[m_previous[ear]] = m_next[ear];
            m_previous[m_next[ear]] = m_previous[ear];
            m_quality[m_previous[ear]] = qualityAt(m_previous[ear]);
            m_quality[m_next[ear]] = qualityAt(m_next[ear]);
        }
        return triangles;
    }

private:
    const Vec2& at(std::size_t i) const { return m_corners[m_loop[i]]; }

    /// Of the triangle at a corner; negative when it is no ear.
    double qualityAt(std::size_t i) const
    {
        const double own = quality(at(m_previous[i]), at(i), at(m_next[i]));
        return own > 0 && holdsNoCorner(i) ? own : own - 1;
    }

    bool holdsNoCorner(std::size_t i) const
    {
        const std::uint32_t own[] = {m_loop[m_previous[i]], m_loop[i], m_loop[m_next[i]]};
        const Vec2& a = m_corners[own[0]];
        const Vec2& b = m_corners[own[1]];
        const Vec2& c = m_corners[own[2]];
        return std::ranges::none_of(m_left, [&](std::size_t other) {
            const std::uint32_t corner = m_loop[other];
            if (corner == own[0] || corner == own[1] || corner == own[2])
                return false;
            const Vec2& p = m_corners[corner];
            return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }

    std::span<const Vec2> m_corners;
    std::vector<std::uint32_t> m_loop;
    std::vector<std::size_t> m_next;
    std::vector<std::size_t> m_previous;
    std::vector<std::size_t> m_left; // places in the loop that are not cut off yet
    std::vector<double> m_quality;
};

/// Whether a bridge between a corner of the loop and one of a hole stays clear of the sides of both and of other holes.
bool isClear(std::span<const Vec2> corners, std::uint32_t from, std::uint32_t to,
             const std::vector<std::uint32_t>& loop)
{
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (cross(corners[from], corners[to], corners[loop[i]], corners[loop[(i + 1) % loop.size()]]))
            return false;
    return true;
}

/// Whether the way from place i of a loop to a point begins inside it.
bool leadsInside(std::span<const Vec2> corners, const std::vector<std::uint32_t>& loop, std::size_t i, const Vec2& to)
{
    const Vec2& before = corners[loop[(i + loop.size() - 1) % loop.size()]];
    const Vec2& here = corners[loop[i]];
    const Vec2& after = corners[loop[(i + 1) % loop.size()]];
    const bool leftOfIn = turn(before, here, to) > 0;
    const bool leftOfOut = turn(here, after, to) > 0;
    return turn(before, here, after) >= 0 ? leftOfIn && leftOfOut : leftOfIn || leftOfOut;
}

/// Joins the hole to the loop by the shortest bridge that crosses nothing, or the shortest of all.
void bridge(std::span<const Vec2> corners, std::vector<std::uint32_t>& loop, const std::vector<std::uint32_t>& hole,
            const std::vector<std::vector<std::uint32_t>>& others)
{
    struct Way {
        double length;
        std::size_t from; // place in the loop
        std::size_t to;   // place in the hole
    };
    std::vector<Way> ways;
    for (std::size_t i = 0; i < loop.size(); ++i)
        for (std::size_t j = 0; j < hole.size(); ++j)
            if (leadsInside(corners, loop, i, corners[hole[j]]))
                ways.push_back({(corners[loop[i]] - corners[hole[j]]).squaredNorm(), i, j});
    if (ways.empty())
        ways.push_back({0, 0, 0});
    const auto isLonger = [](const Way& a, const Way& b) {
        return std::tie(a.length, a.from, a.to) > std::tie(b.length, b.from, b.to);
    };
    std::make_heap(ways.begin(), ways.end(), isLonger);
    Way way = ways.front();
    for (auto end = ways.end(); end != ways.begin(); --end) {
        std::pop_heap(ways.begin(), end, isLonger);
        const std::uint32_t from = loop[(end - 1)->from];
        const std::uint32_t to = hole[(end - 1)->to];
        if (isClear(corners, from, to, loop) && isClear(corners, from, to, hole) &&
            std::ranges::all_of(others, [&](const auto& other) { return isClear(corners, from, to, other); })) {
            way = *(end - 1);
            break;
        }
    }
    std::vector<std::uint32_t> detour;
    for (std::size_t j = 0; j <= hole.size(); ++j)
        detour.push_back(hole[(way.to + j) % hole.size()]);
    detour.push_back(loop[way.from]);
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(way.from) + 1, detour.begin(), detour.end());
}

/// Exchanges the diagonals of pairs of triangles as long as the worse one of a pair gets better. Cutting off corners leaves
/// needles behind, such as three points of one side.
class Improver {
public:
    Improver(std::span<const Vec2> corners, Triangles& triangles)
        : m_corners(corners)
        , m_triangles(triangles)
    {
        for (std::size_t t = 0; t < triangles.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i)
                m_isSound = m_at.try_emplace({triangles[t][i], triangles[t][(i + 1) % 3]}, t).second && m_isSound;
    }

    void improve()
    {
        constexpr int mostRounds = 20;
        bool isChanged = m_isSound;
        for (int round = 0; round < mostRounds && isChanged; ++round) {
            isChanged = false;
            for (std::size_t t = 0; t < m_triangles.size(); ++t)
                for (std::size_t i = 0; i < 3; ++i)
                    isChanged = exchange(t, i) || isChanged;
        }
    }

private:
    double qualityOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        return quality(m_corners[a], m_corners[b], m_corners[c]);
    }

    bool exchange(std::size_t t, std::size_t side)
    {
        const std::uint32_t a = m_triangles[t][side];
        const std::uint32_t b = m_triangles[t][(side + 1) % 3];
        const std::uint32_t c = m_triangles[t][(side + 2) % 3];
        const auto found = m_at.find({b, a});
        if (found == m_at.end())
            return false;
        const std::size_t other = found->second;
        std::uint32_t d = 0;
        for (const std::uint32_t corner : m_triangles[other])
            d = corner != a && corner != b ? corner : d;
        if (d == c || m_at.contains({c, d}) || m_at.contains({d, c}))
            return false;
        const double before = std::min(qualityOf(a, b, c), qualityOf(b, a, d));
        if (std::min(qualityOf(a, d, c), qualityOf(d, b, c)) <= before + 1e-12)
            return false;
        m_triangles[t] = {a, d, c};
        m_triangles[other] = {d, b, c};
        m_at.erase({a, b});
        m_at.erase({b, a});
        m_at[{a, d}] = m_at[{d, c}] = m_at[{c, a}] = t;
        m_at[{d, b}] = m_at[{b, c}] = m_at[{c, d}] = other;
        return true;
    }

    std::span<const Vec2> m_corners;
    Triangles& m_triangles;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> m_at; // the triangle to the left of two corners
    bool m_isSound = true;                                               // no side is there twice
};

} // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec2> corners,
                                                      std::span<const std::size_t> loopEnds)
{
    std::vector<std::vector<std::uint32_t>> loops;
    std::uint32_t corner = 0;
    for (const std::size_t end : loopEnds) {
        loops.emplace_back();
        for (; corner < end; ++corner)
            loops.back().push_back(corner);
    }
    std::vector<std::uint32_t> outline = std::move(loops.front());
    loops.erase(loops.begin());
    while (!loops.empty()) {
        const std::vector<std::uint32_t> hole = std::move(loops.back());
        loops.pop_back();
        bridge(corners, outline, hole, loops);
    }
    Triangles triangles = EarCutter(corners, std::move(outline)).cut();
    Improver(corners, triangles).improve();
    return triangles;
}

} // namespace knead
