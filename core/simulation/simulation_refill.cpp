// Filling bodies anew in the shape that they have, while they are worked on; and going back to the first filling.
#include "core/simulation/carried_state.h"
#include "core/simulation/simulation_state.h"
#include "core/skin/refilled.h"
#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace knead {

namespace {

// Cells go bad slowly: they are looked at this often [steps].
constexpr std::uint64_t looksInterval = 64;
constexpr std::uint64_t implicitLooksInterval = 3;
// A cell is bad from here on: corners that are flat, edges that are long.
constexpr double leastCorner = 0.3;
constexpr double largestStretch = 3;
// And beyond this it is not material any more, which the look at the health of the state finds.
constexpr double beyondStretch = 30;

VectorArray placesOf(const std::vector<Vec3>& places)
{
    VectorArray array(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        array.set(i, places[i]);
    return array;
}

VectorArray nodesOf(const Aggregate& aggregate)
{
    VectorArray nodes(aggregate.size());
    for (ObjectIndex i = 0; i < nodes.size(); ++i)
        nodes.set(i, aggregate.lattice.position(i));
    return nodes;
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

/// Objects of the body have other numbers; what they had to do with each other is the filling's now.
void renumber(Contacts::Memory& memory, BodyId body, const std::vector<ObjectIndex>& newOfOld)
{
    const auto isOfBody = [&](const auto& pair) { return pair.first.body == body || pair.second.body == body; };
    std::erase_if(memory.keptLengths, isOfBody);
    std::erase_if(memory.pressedTimes, isOfBody);
    std::erase_if(memory.holds, isOfBody);
    std::erase_if(memory.touches, [&](const SurfaceContacts::Touch& touch) { return touch.body == body; });
    std::erase_if(memory.facingSlit, [&](const ObjectRef& object) { return object.body == body; });
    for (Joint& joint : memory.joints)
        for (ObjectRef* end : {&joint.first, &joint.second})
            if (end->body == body)
                end->object = newOfOld[end->object];
    std::erase_if(memory.joints, [](const Joint& joint) { return joint.first == joint.second; });
    for (Joint& joint : memory.joints)
        if (joint.second < joint.first)
            std::swap(joint.first, joint.second);
    const auto ends = [](const Joint& joint) { return std::pair(joint.first, joint.second); };
    std::ranges::stable_sort(memory.joints, {}, ends);
    const auto doubles = std::ranges::unique(memory.joints, {}, ends);
    memory.joints.erase(doubles.begin(), doubles.end());
}

} // namespace

/// A sentence; empty when it can.
std::string Simulation::State::whyNotRefilled(BodyId id) const
{
    const Body& body = bodies[id];
    const BodyRun& run = *runs[id];
    const std::string name = "\"" + body.name + "\" ";
    if (!body.surface)
        return name + "has no surface that it could be filled from.";
    if (!body.aggregate->weight.back().empty())
        return name + "is arranged as published, which filling anew does not know.";
    if (!run.deforms())
        return name + "is not deformable, and keeps its shape.";
    if (!run.connections.yields())
        return name +
               "is elastic: it keeps its shape at rest, and is not filled anew. Let it yield, or re-normalize it.";
    if (!run.connections.changes().broken.empty())
        return name + "has cracks, which another filling would close.";
    for (LoadId load = 0; load < loads.size(); ++load)
        if (loads.isThere(load) && loads.run(load).load.body == id && loads.run(load).load.faces.empty())
            return name + "has a load on a box, which says nothing of its present shape. Put it on faces.";
    if (!std::isfinite(largestSpeed(run.state)))
        return name + "moves out of all bounds.";
    if (contacts->isWaiting())
        return name + "is still being pushed out of a tool that was put into it.";
    return {};
}

bool Simulation::State::isFirstFilling(BodyId body) const
{
    return bodies[body].aggregate == firstFillings[body];
}

/// The same body of other objects, at rest where they are and of its own material alone. @return what there was before
std::unique_ptr<BodyRun> Simulation::State::replaceRun(BodyId id, std::shared_ptr<const Aggregate> aggregate)
{
    bodies[id].aggregate = std::move(aggregate);
    Body plain = bodies[id];
    plain.regions.clear(); // their objects are those of the first filling
    plain.kind = runs[id]->kind;
    implicit.reset();
    componentsVersion = ~std::uint64_t{0};
    return std::exchange(runs[id], std::make_unique<BodyRun>(plain));
}

/// Puts another filling in the place of the one of a body. Everything but its state is made again; fixtures, regions, loads, joints
/// and re-normalizations under way keep to the material.
/// @param oldOfNew per new object, the old one that lies where it does; newOfOld the other way
/// @return what there was before
std::unique_ptr<BodyRun> Simulation::State::takeFilling(BodyId id, std::shared_ptr<const Aggregate> aggregate,
                                                        const std::vector<ObjectIndex>& oldOfNew,
                                                        const std::vector<ObjectIndex>& newOfOld)
{
    const bool wasFirst = isFirstFilling(id);
    std::unique_ptr<BodyRun> before = replaceRun(id, std::move(aggregate));
    runs[id]->materials = carried(before->materials, oldOfNew);
    runs[id]->connections.updateMaterials();
    for (auto& fixture : fixtures)
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
    Contacts::Memory memory = contacts->memory();
    renumber(memory, id, newOfOld);
    contacts = std::make_unique<Contacts>(contactBodies(), vicinity, memory);
    contacts->setScheme({}, isImplicit());
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

/// Tools reach into the surface between points of a skin that was stretched: it goes on as deep in them as it is pressed.
MovePlaces Simulation::State::outOfTools(BodyId id) const
{
    struct Pressed {
        RigidSurface surface;
        Box reach;
        double depth; ///< [m]
    };
    std::vector<Pressed> pressed;
    const double spacing = bodies[id].aggregate->lattice.spacing;
    for (const RigidSurface& surface : surfaces())
        if (const double depth = contacts->deepest(id, surface); depth > 0)
            pressed.push_back({surface, surface.reach(spacing), depth});
    return [pressed](std::span<Vec3> places) {
        for (Vec3& place : places)
            for (const Pressed& each : pressed)
                if (each.reach.contains(place))
                    if (const SurfacePoint nearest = each.surface.nearest(place); nearest.distance < -each.depth)
                        place -= (nearest.distance + each.depth) * nearest.normal;
    };
}

/// What contacts store where everything is now. Changes nothing.
Contacts::Report Simulation::State::lookAtContacts()
{
    std::vector<std::pair<VectorArray, VectorArray>> before;
    for (const auto& run : runs)
        before.emplace_back(run->state.force, run->state.damping);
    contacts->updateVicinity(surfaces(), 0, 0);
    Contacts::Report report = contacts->computeForces(
        surfaces(), {.duration = timeStep, .stickSpeed = isImplicit() ? 1.0 : 0.0, .isTrial = true});
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
    std::vector<Vec3> displacements(run.state.size());
    for (ObjectIndex i = 0; i < displacements.size(); ++i)
        displacements[i] = run.state.position.at(i) - bodies[id].aggregate->lattice.position(i);
    const double finest = spacing > 0 ? spacing : bodies[id].aggregate->lattice.spacing;
    std::shared_ptr<const ShapeFitting> fitting = run.fitting;
    std::shared_ptr<const Aggregate> aggregate =
        refilled(*bodies[id].surface, bodies[id].aggregate, displacements, finest, fitting, outOfTools(id));

    const CarriedState state(run.connections, run.state, *aggregate);
    StructuralConnections::Changes changes = state.changes(run.materials);
    const VectorArray nodes = nodesOf(*aggregate);
    const std::vector<ObjectIndex> oldOfNew = nearestPoints(run.state.position, nodes, finest);
    const std::vector<ObjectIndex> newOfOld = nearestPoints(nodes, run.state.position, finest);
    const std::unique_ptr<BodyRun> old = takeFilling(id, aggregate, oldOfNew, newOfOld); // which `state` reads
    BodyRun& filled = *runs[id];
    filled.fitting = std::move(fitting);
    filled.connections.restore(std::move(changes));
    setMasses();
    filled.state.velocity = state.velocities(filled.state.mass);
    holdFixtures();
    updateTimeStep();
    contactReport = lookAtContacts();
    lastKick = 0;
    energy.plastic += before - storedEnergy().imbalance;
    rest.disturb();
    ++refills;
}

/// Bodies whose cells are no good any more.
void Simulation::State::refillWhereBad()
{
    if (!refilling || step % (isImplicit() ? implicitLooksInterval : looksInterval) != 0)
        return;
    for (BodyId id = 0; id < bodies.size(); ++id) {
        BodyRun& run = *runs[id];
        if (!bodies[id].surface || !run.deforms() || !run.connections.yields())
            continue;
        if (!run.cells)
            run.cells = std::make_unique<const CellShapes>(*bodies[id].aggregate);
        const CellQuality quality = run.cells->quality([&](ObjectIndex i) { return run.state.position.at(i); });
        const bool isBad = quality.leastCorner < leastCorner || quality.largestStretch > largestStretch;
        if (!isBad || !(quality.largestStretch < beyondStretch) || !whyNotRefilled(id).empty())
            continue;
        try {
            refill(id, 0);
        } catch (const std::runtime_error& error) {
            notice = "\"" + bodies[id].name + "\" could not be filled anew: " + error.what();
        }
    }
}

/// As it was opened, with what is held and made of what now.
void Simulation::State::takeFirstFilling(BodyId id)
{
    if (isFirstFilling(id))
        return;
    const Aggregate& present = *bodies[id].aggregate;
    const Aggregate& first = *firstFillings[id];
    std::vector<Vec3> places(first.size());
    for (ObjectIndex i = 0; i < places.size(); ++i)
        places[i] = first.lattice.position(i);
    const VectorArray then = placesOf(placesWhenFilled(present, places));
    const VectorArray nodes = nodesOf(present);
    const std::vector<ObjectIndex> oldOfNew = nearestPoints(nodes, then, present.lattice.spacing);
    const std::vector<ObjectIndex> newOfOld = nearestPoints(then, nodes, present.lattice.spacing);
    takeFilling(id, firstFillings[id], oldOfNew, newOfOld);
    for (auto& fixture : fixtures)
        if (fixture && fixture->body == id && !fixture->whenOpened.empty())
            fixture->objects = std::exchange(fixture->whenOpened, {});
    setMasses();
}

} // namespace knead
