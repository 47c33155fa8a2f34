#pragma once

#include "core/geometry/smooth_map.h"
#include "core/task/task_control.h"
#include "io/morph/face_morph.h"
#include "io/morph/morph_options.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

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
    std::string problem;
};

/// A boundary representation carried through a smooth map: the same topology, each face, edge and vertex where the map takes it.
struct MorphedShape {
    TopoDS_Shape shape;
    TopTools_IndexedMapOfShape sourceFaces; ///< as TopExp::MapShapes() numbers them
    std::vector<TopoDS_Shape> faces;        ///< what became of each of these, in that order
    std::vector<MorphedFaceNote> notes;     ///< on each of these
    double largestEdgeTolerance = 0;        ///< [mm]
    int widenedVertices = 0;                ///< whose ball had to grow for edges that nearly touch beside it
    bool isValid = false;                   ///< by BRepCheck
};

/// Morphs a shape: one new vertex per vertex, one curve per edge, one surface per face, in the parameters of the source, so that
/// they fit together as they did; tolerances as measured. Topology is copied, never recomputed. In parallel over edges and
/// faces; the result does not depend on the number of threads.
/// @param shape located where it is [mm]
/// @param map in metres
/// @throws Cancelled
MorphedShape morphShape(const TopoDS_Shape& shape, const SmoothMap& map, const MorphOptions& options,
                        TaskControl& control = TaskControl::none());

} // namespace knead
