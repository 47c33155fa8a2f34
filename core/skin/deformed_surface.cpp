#include "core/skin/deformed_surface.h"

#include "core/geometry/refine.h"
#include "core/skin/skin.h"

#include <utility>

namespace knead {

TriangleMesh deformedSurface(const TriangleMesh& mesh, const Aggregate& aggregate, std::span<const Vec3> displacements,
                             std::size_t mostTriangles, TaskControl& control)
{
    TriangleMesh surface = refine(mesh, aggregate.lattice.spacing, mostTriangles);
    const Skin skin(aggregate, surface.vertices, control);
    std::vector<Vec3> places(surface.vertices.size());
    skin.evaluate(displacements, places);
    surface.vertices = std::move(places);
    return surface;
}

} // namespace knead
