#include "core/session/body_stress.h"

#include "core/geometry/refine.h"
#include "core/skin/refilled.h"
#include "core/skin/skin_stress.h"

#include <algorithm>

namespace knead {

namespace {

constexpr std::size_t mostTriangles = 100'000; // at the end of every run: about a second of one core

} // namespace

BodyStress bodyStress(const TriangleMesh& surface, const Snapshot& snapshot, BodyId body)
{
    const Snapshot::BodyState& state = snapshot.bodies[body];
    BodyStress result;
    if (state.kind != BodyKind::deformable || state.relaxed == nullptr || state.aggregate->size() == 0)
        return result;
    const double spacing = state.aggregate->lattice.spacing;
    const TriangleMesh mesh = state.aggregate->former ? surfaceWhenFilled(surface, *state.aggregate)
                                                      : refine(surface, spacing, mostTriangles);
    const std::vector<Vec3> displacements = state.displacements();
    const std::vector<BrokenConnection> none;
    const ObjectStrains objects(*state.aggregate, displacements, *state.relaxed, state.broken ? *state.broken : none);
    const SkinStresses stresses =
        SkinStress(*state.aggregate, mesh).stresses(objects, loadedObjects(snapshot, body), true);
    const auto most = std::ranges::max_element(stresses.vonMises);
    if (most == stresses.vonMises.end())
        return result;
    result.largest = static_cast<double>(*most);
    result.error = stresses.errorShare;
    result.place = mesh.vertices[static_cast<std::size_t>(most - stresses.vonMises.begin())];
    if (state.aggregate->former &&
        state.aggregate->former->isInPieces()) // which lie apart from each other in the lattice
        Skin::ofPlacesWhenFilled(*state.aggregate, {result.place}).evaluate(displacements, {&result.place, 1});
    return result;
}

} // namespace knead
