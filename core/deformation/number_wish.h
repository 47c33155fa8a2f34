#pragma once

#include "core/deformation/number_deformation.h"

#include <optional>
#include <span>

namespace knead {

/// A NumberDeformation as a person says it: what is left open follows from the parts that it is for.
struct NumberWish {
    NumberKind kind = NumberKind::bend;
    double amount = 0;        ///< the angle [rad], the factor, or the shift [m]
    std::optional<Vec3> axis; ///< of any length; none: along the longest side of the box around the parts
    std::optional<Vec3>
        side; ///< of any length, made perpendicular; none: z, of an axis along z x, of an axis along y z
    std::optional<Vec3> origin;   ///< [m]; none: in the middle of the parts, but at 0 along the axis
    std::optional<double> from;   ///< along the axis from the origin [m]; none: where the parts begin
    std::optional<double> to;     ///< [m]; none: where they end, or as a radius says
    std::optional<double> radius; ///< bend: of the plane that keeps its length; to = from + |angle| radius [m]
    std::optional<double>
        neutral; ///< bend: of the plane that keeps its length, toward the side from the origin [m]; none: 0
    std::optional<double>
        kFactor;      ///< bend: where that lies in the thickness, 0 inside to 1 outside, in place of `neutral`
    double stays = 0; ///< as NumberDeformation
    bool eases = false;
};

/// @param places of the surfaces of the parts [m], one at least
/// @throws Problem where directions are none, or more is said than can hold
NumberDeformation numberDeformation(const NumberWish& wish, std::span<const Vec3> places);

} // namespace knead
