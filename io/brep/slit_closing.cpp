#include "io/brep/slit_closing.h"

#include "core/geometry/mass_properties.h"
#include "io/mesh/mesh_repair.h"
#include "io/mesh/open_borders.h"

#include <limits>
#include <vector>

namespace knead {

namespace {

constexpr double largestSlitShare = 1e-4; // of the area of the mesh, for all slits together
constexpr std::size_t longestSlit = 200;

double areaOf(const TriangleMesh& mesh, const TriangleMesh::Triangle& t)
{
    const Vec3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    return 0.5 * a.cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
}

/// Cuts off the smallest corner again and again.
std::vector<TriangleMesh::Triangle> triangulated(const TriangleMesh& mesh, std::vector<std::uint32_t> loop)
{
    std::vector<TriangleMesh::Triangle> triangles;
    while (loop.size() >= 3) {
        const std::size_t count = loop.size();
        const auto corner = [&](std::size_t i) {
            return TriangleMesh::Triangle{loop[(i + count - 1) % count], loop[i], loop[(i + 1) % count]};
        };
        std::size_t best = 0;
        double smallest = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < count; ++i)
            if (const double area = areaOf(mesh, corner(i)); area < smallest) {
                smallest = area;
                best = i;
            }
        triangles.push_back(corner(best));
        if (count == 3)
            break;
        loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return triangles;
}

} // namespace

TriangleMesh closeSlits(TriangleMesh mesh)
{
    std::vector<OpenLoop> loops = openLoopsOf(mesh);
    if (loops.empty())
        return mesh;
    mesh = withoutFolds(mesh);
    loops = openLoopsOf(mesh);
    TriangleMesh closed = mesh;
    double area = 0;
    for (const OpenLoop& loop : loops) {
        if (loop.vertices.size() > longestSlit)
            return mesh;
        for (const TriangleMesh::Triangle& triangle : triangulated(mesh, loop.vertices)) {
            area += areaOf(mesh, triangle);
            closed.triangles.push_back(triangle);
            if (!mesh.faceOfTriangle.empty())
                closed.faceOfTriangle.push_back(loop.face);
        }
    }
    return area <= largestSlitShare * massProperties(mesh).area ? closed : mesh;
}

} // namespace knead
