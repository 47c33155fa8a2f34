#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace knead {

/// Triangles of a plane into which points are put one after the other: Delaunay, but for sides along which the mesh ends,
/// which stay (Lawson 1977).
class PlanarMesh {
public:
    using Triangle = std::array<std::uint32_t, 3>; ///< counter-clockwise; side i runs from corner i to the next one

    /// @param points any unit of length
    /// @param triangles mostly counter-clockwise ones. A side that two of them have in the same direction is a border
    PlanarMesh(std::vector<Eigen::Vector2d> points, std::vector<Triangle> triangles);

    const std::vector<Eigen::Vector2d>& points() const { return m_points; }
    const std::vector<Triangle>& triangles() const { return m_triangles; }

    bool isBorder(std::uint32_t triangle, std::size_t side) const { return m_neighbors[triangle][side] == none; }

    /// Twice the area, negative when clockwise.
    double turnOf(std::uint32_t triangle) const;

    /// Puts a point into the middle of a triangle.
    /// @return the triangles that changed or are new
    std::vector<std::uint32_t> addInside(std::uint32_t triangle);

    /// Puts a point on the middle of a side that is no border.
    /// @return the triangles that changed or are new
    std::vector<std::uint32_t> addOnSide(std::uint32_t triangle, std::size_t side);

private:
    static constexpr std::uint32_t none = 0xffffffffU;

    struct Side {
        std::uint32_t triangle;
        std::size_t side;
    };

    /// Two triangles, a b c and b a d, on both sides of a b, and what lies beyond their other sides.
    struct Pair {
        std::uint32_t other; ///< the second one
        std::uint32_t a, b, c, d;
        std::uint32_t beyondBc, beyondCa, beyondAd, beyondDb;
    };

    Pair pairAt(std::uint32_t triangle, std::size_t side) const;
    std::size_t sideFrom(std::uint32_t triangle, std::uint32_t from, std::uint32_t to) const;
    void tellNeighbor(std::uint32_t triangle, std::size_t side);
    std::vector<std::uint32_t> settle(std::vector<std::uint32_t> changed, std::vector<Side> outer);
    bool shouldFlip(std::uint32_t triangle, std::size_t side) const;
    void flip(std::uint32_t triangle, std::size_t side);

    std::vector<Eigen::Vector2d> m_points;
    std::vector<Triangle> m_triangles;
    std::vector<std::array<std::uint32_t, 3>> m_neighbors; ///< beyond each side
};

} // namespace knead
