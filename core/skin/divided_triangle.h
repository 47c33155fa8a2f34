#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace knead {

/// A triangle and the lines that divide it. Points are numbers of whoever asks. Lines begin and end on the sides or close in
/// themselves; where three of them meet, their tags tell which belong together.
struct DividedTriangle {
    static constexpr std::uint32_t noTag = 0xffffffffU;

    struct Line {
        std::uint32_t start = 0;
        std::uint32_t end = 0;
        std::uint32_t leftTag = 0;
        std::uint32_t rightTag = 0;
    };

    std::array<std::uint32_t, 3> corners{};              ///< counter-clockwise
    std::array<std::vector<std::uint32_t>, 3> onSides{}; ///< points from corner i on to corner i + 1
    std::vector<Line> lines;
};

/// A part of a divided triangle.
struct TriangleFace {
    /// A part of a side: `stretch` points come before it.
    struct Border {
        std::size_t side = 0;
        std::size_t stretch = 0;
    };

    std::vector<std::vector<std::uint32_t>> loops; ///< the outline, counter-clockwise, then the holes, clockwise
    std::uint32_t tag = DividedTriangle::noTag;    ///< of the lines around it
    std::vector<Border> borders;                   ///< of the outline
};

/// The faces of a divided triangle. Which lines follow each other is told by points and tags, never by places; these tell
/// holes from outlines and which hole is in which outline.
/// @param placeOf a point's place in the plane of the triangle
/// @throws DegenerateCut when the lines do not make loops
std::vector<TriangleFace> divide(const DividedTriangle& triangle,
                                 const std::function<Eigen::Vector2d(std::uint32_t)>& placeOf);

} // namespace knead
