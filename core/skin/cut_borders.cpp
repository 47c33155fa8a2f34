#include "core/skin/cut_borders.h"

#include "core/aggregate/pieces.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr std::uint32_t none = 0xffffffffU; // label of what takes no part
constexpr double reach = 2.5;               // of the points that say where a cut is [spacings]
constexpr std::size_t mostPoints = 24;
constexpr std::size_t leastPoints = 4;
// Points that lie in a line say nothing about a plane: least share of their second by their first principal moment.
constexpr double leastBreadth = 0.02;

} // namespace

CutBorders::CutBorders(const Aggregate& aggregate, std::span<const BrokenConnection> broken,
                       std::span<const std::uint32_t> labels)
    : m_spacing(aggregate.lattice.spacing)
{
    std::vector<Vec3> points;
    for (const BrokenConnection& connection : broken) {
        const ObjectIndex upper = upperEnd(aggregate.lattice, connection);
        const std::uint32_t lowerLabel = labels[connection.lower];
        if (lowerLabel == labels[upper] || lowerLabel == none || labels[upper] == none)
            continue;
        const Vec3 way = aggregate.lattice.direction(static_cast<int>(connection.direction));
        const double share = connection.isCut() ? connection.cutAt : 0.5;
        points.push_back(aggregate.lattice.position(connection.lower) + share * way);
        m_crossings.push_back({lowerLabel, labels[upper], way, connection.isCut()});
    }
    m_points = VectorArray(points);
    if (!points.empty())
        m_grid.emplace(m_points, m_spacing);
}

std::optional<CutBorders::Height> CutBorders::at(const Vec3& place) const
{
    if (!m_grid)
        return {};
    std::vector<PointGrid::Found> found;
    m_grid->nearest(place, mostPoints, found, reach * m_spacing);
    if (found.size() < leastPoints)
        return {};
    const auto labelsOf = [&](const Crossing& crossing) {
        return std::pair(std::min(crossing.lower, crossing.upper), std::max(crossing.lower, crossing.upper));
    };
    const std::pair<std::uint32_t, std::uint32_t> labels = labelsOf(m_crossings[found.front().point]);
    const auto [below, above] = labels;
    double sum = 0;
    Vec3 middle = Vec3::Zero();
    Vec3 upwards = Vec3::Zero();
    const auto weightOf = [&](const PointGrid::Found& point) {
        const double near = 1 - point.squared / (reach * reach * m_spacing * m_spacing);
        return near * near;
    };
    for (const PointGrid::Found& point : found) {
        const Crossing& crossing = m_crossings[point.point];
        if (!crossing.isCut || labelsOf(crossing) != labels)
            return {};
        const double weight = weightOf(point);
        sum += weight;
        middle += weight * m_points.at(point.point);
        upwards += (crossing.lower == labels.first ? weight : -weight) * crossing.way;
    }
    middle /= sum;
    Mat3 moments = Mat3::Zero();
    for (const PointGrid::Found& point : found) {
        const Vec3 arm = m_points.at(point.point) - middle;
        moments += weightOf(point) * arm * arm.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(moments);
    if (principal.eigenvalues()[1] < leastBreadth * principal.eigenvalues()[2])
        return {};
    Vec3 normal = principal.eigenvectors().col(0);
    if (normal.dot(upwards) < 0)
        normal = -normal;
    return Height{below, above, normal.dot(place - middle) / m_spacing};
}

} // namespace knead
