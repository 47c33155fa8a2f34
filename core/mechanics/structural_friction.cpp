#include "core/mechanics/structural_friction.h"

#include "core/geometry/vec3.h"

#include <algorithm>

namespace knead {

namespace {

// Of what would stop the slide within the step; an object has up to 26 connections that brake it together.
constexpr double largestBraking = 0.5 / 13;

Vec3 at(const kernels::ConstVectors& v, std::size_t i)
{
    return {v.x[i], v.y[i], v.z[i]};
}
Vec3 at(const kernels::Vectors& v, std::size_t i)
{
    return {v.x[i], v.y[i], v.z[i]};
}

} // namespace

void addStructuralFriction(std::size_t count, const kernels::End& self, const kernels::End& neighbor,
                           const double* const (&mass)[2], double friction, double dt, const kernels::Vectors& pull,
                           const kernels::Vectors& brake)
{
    if (dt <= 0)
        return;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 across = at(neighbor.position, i) - at(self.position, i);
        const double length = across.norm();
        const Vec3 velocity = at(neighbor.velocity, i) - at(self.velocity, i);
        const double normalForce = (at(pull, i) + at(brake, i)).norm();
        if (length == 0 || normalForce == 0)
            continue;
        const Vec3 slide = velocity - velocity.dot(across) / (length * length) * across;
        const double speed = slide.norm();
        if (speed == 0)
            continue;
        const double reducedMass = mass[0][i] * mass[1][i] / (mass[0][i] + mass[1][i]);
        const Vec3 force = std::min(friction * normalForce, largestBraking * reducedMass * speed / dt) / speed * slide;
        brake.x[i] += force.x();
        brake.y[i] += force.y();
        brake.z[i] += force.z();
    }
}

} // namespace knead
