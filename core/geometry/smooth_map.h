#pragma once

#include "core/geometry/vec3.h"

#include <span>

namespace knead {

/// A smooth map x(X) of space into itself: what takes a part to its deformed shape. Twice continuously differentiable near
/// the part. Its functions may be called from any number of threads.
class SmoothMap {
public:
    virtual ~SmoothMap() = default;

    /// Where points are taken.
    /// @param places as many as points, written
    virtual void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const = 0;

    /// A length over which the map is well described by a quadratic function. Whoever approximates the map looks at it at
    /// least this often.
    virtual double featureSize() const = 0;

    /// What carries a face that places are of, and smoothly goes on beyond its borders, for a map that is not smooth everywhere; else
    /// the map itself. It lives as long as this.
    virtual const SmoothMap& ofFace(std::span<const Vec3> places) const
    {
        static_cast<void>(places);
        return *this;
    }

    /// Where one point is taken.
    Vec3 at(const Vec3& point) const;

    /// Gradient F = dx/dX at a point, by central differences over a tenth of the feature size. Its determinant is
    /// negative where the map folds space.
    Mat3 gradient(const Vec3& point) const;
};

} // namespace knead
