#include "core/integration/forward_euler.h"

#include "core/task/block_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

StepReport forwardEuler(ObjectState& state, const Vec3& gravity, double dt)
{
    constexpr std::size_t blockSize = 4096;
    const LaneVector<double>& weighed = state.weighedMass();
    const auto reports = ofEachBlock<StepReport>(state.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        StepReport report;
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3 before = state.velocity.at(i);
            const Vec3 braking = state.damping.at(i);
            Vec3 after = before + dt * state.inverseMass[i] * (state.force.at(i) + braking + weighed[i] * gravity);
            if (state.inverseMass[i] == 0)
                after = before;
            state.position.add(i, dt * before);
            state.velocity.set(i, after);
            report.dampingWork += 0.5 * dt * braking.dot(before + after);
            const double speed = after.norm();
            if (!(speed <= report.largestSpeed))
                report.largestSpeed = std::isfinite(speed) ? speed : std::numeric_limits<double>::infinity();
        }
        return report;
    });
    StepReport total;
    for (const StepReport& report : reports) {
        total.largestSpeed = std::max(total.largestSpeed, report.largestSpeed);
        total.dampingWork += report.dampingWork;
    }
    return total;
}

} // namespace knead
