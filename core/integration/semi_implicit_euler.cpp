#include "core/integration/semi_implicit_euler.h"

#include "core/mechanics/lattice_kernels.h"
#include "core/task/parallel.h"

#include <Eigen/Dense>

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
                                     .mass = state.mass.data() + begin,
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
                state.velocity.add(i,
                                   dt * (state.inverseMass[i] * (state.force.at(i) + state.damping.at(i)) + gravity));
    });
}

double dampShape(ObjectState& state, double rate, double dt, bool anchored)
{
    Vec3 velocity = Vec3::Zero();
    Vec3 spin = Vec3::Zero();
    Vec3 center = Vec3::Zero();
    if (!anchored) {
        double mass = 0;
        for (std::size_t i = 0; i < state.size(); ++i) {
            mass += state.mass[i];
            center += state.mass[i] * state.position.at(i);
            velocity += state.mass[i] * state.velocity.at(i);
        }
        center /= mass;
        velocity /= mass;
        Mat3 inertia = Mat3::Zero();
        Vec3 momentum = Vec3::Zero();
        for (std::size_t i = 0; i < state.size(); ++i) {
            const Vec3 r = state.position.at(i) - center;
            inertia += state.mass[i] * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
            momentum += state.mass[i] * r.cross(state.velocity.at(i));
        }
        spin = inertia.ldlt().solve(momentum);
    }
    if (anchored) {
        double held = 0;
        for (std::size_t i = 0; i < state.size(); ++i)
            if (state.inverseMass[i] == 0) {
                velocity += state.velocity.at(i);
                held += 1;
            }
        velocity /= std::max(held, 1.0);
    }
    const double share = 1 - std::exp(-rate * dt);
    double lost = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
        if (state.inverseMass[i] == 0)
            continue;
        const Vec3 before = state.velocity.at(i);
        const Vec3 rigid = velocity + spin.cross(state.position.at(i) - center);
        const Vec3 after = before + share * (rigid - before);
        lost += 0.5 * state.mass[i] * (before.squaredNorm() - after.squaredNorm());
        state.velocity.set(i, after);
    }
    return lost;
}

} // namespace knead
