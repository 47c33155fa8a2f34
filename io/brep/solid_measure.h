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
    bool isWatertight = false; ///< the mesh
};

/// Triangulates so that the volume of the triangles is within a thousandth, unless a deflection was asked for: with vertices
/// off the curved faces where chords cut too much off, then with finer triangles. When the two volumes do not approach each
/// other, and faces that gape do not say why, the integration is repeated adaptively, which is better on some faces and worse
/// on others, so the limit of the triangles decides.
/// @param solid lengths in mm, no free edges
/// @param volume as integrated over its faces [m^3], negative for a solid turned inside out
/// @param diagonal of its box [m]
SolidMeasure measureSolid(const TopoDS_Shape& solid, double volume, double diagonal, const ImportOptions& options);

} // namespace knead
