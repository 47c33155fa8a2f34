#include "core/deformation/kept_weight.h"

#include "core/geometry/refine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace knead {

namespace {

using KeptCorners = std::array<Vec3, 3>;

constexpr double rangeShare =
    0.7; // f, of the fade: branches whose middle is nearer than they are do not count beyond it
constexpr double longestKeptEdge = 1.0 / 5; // of triangles, in f
constexpr std::size_t mostKeptTriangles = 400'000;
constexpr double keptRaise = 1e-5;       // height above a triangle, in f
constexpr double fromMoments = 3.5;      // radii away, moments are enough
constexpr double fromTriangles = 2.5;    // nearer than that only what is inside counts
constexpr double keptHalfway = 0.243676; // int_{1/2}^1 rho^-4 (1 - rho^2)^5 drho

/// g(s) = s^(-5/2) (1 - s)^5, s = r^2 < 1, and its derivatives by s.
struct Kernel {
    double value = 0;
    double first = 0;
    double second = 0;

    explicit Kernel(double s)
    {
        const double rest = std::max(1 - s, 0.0);
        const double power = 1 / (s * s * std::sqrt(s));
        const double cube = rest * rest * rest;
        value = power * cube * rest * rest;
        first = power * cube * rest * (-5 - 2.5 * rest / s);
        second = power * cube * (20 + 25 * rest / s + 8.75 * rest * rest / (s * s));
    }
};

double blendAt(double t)
{
    const double c = std::clamp(t, 0.0, 1.0);
    return c * c * c * (c * (6 * c - 15) + 10);
}

/// int over a triangle of r^-5 (1 - r^2)^5 dA, where r^2 = h^2 + in-plane distance^2, with the height h keptRaise a little. Exactly are
///   int r^-3 dA = solid angle / h,
///   int r^-5 dA = (solid angle + h sum over edges of a l / ((a^2 + h^2) r) from end to end) / (3 h^3),
/// where a is how far inside of an edge the foot of the place lies, and l how far along it (the divergence theorem in the plane).
/// Their quotient is a mean of r^2, with which the other factor is taken.
double integralOver(const KeptCorners& corners, const Vec3& place)
{
    const Vec3 cross = crossOf(corners);
    const Vec3 normal = cross.normalized();
    const double above = normal.dot(place - corners[0]);
    const double h = std::sqrt(above * above + keptRaise * keptRaise);
    std::array<Vec3, 3> from; // the keptRaise place
    std::array<double, 3> r{};
    for (std::size_t i = 0; i < 3; ++i) {
        from[i] = corners[i] - place + (above - h) * normal;
        r[i] = from[i].norm();
    }
    double edges = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const Vec3 along = (corners[j] - corners[i]).normalized();
        const double inside = along.cross(normal).dot(from[i]);
        edges += inside / (inside * inside + h * h) * (along.dot(from[j]) / r[j] - along.dot(from[i]) / r[i]);
    }
    // van Oosterom and Strackee 1983
    const double solidAngle = 2 * std::atan2(std::abs(from[0].dot(from[1].cross(from[2]))),
                                             r[0] * r[1] * r[2] + from[0].dot(from[1]) * r[2] +
                                                 from[1].dot(from[2]) * r[0] + from[2].dot(from[0]) * r[1]);
    const double third = solidAngle / h;
    const double fifth = (solidAngle + h * edges) / (3 * h * h * h);
    const double rest = 1 - third / std::max(fifth, third);
    return fifth > third ? fifth * rest * rest * rest * rest * rest : 0;
}

} // namespace

KeptWeight::KeptWeight(const TriangleMesh& mesh, double fade)
    : m_perUnit(1 / (rangeShare * fade))
{
    const TriangleMesh fine = refine(mesh, longestKeptEdge / m_perUnit, mostKeptTriangles);
    for (const TriangleMesh::Triangle& t : fine.triangles) {
        KeptCorners corners = cornersOf(fine.vertices, t);
        for (Vec3& corner : corners)
            corner *= m_perUnit;
        if (crossOf(corners).squaredNorm() > 0)
            m_triangles.push_back(corners);
    }
    std::vector<std::uint32_t> order(m_triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    if (order.empty())
        return;
    m_branches.resize(1);
    grow(order, 0, order.size(), 0);
}

/// Halves by the middles along the longest side of their box.
std::uint32_t KeptWeight::grow(std::vector<std::uint32_t>& order, std::size_t begin, std::size_t end, std::uint32_t at)
{
    const auto middle = [&](std::uint32_t t) {
        return Vec3((m_triangles[t][0] + m_triangles[t][1] + m_triangles[t][2]) / 3);
    };
    Branch branch;
    if (end - begin == 1) {
        const KeptCorners& corners = m_triangles[order[begin]];
        branch = {middle(order[begin]), 0, crossOf(corners).norm() / 2, Mat3::Zero(), order[begin], true};
        for (const Vec3& corner : corners) {
            const Vec3 from = corner - branch.center;
            branch.radius = std::max(branch.radius, from.norm());
            branch.moment += branch.area / 12 * from * from.transpose();
        }
        m_branches[at] = branch;
        return at;
    }
    Box box;
    for (std::size_t i = begin; i < end; ++i)
        box.extend(middle(order[i]));
    Eigen::Index side = 0;
    box.sizes().maxCoeff(&side);
    const std::size_t half = begin + (end - begin) / 2;
    const auto place = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(begin), place(half), place(end), [&](std::uint32_t one, std::uint32_t other) {
        return std::pair(middle(one)[side], one) < std::pair(middle(other)[side], other);
    });
    branch.first = static_cast<std::uint32_t>(m_branches.size());
    m_branches.resize(m_branches.size() + 2);
    grow(order, begin, half, branch.first);
    grow(order, half, end, branch.first + 1);
    const std::array<const Branch*, 2> parts{&m_branches[branch.first], &m_branches[branch.first + 1]};
    branch.area = parts[0]->area + parts[1]->area;
    branch.center = (parts[0]->area * parts[0]->center + parts[1]->area * parts[1]->center) / branch.area;
    for (const Branch* part : parts) {
        const Vec3 from = part->center - branch.center;
        branch.radius = std::max(branch.radius, from.norm() + part->radius);
        branch.moment += part->moment + part->area * from * from.transpose();
    }
    m_branches[at] = branch;
    return at;
}

double KeptWeight::at(const Vec3& place) const
{
    if (m_branches.empty())
        return 1;
    const double factor = 1 / (2 * std::numbers::pi * keptHalfway);
    return 1 / (1 + factor * integral(0, m_perUnit * place));
}

/// int g dA over a branch. From its moments to the second order of Taylor's series.
double KeptWeight::integral(std::uint32_t which, const Vec3& place) const
{
    const Branch& branch = m_branches[which];
    const Vec3 from = branch.center - place;
    const double squared = from.squaredNorm();
    const double r = std::sqrt(squared);
    if (r >= 1 + branch.radius)
        return 0;
    const double share = blendAt((r / branch.radius - fromTriangles) / (fromMoments - fromTriangles));
    double sum = 0;
    if (share > 0) {
        const Kernel g(squared);
        sum += share * (g.value * branch.area + g.first * branch.moment.trace() +
                        2 * g.second * from.dot(branch.moment * from));
    }
    if (share == 1)
        return sum;
    const double inside = branch.isTriangle ? integralOver(m_triangles[branch.first], place)
                                            : integral(branch.first, place) + integral(branch.first + 1, place);
    return sum + (1 - share) * inside;
}

} // namespace knead
