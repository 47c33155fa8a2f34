#pragma once

#include "core/geometry/smooth_map.h"
#include "core/message/message.h"
#include "core/task/task_control.h"
#include "io/morph/face_morph.h"
#include "io/morph/morph_options.h"

#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// What became of one face of the source.
struct MorphedFaceNote {
    MorphedFaceKind kind = MorphedFaceKind::failed;
    double error = 0;          ///< of its fit, at equal parameters and a little beyond its border too [mm]
    Vec2 worst = Vec2::Zero(); ///< parameters where that was
    bool converged = true;
    int poles = 0;
    Message problem;
};

/// A boundary representation carried through a smooth map: the same topology, each face, edge and vertex where the map takes it, but
/// for faces that are to be flat (MorphOptions::flat): these come as triangles, and edges beside them in pieces.
struct MorphedShape {
    TopoDS_Shape shape;
    std::vector<MorphedFaceNote> notes; ///< on each face of the source, as TopExp::MapShapes() numbers them
    std::vector<std::uint32_t> origin;  ///< per face of the shape, which of the source it is or is a part of
    double largestEdgeTolerance = 0;    ///< [mm]
    int widenedVertices = 0;            ///< whose ball had to grow for edges that nearly touch beside it
    bool isValid = false;               ///< by BRepCheck; not looked at when a face failed
    std::vector<std::uint32_t>
        faulty; ///< faces of the source that failed, or else are why it is not valid, as far as known
};

/// Morphs a shape: one new vertex per vertex, one curve per edge, one surface per face, in the parameters of the source, so that
/// they fit together as they did; tolerances as measured. Topology is copied, never recomputed. In parallel over edges and
/// faces; the result does not depend on the number of threads.
/// @param shape located where it is [mm]
/// @param map in metres
/// @throws Cancelled, and Problem, when a face that is to be flat cannot be drawn
MorphedShape morphShape(const TopoDS_Shape& shape, const SmoothMap& map, const MorphOptions& options,
                        TaskControl& control = TaskControl::none());

} // namespace knead
