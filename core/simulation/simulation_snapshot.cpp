#include "core/simulation/simulation_state.h"
#include "core/task/block_sums.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t snapshotBlockSize = 8192;

/// Mostly nothing has broken since the snapshot before.
std::shared_ptr<const std::vector<BrokenConnection>> brokenOf(BodyRun& run)
{
    const std::vector<BrokenConnection>& broken = run.connections.changes().broken;
    if (broken.empty())
        run.published = nullptr;
    else if (!run.published || *run.published != broken)
        run.published = std::make_shared<const std::vector<BrokenConnection>>(broken);
    return run.published;
}

/// Component n of the metric of each object's relaxed material, what of it is volume included.
std::vector<float> metricOf(const BodyRun& run, std::size_t n)
{
    const StructuralConnections::Changes& changes = run.connections.changes();
    const LaneVector<double>& shape = changes.plastic.metric[n];
    std::vector<float> metric(shape.size());
    forEachBlock(shape.size(), snapshotBlockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            metric[i] = static_cast<float>(shape[i] * std::exp(2.0 / 3 * changes.restDilatation[i]));
    });
    return metric;
}

/// Elastic material stays as it is.
std::shared_ptr<const RelaxedState> relaxedOf(BodyRun& run)
{
    const std::uint64_t version = run.connections.lengthVersion();
    if (run.relaxed && run.relaxedVersion == version && run.relaxed->materials == run.materials)
        return run.relaxed;
    auto relaxed = std::make_shared<RelaxedState>(RelaxedState{.materials = run.materials});
    for (std::size_t n = 0; version > 0 && n < relaxed->metric.size(); ++n)
        relaxed->metric[n] = metricOf(run, n);
    const LaneVector<double>& flowed = run.connections.changes().plastic.equivalentStrain;
    relaxed->equivalentStrain.assign(flowed.begin(), flowed.end());
    bool isAtRest = true; // it may have been put back
    for (std::size_t n = 0; n < relaxed->metric.size(); ++n)
        isAtRest = isAtRest && std::all_of(relaxed->metric[n].begin(), relaxed->metric[n].end(),
                                           [&](float one) { return one == (n < 3 ? 1.0F : 0.0F); });
    if (isAtRest) {
        relaxed->metric = {};
        relaxed->equivalentStrain.clear();
    }
    run.relaxed = std::move(relaxed);
    run.relaxedVersion = version;
    return run.relaxed;
}

Snapshot::BodyState copyOf(BodyRun& run, std::shared_ptr<const Aggregate> aggregate)
{
    Snapshot::BodyState copy{.positions = {},
                             .kind = run.kind,
                             .aggregate = std::move(aggregate),
                             .broken = brokenOf(run),
                             .relaxed = relaxedOf(run)};
    copy.positions.resize(run.state.size());
    forEachBlock(run.state.size(), snapshotBlockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            copy.positions[i] = run.state.position.at(i);
    });
    return copy;
}

struct Momenta {
    double mass = 0;             ///< [kg]
    Vec3 linear = Vec3::Zero();  ///< [kg m/s]
    Vec3 angular = Vec3::Zero(); ///< about the origin [kg m^2/s]
};

/// Of each block of objects.
std::vector<Momenta> momentaOf(const ObjectState& state)
{
    return ofEachBlock<Momenta>(state.size(), snapshotBlockSize, [&](std::size_t begin, std::size_t end) {
        Momenta sum;
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3 momentum = state.mass[i] * state.velocity.at(i);
            sum.mass += state.mass[i];
            sum.linear += momentum;
            sum.angular += state.position.at(i).cross(momentum);
        }
        return sum;
    });
}

ToolState stateOf(ToolId id, ToolRun& tool)
{
    tool.findMeans();
    return {.id = id,
            .name = tool.manipulator.name,
            .kind = tool.manipulator.kind,
            .part = tool.manipulator.part,
            .size = tool.manipulator.size,
            .pose = tool.manipulator.pose,
            .friction = tool.manipulator.friction,
            .speedLimit = tool.manipulator.speedLimit,
            .forceLimit = tool.manipulator.forceLimit,
            .adhesion = tool.manipulator.adhesion,
            .rollsFreely = tool.manipulator.rollsFreely,
            .force = tool.meanForce,
            .torque = tool.meanTorque,
            .peakForce = tool.peakForce};
}

} // namespace

EnergyLedger Simulation::State::storedEnergy()
{
    // The semi-implicit scheme keeps velocities half a step ahead of positions. All is taken at the start of the last step,
    // where forces and contact energy are known. With 1/2 m v- . v+ of the velocities half a step before and after, the sum
    // is what the scheme conserves exactly for linear springs; the imbalance uses that, or it would show the offset as an
    // error.
    EnergyLedger stored = accounts.energy;
    stored.contact = contactReport.energy;
    // Forward Euler has both at the same time; the implicit scheme has all at the end of the step.
    const bool sameTime = scheme.inUse != Integrator::semiImplicitEuler;
    // Right after going to a moment forces are not known: all is taken at present, and `unknownEnergy` makes up for it.
    const double kicked = isImplicit() ? 0 : travel.lastKick;
    const double back = kicked > 0 ? steps.last : 0;
    double conserved = 0;
    for (auto& run : runs) {
        if (run->rigid) {
            const Vec3 center = run->rigid->center() - back * run->rigid->velocity();
            conserved += isImplicit() ? run->rigid->presentKinetic() : run->rigid->conservedKinetic();
            stored.kinetic += isImplicit() ? run->rigid->presentKinetic() : run->rigid->kinetic();
            stored.gravity -= run->rigid->mass() * around.gravity.dot(center);
            continue;
        }
        const ObjectState& state = run->state;
        const LaneVector<double>& weighed = state.weighedMass();
        VectorArray earlier(back > 0 ? state.size() : 0); // places then
        struct Sums {
            double kinetic = 0;
            double gravity = 0;
            double conserved = 0;
        };
        std::vector<Sums> sums((state.size() + snapshotBlockSize - 1) / snapshotBlockSize);
        forEachBlock(state.size(), snapshotBlockSize, [&](std::size_t begin, std::size_t end) {
            Sums& sum = sums[begin / snapshotBlockSize];
            for (std::size_t i = begin; i < end; ++i) {
                const double mass = state.mass[i];
                const Vec3 force = state.force.at(i) + state.damping.at(i) + weighed[i] * around.gravity;
                const Vec3 after = state.velocity.at(i);
                const Vec3 before = after - kicked * state.inverseMass[i] * force;
                const Vec3 place = state.position.at(i) - back * (sameTime ? before : after);
                if (back > 0)
                    earlier.set(i, place);
                sum.kinetic +=
                    sameTime ? 0.5 * mass * before.squaredNorm() : 0.125 * mass * (before + after).squaredNorm();
                sum.gravity -= weighed[i] * around.gravity.dot(place);
                sum.conserved += 0.5 * mass * before.dot(sameTime ? before : after);
            }
        });
        for (const Sums& sum : sums) {
            stored.kinetic += sum.kinetic;
            stored.gravity += sum.gravity;
            conserved += sum.conserved;
        }
        if (run->deforms())
            stored.elastic += run->connections.energy(back > 0 ? earlier : state.position);
    }
    if (back > 0)
        stored.toolWork -= loads.workAhead; // of the last step, which is not counted yet
    stored.imbalance = conserved + stored.elastic + stored.gravity + stored.contact + stored.dissipated() -
                       stored.toolWork + accounts.unknown - accounts.atStart;
    stored.turnover = std::max(accounts.energy.turnover,
                               stored.kinetic + stored.elastic + stored.contact + std::abs(stored.dissipated()));
    return stored;
}

void Simulation::showPressing(bool on)
{
    m_state->out.showsPressing = on;
}

void Simulation::State::addPressing(Snapshot& shot) const
{
    const ContactStep now{.duration = steps.length, .stickSpeed = isImplicit() ? 1.0 : 0.0}; // friction does not count
    std::vector<std::vector<Vec3>> forces = contacts->pressingForces(surfaces(), now);
    for (std::size_t b = 0; b < forces.size(); ++b)
        shot.bodies[b].pressing = std::make_shared<const std::vector<Vec3>>(std::move(forces[b]));
}

std::shared_ptr<Snapshot> Simulation::snapshot()
{
    State& state = *m_state;
    auto shot = std::make_shared<Snapshot>();
    shot->resets = state.commands.resets;
    shot->step = state.steps.count;
    shot->time = state.steps.time;
    shot->timeStep = state.steps.length;
    shot->stableStep = state.steps.stable;
    shot->integrator = state.scheme.inUse;
    shot->wantedIntegrator = state.scheme.wanted;
    shot->integratorReason = state.scheme.reason;
    shot->pace = state.scheme.pace;
    shot->solverIterations = state.isImplicit() ? state.scheme.iterations : 0;
    shot->gravity = state.around.gravity;
    shot->floorHeight = state.around.floorHeight;
    shot->floorFriction = state.around.floorFriction;
    shot->floorAdhesion = state.around.floorAdhesion;
    shot->health = state.watch.health;
    shot->notice = state.out.notice;
    shot->stages = state.out.clock.take();
    shot->contacts = state.contactReport.count;
    shot->energy = state.storedEnergy();
    shot->joints = state.contacts->joints().all().size();
    shot->components = state.components();
    shot->penetration = std::max(state.out.penetration, state.deepestOverlap());
    shot->rest = state.rest.rests ? state.rest.count : 0;
    shot->refills = state.refilling.count;
    shot->unsolvedSteps = state.watch.unsolved;
    double allMass = 0;
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        BodyRun& run = *state.runs[b];
        shot->bodies.push_back(copyOf(run, state.bodies[b].aggregate));
        shot->materials.push_back(state.bodies[b].material);
        shot->objects += run.state.size();
        shot->connections += run.deforms() ? run.connections.count() : 0;
        shot->broken += run.connections.changes().broken.size();
        for (const Momenta& each : momentaOf(run.state)) {
            allMass += each.mass;
            shot->momentum += each.linear;
            shot->angularMomentum += each.angular;
        }
    }
    if (state.out.showsPressing)
        state.addPressing(*shot);
    shot->addedMass = allMass > 0 ? state.massScaling.added / allMass : 0;
    for (ToolId id = 0; id < state.tools.size(); ++id)
        if (state.tools[id])
            shot->tools.push_back(stateOf(id, *state.tools[id]));
    shot->nextTool = static_cast<ToolId>(state.tools.size());
    shot->nextFixture = static_cast<FixtureId>(state.grips.fixtures.size());
    for (FixtureId id = 0; id < state.grips.fixtures.size(); ++id)
        if (state.grips.fixtures[id]) {
            shot->fixtures.push_back(*state.grips.fixtures[id]);
            shot->fixtureIds.push_back(id);
            const auto of = [id](const std::vector<Vec3>& values) {
                return id < values.size() ? values[id] : Vec3(Vec3::Zero());
            };
            shot->fixtureForces.push_back(of(state.grips.forces));
            shot->fixtureMoments.push_back(of(state.grips.moments));
            shot->fixtureCenters.push_back(of(state.grips.centers));
        }
    return shot;
}

std::uint64_t Simulation::stateHash() const
{
    // FNV-1a over 64-bit words.
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const auto& run : m_state->runs)
        for (const VectorArray* array : {&run->state.position, &run->state.velocity})
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t i = 0; i < array->size(); ++i)
                    hash = (hash ^ std::bit_cast<std::uint64_t>(array->component(c)[i])) * 0x100000001b3ULL;
    return hash;
}

} // namespace knead
