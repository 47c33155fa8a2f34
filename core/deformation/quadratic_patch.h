#pragma once

#include "core/geometry/vec3.h"

#include <Eigen/Core>

namespace knead {

/// A quadratic function of space with values in space, as it holds in a cube:
///   p(t) = c0 + c1 tx + c2 ty + c3 tz + c4 tx^2 + c5 ty^2 + c6 tz^2 + c7 tx ty + c8 ty tz + c9 tz tx,  t = (X - center) / half.
struct QuadraticPatch {
    using Terms = Eigen::Matrix<double, 10, 1>;
    using Coefficients = Eigen::Matrix<double, 3, 10>;

    Vec3 center = Vec3::Zero();                       ///< of the cube [m]
    double half = 1;                                  ///< of its sides [m]
    Coefficients coefficients = Coefficients::Zero(); ///< c0 .. c9 [m]

    static Terms termsAt(const Vec3& t)
    {
        Terms terms;
        terms << 1, t.x(), t.y(), t.z(), t.x() * t.x(), t.y() * t.y(), t.z() * t.z(), t.x() * t.y(), t.y() * t.z(),
            t.z() * t.x();
        return terms;
    }

    Vec3 within(const Vec3& place) const { return (place - center) / half; } ///< t of a place

    /// p(t), by Horner's scheme.
    Vec3 at(const Vec3& t) const
    {
        const Coefficients& c = coefficients;
        return c.col(0) + t.x() * (c.col(1) + t.x() * c.col(4) + t.y() * c.col(7)) +
               t.y() * (c.col(2) + t.y() * c.col(5) + t.z() * c.col(8)) +
               t.z() * (c.col(3) + t.z() * c.col(6) + t.x() * c.col(9));
    }

    /// The same function about another cube.
    QuadraticPatch about(const Vec3& otherCenter, double otherHalf) const
    {
        const double a = otherHalf / half;
        const Vec3 b = within(otherCenter);
        const Coefficients& c = coefficients;
        QuadraticPatch other{otherCenter, otherHalf, a * a * c};
        other.coefficients.col(0) = at(b);
        other.coefficients.col(1) = a * (c.col(1) + 2 * b.x() * c.col(4) + b.y() * c.col(7) + b.z() * c.col(9));
        other.coefficients.col(2) = a * (c.col(2) + 2 * b.y() * c.col(5) + b.x() * c.col(7) + b.z() * c.col(8));
        other.coefficients.col(3) = a * (c.col(3) + 2 * b.z() * c.col(6) + b.y() * c.col(8) + b.x() * c.col(9));
        return other;
    }
};

/// How much a patch counts at t: prod (1 - t_k^2)^3 in its cube, 0 outside. Twice continuously differentiable.
inline double patchWeight(const Vec3& t)
{
    const Vec3 rest = (1 - t.array().square()).max(0.0);
    const double product = rest.x() * rest.y() * rest.z();
    return product * product * product;
}

} // namespace knead
