#pragma once

#include "io/export/divided_shape.h"

#include <gp_Pln.hxx>

#include <cstddef>
#include <optional>
#include <span>

namespace knead {

/// A shape whose faces end at planes.
struct PlaneDivision {
    DividedShape shape;
    std::size_t divided = 0; ///< faces that came in several pieces
};

/// Divides the faces of a shape where planes go through them. Solids stay whole: nothing is put between the pieces.
/// @param planes [mm]
/// @return none where faces cannot be divided soundly: not closed any more, not valid, of another volume
std::optional<PlaneDivision> dividedAtPlanes(const TopoDS_Shape& shape, std::span<const gp_Pln> planes);

} // namespace knead
