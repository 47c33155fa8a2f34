#pragma once

namespace knead {

/// What a number measures. Inside everything is SI; people see millimetres, megapascals and the like.
enum class Quantity {
    Number,
    Length,
    Pressure,
    Density,
    Rate,
    Speed,
    Force,
    Volume,
    Time,
    Strain,
    Area,
    Angle,
    Mass,
    Acceleration,
    Stiffness,
    Toughness ///< work per area
};

} // namespace knead
