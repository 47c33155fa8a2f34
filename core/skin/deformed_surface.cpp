#include "core/skin/deformed_surface.h"

#include "core/geometry/refine.h"
#include "core/skin/former_shape.h"
#include "core/skin/skin.h"
#include "core/skin/skin_stress.h"

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

TriangleMesh bendableSurface(const TriangleMesh& mesh, const Aggregate& aggregate, std::size_t mostTriangles)
{
    if (!aggregate.former)
        return refine(mesh, aggregate.lattice.spacing, mostTriangles);
    return carriedSurface(mesh, *aggregate.former, aggregate.lattice.spacing, mostTriangles).mesh;
}

TriangleMesh deformedSurface(const TriangleMesh& mesh, const Aggregate& aggregate, std::span<const Vec3> displacements,
                             std::size_t mostTriangles, TaskControl& control)
{
    TriangleMesh surface = bendableSurface(mesh, aggregate, mostTriangles);
    carry(surface, Skin(aggregate, surface.vertices, control), displacements);
    return surface;
}

StrainedSurface strainedSurface(const TriangleMesh& mesh, const Aggregate& aggregate, const ObjectStrains& body,
                                std::span<const ObjectIndex> loaded, std::size_t mostTriangles, TaskControl& control)
{
    StrainedSurface surface{.mesh = bendableSurface(mesh, aggregate, mostTriangles), .fields = {}};
    TaskPortion placing(control, 0, 0.5);
    const Skin skin(aggregate, surface.mesh.vertices, placing);
    TaskPortion straining(control, 0.5, 1);
    const std::vector<Vec3> opened = std::exchange(surface.mesh.vertices, {skin.points().begin(), skin.points().end()});
    const SkinStress stress(aggregate, surface.mesh, {}, straining);
    surface.fields = skinFields(skin, stress, body.displacements(), body, loaded);
    carry(surface.mesh, skin, body.displacements());
    for (std::size_t i = 0; i < opened.size(); ++i) // since the part was opened, not since it was filled
        surface.fields.displacement[i] = surface.mesh.vertices[i] - opened[i];
    return surface;
}

} // namespace knead
