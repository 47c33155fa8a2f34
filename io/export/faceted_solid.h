#pragma once

#include "core/geometry/triangle_mesh.h"

#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <vector>

namespace knead {

/// Flat faces around a volume.
struct FacetedSolid {
    TopoDS_Shape shape; ///< a solid, or a compound of several [mm]
    std::vector<std::uint32_t>
        origin; ///< the CAD face that each came from, as TopExp::MapShapes() numbers them; empty when
                ///< the mesh knows none
};

/// A solid of the flat faces of a closed mesh, edges and vertices shared; a solid for each closed shell, with those inside as its
/// voids. For what smooth faces cannot describe. Triangles in one plane become one face where that gives a valid solid.
/// @param mesh closed, outward [m]; triangles that are shorter than a point are left out
/// @param flatness how far vertices may be off a face of several triangles [m]
/// @throws Problem, when the mesh bounds no volume
FacetedSolid facetedSolid(const TriangleMesh& mesh, double flatness = 0);

} // namespace knead
