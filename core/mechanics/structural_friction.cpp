#include "core/mechanics/structural_friction.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

// Of what would stop the slide within the step; an object has up to 26 connections that brake it together.
constexpr double largestBraking = 0.5 / 13;

} // namespace

Vec3 structuralFriction(const RubbingConnection& connection, double friction, double dt)
{
    const double length = connection.across.norm();
    if (length == 0)
        return Vec3::Zero();
    const Vec3 normal = connection.across / length;
    const double approach = connection.velocity.dot(normal);
    const double load = connection.stiffness * (length - connection.nominalLength) + connection.damping * approach;
    const Vec3 slide = connection.velocity - approach * normal;
    const double speed = slide.norm();
    if (load == 0 || speed == 0)
        return Vec3::Zero();
    const double stop = largestBraking * connection.reducedMass * speed / dt;
    return std::min(friction * std::abs(load), stop) / speed * slide;
}

} // namespace knead
