#include "core/geometry/surface_ray.h"

#include <cmath>

namespace knead {

SurfaceRay::SurfaceRay(const TriangleMesh& mesh, double orientation)
    : m_mesh(mesh)
    , m_tree(mesh)
    , m_orientation(orientation)
{
    const Box box = boxOfPlaces(mesh.vertices);
    m_size = box.isEmpty() ? 0 : box.diagonal().norm();
}

/// Möller and Trumbore 1997, with the sign of the determinant telling the side. What is met within rounding of the start
/// are the neighbors of the triangle that it lies on.
std::optional<SurfaceRay::Exit> SurfaceRay::firstExit(const Vec3& start, const Vec3& direction,
                                                      std::uint32_t from) const
{
    const double nearest = 1e-9 * m_size;
    double best = m_size;
    std::optional<Exit> exit;
    m_tree.forEachAlong(start, direction, best, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t triangle = m_tree.order()[i];
            if (triangle == from)
                continue;
            const auto [a, b, c] = cornersOf(m_mesh.vertices, m_mesh.triangles[triangle]);
            const Vec3 ab = b - a;
            const Vec3 ac = c - a;
            const Vec3 normal = ab.cross(ac);
            const double slope = direction.dot(normal);
            if (m_orientation * slope <= 0)
                continue;
            const Vec3 across = (start - a).cross(direction);
            const double atB = -ac.dot(across) / slope;
            const double atC = ab.dot(across) / slope;
            const double distance = (a - start).dot(normal) / slope;
            if (atB < 0 || atC < 0 || atB + atC > 1 || distance <= nearest || distance >= best)
                continue;
            best = distance;
            exit = Exit{distance, std::abs(slope) / normal.norm(), triangle};
        }
        return best;
    });
    return exit;
}

} // namespace knead
