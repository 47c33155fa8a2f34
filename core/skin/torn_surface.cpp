#include "core/skin/torn_surface.h"

#include "core/aggregate/pieces.h"
#include "core/skin/carried_cracks.h"
#include "core/skin/carried_fragments.h"
#include "core/skin/former_shape.h"
#include "core/skin/fragments.h"
#include "core/skin/opened_state.h"
#include "core/skin/surface_fit.h"
#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

/// The objects of each fragment that carry it in the body as it was opened, and those in its present filling.
struct FragmentObjects {
    std::vector<ObjectIndex> opened;
    std::vector<ObjectIndex> present;
};

/// Objects of a present filling belong to the fragment of the carrier that was nearest when it was filled.
std::vector<FragmentObjects> objectsOf(const Aggregate& present, const Aggregate& opened,
                                       std::span<const Fragment> fragments, std::span<const std::uint16_t> isBroken)
{
    std::vector<FragmentObjects> objects;
    for (const Fragment& fragment : fragments)
        objects.push_back({carriersOf(opened, fragment, isBroken), {}});
    if (!present.former) {
        for (FragmentObjects& each : objects)
            each.present = each.opened;
        return objects;
    }
    std::vector<std::uint32_t> fragmentOf(opened.size(), 0);
    for (std::uint32_t f = 0; f < fragments.size(); ++f)
        for (const std::vector<ObjectIndex>* list : {&fragments[f].objects, &fragments[f].dust})
            for (const ObjectIndex object : *list)
                fragmentOf[object] = f;
    const VectorArray nodes = nodesOf(opened);
    std::vector<Vec3> rest(nodes.size());
    for (ObjectIndex i = 0; i < rest.size(); ++i)
        rest[i] = nodes.at(i);
    const std::vector<Vec3> whenFilled = placesWhenFilled(present, rest);
    VectorArray places(whenFilled.size());
    for (std::size_t i = 0; i < whenFilled.size(); ++i)
        places.set(i, whenFilled[i]);
    const std::vector<ObjectIndex> nearest = nearestPoints(places, nodesOf(present), present.lattice.spacing);
    for (ObjectIndex i = 0; i < nearest.size(); ++i)
        objects[fragmentOf[nearest[i]]].present.push_back(i);
    return objects;
}

} // namespace

std::optional<TornSurface> tornSurface(const Aggregate& aggregate, const TriangleMesh& opened,
                                       std::span<const BrokenConnection> broken, TaskControl& control)
{
    if (aggregate.former && aggregate.former->carriers()->former)
        return {}; // its cracks are not followed back so far
    const Aggregate& first = aggregate.former ? *aggregate.former->carriers() : aggregate;
    const std::vector<BrokenConnection> brokenAtFirst =
        aggregate.former ? brokenInFormer(aggregate, broken)
                         : std::vector<BrokenConnection>(broken.begin(), broken.end());
    TaskPortion breaking(control, 0, 0.5);
    const std::vector<Fragment> fragments = fragmentsOf(first, opened, brokenAtFirst, {}, breaking);
    if (fragments.size() < 2)
        return {};
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    const std::vector<std::uint16_t> wasBroken = brokenDirections(first, brokenAtFirst);
    const std::vector<FragmentObjects> objects = objectsOf(aggregate, first, fragments, wasBroken);
    if (std::ranges::any_of(objects, [](const FragmentObjects& each) { return each.present.empty(); }))
        return {};
    TriangleMesh mesh;
    std::vector<Skin> skins;
    std::vector<std::vector<ObjectIndex>> numbers;
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        const double count = static_cast<double>(fragments.size());
        TaskPortion attaching(control, 0.5 + 0.5 * static_cast<double>(f) / count,
                              0.5 + 0.5 * static_cast<double>(f + 1) / count);
        append(mesh, fragments[f].mesh);
        std::vector<Vec3> places = fragments[f].mesh.vertices;
        if (aggregate.former) {
            std::vector<Vec3> then;
            for (const ObjectIndex object : objects[f].opened)
                then.push_back(aggregate.former->displacements()[object]);
            Skin(extract(first, objects[f].opened, wasBroken), fragments[f].mesh.vertices).evaluate(then, places);
        }
        numbers.push_back(objects[f].present);
        skins.push_back(
            Skin::ofPlacesWhenFilled(extract(aggregate, objects[f].present, isBroken), std::move(places), attaching));
    }
    return TornSurface{std::move(mesh), Skin::joined(skins, numbers)};
}

} // namespace knead
