#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/task/task_control.h"

#include <cstddef>

namespace knead {

/// How thick the walls of a body are.
///
/// From points spread evenly over the area a ray goes straight in. Where it leaves through a surface that is within 20
/// degrees of parallel, there is a wall, as thick as the ray is long. At edges the thickness goes to zero by geometry alone:
/// there the surfaces are not parallel, and the place says nothing about walls. (Balls that touch the surface from inside
/// shrink to nothing at every edge, also those of a cube.) A blade with less than 20 degrees is a wall down to its edge;
/// so what counts as thinnest is the thickness that 2 % of the area is below.
struct WallThickness {
    double thinnest = 0;  ///< 2 % of the surface belongs to thinner walls [m]
    double typical = 0;   ///< half of the area that belongs to walls is thinner [m]
    double wallShare = 0; ///< of the area that belongs to walls, 0..1
};

/// Where less than 2 % of the area belongs to walls, both lengths are 6 V / A: the diameter of the ball inside, when one
/// ball touches all faces. Takes the same samples whatever the number of threads; quick for a million triangles.
/// @pre the mesh is closed
/// @throws Cancelled
WallThickness wallThickness(const TriangleMesh& mesh, TaskControl& control = TaskControl::none());

} // namespace knead
