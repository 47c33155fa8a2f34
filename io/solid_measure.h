#pragma once

#include "core/geometry/triangle_mesh.h"
#include "io/importer.h"

class TopoDS_Shape;

namespace knead {

/// Volume and triangles of a closed solid, each a check of the other.
struct SolidMeasure {
    double volume = 0; ///< [m^3], negative for a solid turned inside out
    TriangleMesh mesh; ///< [m], its triangles as the faces are
    double disagreement =
        0; ///< relative, of the volume of the triangles; above a thousandth when faces do not meet well
};

/// Integrates the faces, and triangulates finer until the volume of the triangles is within a thousandth, unless a
/// deflection was asked for. Where the two do not approach each other the integration is repeated adaptively: the quick
/// one is off by a percent on threads and the like, the adaptive one on some tori, so the limit of the triangles
/// decides.
/// @param solid lengths in mm, no free edges
/// @param diagonal of its box [m]
SolidMeasure measureSolid(const TopoDS_Shape& solid, double diagonal, const ImportOptions& options);

} // namespace knead
