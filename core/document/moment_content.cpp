#include "core/document/moment_content.h"

#include "core/aggregate/material_history.h"
#include "core/document/aggregate_content.h"
#include "core/document/moment_check.h"
#include "core/document/moment_fields.h"
#include "core/message/message.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace knead {

namespace {

using namespace moment_fields;

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
void friction(Stream& bytes, Of<Stream, FrictionMemory>& memory, std::uint32_t version)
{
    bytes(memory.hold);
    bytes(memory.pressure);
    if (version >= 8)
        bytes(memory.sticks);
}

/// What version 4 knows beside.
template <typename Stream>
void frictions(Stream& bytes, Of<Stream, Contacts::Memory>& memory, std::uint32_t version)
{
    bytes.list(memory.holds, [&](auto& held) {
        objectRef(bytes, held.first);
        objectRef(bytes, held.second);
        friction(bytes, held.friction, version);
    });
    bytes.list(memory.touches, [&](auto& touch) {
        bytes(touch.surface);
        bytes(touch.body);
        bytes(touch.point);
        friction(bytes, touch.friction, version);
        bytes(touch.kept);
        bytes(touch.pressed);
        if (version >= 7)
            bytes(touch.side);
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
            if (sizes.version >= momentVersionOf(field))
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
    if (sizes.version >= 12)
        bytes(changes.keptVolume);
    bytes.list(changes.broken, [&](auto& connection) {
        bytes(connection.direction);
        bytes(connection.lower);
        if (sizes.version >= 7)
            bytes(connection.cutAt);
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
    bytes(moment.watch.unsolved);
    bytes(moment.watch.unsolvedInRow);
    bytes(moment.watch.isPlacedInside);
    bytes(moment.accounts.placed);
    bytes(moment.accounts.energy.turnover);
}

/// What version 7 knows beside.
template <typename Stream>
void edges(Stream& bytes, Of<Stream, Contacts::Memory>& memory)
{
    bytes.list(memory.edges, [&](auto& hold) {
        bytes(hold.surface);
        bytes(hold.point);
        bytes(hold.force);
    });
}

/// What was said is kept in English.
void sentence(ByteWriter& bytes, const Message& said)
{
    bytes(said.english());
}

void sentence(ByteReader& bytes, Message& said)
{
    std::string text;
    bytes(text);
    said = Message::verbatim(std::move(text));
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
    bytes(moment.around.gravity);
    bytes.optional(moment.around.floorHeight, [&](auto& height) { bytes(height); });
    bytes(moment.around.floorFriction);
    if (version >= 8)
        bytes(moment.around.floorAdhesion);
    bytes(moment.scheme.wanted, Integrator::automatic);
    bytes(moment.scheme.inUse, Integrator::implicitEuler);
    sentence(bytes, moment.scheme.reason);
    bytes(moment.scheme.iterations);
    bytes(moment.steps.count);
    for (auto* number : {&moment.steps.time, &moment.steps.length, &moment.steps.last, &moment.steps.stable,
                         &moment.steps.crowding, &moment.addedMass, &moment.accounts.atStart, &moment.accounts.unknown})
        bytes(*number);
    energies(bytes, moment.accounts.energy);
    if (version >= 2)
        watched(bytes, moment);
    if (version >= 4)
        frictions(bytes, moment.contacts, version);
    if (version >= 5)
        bytes(moment.scheme.pace, Pace::exact);
    if (version >= 7)
        edges(bytes, moment.contacts);
    bytes(moment.watch.wasSquashed);
    bytes(moment.watch.health.ok);
    sentence(bytes, moment.watch.health.message);
    if constexpr (Stream::isReader) {
        if (!bytes.atEnd())
            loadsAndTurns(bytes, moment);
    } else if (hasLoadsOrTurns(moment)) {
        loadsAndTurns(bytes, moment);
    }
}

/// The filling that a body has then; null: the first one.
std::shared_ptr<const Aggregate> nextFilling(ByteReader& bytes, const Body& body, std::uint32_t version)
{
    bool isRefilled = false;
    if (version >= 6)
        bytes(isRefilled);
    return isRefilled ? readRefilled(bytes, body.aggregate, version) : nullptr;
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

Moment momentFromContent(std::span<const std::byte> content, std::span<const Body> bodies, const ToolParts& parts,
                         std::uint32_t version)
{
    ByteReader bytes(content);
    Moment moment;
    std::uint32_t count = 0;
    bytes(count);
    if (count != bodies.size())
        throw Problem(Message("History", "it has another number of bodies than the scene"));
    for (const Body& each : bodies) {
        Moment::BodyMoment& read = moment.bodies.emplace_back(Moment::BodyMoment{.materials = MaterialMap({}, 0)});
        read.refilled = nextFilling(bytes, each, version);
        body(bytes, read, Sizes(read.refilled ? *read.refilled : *each.aggregate, version));
    }
    rest(bytes, moment, parts, version);
    if (!bytes.atEnd())
        throw Problem(Message("History", "it goes on after its end"));
    if (const Message problem = momentProblem(moment, bodies); !problem.empty())
        throw Problem(problem);
    return moment;
}

} // namespace knead
