#include "core/session/nodal_states.h"

#include "core/aggregate/pieces.h"
#include "core/model/number_words.h"
#include "core/session/shared_force.h"
#include "core/skin/former_shape.h"
#include "core/skin/free_surface.h"
#include "core/skin/skin.h"
#include "core/skin/skin_stress.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t nodesAtOnce = 50'000; // about 60 MB of what carries them
constexpr std::size_t nodesPerBlock = 64;
constexpr double skinDepth =
    0.1; // spacings: a node less deep is on the skin, whose triangles are chords of round faces
constexpr double edgeReach = 0.05; // spacings from an edge of the skin that a node is still on
const Vec3 unknownVector = Vec3::Constant(notANumber);
const Mat3 unknownTensor = Mat3::Constant(notANumber);

/// The pieces of all bodies.
struct AllPieces {
    std::vector<CarriedPiece> pieces;
    std::vector<std::uint32_t> bodyOf; ///< per piece
};

AllPieces piecesOf(std::span<const BodyAtNodes> bodies, TaskControl& control)
{
    AllPieces all;
    for (std::uint32_t b = 0; b < bodies.size(); ++b) {
        const BodyAtNodes& body = bodies[b];
        TaskPortion portion = TaskPortion::ofItem(control, b, bodies.size());
        const std::span<const BrokenConnection> broken =
            body.broken ? std::span<const BrokenConnection>(*body.broken) : std::span<const BrokenConnection>();
        for (CarriedPiece& piece : carriedPieces(*body.surface, body.aggregate, body.displacements, broken, portion)) {
            all.pieces.push_back(std::move(piece));
            all.bodyOf.push_back(b);
        }
    }
    return all;
}

/// All nodes, and the pieces that they are of.
struct PlacedNodes {
    std::span<const Vec3> given; ///< [m]
    std::span<const NodePlace> places;
    NodesAt at = NodesAt::rest;
};

/// Nodes of one piece, a part of them at a time, and what is known of them.
class PieceAtNodes {
public:
    PieceAtNodes(const CarriedPiece& piece, const BodyAtNodes& body, const ObjectStrains& objects)
        : m_piece(piece)
        , m_body(body)
        , m_objects(objects)
        , m_filled{.vertices = piece.filled, .triangles = piece.mesh.triangles, .faceOfTriangle = {}}
        , m_surface(m_filled)
    {
    }

    /// @param which nodes, of this piece
    void tell(std::span<const std::size_t> which, const PlacedNodes& nodes, NodalStates& states,
              TaskControl& control) const
    {
        std::vector<Vec3> given;
        given.reserve(which.size());
        for (const std::size_t node : which)
            given.push_back(nodes.given[node]);
        const std::vector<Vec3> opened = nodes.at == NodesAt::now ? openedPlaces(m_piece, given) : given;
        std::vector<Vec3> now(opened.size());
        m_piece.map->evaluate(opened, now);
        for (std::size_t i = 0; i < which.size(); ++i) {
            states.rest[which[i]] = opened[i];
            states.displacement[which[i]] = now[i] - opened[i];
        }
        const std::vector<Vec3> filled = placesWhenFilled(*m_piece.aggregate, opened);
        tellTensors(which, opened, filled, surfacesOf(which, nodes.places), states, control);
        tellCarried(which, filled, states, control);
    }

private:
    /// What of the surface nodes are on, which is what nothing presses on where it is free.
    std::vector<FreeSurface> surfacesOf(std::span<const std::size_t> which, std::span<const NodePlace> places) const
    {
        const double spacing = m_piece.aggregate->lattice.spacing;
        std::vector<FreeSurface> surfaces(which.size());
        for (std::size_t i = 0; i < which.size(); ++i) {
            const NodePlace& place = places[which[i]];
            if (place.depth < -skinDepth * spacing)
                continue;
            const auto corners = cornersOf(m_filled.vertices, m_filled.triangles[place.triangle]);
            const Vec3 nearest =
                place.shares[0] * corners[0] + place.shares[1] * corners[1] + place.shares[2] * corners[2];
            surfaces[i] = m_surface.at(nearest, place.triangle, edgeReach * spacing);
        }
        return surfaces;
    }

    void tellTensors(std::span<const std::size_t> which, std::span<const Vec3> opened, std::span<const Vec3> filled,
                     std::vector<FreeSurface> surfaces, NodalStates& states, TaskControl& control) const
    {
        const SkinStress skin(*m_piece.aggregate, filled, std::move(surfaces), m_piece.numbers, control);
        const SkinTensors tensors = skin.tensors(m_objects, m_body.loaded);
        const bool isRefilled = m_piece.aggregate->former != nullptr;
        forEachBlock(which.size(), nodesPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const std::size_t node = which[i];
                states.strain[node] = tensors.strain[i];
                if (isRefilled) { // the objects know no more than what came since
                    const Mat3 gradient = m_piece.map->gradient(opened[i]);
                    states.strain[node] = halfLogarithm(gradient * gradient.transpose());
                }
                if (!states.stress.empty() && m_body.relaxed)
                    states.stress[node] = tensors.stress[i];
            }
        });
    }

    /// What objects have, each with its share in the skin.
    void tellCarried(std::span<const std::size_t> which, const std::vector<Vec3>& filled, NodalStates& states,
                     TaskControl& control) const
    {
        const bool hasVelocity = !states.velocity.empty() && !m_body.velocities.empty();
        const bool hasFlow = !states.plasticStrain.empty() && m_body.relaxed != nullptr;
        if (!hasVelocity && !hasFlow)
            return;
        const Skin skin = Skin::ofPlacesWhenFilled(*m_piece.aggregate, filled, control);
        const auto inBody = [&](ObjectIndex own) { return m_piece.numbers.empty() ? own : m_piece.numbers[own]; };
        for (std::size_t i = 0; i < which.size(); ++i) {
            Vec3 velocity = Vec3::Zero();
            double flow = 0;
            for (const auto& [object, weight] : skin.influences(i)) {
                if (hasVelocity)
                    velocity += static_cast<double>(weight) * m_body.velocities[inBody(object)];
                if (hasFlow)
                    flow += static_cast<double>(weight) * m_objects.plasticStrain(inBody(object));
            }
            if (hasVelocity)
                states.velocity[which[i]] = velocity;
            if (hasFlow)
                states.plasticStrain[which[i]] = std::max(0.0, flow);
        }
    }

    const CarriedPiece& m_piece;
    const BodyAtNodes& m_body;
    const ObjectStrains& m_objects;
    TriangleMesh m_filled; ///< the surface where the objects were filled
    FreeSurfaceFinder m_surface;
};

/// All not known yet; what no body tells is left out.
NodalStates unknownStates(std::span<const BodyAtNodes> bodies, std::size_t count)
{
    const auto someBody = [&](auto has) { return std::ranges::any_of(bodies, has) ? count : 0; };
    NodalStates states;
    states.body.assign(count, NodePlace::none);
    states.outside.assign(count, 0);
    states.rest.assign(count, unknownVector);
    states.displacement.assign(count, unknownVector);
    states.strain.assign(count, unknownTensor);
    states.velocity.assign(someBody([](const BodyAtNodes& body) { return !body.velocities.empty(); }), unknownVector);
    states.stress.assign(someBody([](const BodyAtNodes& body) { return body.relaxed != nullptr; }), unknownTensor);
    states.plasticStrain.assign(states.stress.size(), notANumber);
    return states;
}

/// What presses on the objects of each body, shared out to its nodes, all where they are now.
void tellForces(std::span<const BodyAtNodes> bodies, std::size_t count, NodalStates& states)
{
    if (std::ranges::none_of(bodies, [](const BodyAtNodes& body) { return body.pressing != nullptr; }))
        return;
    states.contactForce.assign(states.body.size(), unknownVector);
    for (std::uint32_t b = 0; b < bodies.size(); ++b) {
        const BodyAtNodes& body = bodies[b];
        if (!body.pressing)
            continue;
        std::vector<std::size_t> which;
        std::vector<Vec3> nodes;
        for (std::size_t n = 0; n < count; ++n)
            if (states.body[n] == b) {
                which.push_back(n);
                nodes.push_back(states.rest[n] + states.displacement[n]);
            }
        std::vector<PlacedForce> forces;
        for (ObjectIndex i = 0; i < body.pressing->size(); ++i)
            if (const Vec3& force = (*body.pressing)[i]; !force.isZero(0))
                forces.push_back({body.aggregate->lattice.position(i) + body.displacements[i], force});
        const std::vector<Vec3> shared = sharedForces(forces, nodes, body.aggregate->lattice.spacing);
        for (std::size_t i = 0; i < which.size(); ++i)
            states.contactForce[which[i]] = shared[i];
    }
}

/// What a person should know before another program takes the numbers for good.
void remark(std::span<const BodyAtNodes> bodies, const AllPieces& all, std::span<const Vec3> nodes, NodalStates& states)
{
    for (std::uint32_t b = 0; b < bodies.size(); ++b)
        for (std::size_t p = 0; p < all.pieces.size(); ++p)
            if (all.bodyOf[p] == b && all.pieces[p].spansCracks) {
                states.warnings.push_back(
                    Message("Field",
                            "The cracks of \"%1\" could not be made into surfaces: values at nodes beside them "
                            "may be those of the other side.")
                        .with(bodies[b].name));
                break;
            }
    if (states.outsideCount == 0)
        return;
    std::size_t farthest = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n)
        if (states.body[n] == NodePlace::none && states.outside[n] >= states.outside[farthest])
            farthest = n;
    const Vec3& where = nodes[farthest];
    states.warnings.push_back(
        Message("Field", "%1 of %2 nodes lie outside of all bodies and have no values; the farthest is %3 away, at "
                         "(%4, %5, %6). Check the unit of the mesh, and whether its nodes lie in the parts as they "
                         "were opened or as they are now.")
            .with(states.outsideCount, nodes.size(), lengthWords(states.outside[farthest]), lengthWords(where.x()),
                  lengthWords(where.y()), lengthWords(where.z())));
}

} // namespace

std::vector<BodyAtNodes> bodiesAtNodes(const Model& model, std::span<const std::size_t> partOfBody,
                                       const Snapshot& snapshot, const Moment* moment)
{
    std::vector<BodyAtNodes> bodies;
    for (std::size_t b = 0; b < snapshot.bodies.size(); ++b) {
        const Snapshot::BodyState& state = snapshot.bodies[b];
        const Part& part = model.parts[partOfBody[b]];
        BodyAtNodes& body = bodies.emplace_back(BodyAtNodes{.name = part.name,
                                                            .surface = &part.mesh,
                                                            .aggregate = state.aggregate,
                                                            .displacements = state.displacements(),
                                                            .broken = state.broken,
                                                            .relaxed = state.relaxed,
                                                            .pressing = state.pressing,
                                                            .loaded = loadedObjects(snapshot, static_cast<BodyId>(b))});
        if (moment == nullptr || moment->bodies[b].velocity.size() != state.aggregate->size())
            continue;
        body.velocities.reserve(state.aggregate->size());
        for (std::size_t i = 0; i < state.aggregate->size(); ++i)
            body.velocities.push_back(moment->bodies[b].velocity.at(i));
    }
    return bodies;
}

NodalStates nodalStates(std::span<const BodyAtNodes> bodies, const NodesToAsk& asked, TaskControl& control)
{
    TaskPortion cutting(control, 0, 0.2);
    const AllPieces all = piecesOf(bodies, cutting);
    TaskPortion finding(control, 0.2, 0.3);
    std::vector<Vec3> nodes(asked.nodes.begin(), asked.nodes.end());
    nodes.insert(nodes.end(), asked.others.begin(), asked.others.end());
    const std::vector<NodePlace> places = nodePlaces(all.pieces, nodes, asked.at, asked.cells, finding);
    NodalStates states = unknownStates(bodies, nodes.size());
    std::vector<std::vector<std::size_t>> ofPiece(all.pieces.size());
    for (std::size_t n = 0; n < places.size(); ++n) {
        states.outside[n] = std::max(0.0, places[n].depth);
        if (places[n].piece == NodePlace::none) {
            states.outsideCount += n < asked.nodes.size() ? 1 : 0;
            continue;
        }
        states.body[n] = all.bodyOf[places[n].piece];
        ofPiece[places[n].piece].push_back(n);
    }
    for (std::size_t p = 0; p < all.pieces.size(); ++p) {
        if (ofPiece[p].empty())
            continue;
        const BodyAtNodes& body = bodies[all.bodyOf[p]];
        const RelaxedState plain{.materials = MaterialMap(Material{}, body.aggregate->size())};
        const std::vector<BrokenConnection> none;
        const ObjectStrains objects(*body.aggregate, body.displacements, body.relaxed ? *body.relaxed : plain,
                                    body.broken ? *body.broken : none);
        const PieceAtNodes piece(all.pieces[p], body, objects);
        TaskPortion telling(control, 0.3 + 0.7 * static_cast<double>(p) / static_cast<double>(all.pieces.size()),
                            0.3 + 0.7 * static_cast<double>(p + 1) / static_cast<double>(all.pieces.size()));
        for (std::size_t begin = 0; begin < ofPiece[p].size(); begin += nodesAtOnce) {
            const std::size_t count = std::min(nodesAtOnce, ofPiece[p].size() - begin);
            piece.tell(std::span(ofPiece[p]).subspan(begin, count), {nodes, places, asked.at}, states, telling);
        }
    }
    tellForces(bodies, asked.nodes.size(), states);
    remark(bodies, all, asked.nodes, states);
    return states;
}

} // namespace knead
