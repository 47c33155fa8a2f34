#include "core/geometry/mass_properties.h"

#include "core/geometry/half_edges.h"

namespace knead {

namespace {

Box boxOf(const TriangleMesh& mesh)
{
    Box box;
    for (const TriangleMesh::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle)
            box.extend(mesh.vertices[vertex]);
    return box;
}

} // namespace

MassProperties massProperties(const TriangleMesh& mesh)
{
    MassProperties result;
    result.box = boxOf(mesh);
    if (mesh.empty())
        return result;

    const Vec3 middle = result.box.center();
    double sixVolumes = 0;
    Vec3 moment = Vec3::Zero(); // of tetrahedra middle-a-b-c: 24 times volume times centroid
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        const Vec3 a = mesh.vertices[triangle[0]] - middle;
        const Vec3 b = mesh.vertices[triangle[1]] - middle;
        const Vec3 c = mesh.vertices[triangle[2]] - middle;
        const double sixVolume = a.dot(b.cross(c));
        sixVolumes += sixVolume;
        moment += sixVolume * (a + b + c);
        result.area += 0.5 * (b - a).cross(c - a).norm();
    }
    result.volume = sixVolumes / 6;
    result.centroid = sixVolumes == 0 ? middle : Vec3(middle + moment / (4 * sixVolumes));
    return result;
}

bool isWatertight(const TriangleMesh& mesh)
{
    return !mesh.empty() && findHalfEdges(mesh).unpaired == 0;
}

} // namespace knead
