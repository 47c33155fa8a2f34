#pragma once

#include "core/geometry/vec3.h"
#include "core/integration/solver_settings.h"

#include <cstdint>

namespace knead {

/// A hand that guides a tool and pushes it no harder than it may: a spring from the tool's center x to where the hand is, g, on top of
/// what it pushed with at the end of the last step, p,
///     w = p + k (g - x),   f = min(1, limit / |w|) w.
/// The tool has no mass: at the end of a step f balances what the material does to it. So a tool at its limit goes along with the
/// material, and follows the hand where nothing is in the way; below its limit it comes to where the hand is.
struct ToolHand {
    std::uint32_t surface = 0;    ///< index of the tool among the rigid surfaces
    Vec3 from = Vec3::Zero();     ///< center at the start of the step [m]
    Vec3 goal = Vec3::Zero();     ///< g, at its end [m]
    Vec3 push = Vec3::Zero();     ///< p, no more than the limit [N]
    Vec3 velocity = Vec3::Zero(); ///< of the tool at the start of the step [m/s]
    double limit = 0;             ///< > 0 [N]
    double stiffness = 0;         ///< k, > 0 [N/m]

    /// f with the center at `place` [N].
    Vec3 forceAt(const Vec3& place) const { return grip(place) * wantedAt(place); }

    /// How f answers to a way of the center there, -df/dx; symmetric, positive definite [N/m].
    Mat3 stiffnessAt(const Vec3& place) const
    {
        const double s = grip(place);
        Mat3 answer = s * stiffness * Mat3::Identity();
        if (s < 1) {
            const Vec3 along = wantedAt(place).normalized();
            answer -= solverSettings.newton.handSlack * s * stiffness * along * along.transpose();
        }
        return answer;
    }

private:
    Vec3 wantedAt(const Vec3& place) const { return push + stiffness * (goal - place); }
    double grip(const Vec3& place) const
    {
        const double wanted = wantedAt(place).norm();
        return wanted > limit ? limit / wanted : 1;
    }
};

} // namespace knead
