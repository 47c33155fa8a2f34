#include "core/integration/semi_implicit_euler.h"

#include "core/task/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace knead {

namespace {

constexpr std::size_t blockSize = 4096;

struct Axis {
    const std::vector<double>& force;
    const std::vector<double>& damping;
    std::vector<double>& velocity;
    std::vector<double>& position;
    double gravity;
};

struct AxisReport {
    double largestSpeed = 0;
    double dampingWork = 0;
};

AxisReport advanceAxis(std::size_t begin, std::size_t end, double dt, const ObjectState& state, const Axis& axis)
{
    const double* f = axis.force.data();
    const double* b = axis.damping.data();
    const double* mass = state.mass.data();
    const double* inverseMass = state.inverseMass.data();
    double* v = axis.velocity.data();
    double* x = axis.position.data();
    AxisReport report;
    for (std::size_t i = begin; i < end; ++i) {
        const double before = v[i];
        v[i] += dt * inverseMass[i] * (f[i] + b[i] + mass[i] * axis.gravity);
        x[i] += dt * v[i];
        report.dampingWork += b[i] * (0.5 * dt) * (before + v[i]);
    }
    for (std::size_t i = begin; i < end; ++i)   // the negated comparison also catches a velocity that is not a number
        if (!(std::abs(v[i]) <= report.largestSpeed))
            report.largestSpeed = std::abs(v[i]);
    return report;
}

} // namespace

StepReport semiImplicitEuler(ObjectState& state, const Vec3& gravity, double dt)
{
    const std::size_t blocks = (state.size() + blockSize - 1) / blockSize;
    std::vector<StepReport> reports(blocks);
    forEachBlock(state.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        const auto& [f, b, v, x] = std::tie(state.force, state.damping, state.velocity, state.position);
        const AxisReport axes[] = {advanceAxis(begin, end, dt, state, {f.x, b.x, v.x, x.x, gravity.x()}),
                                   advanceAxis(begin, end, dt, state, {f.y, b.y, v.y, x.y, gravity.y()}),
                                   advanceAxis(begin, end, dt, state, {f.z, b.z, v.z, x.z, gravity.z()})};
        StepReport& report = reports[begin / blockSize];
        for (const AxisReport& axis : axes) {
            report.largestSpeed = std::hypot(report.largestSpeed, axis.largestSpeed);
            report.dampingWork += axis.dampingWork;
        }
    });
    StepReport total;
    for (const StepReport& report : reports) {
        if (!(report.largestSpeed <= total.largestSpeed))
            total.largestSpeed = report.largestSpeed;
        total.dampingWork += report.dampingWork;
    }
    return total;
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
