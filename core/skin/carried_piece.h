#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/geometry/triangle_mesh.h"
#include "core/skin/skin_map.h"
#include "core/task/task_control.h"

#include <memory>
#include <span>
#include <vector>

namespace knead {

/// A body, or a piece of one that has come apart, whose material can be asked for at any place of it.
struct CarriedPiece {
    TriangleMesh mesh;                          ///< its surface in the opened part, fine enough to bend
    std::vector<Vec3> filled;                   ///< where its vertices were when the objects were filled [m]
    std::vector<Vec3> now;                      ///< where they are [m]
    std::shared_ptr<const Aggregate> aggregate; ///< its objects alone
    std::vector<ObjectIndex> numbers;           ///< of these in the body; empty: they are all of it
    std::unique_ptr<const SkinMap> map;         ///< x(X) of the piece, from the opened part to now
    bool spansCracks = false; ///< cracks of it could not be made surfaces: on both sides of them it is one piece
};

/// The pieces of a body, one where it hangs together.
/// @param surface of the opened part
/// @param displacements one per object, since they were filled [m]
/// @throws Cancelled
std::vector<CarriedPiece> carriedPieces(const TriangleMesh& surface, const std::shared_ptr<const Aggregate>& aggregate,
                                        std::span<const Vec3> displacements, std::span<const BrokenConnection> broken,
                                        TaskControl& control = TaskControl::none());

/// Where places of a piece were in the opened part: X with x(X) = place, by Newton's method from the nearest of the objects. As near
/// as a millionth of a spacing; a place at which the map folds stays as near as that came.
/// @param places now [m]
/// @return one per place [m]
std::vector<Vec3> openedPlaces(const CarriedPiece& piece, std::span<const Vec3> places);

} // namespace knead
