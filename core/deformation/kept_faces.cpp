#include "core/deformation/kept_faces.h"

#include <limits>

namespace knead {

TriangleMesh facesOf(const TriangleMesh& mesh, const std::set<std::uint32_t>& faces)
{
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    TriangleMesh result;
    std::vector<std::uint32_t> number(mesh.vertices.size(), none);
    for (std::size_t t = 0; t < mesh.faceOfTriangle.size(); ++t) {
        if (!faces.contains(mesh.faceOfTriangle[t]))
            continue;
        TriangleMesh::Triangle triangle = mesh.triangles[t];
        for (std::uint32_t& corner : triangle) {
            if (number[corner] == none) {
                number[corner] = static_cast<std::uint32_t>(result.vertices.size());
                result.vertices.push_back(mesh.vertices[corner]);
            }
            corner = number[corner];
        }
        result.triangles.push_back(triangle);
        result.faceOfTriangle.push_back(mesh.faceOfTriangle[t]);
    }
    return result;
}

TriangleMesh besides(TriangleMesh one, const TriangleMesh& other)
{
    const auto first = static_cast<std::uint32_t>(one.vertices.size());
    one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles)
        one.triangles.push_back({first + a, first + b, first + c});
    one.faceOfTriangle.clear();
    return one;
}

} // namespace knead
