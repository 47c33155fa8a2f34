#include "core/session/session_field.h"

#include "core/geometry/disjoint_sets.h"
#include "core/skin/former_shape.h"
#include "core/skin/skin_map.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace knead {

namespace {

/// Objects nearer to the surface than that are spoken for by its vertices [spacings].
constexpr double nearSurface = 0.25;

constexpr std::size_t pointsAtOnce = 20'000; // between looks at whether to go on

void addNode(DisplacementField& field, const Vec3& rest, const Vec3& now)
{
    if (!rest.allFinite() || !now.allFinite())
        return;
    field.nodes.push_back(rest);
    field.displacements.push_back(now - rest);
}

/// The nodes of a body in one piece: vertices of its surface, and objects inside of it.
std::vector<Vec3> nodesOf(const FilledBody& body)
{
    std::vector<Vec3> nodes = body.mesh.vertices;
    const Aggregate& first = firstFillingOf(*body.aggregate);
    for (ObjectIndex i = 0; i < first.size(); ++i)
        if (first.depth[i] > nearSurface * first.lattice.spacing)
            nodes.push_back(first.lattice.position(i));
    return nodes;
}

DisplacementField wholeField(const FilledBody& body, const Snapshot::BodyState& state, TaskControl& control)
{
    const std::vector<Vec3> nodes = nodesOf(body);
    const SkinMap map(*body.aggregate, state.displacements());
    std::vector<Vec3> places(nodes.size());
    for (std::size_t begin = 0; begin < nodes.size(); begin += pointsAtOnce) {
        control.throwIfCancelled();
        control.report(static_cast<double>(begin) / static_cast<double>(nodes.size()), body.name);
        const std::size_t count = std::min(pointsAtOnce, nodes.size() - begin);
        map.evaluate(std::span(nodes).subspan(begin, count), std::span(places).subspan(begin, count));
    }
    DisplacementField field;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        addNode(field, nodes[i], places[i]);
    return field;
}

/// Per vertex, whether it belongs to the piece of a surface with the largest area.
std::vector<bool> largestPiece(const TriangleMesh& mesh)
{
    DisjointSets sets(mesh.vertices.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        sets.join(a, b);
        sets.join(b, c);
    }
    std::vector<double> areas(mesh.vertices.size(), 0);
    for (const auto& t : mesh.triangles)
        areas[sets.find(t[0])] += crossOf(mesh.vertices, t).norm() / 2;
    const auto largest = static_cast<std::size_t>(std::ranges::max_element(areas) - areas.begin());
    std::vector<bool> isIn(mesh.vertices.size());
    for (std::size_t v = 0; v < isIn.size(); ++v)
        isIn[v] = sets.find(v) == largest;
    return isIn;
}

bool isBefore(const Vec3& a, const Vec3& b)
{
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// Where several nodes lie in one place, as the two sides of a crack do at rest, they become one in the middle of where they went.
/// Nodes are in the order of their places afterwards.
void joinNodes(DisplacementField& field)
{
    std::vector<std::size_t> order(field.nodes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return isBefore(field.nodes[a], field.nodes[b]); });
    DisplacementField joined;
    for (std::size_t i = 0; i < order.size();) {
        const Vec3& place = field.nodes[order[i]];
        Vec3 sum = Vec3::Zero();
        std::size_t end = i;
        for (; end < order.size() && field.nodes[order[end]] == place; ++end)
            sum += field.displacements[order[end]];
        joined.nodes.push_back(place);
        joined.displacements.push_back(sum / static_cast<double>(end - i));
        i = end;
    }
    field = std::move(joined);
}

/// Of the surface only: which side of a crack an object belongs to is known there.
DisplacementField tornField(const FilledBody& body, const BodyFrame& now)
{
    const std::vector<bool> isIn = largestPiece(body.mesh);
    DisplacementField field;
    for (std::size_t v = 0; v < isIn.size(); ++v)
        if (isIn[v])
            addNode(field, body.mesh.vertices[v], now.places[v]);
    joinNodes(field);
    return field;
}

bool hasComeApart(const FilledBody& body, const Snapshot::BodyState& state)
{
    return body.whole || (state.aggregate->former && state.aggregate->former->isInPieces());
}

} // namespace

SessionField sessionField(const FilledModel& content, const Frame& frame, TaskControl& control)
{
    SessionField session;
    const FilledBodies& bodies = frame.filled.empty() ? content.bodies : frame.filled;
    for (BodyId b = 0; b < bodies.size(); ++b) {
        TaskPortion portion = TaskPortion::ofItem(control, b, bodies.size());
        const FilledBody& body = *bodies[b];
        const Snapshot::BodyState& state = frame.snapshot->bodies[b];
        const bool isTorn = hasComeApart(body, state);
        session.bodies.push_back(
            {b, body.name, isTorn ? tornField(body, *frame.bodies[b]) : wholeField(body, state, portion)});
        if (isTorn)
            session.leftOut.push_back(
                Message("Session field", "\"%1\" is cracked, cut or in pieces there, and a field cannot tear: it says "
                                         "what became of the largest piece, as if it were whole.")
                    .with(body.name));
    }
    return session;
}

DisplacementField joinedField(const SessionField& session)
{
    DisplacementField all;
    for (const BodyField& body : session.bodies) {
        all.nodes.insert(all.nodes.end(), body.field.nodes.begin(), body.field.nodes.end());
        all.displacements.insert(all.displacements.end(), body.field.displacements.begin(),
                                 body.field.displacements.end());
    }
    if (session.bodies.size() > 1)
        joinNodes(all);
    return all;
}

} // namespace knead
