#include "core/skin/label_seams.h"

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/half_edges.h"
#include "core/skin/crossings.h"
#include "core/skin/fragments.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace knead {

namespace {

using Triangle = TriangleMesh::Triangle;

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
            m_isOpen[i] = seams.pieceOf(back) != seams.pieceOf(front) || seams.isOpen(middle) ? 1 : 0;
            if (m_isOpen[i] == 0)
                sew(i);
        }
    }

    std::vector<SewnMesh> sewn()
    {
        while (closePinches())
            continue;
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

    /// Edges whose two ends are sewn, with more than one open triangle of a piece at them, would have four.
    bool closePinches()
    {
        std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> atEdge; // open triangles
        for (std::size_t i = 0; i < m_isOpen.size(); ++i) {
            const auto& [points, back, front] = m_triangles.cracks[i];
            if (m_isOpen[i] == 0 || m_seams.pieceOf(back) != m_seams.pieceOf(front))
                continue;
            for (std::size_t side = 0; side < 3; ++side) {
                const std::uint32_t p = points[side];
                const std::uint32_t q = points[(side + 1) % 3];
                const std::size_t a = m_sets.find(m_corners.of(p, back));
                const std::size_t b = m_sets.find(m_corners.of(q, back));
                if (a == m_sets.find(m_corners.of(p, front)) && b == m_sets.find(m_corners.of(q, front)))
                    atEdge[{std::min(a, b), std::max(a, b)}].push_back(i);
            }
        }
        bool isChanged = false;
        for (const auto& [edge, open] : atEdge)
            for (std::size_t i = 0; open.size() > 1 && i < open.size(); ++i)
                if (std::exchange(m_isOpen[open[i]], std::uint8_t{0}) != 0) {
                    sew(open[i]);
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
