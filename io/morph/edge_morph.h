#pragma once

#include "core/geometry/smooth_map.h"
#include "io/morph/morph_options.h"

#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>

namespace knead {

/// The curve of an edge after a map, over the same parameters, or over others that run evenly with these.
struct MorphedEdge {
    Handle(Geom_Curve) curve; ///< null for a degenerated edge
    double first = 0;
    double last = 0;
    double sourceFirst = 0; ///< of the edge before
    double sourceLast = 0;

    bool hasOtherRange() const { return first != sourceFirst || last != sourceLast; }

    /// What became of a parameter of the edge before.
    double rangedParameter(double parameter) const
    {
        return first + (parameter - sourceFirst) * (last - first) / (sourceLast - sourceFirst);
    }

    double error = 0;     ///< largest distance from where the map takes it [mm]
    bool isExact = false; ///< moved as a rigid thing
    bool converged = true;
};

/// @param edge forward, where it is in space. @param map in millimetres
MorphedEdge morphEdge(const TopoDS_Edge& edge, const SmoothMap& map, const MorphOptions& options);

} // namespace knead
