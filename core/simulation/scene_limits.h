#pragma once

namespace knead {

// What a scene may have, and so what a moment of its run may hold.
constexpr double fastestFixture = 100;   ///< [m/s]
constexpr double strongestGravity = 1e4; ///< [m/s^2], a thousand times that of the earth
constexpr double farthestFloor = 1e4;    ///< [m]

} // namespace knead
