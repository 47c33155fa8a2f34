#pragma once

#include "core/geometry/plane_section.h"
#include "core/geometry/vec3.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// How dark the ground is under what lies or hangs above it: contact looks dark and sharp, what is high above leaves a faint haze.
struct GroundShadow {
    Eigen::Vector2d low = Eigen::Vector2d::Zero(); ///< corner with the least x and y [m]
    double step = 0;                               ///< between neighbors [m]; 0: there is none
    int side = 0;                                  ///< values along x, and along y
    std::vector<float> darkness;                   ///< 0 .. 1, x runs first; 0 all along the rim
};

/// Something that casts a shadow.
struct ShadowCaster {
    std::span<const std::array<std::uint32_t, 3>> triangles; ///< of points
    std::span<const float> points;                           ///< x y z [m]
};

/// Something else that does: from a place on the ground, the height of the lowest point straight above it [m]; negative: nothing.
struct ShadowProbe {
    Box box; ///< that it lies in [m]
    std::function<double(const Vec3&)> heightAbove;
};

/// With h the height above the ground of what is lowest, darkness = 1 / (1 + (h / s)^2), s a share of the size of all, blurred a little.
/// @param height of the ground [m]; what lies below it counts as on it
/// @param cut what it cuts off of the casters throws no shadow
GroundShadow groundShadow(std::span<const ShadowCaster> casters, std::span<const ShadowProbe> probes, double height,
                          const std::optional<CutPlane>& cut = {});

} // namespace knead
