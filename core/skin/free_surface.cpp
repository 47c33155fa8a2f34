#include "core/skin/free_surface.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double flatSpread = 0.22;   // second eigenvalue of the normals by the first: tan^2 of 25 degrees
constexpr double flatMean = 0.7;      // length of their mean: those of a knife's edge point away from each other
constexpr double cornerSpread = 0.08; // third by the first: normals no longer lie in a plane across an edge

/// What the triangles at a vertex say.
struct Fan {
    Mat3 normals = Mat3::Zero(); ///< sum of angle n n^T
    Vec3 mean = Vec3::Zero();    ///< sum of angle n
    Vec3 away = Vec3::Zero();    ///< sum of angle times the way to the middle of the opposite side
};

std::vector<Fan> fansOf(const TriangleMesh& mesh)
{
    std::vector<Fan> fans(mesh.vertices.size());
    for (const TriangleMesh::Triangle& triangle : mesh.triangles)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vec3& here = mesh.vertices[triangle[corner]];
            const Vec3 a = mesh.vertices[triangle[(corner + 1) % 3]] - here;
            const Vec3 b = mesh.vertices[triangle[(corner + 2) % 3]] - here;
            const Vec3 area = a.cross(b);
            const double twice = area.norm();
            if (!(twice > 0))
                continue;
            const double angle = std::atan2(twice, a.dot(b));
            const Vec3 normal = area / twice;
            Fan& fan = fans[triangle[corner]];
            fan.normals += angle * normal * normal.transpose();
            fan.mean += angle * normal;
            fan.away += angle * (a + b).normalized();
        }
    return fans;
}

FreeSurface surfaceOf(const Fan& fan)
{
    const double mean = fan.mean.norm();
    const Eigen::SelfAdjointEigenSolver<Mat3> spread(fan.normals);
    const Vec3& shares = spread.eigenvalues();
    if (!(mean > 0) || !(shares[2] > 0))
        return {};
    if (shares[1] < flatSpread * shares[2] && mean > flatMean * fan.normals.trace())
        return {FreeSurface::Kind::face, fan.mean / mean};
    const bool isOutward = fan.away.dot(fan.mean) < 0;
    if (shares[0] < cornerSpread * shares[2] && isOutward)
        return {FreeSurface::Kind::edge, spread.eigenvectors().col(0)};
    return {};
}

} // namespace

std::vector<FreeSurface> freeSurfaces(const TriangleMesh& mesh)
{
    const std::vector<Fan> fans = fansOf(mesh);
    std::vector<FreeSurface> surfaces(fans.size());
    std::transform(fans.begin(), fans.end(), surfaces.begin(), surfaceOf);
    return surfaces;
}

FreeSurface moved(const FreeSurface& surface, const Mat3& gradient)
{
    if (surface.kind == FreeSurface::Kind::none)
        return surface;
    Vec3 direction = gradient * surface.direction;
    if (surface.kind == FreeSurface::Kind::face) {
        Mat3 cofactors; // det F F^-T, which is finite for flat material, too
        cofactors << gradient.col(1).cross(gradient.col(2)), gradient.col(2).cross(gradient.col(0)),
            gradient.col(0).cross(gradient.col(1));
        direction = cofactors * surface.direction;
    }
    const double length = direction.norm();
    return length > 0 ? FreeSurface{surface.kind, direction / length} : FreeSurface{};
}

Mat3 withoutTraction(const Mat3& stress, const FreeSurface& surface, double poissonRatio, double share)
{
    if (surface.kind == FreeSurface::Kind::none || share <= 0)
        return stress;
    const Vec3& n = surface.direction;
    const Mat3 across = n * n.transpose();
    const Vec3 t = stress * n;
    const double normal = n.dot(t);
    if (surface.kind == FreeSurface::Kind::edge)
        return (1 - share) * stress + share * (normal - poissonRatio * (stress.trace() - normal)) * across;
    const Mat3 traction = n * t.transpose() + t * n.transpose() - normal * across;
    const Mat3 squeezed = poissonRatio / (1 - poissonRatio) * normal * (Mat3::Identity() - across);
    return stress - share * (traction + squeezed);
}

} // namespace knead
