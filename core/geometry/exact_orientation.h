#pragma once

#include "core/geometry/vec3.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace knead {

/// Places rounded to a grid of 2^40 steps along the longest side of a box, of which orientations are told exactly: what is
/// said of one triangle never contradicts what is said of its neighbors.
class ExactOrientation {
public:
    using Place = std::array<std::int64_t, 3>;

    /// @param box of all places, not empty
    explicit ExactOrientation(const Box& box)
        : m_origin(box.min())
        , m_scale(0x1p40 / box.sizes().maxCoeff())
    {
    }

    Place rounded(const Vec3& place) const
    {
        const Vec3 steps = (place - m_origin) * m_scale;
        return {std::llround(steps.x()), std::llround(steps.y()), std::llround(steps.z())};
    }

    /// Six times the volume of the tetrahedron a b c d [cubic steps]: positive when a, b, c run counter-clockwise seen
    /// from d; exact before it is rounded, so that 0 means that they lie in a plane. Below 2^123, as differences are below 2^40.
    static double sixVolumes(const Place& a, const Place& b, const Place& c, const Place& d)
    {
        const Place u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const Place v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        const Place w{d[0] - a[0], d[1] - a[1], d[2] - a[2]};
        const auto minor = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
            return Wide{p} * s - Wide{q} * r;
        };
        return static_cast<double>(minor(u[1], u[2], v[1], v[2]) * w[0] + minor(u[2], u[0], v[2], v[0]) * w[1] +
                                   minor(u[0], u[1], v[0], v[1]) * w[2]);
    }

private:
    __extension__ using Wide = __int128;

    Vec3 m_origin;
    double m_scale; ///< steps per metre
};

} // namespace knead
