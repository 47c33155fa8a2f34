#include "core/document/moment_content.h"

#include "core/aggregate/material_history.h"
#include "core/document/aggregate_content.h"
#include "core/document/moment_check.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <type_traits>
#include <variant>

namespace knead {

namespace {

// One description serves a ByteWriter and a ByteReader: `Of<Stream, T>` is what the one writes from and the other reads to. A
// change of anything here is a new version of what momentToBytes() gives.
template <typename Stream, typename Value>
using Of = std::conditional_t<Stream::isReader, Value, const Value>;

/// How many numbers a body has, for those who read it; who writes it knows.
struct Sizes {
    Sizes() = default;
    Sizes(const Aggregate& aggregate, std::uint32_t written)
        : objects(aggregate.size())
        , version(written)
    {
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            connections[d] = aggregate.weight[d].size();
    }

    std::size_t objects = 0;
    std::array<std::size_t, Lattice::directionCount> connections{};
    std::uint32_t version = momentVersion;
};

std::uint64_t fingerprintOf(const ToolPart& part)
{
    ByteWriter bytes;
    for (const TriangleMesh::Triangle& triangle : part.mesh().triangles)
        for (const std::uint32_t corner : triangle)
            bytes(corner);
    for (const Vec3& vertex : part.mesh().vertices)
        bytes(vertex);
    return checksumOf(bytes.take());
}

/// A part by its fingerprint, 0 for none.
void toolPart(ByteWriter& bytes, const std::shared_ptr<const ToolPart>& part, const ToolParts& /*parts*/)
{
    bytes(part ? fingerprintOf(*part) : 0);
}

void toolPart(ByteReader& bytes, std::shared_ptr<const ToolPart>& part, const ToolParts& parts)
{
    std::uint64_t fingerprint = 0;
    bytes(fingerprint);
    part = nullptr;
    if (fingerprint == 0)
        return;
    const auto found = std::find_if(parts.begin(), parts.end(),
                                    [&](const auto& candidate) { return fingerprintOf(*candidate) == fingerprint; });
    if (found == parts.end())
        throw std::runtime_error("a tool is made of a part that the document does not have");
    part = *found;
}

template <typename Stream>
void pose(Stream& bytes, Of<Stream, Pose>& pose)
{
    bytes(pose.position);
    bytes(pose.rotation);
}

/// Writes which alternative it is; reads it and makes it so.
void alternative(ByteWriter& bytes, const Motion& motion)
{
    bytes(static_cast<std::uint8_t>(motion.index()));
}

void alternative(ByteReader& bytes, Motion& motion)
{
    static const Motion motions[] = {HoldStill{}, DriveAt{}, GoTo{}, FollowKeyFrames{}};
    static_assert(std::size(motions) == std::variant_size_v<Motion>);
    std::uint8_t index = 0;
    bytes(index);
    if (index >= std::size(motions))
        throw std::runtime_error("a motion is none of those there are");
    motion = motions[index];
}

template <typename Stream>
void motion(Stream& bytes, Of<Stream, Motion>& motion)
{
    alternative(bytes, motion);
    if (auto* drive = std::get_if<DriveAt>(&motion)) {
        bytes(drive->velocity);
        bytes(drive->angularVelocity);
    } else if (auto* goTo = std::get_if<GoTo>(&motion)) {
        pose(bytes, goTo->target);
    } else if (auto* follow = std::get_if<FollowKeyFrames>(&motion)) {
        bytes.list(follow->frames, [&](auto& frame) {
            bytes(frame.time);
            pose(bytes, frame.pose);
        });
    }
}

template <typename Stream>
void manipulator(Stream& bytes, Of<Stream, Manipulator>& tool, const ToolParts& parts)
{
    bytes(tool.name);
    bytes(tool.size);
    pose(bytes, tool.pose);
    bytes(tool.friction);
    bytes(tool.speedLimit);
    bytes(tool.forceLimit);
    motion(bytes, tool.motion);
    bytes(tool.kind, ToolKind::part);
    toolPart(bytes, tool.part, parts);
}

template <typename Stream>
void toolRun(Stream& bytes, Of<Stream, ToolRun>& tool, const ToolParts& parts, std::uint32_t version)
{
    manipulator(bytes, tool.manipulator, parts);
    manipulator(bytes, tool.start, parts);
    for (auto* vector : {&tool.force, &tool.meanForce, &tool.meanTorque})
        bytes(*vector);
    if constexpr (Stream::isReader)
        if (version < 5) {
            double resistance = 0; // tools at their limit follow their hands now
            bytes(resistance);
        }
    bytes(tool.peakForce);
}

void box(ByteWriter& bytes, const std::optional<Box>& box)
{
    bytes(box.has_value());
    if (box) {
        bytes(Vec3(box->min()));
        bytes(Vec3(box->max()));
    }
}

void box(ByteReader& bytes, std::optional<Box>& box)
{
    bool isThere = false;
    Vec3 low = Vec3::Zero();
    Vec3 high = Vec3::Zero();
    bytes(isThere);
    box.reset();
    if (isThere) {
        bytes(low);
        bytes(high);
        box = Box(low, high);
    }
}

template <typename Stream>
void fixture(Stream& bytes, Of<Stream, Fixture>& fixture, std::uint32_t version)
{
    bytes(fixture.name);
    bytes(fixture.body);
    bytes.plainList(fixture.objects);
    bytes(fixture.velocity);
    if (version >= 6)
        bytes.plainList(fixture.whenOpened);
}

template <typename Stream>
void amount(Stream& bytes, Of<Stream, LoadAmount>& amount)
{
    bytes(amount.force);
    bytes(amount.moment);
    bytes(amount.pressure);
}

template <typename Stream>
void load(Stream& bytes, Of<Stream, Load>& load)
{
    bytes(load.name);
    bytes(load.body);
    bytes.plainList(load.faces);
    box(bytes, load.box);
    bytes.plainList(load.patch.objects);
    bytes.plainList(load.patch.share);
    bytes.plainList(load.patch.area);
    amount(bytes, load.amount);
    bytes(load.ramp);
}

/// Loads, and grips that turn: what moments of before have nothing of.
template <typename Stream>
void loadsAndTurns(Stream& bytes, Of<Stream, Moment>& moment)
{
    bytes.list(moment.loads, [&](auto& each) {
        bytes.optional(each, [&](auto& run) {
            load(bytes, run.load);
            amount(bytes, run.from);
            bytes(run.begin);
        });
    });
    bytes.list(moment.gripProgress, [&](auto& progress) {
        bytes(progress.way);
        bytes(progress.angle);
    });
    for (auto& fixture : moment.fixtures) {
        if (!fixture)
            continue;
        bytes(fixture->turn.center);
        bytes(fixture->turn.angularVelocity);
        bytes(fixture->turn.angle);
    }
}

bool hasLoadsOrTurns(const Moment& moment)
{
    return !moment.loads.empty() || std::any_of(moment.fixtures.begin(), moment.fixtures.end(),
                                                [](const auto& fixture) { return fixture && fixture->turn.turns(); });
}

template <typename Stream>
void annealing(Stream& bytes, Of<Stream, Annealing>& annealing)
{
    bytes(annealing.body);
    bytes.plainList(annealing.marks);
    bytes(annealing.rate);
    bytes(annealing.end);
}

template <typename Stream>
void objectRef(Stream& bytes, Of<Stream, ObjectRef>& object)
{
    bytes(object.body);
    bytes(object.object);
}

template <typename Stream>
void joint(Stream& bytes, Of<Stream, Joint>& joint)
{
    objectRef(bytes, joint.first);
    objectRef(bytes, joint.second);
    for (auto* number : {&joint.nominalLength, &joint.stiffness, &joint.damping, &joint.friction, &joint.tolerance,
                         &joint.yieldStrain, &joint.flowTime, &joint.ductility, &joint.plasticStrain})
        bytes(*number);
    bytes(joint.healed);
}

template <typename Stream>
void friction(Stream& bytes, Of<Stream, FrictionMemory>& memory)
{
    bytes(memory.hold);
    bytes(memory.pressure);
}

/// What version 4 knows beside.
template <typename Stream>
void frictions(Stream& bytes, Of<Stream, Contacts::Memory>& memory)
{
    bytes.list(memory.holds, [&](auto& held) {
        objectRef(bytes, held.first);
        objectRef(bytes, held.second);
        friction(bytes, held.friction);
    });
    bytes.list(memory.touches, [&](auto& touch) {
        bytes(touch.surface);
        bytes(touch.body);
        bytes(touch.point);
        friction(bytes, touch.friction);
        bytes(touch.kept);
        bytes(touch.pressed);
    });
}

template <typename Stream>
void contacts(Stream& bytes, Of<Stream, Contacts::Memory>& memory)
{
    for (auto* pairs : {&memory.keptLengths, &memory.pressedTimes})
        bytes.list(*pairs, [&](auto& pair) {
            objectRef(bytes, pair.first);
            objectRef(bytes, pair.second);
            bytes(pair.value);
        });
    bytes.list(memory.facingSlit, [&](auto& object) { objectRef(bytes, object); });
    bytes.list(memory.joints, [&](auto& each) { joint(bytes, each); });
    bytes(memory.frequency);
}

void materials(ByteWriter& bytes, const MaterialMap& map)
{
    bytes.list(map.materials(), [&](const Material& material) {
        for (const MaterialField& field : materialFields())
            bytes(material.*field.value);
    });
    if (!map.isUniform())
        for (const MaterialMap::Index index : map.indices())
            bytes(index);
}

void materials(ByteReader& bytes, MaterialMap& map, const Sizes& sizes)
{
    std::vector<Material> materials;
    bytes.list(materials, [&](Material& material) {
        for (const MaterialField& field : materialFields())
            if (sizes.version >= 3 || !isMissingInOlderFiles(field))
                bytes(material.*field.value);
    });
    std::vector<MaterialMap::Index> indices(sizes.objects, 0);
    if (materials.size() != 1)
        for (MaterialMap::Index& index : indices)
            bytes(index);
    map = MaterialMap(std::move(materials), std::move(indices));
}

template <typename Stream>
void rigidMotion(Stream& bytes, Of<Stream, RigidMotion::Memory>& motion, std::size_t objects)
{
    bytes.numbers(motion.arms, objects);
    bytes(motion.center);
    bytes(motion.rotation);
    for (auto* vector : {&motion.velocity, &motion.angularVelocity, &motion.angularMomentum})
        bytes(*vector);
}

template <typename Stream>
void changes(Stream& bytes, Of<Stream, StructuralConnections::Changes>& changes, const Sizes& sizes)
{
    auto& plastic = changes.plastic;
    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        bytes.numbers(plastic.nominalLength[d], sizes.connections[d]);
        if constexpr (Stream::isReader)
            if (sizes.version == 1) {
                LaneVector<double> strainOfConnections; // objects have their own now, which begins anew
                bytes.numbers(strainOfConnections, sizes.connections[d]);
            }
    }
    if (sizes.version > 1) {
        for (auto& component : plastic.metric)
            bytes.numbers(component, sizes.objects);
        bytes.numbers(plastic.equivalentStrain, sizes.objects);
        bytes.numbers(plastic.damage, sizes.objects);
    }
    bytes.numbers(changes.restDilatation, sizes.objects);
    bytes.list(changes.broken, [&](auto& connection) {
        bytes(connection.direction);
        bytes(connection.lower);
    });
}

template <typename Stream>
void body(Stream& bytes, Of<Stream, Moment::BodyMoment>& body, const Sizes& sizes)
{
    bytes(body.kind, BodyKind::glue);
    if constexpr (Stream::isReader)
        materials(bytes, body.materials, sizes);
    else
        materials(bytes, body.materials);
    bytes.optional(body.rigid, [&](auto& motion) { rigidMotion(bytes, motion, sizes.objects); });
    bytes.numbers(body.position, sizes.objects);
    bytes.numbers(body.velocity, sizes.objects);
    bytes.numbers(body.mass, sizes.objects);
    changes(bytes, body.changes, sizes);
    bytes.plainList(body.fastestMode);
}

template <typename Stream>
void energies(Stream& bytes, Of<Stream, EnergyLedger>& energy)
{
    for (auto* number :
         {&energy.toolWork, &energy.viscous, &energy.friction, &energy.plastic, &energy.fracture, &energy.numerical})
        bytes(*number);
}

/// What version 2 knows beside.
template <typename Stream>
void watched(Stream& bytes, Of<Stream, Moment>& moment)
{
    bytes(moment.unsolvedSteps);
    bytes(moment.unsolvedInRow);
    bytes(moment.isPlacedInside);
    bytes(moment.placedEnergy);
    bytes(moment.energy.turnover);
}

/// All but the bodies.
template <typename Stream>
void rest(Stream& bytes, Of<Stream, Moment>& moment, const ToolParts& parts, std::uint32_t version)
{
    bytes.list(moment.tools,
               [&](auto& tool) { bytes.optional(tool, [&](auto& run) { toolRun(bytes, run, parts, version); }); });
    bytes.list(moment.fixtures,
               [&](auto& each) { bytes.optional(each, [&](auto& one) { fixture(bytes, one, version); }); });
    bytes.plainList(moment.fixtureForces);
    bytes.list(moment.annealings, [&](auto& each) { annealing(bytes, each); });
    contacts(bytes, moment.contacts);
    bytes(moment.contactEnergy);
    bytes(moment.contactCount);
    bytes(moment.gravity);
    bytes.optional(moment.floorHeight, [&](auto& height) { bytes(height); });
    bytes(moment.floorFriction);
    bytes(moment.wantedIntegrator, Integrator::automatic);
    bytes(moment.integrator, Integrator::implicitEuler);
    bytes(moment.integratorReason);
    bytes(moment.solverIterations);
    bytes(moment.step);
    for (auto* number : {&moment.time, &moment.timeStep, &moment.lastStep, &moment.stableStep, &moment.crowding,
                         &moment.addedMass, &moment.startEnergy, &moment.unknownEnergy})
        bytes(*number);
    energies(bytes, moment.energy);
    if (version >= 2)
        watched(bytes, moment);
    if (version >= 4)
        frictions(bytes, moment.contacts);
    if (version >= 5)
        bytes(moment.pace, Pace::exact);
    bytes(moment.wasSquashed);
    bytes(moment.health.ok);
    bytes(moment.health.message);
    if constexpr (Stream::isReader) {
        if (!bytes.atEnd())
            loadsAndTurns(bytes, moment);
    } else if (hasLoadsOrTurns(moment)) {
        loadsAndTurns(bytes, moment);
    }
}

} // namespace

Bytes momentContent(const Moment& moment)
{
    ByteWriter bytes;
    bytes(static_cast<std::uint32_t>(moment.bodies.size()));
    for (const Moment::BodyMoment& each : moment.bodies) {
        bytes(each.refilled != nullptr);
        if (each.refilled)
            writeRefilled(bytes, *each.refilled);
        body(bytes, each, Sizes());
    }
    rest(bytes, moment, {}, momentVersion);
    return bytes.take();
}

namespace {

/// The filling that a body has then; null: the first one.
std::shared_ptr<const Aggregate> nextFilling(ByteReader& bytes, const Body& body, std::uint32_t version)
{
    bool isRefilled = false;
    if (version >= 6)
        bytes(isRefilled);
    return isRefilled ? readRefilled(bytes, body.aggregate) : nullptr;
}

} // namespace

Moment momentFromContent(std::span<const std::byte> content, std::span<const Body> bodies, const ToolParts& parts,
                         std::uint32_t version)
{
    ByteReader bytes(content);
    Moment moment;
    std::uint32_t count = 0;
    bytes(count);
    if (count != bodies.size())
        throw std::runtime_error("it has another number of bodies than the scene");
    for (const Body& each : bodies) {
        Moment::BodyMoment& read = moment.bodies.emplace_back(Moment::BodyMoment{.materials = MaterialMap({}, 0)});
        read.refilled = nextFilling(bytes, each, version);
        body(bytes, read, Sizes(read.refilled ? *read.refilled : *each.aggregate, version));
    }
    rest(bytes, moment, parts, version);
    if (!bytes.atEnd())
        throw std::runtime_error("it goes on after its end");
    if (const std::string problem = momentProblem(moment, bodies); !problem.empty())
        throw std::runtime_error(problem);
    return moment;
}

} // namespace knead
