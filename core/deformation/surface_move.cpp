#include "core/deformation/surface_move.h"

namespace knead {

SurfaceMove surfaceMove(const TriangleMesh& rest, std::span<const Vec3> places)
{
    SurfaceMove move;
    double area = 0;
    double sum = 0;
    for (const TriangleMesh::Triangle& triangle : rest.triangles) {
        const double weight = crossOf(rest.vertices, triangle).norm();
        for (const std::uint32_t corner : triangle) {
            const double distance = (places[corner] - rest.vertices[corner]).norm();
            area += weight;
            sum += weight * distance;
            if (distance > move.largest) {
                move.largest = distance;
                move.where = rest.vertices[corner];
            }
        }
    }
    move.mean = area > 0 ? sum / area : 0;
    return move;
}

} // namespace knead
