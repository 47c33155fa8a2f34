#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/skin/skin.h"

#include <memory>
#include <span>
#include <vector>

namespace knead {

/// What the surface of a body encloses as its objects move, which is what is drawn, measured and exported.
///
/// The surface is taken in triangles of about two spacings (of less where the part is small), and their sides as curved as the map of
/// the skin makes them: with V1 of these triangles and V4 of the four that their halved edges make, V = (4 V4 - V1) / 3 (Richardson).
/// Clay that was pressed by half is within a thousandth of its surface in triangles of a quarter of a spacing.
///
/// Immutable; its members may be called from any thread.
class EnclosedVolume {
public:
    /// @param surface of the opened part
    /// @return null where the surface is not closed or encloses something else than what was filled, and of what was filled in pieces,
    /// which lie apart in their lattice
    /// @throws Problem when the surface has a point that is nowhere
    static std::unique_ptr<const EnclosedVolume> of(const TriangleMesh& surface, const Aggregate& aggregate);

    /// By what it was when the body was filled.
    /// @param displacements one per object since then [m]
    double ratio(std::span<const Vec3> displacements) const;

    std::size_t points() const { return m_skin.size(); }

private:
    EnclosedVolume(TriangleMesh coarse, const TriangleMesh& fine, const Aggregate& aggregate);

    std::vector<TriangleMesh::Triangle> m_coarse;
    std::vector<TriangleMesh::Triangle> m_fine;
    Skin m_skin;             ///< of vertices and of the middles of edges
    double m_whenFilled = 0; ///< [m^3]
};

} // namespace knead
