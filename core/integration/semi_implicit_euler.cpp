#include "core/integration/semi_implicit_euler.h"

#include "core/kernels/kernels.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t blockSize = 2048;

} // namespace

StepReport semiImplicitEuler(ObjectState& state, const Vec3& gravity, double dt)
{
    const std::size_t blocks = (state.size() + blockSize - 1) / blockSize;
    std::vector<StepReport> reports(blocks);
    forEachBlock(state.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        const kernels::AdvanceReport report =
            kernels::best().advance({.count = end - begin,
                                     .dt = dt,
                                     .gravity = gravity.data(),
                                     .weighedMass = state.weighedMass().data() + begin,
                                     .inverseMass = state.inverseMass.data() + begin,
                                     .force = state.force.data() + begin,
                                     .damping = state.damping.data() + begin,
                                     .velocity = state.velocity.data() + begin,
                                     .position = state.position.data() + begin,
                                     .stride = static_cast<std::ptrdiff_t>(state.position.stride())});
        reports[begin / blockSize] = {std::sqrt(report.squaredSpeed), report.dampingWork};
    });
    StepReport total;
    for (const StepReport& report : reports) {
        const bool isNumber = std::isfinite(report.largestSpeed);
        total.largestSpeed =
            isNumber ? std::max(total.largestSpeed, report.largestSpeed) : std::numeric_limits<double>::infinity();
        total.dampingWork += report.dampingWork;
    }
    return total;
}

void kick(ObjectState& state, const Vec3& gravity, double dt)
{
    forEachBlock(state.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (state.inverseMass[i] > 0)
                state.velocity.add(i, dt * (state.inverseMass[i] * (state.force.at(i) + state.damping.at(i)) +
                                            state.gravityShare(i) * gravity));
    });
}

} // namespace knead
