#include "io/picture/ground_shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr int cells = 384;         // along each side of the map
constexpr double mapMargin = 0.35; // of the size of what casts the shadow, on each side
constexpr double softness = 0.035; // radius of one blur, of the size
constexpr int blurs = 3;           // three box filters make nearly a Gaussian

/// One pass of a box filter along rows, with the result turned, so that two passes do both directions.
std::vector<float> blurredAndTurned(const std::vector<float>& map, int radius)
{
    std::vector<float> result(map.size());
    const auto at = [](int column, int row) {
        return static_cast<std::size_t>(row) * cells + static_cast<std::size_t>(column);
    };
    for (int row = 0; row < cells; ++row) {
        float sum = 0;
        for (int column = -radius; column < cells; ++column) {
            if (column + radius < cells)
                sum += map[at(column + radius, row)];
            if (column - radius - 1 >= 0)
                sum -= map[at(column - radius - 1, row)];
            if (column >= 0)
                result[at(row, column)] = sum / static_cast<float>(2 * radius + 1);
        }
    }
    return result;
}

} // namespace

PictureShadow::PictureShadow(const std::vector<const TriangleMesh*>& meshes, const Vec3& up)
    : m_up(up)
    , m_right(up.unitOrthogonal())
    , m_ahead(up.cross(m_right))
    , m_map(static_cast<std::size_t>(cells) * cells, 0)
{
    Box box; // in right, ahead and up
    for (const TriangleMesh* mesh : meshes)
        for (const Vec3& vertex : mesh->vertices)
            box.extend(Vec3(m_right.dot(vertex), m_ahead.dot(vertex), m_up.dot(vertex)));
    m_height = box.min().z();
    const double size = std::max({box.sizes().x(), box.sizes().y(), std::numeric_limits<double>::min()});
    m_cell = (1 + 2 * mapMargin) * size / cells;
    m_left = box.center().x() - 0.5 * cells * m_cell;
    m_near = box.center().y() - 0.5 * cells * m_cell;

    for (const TriangleMesh* mesh : meshes)
        for (const TriangleMesh::Triangle& triangle : mesh->triangles)
            cover({toMap(mesh->vertices[triangle[0]]), toMap(mesh->vertices[triangle[1]]),
                   toMap(mesh->vertices[triangle[2]])});
    const int radius = std::max(1, static_cast<int>(softness * size / m_cell));
    for (int i = 0; i < 2 * blurs; ++i)
        m_map = blurredAndTurned(m_map, radius);
}

Eigen::Vector2d PictureShadow::toMap(const Vec3& point) const
{
    return {(m_right.dot(point) - m_left) / m_cell - 0.5, (m_ahead.dot(point) - m_near) / m_cell - 0.5};
}

void PictureShadow::cover(const std::array<Eigen::Vector2d, 3>& p)
{
    const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
    const double area = cross(p[1] - p[0], p[2] - p[0]);
    if (area == 0)
        return;
    const auto isInside = [&](const Eigen::Vector2d& q) {
        return cross(p[1] - p[0], q - p[0]) / area >= 0 && cross(p[2] - p[1], q - p[1]) / area >= 0 &&
               cross(p[0] - p[2], q - p[2]) / area >= 0;
    };
    const Eigen::Vector2d low = p[0].cwiseMin(p[1]).cwiseMin(p[2]);
    const Eigen::Vector2d high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
    for (int row = static_cast<int>(std::ceil(low.y())); row <= static_cast<int>(high.y()); ++row)
        for (int column = static_cast<int>(std::ceil(low.x())); column <= static_cast<int>(high.x()); ++column)
            if (isInside({column, row}))
                m_map[static_cast<std::size_t>(row) * cells + static_cast<std::size_t>(column)] = 1;
}

double PictureShadow::at(const Vec3& point, const Vec3& forward) const
{
    const Vec3 place = point + (m_height - m_up.dot(point)) / m_up.dot(forward) * forward;
    const Eigen::Vector2d onMap = toMap(place);
    const double x = onMap.x();
    const double y = onMap.y();
    if (!(x >= 0 && y >= 0 && x < cells - 1 && y < cells - 1))
        return 0;
    const auto column = static_cast<std::size_t>(x);
    const auto row = static_cast<std::size_t>(y);
    const double u = x - static_cast<double>(column);
    const double v = y - static_cast<double>(row);
    const auto value = [&](std::size_t c, std::size_t r) { return static_cast<double>(m_map[r * cells + c]); };
    return (1 - v) * ((1 - u) * value(column, row) + u * value(column + 1, row)) +
           v * ((1 - u) * value(column, row + 1) + u * value(column + 1, row + 1));
}

} // namespace knead
