#pragma once

#include "core/geometry/smooth_map.h"
#include "core/geometry/spline_fit.h"
#include "core/message/message.h"
#include "io/morph/morph_options.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <array>
#include <string>
#include <vector>

namespace knead {

/// How a face came through a map.
enum class MorphedFaceKind {
    kept,     ///< exactly where and what it was
    moved,    ///< exactly what it was, at another place
    planar,   ///< a plane that became another plane
    fitted,   ///< a B-spline surface
    flat,     ///< triangles, as was asked for
    failed,   ///< nothing to build a face on
    reshaped, ///< exactly a cylinder, cone, sphere or torus, see MorphOptions::findsForms
};

/// The surface of a face after a map, in the same parameters unless it is reshaped, and the curves of its edges in these.
struct MorphedFace {
    struct EdgeCurves {
        TopoDS_Edge edge;                           ///< of the source, forward
        std::array<Handle(Geom2d_Curve), 2> curves; ///< the second one for the other side of a seam, or null
        double first = 0;
        double last = 0;
    };

    MorphedFaceKind kind = MorphedFaceKind::failed;
    Handle(Geom_Surface) surface;
    bool isMirrored = false;       ///< its normal points to the other side of the material than before
    std::vector<EdgeCurves> edges; ///< none where a plane implies them
    double error = 0;              ///< largest distance from where the map takes it, as far as was looked [mm]
    Vec2 worst = Vec2::Zero();     ///< parameters where that was
    bool converged = true;
    int poles = 0;
    Message problem; ///< why it failed
};

/// @param face forward, where it is in space. @param map in millimetres
MorphedFace morphFace(const TopoDS_Face& face, const SmoothMap& map, const MorphOptions& options);

} // namespace knead
