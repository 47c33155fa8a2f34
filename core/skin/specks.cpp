#include "core/skin/specks.h"

#include "core/geometry/disjoint_sets.h"

#include <algorithm>
#include <map>
#include <optional>

namespace knead {

namespace {

using Triangle = TriangleMesh::Triangle;
constexpr std::uint32_t none = 0xffffffffU;

class SpeckJoiner {
public:
    SpeckJoiner(CutTriangles& triangles, const std::function<Vec3(std::uint32_t)>& placeOf)
        : m_triangles(triangles)
        , m_placeOf(placeOf)
        , m_corners(cornersOf(triangles))
        , m_sets(m_corners.size())
        , m_shellOf(m_corners.size(), none)
    {
        forEachSide([&](std::uint32_t label, const Triangle& points) {
            m_sets.join(cornerOf(label, points[0]), cornerOf(label, points[1]));
            m_sets.join(cornerOf(label, points[1]), cornerOf(label, points[2]));
        });
        if (m_corners.empty())
            return;
        const Vec3 origin = placeOf(static_cast<std::uint32_t>(m_corners.front()));
        forEachSide([&](std::uint32_t label, const Triangle& points) {
            const Vec3 a = placeOf(points[0]) - origin;
            const Vec3 b = placeOf(points[1]) - origin;
            const Vec3 c = placeOf(points[2]) - origin;
            m_shells[shellAt(label, points[0])].volume += a.dot(b.cross(c)) / 6;
        });
    }

    void join(double leastVolume)
    {
        const std::vector<std::uint32_t> specks = findSpecks(leastVolume);
        if (specks.empty())
            return;
        measureBorders();
        DisjointSets groups(m_shells.size());
        for (const std::uint32_t speck : specks) {
            if (!m_shells[groups.find(speck)].isSpeck)
                continue; // it is part of something larger already, which is then known by that
            double largest = 0;
            std::optional<std::uint32_t> neighbor;
            for (const auto& [other, area] : m_shells[speck].borders)
                if (area > largest && groups.find(other) != groups.find(speck)) {
                    largest = area;
                    neighbor = other;
                }
            if (neighbor)
                groups.join(speck, *neighbor);
        }
        relabel(groups);
    }

private:
    struct Shell {
        std::uint32_t label = 0;
        double volume = 0; // [m^3], negative for a void
        bool isSpeck = false;
        std::map<std::uint32_t, double> borders; // crack area by the shell across [m^2]
    };

    template <typename Visit>
    void forEachSide(Visit&& visit) const
    {
        for (const CutTriangles::Skin& t : m_triangles.skin)
            visit(t.label, t.points);
        for (const CutTriangles::Crack& t : m_triangles.cracks) {
            visit(t.back, t.points);
            visit(t.front, Triangle{t.points[0], t.points[2], t.points[1]});
        }
    }

    static std::uint64_t keyOf(std::uint32_t label, std::uint32_t point) { return std::uint64_t{label} << 32 | point; }

    static std::vector<std::uint64_t> cornersOf(const CutTriangles& triangles)
    {
        std::vector<std::uint64_t> corners;
        for (const CutTriangles::Skin& t : triangles.skin)
            for (const std::uint32_t point : t.points)
                corners.push_back(keyOf(t.label, point));
        for (const CutTriangles::Crack& t : triangles.cracks)
            for (const std::uint32_t point : t.points) {
                corners.push_back(keyOf(t.back, point));
                corners.push_back(keyOf(t.front, point));
            }
        std::ranges::sort(corners);
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        return corners;
    }

    std::size_t cornerOf(std::uint32_t label, std::uint32_t point) const
    {
        const auto found = std::lower_bound(m_corners.begin(), m_corners.end(), keyOf(label, point));
        return static_cast<std::size_t>(found - m_corners.begin());
    }

    /// Shells are numbered in the order they are asked for.
    std::uint32_t shellAt(std::uint32_t label, std::uint32_t point)
    {
        std::uint32_t& shell = m_shellOf[m_sets.find(cornerOf(label, point))];
        if (shell == none) {
            shell = static_cast<std::uint32_t>(m_shells.size());
            m_shells.push_back({.label = label, .borders = {}});
        }
        return shell;
    }

    /// Smallest first.
    std::vector<std::uint32_t> findSpecks(double leastVolume)
    {
        std::map<std::uint32_t, std::uint32_t> largest; // shell by label
        for (std::uint32_t i = 0; i < m_shells.size(); ++i) {
            const auto [known, isNew] = largest.try_emplace(m_shells[i].label, i);
            if (!isNew && m_shells[i].volume > m_shells[known->second].volume)
                known->second = i;
        }
        std::vector<std::uint32_t> specks;
        for (std::uint32_t i = 0; i < m_shells.size(); ++i)
            if (largest[m_shells[i].label] != i && m_shells[i].volume > 0 && m_shells[i].volume < leastVolume) {
                m_shells[i].isSpeck = true;
                specks.push_back(i);
            }
        std::ranges::stable_sort(
            specks, [&](std::uint32_t a, std::uint32_t b) { return m_shells[a].volume < m_shells[b].volume; });
        return specks;
    }

    void measureBorders()
    {
        for (const CutTriangles::Crack& t : m_triangles.cracks) {
            const std::uint32_t back = shellAt(t.back, t.points[0]);
            const std::uint32_t front = shellAt(t.front, t.points[0]);
            if (!m_shells[back].isSpeck && !m_shells[front].isSpeck)
                continue;
            const Vec3 a = m_placeOf(t.points[0]);
            const double area = 0.5 * (m_placeOf(t.points[1]) - a).cross(m_placeOf(t.points[2]) - a).norm();
            m_shells[back].borders[front] += area;
            m_shells[front].borders[back] += area;
        }
    }

    /// A group has the label of its largest shell; cracks between equal labels vanish.
    void relabel(DisjointSets& groups)
    {
        std::vector<std::uint32_t> largest(m_shells.size(), none);
        for (std::uint32_t i = 0; i < m_shells.size(); ++i) {
            std::uint32_t& best = largest[groups.find(i)];
            const auto rank = [&](std::uint32_t shell) {
                return std::pair(!m_shells[shell].isSpeck, m_shells[shell].volume);
            };
            if (best == none || rank(i) > rank(best))
                best = i;
        }
        const auto labelOf = [&](std::uint32_t label, std::uint32_t point) {
            return m_shells[largest[groups.find(shellAt(label, point))]].label;
        };
        for (CutTriangles::Skin& t : m_triangles.skin)
            t.label = labelOf(t.label, t.points[0]);
        for (CutTriangles::Crack& t : m_triangles.cracks) {
            t.back = labelOf(t.back, t.points[0]);
            t.front = labelOf(t.front, t.points[0]);
        }
        std::erase_if(m_triangles.cracks, [](const CutTriangles::Crack& t) { return t.back == t.front; });
    }

    CutTriangles& m_triangles;
    const std::function<Vec3(std::uint32_t)>& m_placeOf;
    std::vector<std::uint64_t> m_corners; // label and point of all corners, ascending
    DisjointSets m_sets;                  // of corners
    std::vector<std::uint32_t> m_shellOf; // by set
    std::vector<Shell> m_shells;
};

} // namespace

void joinSpecks(CutTriangles& triangles, const std::function<Vec3(std::uint32_t)>& placeOf, double leastVolume)
{
    SpeckJoiner(triangles, placeOf).join(leastVolume);
}

} // namespace knead
