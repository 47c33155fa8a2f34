#include "core/geometry/clustered.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

namespace knead {

namespace {

// Directions in which planes say less than this share of what they say at most are left as the mean of the vertices has them.
constexpr double leastSaid = 1e-3;

/// Which vertices become one.
struct Cluster {
    std::array<std::int64_t, 3> cube{};
    int side = 0; ///< of the cube that normals point to, 0 .. 5

    friend auto operator<=>(const Cluster&, const Cluster&) = default;
};

int sideOf(const Vec3& normal)
{
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    return static_cast<int>(2 * axis) + (normal[axis] < 0 ? 1 : 0);
}

/// Sum of squared distances from planes, of places relative to the mean: x^T A x - 2 b^T x.
struct Planes {
    Mat3 a = Mat3::Zero();
    Vec3 b = Vec3::Zero();

    /// Where that is least, or the mean in directions that no plane says anything of.
    Vec3 nearest() const
    {
        const Eigen::SelfAdjointEigenSolver<Mat3> solver(a);
        const Vec3 values = solver.eigenvalues();
        Vec3 place = Vec3::Zero();
        for (Eigen::Index n = 0; n < 3; ++n)
            if (values[n] > leastSaid * values[2]) {
                const Vec3 direction = solver.eigenvectors().col(n);
                place += direction.dot(b) / values[n] * direction;
            }
        return place;
    }
};

} // namespace

TriangleMesh clustered(const TriangleMesh& mesh, double size)
{
    const std::size_t count = mesh.vertices.size();
    std::vector<Vec3> normals(count, Vec3::Zero());
    for (const TriangleMesh::Triangle& t : mesh.triangles)
        for (const std::uint32_t vertex : t)
            normals[vertex] += crossOf(mesh.vertices, t);

    std::vector<std::pair<Cluster, std::uint32_t>> sorted(count);
    for (std::uint32_t v = 0; v < count; ++v) {
        Cluster& cluster = sorted[v].first;
        for (std::size_t axis = 0; axis < 3; ++axis)
            cluster.cube[axis] = std::llround(mesh.vertices[v][static_cast<Eigen::Index>(axis)] / size);
        cluster.side = sideOf(normals[v]);
        sorted[v].second = v;
    }
    std::sort(sorted.begin(), sorted.end());

    TriangleMesh coarse;
    std::vector<std::uint32_t> clusterOf(count);
    std::vector<std::uint32_t> members;
    for (std::size_t n = 0; n < count; ++n) {
        if (n == 0 || sorted[n].first != sorted[n - 1].first) {
            coarse.vertices.emplace_back(Vec3::Zero());
            members.push_back(0);
        }
        clusterOf[sorted[n].second] = static_cast<std::uint32_t>(coarse.vertices.size() - 1);
        coarse.vertices.back() += mesh.vertices[sorted[n].second];
        ++members.back();
    }
    for (std::size_t c = 0; c < members.size(); ++c)
        coarse.vertices[c] /= members[c];

    std::vector<Planes> planes(coarse.vertices.size());
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
        const Vec3 cross = crossOf(mesh.vertices, t);
        if (!(cross.norm() > 0))
            continue;
        const Vec3 normal = cross.normalized();
        for (const std::uint32_t vertex : t) {
            const std::uint32_t cluster = clusterOf[vertex];
            const double height = normal.dot(mesh.vertices[t[0]] - coarse.vertices[cluster]);
            planes[cluster].a += cross.norm() * normal * normal.transpose();
            planes[cluster].b += cross.norm() * height * normal;
        }
    }
    for (std::size_t c = 0; c < planes.size(); ++c) {
        const Vec3 move = planes[c].nearest();
        if (members[c] > 1 && move.norm() < size) // planes of a flat saddle meet far away
            coarse.vertices[c] += move;
    }

    for (const TriangleMesh::Triangle& t : mesh.triangles) {
        const TriangleMesh::Triangle corners{clusterOf[t[0]], clusterOf[t[1]], clusterOf[t[2]]};
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            coarse.triangles.push_back(corners);
    }
    return coarse;
}

} // namespace knead
