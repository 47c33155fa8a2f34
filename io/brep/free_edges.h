#pragma once

#include "core/geometry/vec3.h"

#include <TopTools_ListOfShape.hxx>

#include <vector>

class TopoDS_Shape;

namespace knead {

/// Edges along which a surface ends: faces run along them more often one way than the other. Edges without length, as
/// at the pole of a sphere, do not count.
TopTools_ListOfShape freeEdgesOf(const TopoDS_Shape& shape);

/// The same as polylines [m], chained where one ends and the next begins; a closed one ends where it began.
std::vector<std::vector<Vec3>> freeBordersOf(const TopoDS_Shape& shape);

/// Whether a free edge runs within a distance of another one, so that sewing could join the two. Edges no longer than
/// twice the distance do not count: they are near their neighbors in any case.
/// @param distance [mm]
bool canBeSewn(const TopoDS_Shape& shape, double distance);

} // namespace knead
