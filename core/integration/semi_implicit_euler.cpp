#include "core/integration/semi_implicit_euler.h"

#include "core/mechanics/lattice_kernels.h"
#include "core/task/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

/// Largest absolute value; not a number when one of them is.
double largestOf(const double* values, std::size_t count)
{
    // Bit patterns of absolute values compare like the values, with infinities and what is no number on top.
    std::int64_t largest = 0;
    for (std::size_t i = 0; i < count; ++i)
        largest = std::max(largest, std::bit_cast<std::int64_t>(values[i]) & std::numeric_limits<std::int64_t>::max());
    return std::bit_cast<double>(largest);
}

} // namespace

StepReport semiImplicitEuler(ObjectState& state, const Vec3& gravity, double dt)
{
    const std::size_t blocks = (state.size() + blockSize - 1) / blockSize;
    std::vector<StepReport> reports(blocks);
    forEachBlock(state.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        std::array<double, kernels::sumLanes> work{};
        StepReport& report = reports[begin / blockSize];
        for (std::size_t c = 0; c < 3; ++c) {
            double* velocity = state.velocity.component(c) + begin;
            kernels::best().advance(end - begin, dt, gravity[static_cast<Eigen::Index>(c)], state.mass.data() + begin,
                                    state.inverseMass.data() + begin, state.force.component(c) + begin,
                                    state.damping.component(c) + begin, velocity, state.position.component(c) + begin,
                                    work.data());
            report.largestSpeed = std::hypot(report.largestSpeed, largestOf(velocity, end - begin));
        }
        report.dampingWork = std::accumulate(work.begin(), work.end(), 0.0);
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
