#pragma once

#include "core/aggregate/lattice.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstdint>

namespace knead {

/// Cubes of five cells that connections are sorted into by their middles, in coordinates of the lattice.
///
/// They lie alike on both sides of the middle of the lattice, where one is half a cell wider, and no middle of a connection is between two:
/// what is symmetric stays so.
class MomentBlocks {
public:
    explicit MomentBlocks(const Lattice& lattice)
    {
        Eigen::AlignedBox3d box;
        for (const Lattice::Node& node : lattice.nodes)
            box.extend(Vec3(node[0], node[1], node[2]));
        m_middle = box.center();
    }

    /// A number for the block that a place is in and a direction: twenty bits per axis, and the direction last.
    std::uint64_t numberOf(const Vec3& place, std::uint32_t direction) const
    {
        constexpr std::int64_t offset = 1 << 19;
        std::uint64_t number = 0;
        for (const double step : stepsTo(place))
            number = number << 20U | static_cast<std::uint64_t>(static_cast<std::int64_t>(step) + offset);
        return number << 4U | direction;
    }

    static bool isSameBlock(std::uint64_t a, std::uint64_t b) { return a >> 4U == b >> 4U; }

    /// From the middle of the block that a place is in, in halves of a cell.
    using Halves = std::array<std::int8_t, 3>;

    Halves halvesTo(const Vec3& place) const
    {
        const Vec3 halves = 2 * (place - m_middle - side * stepsTo(place));
        const auto whole = [&](Eigen::Index axis) { return static_cast<std::int8_t>(std::lround(halves[axis])); };
        return {whole(0), whole(1), whole(2)};
    }

    /// 1, u, v, w, uu, vv, ww, sqrt(2) (uv, uw, vw), by half of the block's side.
    using Polynomials = Eigen::Matrix<double, 10, 1>;

    static Polynomials polynomialsAt(const Halves& halves)
    {
        const double mixed = std::sqrt(2.0);
        const Vec3 x = Vec3(halves[0], halves[1], halves[2]) / side;
        Polynomials p;
        p << 1, x, x.cwiseProduct(x), mixed * x.x() * x.y(), mixed * x.x() * x.z(), mixed * x.y() * x.z();
        return p;
    }

private:
    static constexpr double side = 5; // [cells]

    Vec3 stepsTo(const Vec3& place) const
    {
        const Eigen::Array3d away = place - m_middle; // in halves
        return away.sign() * ((away.abs() + (side / 2 - 0.25)) / side).floor();
    }

    Vec3 m_middle;
};

} // namespace knead
