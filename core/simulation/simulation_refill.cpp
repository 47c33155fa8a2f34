// Filling bodies anew in the shape that they have, while they are worked on; and going back to the first filling.
#include "core/aggregate/pieces.h"
#include "core/geometry/disjoint_sets.h"
#include "core/mechanics/carried_touches.h"
#include "core/message/message.h"
#include "core/simulation/carried_contacts.h"
#include "core/simulation/carried_state.h"
#include "core/simulation/simulation_state.h"
#include "core/skin/new_filling.h"
#include "core/skin/regrown.h"
#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

// In explicit steps cells go bad slowly: they are looked at this often [steps]. In an implicit step things move by up to half a spacing,
// and cells that were good may be inside out two steps later: each is looked at.
constexpr std::uint64_t looksInterval = 64;
// A cell is bad from here on: corners that are flat, edges that are long.
constexpr double leastCorner = 0.3;
constexpr double largestStretch = 3;
// What has cracks is filled as the surface around it says, which closes those that gape: they must not have grown to more than this
// share of the volume that the body had at first.
constexpr double mostGaping = 0.02;
// A body is not filled anew while a tool that was put into it pushes it out of this depth; fillings themselves leave less [spacings].
constexpr double mostKept = 0.5;
// And beyond this it is not material any more, which the look at the health of the state finds.
constexpr double beyondStretch = 30;

VectorArray placesOf(const std::vector<Vec3>& places)
{
    VectorArray array(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        array.set(i, places[i]);
    return array;
}

/// Those of the other filling that lie nearest to one of these.
std::vector<ObjectIndex> carried(const std::vector<ObjectIndex>& objects, const std::vector<ObjectIndex>& oldOfNew)
{
    std::vector<ObjectIndex> found;
    for (ObjectIndex i = 0; i < oldOfNew.size(); ++i)
        if (std::binary_search(objects.begin(), objects.end(), oldOfNew[i]))
            found.push_back(i);
    return found;
}

MaterialMap carried(const MaterialMap& materials, const std::vector<ObjectIndex>& oldOfNew)
{
    std::vector<MaterialMap::Index> indices(oldOfNew.size());
    std::transform(oldOfNew.begin(), oldOfNew.end(), indices.begin(),
                   [&](ObjectIndex old) { return materials.indexOf(old); });
    return {materials.materials(), std::move(indices)};
}

/// Objects of a body that healing joined, but for those of pieces that only hold on to each other.
std::vector<GrownTogether> grownTogether(BodyId id, const BodyRun& run, const Joints& joints)
{
    std::vector<GrownTogether> healed;
    for (const Joint& joint : joints.all())
        if (joint.healed && joint.first.body == id && joint.second.body == id)
            healed.emplace_back(joint.first.object, joint.second.object);
    return regrown(run.connections.aggregate(), run.displacements(), run.connections.changes().broken, healed);
}

/// Between the sides of cracks within a piece that have not grown together, about [m^3]: a flat one of one spacing squared goes through
/// five connections.
double gapingVolume(BodyId id, const BodyRun& run, const Joints& joints)
{
    const Lattice& lattice = run.connections.aggregate().lattice;
    const std::vector<BrokenConnection>& broken = run.connections.changes().broken;
    if (broken.empty())
        return 0;
    const Pieces pieces = findPieces(run.connections.aggregate(), broken);
    DisjointSets one(pieces.count);
    std::vector<std::uint8_t> isHealed(run.state.size(), 0);
    for (const auto& [first, second] : grownTogether(id, run, joints)) {
        isHealed[first] = isHealed[second] = 1;
        one.join(pieces.ofObject[first], pieces.ofObject[second]);
    }
    double volume = 0;
    for (const BrokenConnection& each : broken) {
        const auto [lower, upper] = run.connections.endsOf(each);
        if (one.find(pieces.ofObject[lower]) != one.find(pieces.ofObject[upper]) || isHealed[lower] != 0 ||
            isHealed[upper] != 0)
            continue;
        const double length = (run.state.position.at(upper) - run.state.position.at(lower)).norm();
        const double gap = length - lattice.direction(static_cast<int>(each.direction)).norm();
        volume += std::max(0.0, gap) * lattice.spacing * lattice.spacing / 5;
    }
    return volume;
}

/// Tools reach into the surface between points of a skin that was stretched: it goes on as deep in them as it is pressed.
MovePlaces outOfTools(const Simulation::State& state, BodyId id)
{
    struct Pressed {
        RigidSurface surface;
        Box reach;
        double depth; ///< [m]
    };
    std::vector<Pressed> pressed;
    const double spacing = state.bodies[id].aggregate->lattice.spacing;
    for (const RigidSurface& surface : state.surfaces())
        if (const double depth = state.contacts->deepest(id, surface); depth > 0)
            pressed.push_back({surface, surface.reach(spacing), depth});
    return [pressed](std::span<Vec3> places) {
        for (Vec3& place : places)
            for (const Pressed& each : pressed)
                if (each.reach.contains(place))
                    if (const SurfacePoint nearest = each.surface.nearest(place); nearest.distance < -each.depth)
                        place -= (nearest.distance + each.depth) * nearest.normal;
    };
}

} // namespace

/// A sentence; empty when it can.
Message Simulation::State::whyNotRefilled(BodyId id) const
{
    const Body& body = bodies[id];
    BodyRun& run = *runs[id];
    if (!body.surface)
        return Message("Filling", "\"%1\" has no surface that it could be filled from.").with(body.name);
    if (!body.aggregate->weight.back().empty())
        return Message("Filling", "\"%1\" is arranged as published, which filling anew does not know.").with(body.name);
    if (!run.deforms())
        return Message("Filling", "\"%1\" is not deformable, and keeps its shape.").with(body.name);
    if (!run.connections.yields())
        return Message("Filling", "\"%1\" is elastic: it keeps its shape at rest, and is not filled anew. Let it "
                                  "yield, or re-normalize it.")
            .with(body.name);
    const bool heals = run.materials.largest([](const Material& material) { return material.healingTime; }) > 0;
    if (!heals && !run.connections.changes().broken.empty())
        return Message("Filling",
                       "\"%1\" has cracks, which another filling would blur: only what heals is filled anew with them.")
            .with(body.name);
    const bool isDrawnOut = body.aggregate->former && body.aggregate->former->carriers()->former;
    if (isDrawnOut &&
        run.pieces.find(run.connections, id, contacts->joints()).count > findPieces(*body.aggregate).count)
        return Message("Filling",
                       "\"%1\" came apart after its skin was drawn out far: pieces of such a body are not filled anew.")
            .with(body.name);
    if (gapingVolume(id, run, contacts->joints()) > 0.5 * mostGaping * refilling.first[id]->filledVolume)
        return Message("Filling", "\"%1\" has cracks that gape, which another filling would close.").with(body.name);
    for (LoadId load = 0; load < loads.size(); ++load)
        if (loads.isThere(load) && loads.run(load).load.body == id && loads.run(load).load.faces.empty())
            return Message("Filling",
                           "\"%1\" has a load on a box, which says nothing of its present shape. Put it on faces.")
                .with(body.name);
    if (!std::isfinite(largestSpeed(run.state)))
        return Message("Filling", "\"%1\" moves out of all bounds.").with(body.name);
    const double deep = mostKept * body.aggregate->lattice.spacing;
    if (contacts->isPushingOut() && std::ranges::any_of(contacts->memory().touches, [&](const auto& touch) {
            return touch.body == id && touch.kept > deep;
        }))
        return Message("Filling", "\"%1\" is still being pushed out of a tool that was put into it.").with(body.name);
    return {};
}

bool Simulation::State::isFirstFilling(BodyId body) const
{
    return bodies[body].aggregate == refilling.first[body];
}

/// The same body of other objects, at rest where they are and of its own material alone. @return what there was before
std::unique_ptr<BodyRun> Simulation::State::replaceRun(BodyId id, std::shared_ptr<const Aggregate> aggregate)
{
    bodies[id].aggregate = std::move(aggregate);
    Body plain = bodies[id];
    plain.regions.clear(); // their objects are those of the first filling
    plain.kind = runs[id]->kind;
    implicit.reset();
    cracks.version = ~std::uint64_t{0};
    return std::exchange(runs[id], std::make_unique<BodyRun>(plain));
}

/// What of a body goes by its objects, for those of another filling: materials, fixtures and re-normalizations under way.
/// @param before what it was
void Simulation::State::carryObjects(BodyId id, const BodyRun& before, bool wasFirst,
                                     const std::vector<ObjectIndex>& oldOfNew)
{
    runs[id]->materials = carried(before.materials, oldOfNew);
    for (auto& fixture : grips.fixtures)
        if (fixture && fixture->body == id) {
            if (wasFirst)
                fixture->whenOpened = fixture->objects;
            fixture->objects = carried(fixture->objects, oldOfNew);
        }
    for (Annealing& annealing : annealings)
        if (annealing.body == id && !annealing.marks.empty()) {
            std::vector<std::uint8_t> marks(oldOfNew.size());
            std::transform(oldOfNew.begin(), oldOfNew.end(), marks.begin(),
                           [&](ObjectIndex old) { return annealing.marks[old]; });
            annealing.marks = std::move(marks);
        }
    takeLoads(id);
}

void Simulation::State::takeContacts(const Contacts::Memory& memory)
{
    contacts = std::make_unique<Contacts>(contactBodies(), chosen.vicinity, memory);
    contacts->setScheme({}, isImplicit());
}

/// Puts another filling in the place of the one of a body. Everything but its state is made again; fixtures, regions, loads, joints
/// and re-normalizations under way keep to the material.
/// @param changes of the new filling, which it takes over
/// @return what there was before
std::unique_ptr<BodyRun> Simulation::State::takeFilling(BodyId id, const NewFilling& filling,
                                                        StructuralConnections::Changes changes)
{
    const bool wasFirst = isFirstFilling(id);
    const std::shared_ptr<const Aggregate> formerFilling = bodies[id].aggregate;
    std::unique_ptr<BodyRun> before = replaceRun(id, filling.aggregate);
    runs[id]->state.position = filling.places;
    carryObjects(id, *before, wasFirst, filling.oldOfNew);
    runs[id]->connections.restore(std::move(changes));
    Contacts::Memory memory = contacts->memory();
    const std::vector<SurfaceContacts::Touch> touches = carriedTouches(
        memory.touches, id, *formerFilling, before->state.position, *filling.aggregate, filling.skin, surfaces());
    keepStretch(
        memory.joints, id,
        [&](const ObjectRef& end) {
            return (end.body == id ? *before : *runs[end.body]).state.position.at(end.object);
        },
        [&](const ObjectRef& end) {
            return end.body == id ? filling.places.at(filling.newOfOld[end.object])
                                  : runs[end.body]->state.position.at(end.object);
        });
    renumber(memory, id, filling.newOfOld, *filling.aggregate, filling.cracks);
    memory.touches.insert(memory.touches.end(), touches.begin(), touches.end());
    takeContacts(memory);
    contacts->keepDistancesOf(id);
    return before;
}

/// Loads act on faces, wherever these are now.
void Simulation::State::takeLoads(BodyId id)
{
    std::vector<std::optional<LoadRun>> acting = loads.runs();
    bool isAny = false;
    TriangleMesh surface;
    for (auto& run : acting) {
        if (!run || run->load.body != id || run->load.faces.empty() || !bodies[id].surface)
            continue;
        if (!isAny)
            surface = surfaceWhenFilled(*bodies[id].surface, *bodies[id].aggregate);
        isAny = true;
        run->load.patch = loadPatch(*bodies[id].aggregate, surface, run->load.faces, std::nullopt);
    }
    if (isAny)
        loads.restore(acting, bodies);
}

/// What contacts store where everything is now. Changes nothing.
Contacts::Report Simulation::State::lookAtContacts()
{
    std::vector<std::pair<VectorArray, VectorArray>> before;
    for (const auto& run : runs)
        before.emplace_back(run->state.force, run->state.damping);
    contacts->updateVicinity(surfaces(), 0, 0);
    Contacts::Report report = contacts->computeForces(
        surfaces(), {.duration = steps.length, .stickSpeed = isImplicit() ? 1.0 : 0.0, .isTrial = true});
    for (std::size_t b = 0; b < runs.size(); ++b) {
        runs[b]->state.force = std::move(before[b].first);
        runs[b]->state.damping = std::move(before[b].second);
    }
    return {.energy = report.energy, .count = report.count};
}

/// @param spacing [m]; 0: as it is
void Simulation::State::refill(BodyId id, double spacing)
{
    BodyRun& run = *runs[id];
    const double before = storedEnergy().imbalance;
    const std::vector<Vec3> displacements = run.displacements();
    const double finest = spacing > 0 ? spacing : bodies[id].aggregate->lattice.spacing;
    const std::vector<BrokenConnection>& broken = run.connections.changes().broken;
    const std::vector<GrownTogether> healed = grownTogether(id, run, contacts->joints());
    KnownFittings fittings = run.fittings;
    NewFilling filling = newFilling({*bodies[id].surface, bodies[id].aggregate, displacements, broken, healed}, finest,
                                    fittings, outOfTools(*this, id));
    const double grown = filling.aggregate->filledVolume / refilling.first[id]->filledVolume - 1;
    if (!broken.empty() && !(grown < mostGaping))
        throw Problem(Message("Filling", "its cracks gape, and would be filled."));
    const CarriedState state(run.connections, run.state, filling);
    const std::unique_ptr<BodyRun> old = takeFilling(id, filling, state.changes(run.materials)); // which `state` reads
    BodyRun& filled = *runs[id];
    filled.fittings = std::move(fittings);
    if (!filling.cracks.empty()) { // their sides keep the distance that they have
        filled.connections.cut(filled.state, filling.cracks, 0);
        touchWhereBroken();
    }
    setMasses();
    filled.state.velocity = state.velocities(filled.state.mass);
    holdFixtures();
    updateTimeStep();
    contactReport = lookAtContacts();
    travel.lastKick = 0;
    accounts.energy.plastic += before - storedEnergy().imbalance;
    rest.disturb();
    ++refilling.count;
}

/// Bodies whose cells are no good any more.
void Simulation::State::refillWhereBad()
{
    if (!refilling.isOn || (!isImplicit() && steps.count % looksInterval != 0))
        return;
    for (BodyId id = 0; id < bodies.size(); ++id) {
        BodyRun& run = *runs[id];
        if (!bodies[id].surface || !run.deforms() || !run.connections.yields())
            continue;
        const std::vector<BrokenConnection>& broken = run.connections.changes().broken;
        if (!run.cells || run.brokenInCells != broken.size())
            run.cells = std::make_unique<const CellShapes>(*withoutBroken(bodies[id].aggregate, broken));
        run.brokenInCells = broken.size();
        const CellQuality quality = run.cells->quality([&](ObjectIndex i) { return run.state.position.at(i); });
        const bool isBad = quality.leastCorner < leastCorner || quality.largestStretch > largestStretch;
        if (!isBad || !(quality.largestStretch < beyondStretch) || !whyNotRefilled(id).empty())
            continue;
        try {
            refill(id, 0);
        } catch (const std::runtime_error& error) {
            out.notice =
                Message("Filling", "\"%1\" could not be filled anew: %2").with(bodies[id].name, messageOf(error));
        }
    }
}

/// As it was opened, with what is held and made of what now.
void Simulation::State::takeFirstFilling(BodyId id)
{
    if (isFirstFilling(id))
        return;
    const Aggregate& present = *bodies[id].aggregate;
    const Aggregate& first = *refilling.first[id];
    const VectorArray then = placesOf(firstFillingWhenFilled(present));
    const VectorArray nodes = nodesOf(present);
    const std::vector<ObjectIndex> oldOfNew = nearestPoints(nodes, then, present.lattice.spacing);
    const std::vector<ObjectIndex> newOfOld = nearestPoints(then, nodes, present.lattice.spacing);
    const std::unique_ptr<BodyRun> before = replaceRun(id, refilling.first[id]);
    carryObjects(id, *before, false, oldOfNew);
    runs[id]->connections.updateMaterials();
    Contacts::Memory memory = contacts->memory();
    renumber(memory, id, newOfOld, first, {});
    takeContacts(memory);
    for (auto& fixture : grips.fixtures)
        if (fixture && fixture->body == id && !fixture->whenOpened.empty())
            fixture->objects = std::exchange(fixture->whenOpened, {});
    setMasses();
}

} // namespace knead
