#include "core/geometry/mass_properties.h"

#include "core/geometry/half_edges.h"
#include "core/task/block_sums.h"

#include <span>

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

/// Over triangles, and tetrahedra from them to a point.
struct Sums {
    double area = 0;
    double sixVolumes = 0;
    Vec3 moment = Vec3::Zero(); ///< 24 times volume times centroid, from that point
};

Sums sumsOver(std::span<const TriangleMesh::Triangle> triangles, const std::vector<Vec3>& vertices, const Vec3& middle)
{
    Sums sums;
    for (const TriangleMesh::Triangle& triangle : triangles) {
        const Vec3 a = vertices[triangle[0]] - middle;
        const Vec3 b = vertices[triangle[1]] - middle;
        const Vec3 c = vertices[triangle[2]] - middle;
        const double sixVolume = a.dot(b.cross(c));
        sums.sixVolumes += sixVolume;
        sums.moment += sixVolume * (a + b + c);
        sums.area += 0.5 * (b - a).cross(c - a).norm();
    }
    return sums;
}

} // namespace

MassProperties massProperties(const TriangleMesh& mesh)
{
    MassProperties result;
    result.box = boxOf(mesh);
    if (mesh.empty())
        return result;

    const Vec3 middle = result.box.center();
    constexpr std::size_t blockSize = 16384;
    const auto ofBlock = [&](std::size_t begin, std::size_t end) {
        return sumsOver({mesh.triangles.data() + begin, end - begin}, mesh.vertices, middle);
    };
    Sums all;
    for (const Sums& block : ofEachBlock<Sums>(mesh.triangles.size(), blockSize, ofBlock)) {
        all.area += block.area;
        all.sixVolumes += block.sixVolumes;
        all.moment += block.moment;
    }
    result.area = all.area;
    result.volume = all.sixVolumes / 6;
    result.centroid = all.sixVolumes == 0 ? middle : Vec3(middle + all.moment / (4 * all.sixVolumes));
    return result;
}

bool isWatertight(const TriangleMesh& mesh)
{
    return !mesh.empty() && findHalfEdges(mesh).unpaired == 0;
}

} // namespace knead
