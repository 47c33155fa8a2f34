#include "core/geometry/shape_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <vector>

namespace knead {

namespace {

constexpr double flatness = 1e-5; // share of the squared normals across the mean one below which a patch is flat

std::vector<Vec3> verticesOf(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles,
                             std::span<const Vec3> places, std::size_t most)
{
    std::vector<std::uint32_t> vertices;
    for (const std::uint32_t triangle : triangles)
        for (const std::uint32_t v : mesh.triangles[triangle])
            if (v < most)
                vertices.push_back(v);
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::vector<Vec3> result;
    result.reserve(vertices.size());
    for (const std::uint32_t v : vertices)
        result.push_back(places[v]);
    return result;
}

/// The center and the radius of least squares |x|^2 = 2 c x + (r^2 - c^2) of the rows.
std::pair<Eigen::VectorXd, double> fitCenter(const Eigen::MatrixXd& points)
{
    Eigen::MatrixXd system(points.rows(), points.cols() + 1);
    system << 2 * points, Eigen::VectorXd::Ones(points.rows());
    const Eigen::VectorXd solution = system.colPivHouseholderQr().solve(points.rowwise().squaredNorm());
    const Eigen::VectorXd center = solution.head(points.cols());
    const double squared = solution[points.cols()] + center.squaredNorm();
    return {center, std::sqrt(std::max(0.0, squared))};
}

RoundFit fitBall(const std::vector<Vec3>& points)
{
    const Vec3 middle = points.front(); // keeps numbers small
    Eigen::MatrixXd rows(points.size(), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = (points[i] - middle).transpose();
    const auto [center, radius] = fitCenter(rows);
    RoundFit fit{.form = RoundFit::Form::ball, .center = middle + Vec3(center), .radius = radius};
    for (const Vec3& point : points)
        fit.deviation = std::max(fit.deviation, std::abs((point - fit.center).norm() - radius));
    return fit;
}

RoundFit fitCylinder(const std::vector<Vec3>& points, const Vec3& axis)
{
    const Vec3 middle = points.front();
    const Vec3 u = axis.unitOrthogonal();
    const Vec3 v = axis.cross(u);
    Eigen::MatrixXd rows(points.size(), 2);
    double lowest = 0;
    double highest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 from = points[i] - middle;
        rows.row(static_cast<Eigen::Index>(i)) << from.dot(u), from.dot(v);
        lowest = std::min(lowest, from.dot(axis));
        highest = std::max(highest, from.dot(axis));
    }
    const auto [center, radius] = fitCenter(rows);
    RoundFit fit{.form = RoundFit::Form::cylinder, .axis = axis, .radius = radius};
    fit.center = middle + center[0] * u + center[1] * v + (lowest + highest) / 2 * axis;
    for (const Vec3& point : points)
        fit.deviation = std::max(fit.deviation, std::abs((point - fit.center).cross(axis).norm() - radius));
    return fit;
}

} // namespace

std::optional<Circle> circleThrough(const Vec3& a, const Vec3& b, const Vec3& c)
{
    constexpr double straight = 1e-9; // sine of the angle below which three places lie on a line
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 across = ab.cross(ac);
    const double squared = across.squaredNorm();
    if (across.norm() <= straight * ab.norm() * ac.norm())
        return std::nullopt;
    const Vec3 toCenter = (ac.squaredNorm() * across.cross(ab) + ab.squaredNorm() * ac.cross(across)) / (2 * squared);
    return Circle{a + toCenter, across.normalized(), toCenter.norm()};
}

double angleBetween(const Vec3& a, const Vec3& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b)); // right for small angles too
}

/// By the regions around a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
Vec3 nearestShares(const std::array<Vec3, 3>& corners, const Vec3& place)
{
    const auto& [a, b, c] = corners;
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double d1 = ab.dot(place - a);
    const double d2 = ac.dot(place - a);
    if (d1 <= 0 && d2 <= 0)
        return {1, 0, 0};
    const double d3 = ab.dot(place - b);
    const double d4 = ac.dot(place - b);
    if (d3 >= 0 && d4 <= d3)
        return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
        return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
    const double d5 = ab.dot(place - c);
    const double d6 = ac.dot(place - c);
    if (d6 >= 0 && d5 <= d6)
        return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
        return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - share, share};
    }
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
}

PlaneFit fitPlane(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles, std::span<const Vec3> places)
{
    Vec3 sum = Vec3::Zero();
    Vec3 center = Vec3::Zero();
    double area = 0;
    for (const std::uint32_t triangle : triangles) {
        const auto corners = cornersOf(places, mesh.triangles[triangle]);
        const Vec3 normal = crossOf(corners);
        sum += normal;
        center += normal.norm() * (corners[0] + corners[1] + corners[2]) / 3;
        area += normal.norm();
    }
    PlaneFit fit;
    fit.center = area > 0 ? Vec3(center / area) : places[mesh.triangles[triangles.front()][0]];
    fit.normal = sum.isZero() ? Vec3(Vec3::UnitZ()) : Vec3(sum.normalized());
    for (const std::uint32_t triangle : triangles)
        for (const std::uint32_t v : mesh.triangles[triangle])
            fit.deviation = std::max(fit.deviation, std::abs((places[v] - fit.center).dot(fit.normal)));
    return fit;
}

std::optional<RoundFit> fitRound(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles,
                                 std::span<const Vec3> places, std::size_t vertices)
{
    Mat3 spread = Mat3::Zero(); // of the normals
    for (const std::uint32_t triangle : triangles) {
        const Vec3 normal = crossOf(places, mesh.triangles[triangle]);
        if (!normal.isZero())
            spread += normal * normal.transpose() / normal.norm();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(spread);
    const std::vector<Vec3> points = verticesOf(mesh, triangles, places, vertices);
    if (points.size() < 4 || solver.eigenvalues()[1] < flatness * solver.eigenvalues()[2])
        return std::nullopt;
    const RoundFit ball = fitBall(points);
    const RoundFit cylinder = fitCylinder(points, solver.eigenvectors().col(0));
    // Two rims of a cylinder lie on a ball, too: the cylinder is what its normals say.
    constexpr double acrossCylinder = 0.05;
    const bool isCylinder = solver.eigenvalues()[0] < acrossCylinder * solver.eigenvalues()[1];
    return isCylinder || cylinder.deviation < ball.deviation ? cylinder : ball;
}

} // namespace knead
