#pragma once

#include "core/geometry/vec3.h"
#include "io/fields/nodal_mesh.h"

#include <cstddef>
#include <vector>

namespace knead {

/// Where CalculiX integrates a solid cell, in the order of its numbers, by the corners of the cell [m]: the points of Gauss, in bricks along
/// the first axis first; of wedges, whose stress is told at their center, that one as often as there are points. None for other cells.
std::vector<Vec3> integrationPlaces(const NodalMesh& mesh, std::size_t cell);

/// The center of a cell: the mean of its nodes [m].
Vec3 centerOf(const NodalMesh& mesh, std::size_t cell);

/// Whether a cell is a solid one of a kind that solvers take stress for.
bool isSolidCell(const NodalMesh& mesh, std::size_t cell);

} // namespace knead
