#include "core/skin/torn_surface.h"

#include "core/aggregate/pieces.h"
#include "core/skin/carried_fragments.h"
#include "core/skin/former_shape.h"
#include "core/skin/fragments.h"
#include "core/vicinity/point_grid.h"

#include <utility>

namespace knead {

namespace {

VectorArray arrayOf(std::span<const Vec3> places)
{
    VectorArray array(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        array.set(i, places[i]);
    return array;
}

void append(TriangleMesh& all, const TriangleMesh& mesh)
{
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const auto& [a, b, c] : mesh.triangles)
        all.triangles.push_back({first + a, first + b, first + c});
    all.faceOfTriangle.insert(all.faceOfTriangle.end(), mesh.faceOfTriangle.begin(), mesh.faceOfTriangle.end());
}

/// Places of a former shape where they were in the opened part: by what its surface has gone there, nearest to each.
void putBack(std::vector<Vec3>& places, const TriangleMesh& opened, std::span<const Vec3> whenFilled, double spacing)
{
    const VectorArray known = arrayOf(whenFilled);
    const std::vector<ObjectIndex> nearest = nearestPoints(known, arrayOf(places), spacing);
    for (std::size_t v = 0; v < places.size(); ++v)
        places[v] += opened.vertices[nearest[v]] - whenFilled[nearest[v]];
}

} // namespace

std::optional<TornSurface> tornSurface(const Aggregate& aggregate, const TriangleMesh& opened,
                                       std::span<const BrokenConnection> broken, TaskControl& control)
{
    TriangleMesh whenFilled = opened;
    whenFilled.vertices = placesWhenFilled(aggregate, opened.vertices);
    TaskPortion breaking(control, 0, 0.5);
    const std::vector<Fragment> fragments = fragmentsOf(aggregate, whenFilled, broken, {}, breaking);
    if (fragments.size() < 2)
        return {};
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    TriangleMesh mesh;
    std::vector<Skin> skins;
    std::vector<std::vector<ObjectIndex>> numbers;
    for (const Fragment& fragment : fragments) {
        const double count = static_cast<double>(fragments.size());
        const double done = static_cast<double>(skins.size());
        TaskPortion attaching(control, 0.5 + 0.5 * done / count, 0.5 + 0.5 * (done + 1) / count);
        append(mesh, fragment.mesh);
        numbers.push_back(carriersOf(aggregate, fragment, isBroken));
        skins.emplace_back(extract(aggregate, numbers.back(), isBroken), fragment.mesh.vertices, attaching);
    }
    if (aggregate.former)
        putBack(mesh.vertices, opened, whenFilled.vertices, aggregate.lattice.spacing);
    return TornSurface{std::move(mesh), Skin::joined(skins, numbers)};
}

} // namespace knead
