#pragma once

#include "io/brep/face_drawing.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>

namespace knead {

/// How closely a morphed shape follows its map. Lengths in millimetres, as the shapes are.
struct MorphOptions {
    double tolerance = 0.01; ///< largest distance between a face and where the map takes it, > 0 [mm]
    int degree = 5;          ///< of splines: fewer poles than 3 at such tolerances, and smoother across edges

    double slope = 3e-3; ///< by which normals may be off along edges, so that faces that met smoothly still do [rad]

    bool findsForms =
        false; ///< makes cylinders, cones, spheres, tori, lines and circles of what the map takes to such ones

    std::set<std::uint32_t> flat;  ///< faces (from 0, as TopExp::MapShapes() numbers them) that are to be triangles
    DrawingFineness flatFineness;  ///< of these
    std::size_t mostFlat = 60'000; ///< triangles

    double faceTolerance() const { return 0.3 * tolerance; }
    double edgeTolerance() const { return std::max(1e-8, 0.1 * tolerance); } ///< several faces meet there

    /// What moves as a rigid thing up to this stays exactly what it was.
    double rigidTolerance() const { return std::max(1e-7, 0.01 * tolerance); }
};

} // namespace knead
