#include "io/mesh/corner_normals.h"

#include <cmath>
#include <numeric>

namespace knead {

namespace {

constexpr double creaseCosine = 0.866;  // 30 degrees
constexpr double sharpestInFace = 0.17; // 80 degrees; within a face only an apex or an edge in its surface is sharper

/// Corners grouped by vertex.
struct Fans {
    std::vector<std::size_t> first; ///< per vertex, and the end
    std::vector<MeshCorner> corners;
};

Fans groupByVertex(const TriangleMesh& mesh)
{
    Fans fans{std::vector<std::size_t>(mesh.vertices.size() + 1, 0),
              std::vector<MeshCorner>(3 * mesh.triangles.size())};
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

double cornerAngle(const TriangleMesh& mesh, const MeshCorner& corner)
{
    const TriangleMesh::Triangle& t = mesh.triangles[corner.triangle];
    const Vec3& at = mesh.vertices[t[corner.index]];
    const Vec3 a = mesh.vertices[t[(corner.index + 1) % 3]] - at;
    const Vec3 b = mesh.vertices[t[(corner.index + 2) % 3]] - at;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace

std::vector<Vec3> fanNormals(const TriangleMesh& mesh, std::span<const MeshCorner> fan)
{
    std::vector<Vec3> faces;
    std::vector<double> angles;
    for (const MeshCorner& corner : fan) {
        faces.push_back(faceNormal(mesh, mesh.triangles[corner.triangle]));
        angles.push_back(cornerAngle(mesh, corner));
    }
    const auto isSmooth = [&](std::size_t a, std::size_t b) {
        const bool sameFace = !mesh.faceOfTriangle.empty() &&
                              mesh.faceOfTriangle[fan[a].triangle] == mesh.faceOfTriangle[fan[b].triangle];
        return faces[a].dot(faces[b]) > (sameFace ? sharpestInFace : creaseCosine);
    };
    std::vector<Vec3> normals;
    for (std::size_t corner = 0; corner < fan.size(); ++corner) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t other = 0; other < fan.size(); ++other)
            if (isSmooth(corner, other))
                sum += angles[other] * faces[other];
        const double length = sum.norm();
        normals.push_back(length > 0 ? Vec3(sum / length) : faces[corner]);
    }
    return normals;
}

CornerNormals cornerNormals(const TriangleMesh& mesh)
{
    const Fans fans = groupByVertex(mesh);
    CornerNormals result(mesh.triangles.size());
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        const std::span fan(fans.corners.data() + fans.first[vertex], fans.first[vertex + 1] - fans.first[vertex]);
        const std::vector<Vec3> normals = fanNormals(mesh, fan);
        for (std::size_t i = 0; i < fan.size(); ++i)
            result[fan[i].triangle][fan[i].index] = normals[i];
    }
    return result;
}

} // namespace knead
