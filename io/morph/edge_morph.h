#pragma once

#include "core/geometry/smooth_map.h"
#include "io/morph/morph_options.h"

#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>

namespace knead {

/// The curve of an edge after a map, over the same parameters.
struct MorphedEdge {
    Handle(Geom_Curve) curve; ///< null for a degenerated edge
    double first = 0;
    double last = 0;
    double error = 0;     ///< largest distance from where the map takes it [mm]
    bool isExact = false; ///< moved as a rigid thing
    bool converged = true;
};

/// @param edge forward, where it is in space. @param map in millimetres
MorphedEdge morphEdge(const TopoDS_Edge& edge, const SmoothMap& map, const MorphOptions& options);

} // namespace knead
