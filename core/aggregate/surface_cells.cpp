#include "core/aggregate/surface_cells.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

std::int32_t cellOf(double coordinate)
{
    return static_cast<std::int32_t>(std::floor(coordinate));
}

using Vec2 = Eigen::Vector2d;

/// A triangle seen along the axis that it faces most, so that it is never seen edge on.
struct View {
    std::array<Vec2, 3> corners;
    std::array<double, 3> heights{};
    Vec2 slope = Vec2::Zero(); // of its plane
    double orientation = 0;    // 1: counter-clockwise, -1: clockwise, 0: a line

    View(const std::array<Vec3, 3>& places, Eigen::Index axis)
    {
        const Eigen::Index a = (axis + 1) % 3;
        const Eigen::Index b = (axis + 2) % 3;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = Vec2(places[i][a], places[i][b]);
            heights[i] = places[i][axis];
        }
        const Vec3 normal = (places[1] - places[0]).cross(places[2] - places[0]);
        orientation = normal[axis] > 0 ? 1 : normal[axis] < 0 ? -1 : 0;
        if (orientation != 0)
            slope = -Vec2(normal[a], normal[b]) / normal[axis];
    }

    /// Least and greatest height of the plane over a square, as far as the triangle reaches.
    std::array<double, 2> heightsOver(const Eigen::AlignedBox2d& square) const
    {
        const auto [low, high] = std::ranges::minmax_element(heights);
        if (orientation == 0)
            return {*low, *high};
        const double middle = heights[0] + slope.dot(square.center() - corners[0]);
        const double spread = 0.5 * slope.cwiseAbs().dot(square.sizes());
        return {std::max(*low, middle - spread), std::min(*high, middle + spread)};
    }

    /// Whether a side of the triangle has the whole square beyond it.
    bool isBeside(const Eigen::AlignedBox2d& square) const
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2 along = corners[(i + 1) % 3] - corners[i];
            const Vec2 inwards = orientation * Vec2(-along.y(), along.x());
            if (inwards.dot(square.center() - corners[i]) + 0.5 * inwards.cwiseAbs().dot(square.sizes()) < 0)
                return true;
        }
        return false;
    }
};

} // namespace

void forEachTouchedCell(const std::array<Vec3, 3>& corners, double margin,
                        const std::function<void(const Lattice::Node& cell)>& visit)
{
    Eigen::Index axis = 0;
    (corners[1] - corners[0]).cross(corners[2] - corners[0]).cwiseAbs().maxCoeff(&axis);
    const View view(corners, axis);
    Eigen::AlignedBox2d box;
    for (const Vec2& corner : view.corners)
        box.extend(corner);
    for (std::int32_t a = cellOf(box.min().x() - margin); a <= cellOf(box.max().x() + margin); ++a)
        for (std::int32_t b = cellOf(box.min().y() - margin); b <= cellOf(box.max().y() + margin); ++b) {
            const Eigen::AlignedBox2d square(Vec2(a - margin, b - margin), Vec2(a + 1 + margin, b + 1 + margin));
            if (view.isBeside(square))
                continue;
            const auto [low, high] = view.heightsOver(square);
            for (std::int32_t height = cellOf(low - margin); height <= cellOf(high + margin); ++height) {
                Lattice::Node cell{};
                cell[static_cast<std::size_t>(axis)] = height;
                cell[static_cast<std::size_t>((axis + 1) % 3)] = a;
                cell[static_cast<std::size_t>((axis + 2) % 3)] = b;
                visit(cell);
            }
        }
}

} // namespace knead
