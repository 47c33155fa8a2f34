#include "core/geometry/area_samples.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

double fraction(double value)
{
    return value - std::floor(value);
}

} // namespace

AreaSamples::AreaSamples(const TriangleMesh& mesh, std::size_t count)
    : m_mesh(mesh)
    , m_count(count)
    , m_areaUpTo(mesh.triangles.size())
{
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        m_areaUpTo[t] = sum += 0.5 * crossOf(mesh.vertices, mesh.triangles[t]).norm();
}

AreaSamples::Sample AreaSamples::operator[](std::size_t i) const
{
    const double area = (static_cast<double>(i) + 0.5) / static_cast<double>(m_count) * m_areaUpTo.back();
    const auto found = std::upper_bound(m_areaUpTo.begin(), m_areaUpTo.end() - 1, area);
    const auto triangle = static_cast<std::uint32_t>(found - m_areaUpTo.begin());
    double b = fraction(0.7548776662466927 * static_cast<double>(i));
    double c = fraction(0.5698402909980532 * static_cast<double>(i));
    if (b + c > 1) {
        b = 1 - b;
        c = 1 - c;
    }
    const std::array<Vec3, 3> corners = cornersOf(m_mesh.vertices, m_mesh.triangles[triangle]);
    return {corners[0] + b * (corners[1] - corners[0]) + c * (corners[2] - corners[0]),
            crossOf(corners).stableNormalized(), triangle};
}

} // namespace knead
