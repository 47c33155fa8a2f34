#include "core/skin/deformed_surface.h"

#include "core/geometry/refine.h"
#include "core/skin/skin.h"

#include <utility>

namespace knead {

namespace {

void carry(TriangleMesh& surface, const Skin& skin, std::span<const Vec3> displacements)
{
    std::vector<Vec3> places(surface.vertices.size());
    skin.evaluate(displacements, places);
    surface.vertices = std::move(places);
}

} // namespace

TriangleMesh deformedSurface(const TriangleMesh& mesh, const Aggregate& aggregate, std::span<const Vec3> displacements,
                             std::size_t mostTriangles, TaskControl& control)
{
    TriangleMesh surface = refine(mesh, aggregate.lattice.spacing, mostTriangles);
    carry(surface, Skin(aggregate, surface.vertices, control), displacements);
    return surface;
}

StrainedSurface strainedSurface(const TriangleMesh& mesh, const Aggregate& aggregate, const ObjectStrains& body,
                                std::span<const ObjectIndex> loaded, std::size_t mostTriangles, TaskControl& control)
{
    StrainedSurface surface{.mesh = refine(mesh, aggregate.lattice.spacing, mostTriangles), .fields = {}};
    TaskPortion placing(control, 0, 0.5);
    const Skin skin(aggregate, surface.mesh.vertices, placing);
    TaskPortion straining(control, 0.5, 1);
    const SkinStress stress(aggregate, surface.mesh, {}, straining);
    surface.fields = skinFields(skin, stress, body.displacements(), body, loaded);
    carry(surface.mesh, skin, body.displacements());
    return surface;
}

} // namespace knead
