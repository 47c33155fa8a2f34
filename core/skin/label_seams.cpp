#include "core/skin/label_seams.h"

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/half_edges.h"
#include "core/skin/crossings.h"
#include "core/skin/fragments.h"

#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>
#include <utility>

namespace knead {

namespace {

using Triangle = TriangleMesh::Triangle;
constexpr std::size_t leastBubble = 30; // triangles that may be open by themselves

/// Points of the labels that use them, each a corner of its own until it is sewn.
class Corners {
public:
    explicit Corners(const CutTriangles& triangles)
    {
        for (const CutTriangles::Skin& t : triangles.skin)
            add(t.points, t.label);
        for (const CutTriangles::Crack& t : triangles.cracks) {
            add(t.points, t.back);
            add(t.points, t.front);
        }
    }
    std::size_t size() const { return m_labels.size(); }
    std::uint32_t of(std::uint32_t point, std::uint32_t label) const { return m_numbers.at(key(point, label)); }
    std::uint32_t labelOf(std::size_t corner) const { return m_labels[corner]; }

private:
    static std::uint64_t key(std::uint32_t point, std::uint32_t label) { return std::uint64_t{label} << 32 | point; }
    void add(const Triangle& points, std::uint32_t label)
    {
        for (const std::uint32_t point : points)
            if (m_numbers.try_emplace(key(point, label), static_cast<std::uint32_t>(m_labels.size())).second)
                m_labels.push_back(label);
    }

    std::unordered_map<std::uint64_t, std::uint32_t> m_numbers;
    std::vector<std::uint32_t> m_labels;
};

class Sewer {
public:
    Sewer(const CutTriangles& triangles, const std::function<Vec3(std::uint32_t)>& placeOf, const LabelSeams& seams)
        : m_triangles(triangles)
        , m_placeOf(placeOf)
        , m_seams(seams)
        , m_corners(triangles)
        , m_sets(m_corners.size())
        , m_isOpen(triangles.cracks.size())
    {
        for (std::size_t i = 0; i < m_isOpen.size(); ++i) {
            const auto& [points, back, front] = triangles.cracks[i];
            const Vec3 middle = (placeOf(points[0]) + placeOf(points[1]) + placeOf(points[2])) / 3;
            m_isOpen[i] = !isWithinPiece(i) || seams.isOpen(middle) ? 1 : 0;
            if (m_isOpen[i] == 0)
                sew(i);
        }
    }

    std::vector<SewnMesh> sewn()
    {
        closeBubbles();
        while (closePinches())
            closeBubbles();
        std::map<std::uint32_t, SewnMesh> pieces;
        for (const CutTriangles::Skin& t : m_triangles.skin)
            add(pieces[m_seams.pieceOf(t.label)], t.points, t.label, t.face);
        for (std::size_t i = 0; i < m_isOpen.size(); ++i) {
            if (m_isOpen[i] == 0)
                continue;
            const auto& [points, back, front] = m_triangles.cracks[i];
            add(pieces[m_seams.pieceOf(back)], points, back, Fragment::crackFace);
            add(pieces[m_seams.pieceOf(front)], {points[0], points[2], points[1]}, front, Fragment::crackFace);
        }
        std::vector<SewnMesh> result;
        for (auto& [piece, sewn] : pieces) {
            sewn.piece = piece;
            if (findHalfEdges(sewn.mesh).unpaired > 0)
                throw DegenerateCut();
            result.push_back(std::move(sewn));
        }
        return result;
    }

private:
    void sew(std::size_t crack)
    {
        const auto& [points, back, front] = m_triangles.cracks[crack];
        for (const std::uint32_t point : points)
            m_sets.join(m_corners.of(point, back), m_corners.of(point, front));
    }

    void close(std::size_t crack)
    {
        m_isOpen[crack] = 0;
        sew(crack);
    }

    bool isWithinPiece(std::size_t crack) const
    {
        const auto& [points, back, front] = m_triangles.cracks[crack];
        return m_seams.pieceOf(back) == m_seams.pieceOf(front);
    }

    /// Where a few triangles alone would be open, away from the skin.
    void closeBubbles()
    {
        std::uint32_t points = 0;
        for (const CutTriangles::Skin& t : m_triangles.skin)
            points = std::max({points, t.points[0] + 1, t.points[1] + 1, t.points[2] + 1});
        for (const CutTriangles::Crack& t : m_triangles.cracks)
            points = std::max({points, t.points[0] + 1, t.points[1] + 1, t.points[2] + 1});
        DisjointSets groups(points);
        const auto forEachOpen = [&](auto&& visit) {
            for (std::size_t i = 0; i < m_isOpen.size(); ++i)
                if (m_isOpen[i] != 0 && isWithinPiece(i))
                    visit(i, m_triangles.cracks[i].points);
        };
        forEachOpen([&](std::size_t, const Triangle& t) {
            groups.join(t[0], t[1]);
            groups.join(t[1], t[2]);
        });
        std::vector<std::size_t> count(points, 0);
        forEachOpen([&](std::size_t, const Triangle& t) { ++count[groups.find(t[0])]; });
        for (const CutTriangles::Skin& t : m_triangles.skin)
            for (const std::uint32_t point : t.points)
                count[groups.find(point)] += leastBubble;
        forEachOpen([&](std::size_t i, const Triangle& t) {
            if (count[groups.find(t[0])] < leastBubble)
                close(i);
        });
    }

    /// Edges whose two ends are sewn, with more than two triangles of the surface at them.
    bool closePinches()
    {
        std::vector<std::uint8_t> isSewn(m_corners.size(), 0); // per set: it is of several corners
        for (std::size_t corner = 0; corner < m_corners.size(); ++corner)
            if (const std::size_t set = m_sets.find(corner); set != corner)
                isSewn[set] = 1;
        struct Edge {
            std::size_t triangles = 0;
            std::vector<std::size_t> open;
        };
        std::map<std::array<std::size_t, 2>, Edge> edges;
        const auto visit = [&](const Triangle& points, std::uint32_t label, std::size_t crack) {
            for (std::size_t side = 0; side < 3; ++side) {
                const std::size_t a = m_sets.find(m_corners.of(points[side], label));
                const std::size_t b = m_sets.find(m_corners.of(points[(side + 1) % 3], label));
                if (isSewn[a] == 0 || isSewn[b] == 0)
                    continue;
                Edge& edge = edges[{std::min(a, b), std::max(a, b)}];
                ++edge.triangles;
                if (crack < m_isOpen.size())
                    edge.open.push_back(crack);
            }
        };
        for (const CutTriangles::Skin& t : m_triangles.skin)
            visit(t.points, t.label, m_isOpen.size());
        for (std::size_t i = 0; i < m_isOpen.size(); ++i)
            if (m_isOpen[i] != 0) {
                const std::size_t crack = isWithinPiece(i) ? i : m_isOpen.size();
                visit(m_triangles.cracks[i].points, m_triangles.cracks[i].back, crack);
                visit(m_triangles.cracks[i].points, m_triangles.cracks[i].front, crack);
            }
        bool isChanged = false;
        for (const auto& [ends, edge] : edges)
            for (std::size_t i = 0; edge.triangles > 2 && i < edge.open.size(); ++i)
                if (m_isOpen[edge.open[i]] != 0) {
                    close(edge.open[i]);
                    isChanged = true;
                }
        return isChanged;
    }

    void add(SewnMesh& sewn, const Triangle& points, std::uint32_t label, std::uint32_t face)
    {
        Triangle own{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t corner = m_corners.of(points[i], label);
            const auto [number, isNew] =
                m_numbers.try_emplace(m_sets.find(corner), static_cast<std::uint32_t>(sewn.mesh.vertices.size()));
            own[i] = number->second;
            if (isNew) {
                sewn.mesh.vertices.push_back(m_placeOf(points[i]));
                sewn.labelOfVertex.push_back(label);
            } else if (sewn.labelOfVertex[own[i]] != label) {
                sewn.labelOfVertex[own[i]] = SewnMesh::manyLabels;
            }
        }
        sewn.mesh.triangles.push_back(own);
        sewn.mesh.faceOfTriangle.push_back(face);
    }

    const CutTriangles& m_triangles;
    const std::function<Vec3(std::uint32_t)>& m_placeOf;
    const LabelSeams& m_seams;
    Corners m_corners;
    DisjointSets m_sets;                                      ///< of corners: those that are one vertex
    std::vector<std::uint8_t> m_isOpen;                       ///< per triangle of the cracks
    std::unordered_map<std::size_t, std::uint32_t> m_numbers; ///< of vertices in their piece, by set
};

} // namespace

std::vector<SewnMesh> sewn(const CutTriangles& triangles, const std::function<Vec3(std::uint32_t)>& placeOf,
                           const LabelSeams& seams)
{
    return Sewer(triangles, placeOf, seams).sewn();
}

} // namespace knead
