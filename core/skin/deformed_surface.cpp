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

StrainedSurface strainedSurface(const TriangleMesh& mesh, const Aggregate& aggregate,
                                std::span<const Vec3> displacements, std::span<const ObjectStrain> strains,
                                std::size_t mostTriangles, TaskControl& control)
{
    StrainedSurface surface{.mesh = refine(mesh, aggregate.lattice.spacing, mostTriangles), .fields = {}};
    const Skin skin(aggregate, surface.mesh.vertices, control);
    surface.fields = skinFields(skin, displacements, strains);
    carry(surface.mesh, skin, displacements);
    return surface;
}

} // namespace knead
