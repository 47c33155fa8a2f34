#pragma once

#include "core/geometry/half_edges.h"
#include "core/geometry/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace knead {

/// What stands on the air at a vertex of a surface: nothing presses there, so that the material bears no traction across it.
struct FreeSurface {
    enum class Kind : std::uint8_t {
        none, ///< nothing known: a corner, where three faces or more meet, or an edge that goes inwards, where stress has no bound
        face, ///< as good as flat
        edge, ///< two faces meet outwards: the material can be stretched along the edge only
    };
    Kind kind = Kind::none;
    Vec3 direction = Vec3::Zero(); ///< outward normal of a face, direction of an edge; unit

    /// Largest curvature inwards, as of a hole or a fillet [1/m]; 0: none. Infinite at an edge that goes inwards. A mean over a few
    /// triangles: where they are much smaller than the facets of a hole, more on the lines between these and less on them.
    double hollow = 0;
};

/// At all vertices, by the normals of the triangles that meet there, each by its angle: an edge where they differ by more than
/// about 50 degrees, so that the facets of a round hole are none. A surface that is not closed has its rim taken as flat.
std::vector<FreeSurface> freeSurfaces(const TriangleMesh& mesh);

/// The same at any places on a surface: at a vertex, on an edge where two faces meet, or within a face. The mesh must outlive it.
class FreeSurfaceFinder {
public:
    explicit FreeSurfaceFinder(const TriangleMesh& mesh);

    /// @param triangle that the place is on or nearest to
    /// @param reach how far from a vertex or an edge a place is still there [m]
    FreeSurface at(const Vec3& place, std::uint32_t triangle, double reach) const;

private:
    FreeSurface onEdge(std::size_t halfEdge) const;

    const TriangleMesh& m_mesh;
    std::vector<FreeSurface> m_ofVertices;
    HalfEdges m_edges;
};

/// What becomes of it when the material there is deformed by F: the normal n ~ F^-T N, the edge t ~ F T.
FreeSurface moved(const FreeSurface& surface, const Mat3& gradient);

/// The stress whose traction across a free surface is taken off, in so far as that is free, while the strain along the surface
/// stays. At a face of normal n, with t = sigma n and t_n = n.t:
///   sigma - n t^T - t n^T + t_n n n^T - nu / (1 - nu) t_n (I - n n^T)
/// At an edge of direction e: (sigma_ee - nu (tr sigma - sigma_ee)) e e^T.
/// @param share 0 .. 1: how far the surface is free
Mat3 withoutTraction(const Mat3& stress, const FreeSurface& surface, double poissonRatio, double share = 1);

} // namespace knead
