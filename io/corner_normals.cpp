#include "io/corner_normals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace knead {

namespace {

constexpr double creaseCosine = 0.866;  // 30 degrees
constexpr double sharpestInFace = 0.17; // 80 degrees; within a face only an apex or an edge in its surface is sharper

struct Corner {
    std::uint32_t triangle;
    std::uint32_t index; ///< 0..2
};

/// Corners grouped by vertex.
struct Fans {
    std::vector<std::size_t> first; ///< per vertex, and the end
    std::vector<Corner> corners;
};

Fans groupByVertex(const TriangleMesh& mesh)
{
    Fans fans{std::vector<std::size_t>(mesh.vertices.size() + 1, 0), std::vector<Corner>(3 * mesh.triangles.size())};
    for (const TriangleMesh::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            ++fans.first[vertex + 1];
    std::partial_sum(fans.first.begin(), fans.first.end(), fans.first.begin());
    std::vector<std::size_t> next(fans.first.begin(), fans.first.end() - 1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t i = 0; i < 3; ++i)
            fans.corners[next[mesh.triangles[t][i]]++] = {t, i};
    return fans;
}

/// Zero for a triangle without area.
Vec3 faceNormal(const TriangleMesh& mesh, const TriangleMesh::Triangle& t)
{
    const Vec3 normal = (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    const double length = normal.norm();
    return length > 0 ? Vec3(normal / length) : Vec3(Vec3::Zero());
}

double cornerAngle(const TriangleMesh& mesh, const Corner& corner)
{
    const TriangleMesh::Triangle& t = mesh.triangles[corner.triangle];
    const Vec3& at = mesh.vertices[t[corner.index]];
    const Vec3 a = mesh.vertices[t[(corner.index + 1) % 3]] - at;
    const Vec3 b = mesh.vertices[t[(corner.index + 2) % 3]] - at;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace

CornerNormals cornerNormals(const TriangleMesh& mesh)
{
    std::vector<Vec3> normals;
    normals.reserve(mesh.triangles.size());
    for (const TriangleMesh::Triangle& triangle : mesh.triangles)
        normals.push_back(faceNormal(mesh, triangle));

    const auto isSmooth = [&](std::uint32_t a, std::uint32_t b) {
        const double cosine = normals[a].dot(normals[b]);
        const bool sameFace = !mesh.faceOfTriangle.empty() && mesh.faceOfTriangle[a] == mesh.faceOfTriangle[b];
        return cosine > (sameFace ? sharpestInFace : creaseCosine);
    };
    const Fans fans = groupByVertex(mesh);
    CornerNormals result(mesh.triangles.size());
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        const auto begin = fans.corners.begin() + static_cast<std::ptrdiff_t>(fans.first[vertex]);
        const auto end = fans.corners.begin() + static_cast<std::ptrdiff_t>(fans.first[vertex + 1]);
        std::vector<double> angles;
        std::transform(begin, end, std::back_inserter(angles), [&](const Corner& c) { return cornerAngle(mesh, c); });
        for (auto corner = begin; corner != end; ++corner) {
            Vec3 sum = Vec3::Zero();
            for (auto other = begin; other != end; ++other)
                if (isSmooth(corner->triangle, other->triangle))
                    sum += angles[static_cast<std::size_t>(other - begin)] * normals[other->triangle];
            const double length = sum.norm();
            result[corner->triangle][corner->index] = length > 0 ? Vec3(sum / length) : normals[corner->triangle];
        }
    }
    return result;
}

} // namespace knead
