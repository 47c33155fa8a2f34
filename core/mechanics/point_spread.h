#pragma once

#include "core/aggregate/lattice.h"
#include "core/mechanics/vector_array.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace knead {

/// A point of material between objects: x = sum w_i x_i, with the weights of the trilinear interpolation in its cell of the lattice.
/// A force on it is shared out with the same weights, which keeps its work, its momentum and its torque.
struct PointSpread {
    std::array<ObjectIndex, 8> objects{};
    std::array<double, 8> weights{}; ///< their sum is 1; below 0 for points just outside of the cell
    std::uint32_t count = 0;         ///< of those in use

    Vec3 at(const VectorArray& values) const
    {
        Vec3 sum = Vec3::Zero();
        for (std::uint32_t n = 0; n < count; ++n)
            sum += weights[n] * values.at(objects[n]);
        return sum;
    }
    void add(const Vec3& value, VectorArray& values) const
    {
        for (std::uint32_t n = 0; n < count; ++n)
            values.add(objects[n], weights[n] * value);
    }
    ObjectIndex main() const; ///< of the largest weight
    /// sum |w_i| >= 1: where the objects have moved by 1 at most, the point has moved by no more than this.
    double weightSum() const
    {
        double sum = 0;
        for (std::uint32_t n = 0; n < count; ++n)
            sum += std::abs(weights[n]);
        return sum;
    }
};

/// That of an object's own place.
PointSpread spreadOf(ObjectIndex object);

/// That of a place at rest: in its cell, or the nearest one around it that has all of its objects. None where there is none.
std::optional<PointSpread> spreadOf(const Lattice& lattice, const Vec3& place);

} // namespace knead
