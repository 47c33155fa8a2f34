// How bodies that touch at the start are made one.
#include "core/mechanics/contact_joining.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

constexpr double gluingRounding = 1e-6; // [a]
constexpr double touchingGap = 0.5;     // [a] between skins
constexpr double deepestOverlap = 1;    // [a]: bodies further inside each other do not merely touch
constexpr double gluedDepth = 1;        // [a]: objects less deep than this are joined
constexpr double gluingReach = 1.6;     // [a]: straight across and diagonally, as in a lattice

/// A seam of two lattices that meet node on node is opened by so many connections, their squared slopes added up: one
/// between the nodes, and from each of them one straight and four diagonal ones into the other body.
constexpr double connectionsAcross = 1 + 2 * (1 + 4 * 0.5);
constexpr double jointWeight =
    0.5; // by that of a full connection of a lattice; measured: a bar of two is as stiff as one
constexpr double stressAtStrain = 2.5; // E / mu of a lattice, whose connections have the stiffness mu a

Lattice::Node plus(Lattice::Node node, const Lattice::Node& step, int times)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        node[axis] += times * step[axis];
    return node;
}

/// Away from the neighbors that an object has; zero within the body.
Vec3 outwardAt(const Lattice& lattice, ObjectIndex object)
{
    Vec3 sum = Vec3::Zero();
    for (int d = 0; d < Lattice::isotropicCount; ++d)
        for (const int way : {-1, 1})
            if (lattice.find(plus(lattice.nodes[object], Lattice::directions[static_cast<std::size_t>(d)], way)) ==
                lattice.size())
                sum += way * lattice.direction(d);
    return sum.norm() > 0 ? Vec3(sum.normalized()) : sum;
}

/// Calls visit(object, distance) for the objects of a body at rest within `radius` of a place.
template <typename Visit>
void forEachWithin(const Lattice& lattice, const Vec3& place, double radius, Visit&& visit)
{
    const Vec3 middle = lattice.coordinates(place);
    const double nodes = radius / lattice.spacing;
    std::array<std::int32_t, 3> low{};
    std::array<std::int32_t, 3> high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = static_cast<std::int32_t>(std::ceil(middle[static_cast<Eigen::Index>(axis)] - nodes));
        high[axis] = static_cast<std::int32_t>(std::floor(middle[static_cast<Eigen::Index>(axis)] + nodes));
    }
    for (std::int32_t u = low[0]; u <= high[0]; ++u)
        for (std::int32_t v = low[1]; v <= high[1]; ++v)
            for (std::int32_t w = low[2]; w <= high[2]; ++w) {
                const ObjectIndex object = lattice.find({u, v, w});
                if (object == lattice.size())
                    continue;
                const double distance = (lattice.position(object) - place).norm();
                if (distance <= radius)
                    visit(object, distance);
            }
}

/// Whether the skin of another body is within the gap, measured along the way out of that body's nearest object.
bool touches(const ContactObjects& objects, const ObjectRef& object, std::uint32_t other)
{
    const Aggregate& own = objects.bodies()[object.body].connections->aggregate();
    const Aggregate& theirs = objects.bodies()[other].connections->aggregate();
    const double a = std::max(own.lattice.spacing, theirs.lattice.spacing);
    const Vec3 place = own.lattice.position(object.object);
    ObjectIndex nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    forEachWithin(theirs.lattice, place, gluingReach * a, [&](ObjectIndex candidate, double distance) {
        const bool isSkin = theirs.depth[candidate] < (gluedDepth - gluingRounding) * theirs.lattice.spacing;
        if (isSkin && distance < least) {
            nearest = candidate;
            least = distance;
        }
    });
    if (!std::isfinite(least))
        return false;
    const double above =
        outwardAt(theirs.lattice, nearest).dot(place - theirs.lattice.position(nearest)) - theirs.depth[nearest];
    const double gap = above - own.depth[object.object];
    return gap <= (touchingGap + gluingRounding) * a && gap >= -deepestOverlap * a;
}

/// Adds joints of an object with those around it of another body.
void glueTo(const ContactObjects& objects, const ObjectRef& object, std::uint32_t other, std::vector<Joint>& joints)
{
    const Lattice& lattice = objects.bodies()[other].connections->aggregate().lattice;
    const auto shareOf = [&](const ObjectRef& end) { // of the section that an object in the skin stands for
        const double a = objects.spacingOf(end);
        return objects.skinOf(end) / (a * a);
    };
    const double spacing = std::min(objects.spacingOf(object), lattice.spacing);
    const Vec3 place = objects.bodies()[object.body].connections->aggregate().lattice.position(object.object);
    const double radius = gluingReach * std::max(objects.spacingOf(object), lattice.spacing);
    forEachWithin(lattice, place, radius, [&](ObjectIndex end, double distance) {
        const ObjectRef opposite{other, end};
        const Material& one = objects.materialOf(object);
        const Material& two = objects.materialOf(opposite);
        const ConnectionLaw law = lawBetween(one, two, spacing);
        const double stiffness = jointWeight * law.stiffness * spacing * std::min(shareOf(object), shareOf(opposite));
        // By so much the seam opens under the stress that tears it, and the material at it is strained as well.
        const bool tears = std::isfinite(law.breakingStrain);
        const double opening = stressAtStrain * law.breakingStrain * spacing / (jointWeight * connectionsAcross);
        joints.push_back({.first = object,
                          .second = opposite,
                          .nominalLength = distance,
                          .stiffness = stiffness,
                          .damping = law.dampingTime * stiffness,
                          .tolerance = tears ? stiffness * (opening + distance * law.breakingStrain)
                                             : std::numeric_limits<double>::infinity(),
                          .yieldStrain = std::numeric_limits<double>::infinity(),
                          .ductility = std::numeric_limits<double>::infinity(),
                          .healed = true});
    });
}

} // namespace

std::vector<Joint> gluedJoints(const ContactObjects& objects)
{
    std::vector<Joint> joints;
    const auto boxOf = [](const Aggregate& aggregate) {
        Box box;
        for (ObjectIndex i = 0; i < aggregate.size(); ++i)
            box.extend(aggregate.lattice.position(i));
        return box;
    };
    std::vector<Box> boxes;
    for (const ContactBody& body : objects.bodies())
        boxes.push_back(boxOf(body.connections->aggregate()));
    for (std::uint32_t b = 0; b < objects.bodies().size(); ++b)
        for (std::uint32_t other = 0; other < objects.bodies().size(); ++other) {
            const Vec3 margin =
                Vec3::Constant(gluingReach * std::max(objects.spacingOf({b, 0}), objects.spacingOf({other, 0})));
            const Box near(boxes[other].min() - margin, boxes[other].max() + margin);
            if (b == other || !near.intersects(boxes[b]))
                continue;
            const Aggregate& aggregate = objects.bodies()[b].connections->aggregate();
            for (ObjectIndex i = 0; i < aggregate.size(); ++i) {
                const bool isSkin = aggregate.depth[i] < (gluedDepth - gluingRounding) * aggregate.lattice.spacing;
                if (isSkin && near.contains(aggregate.lattice.position(i)) && touches(objects, {b, i}, other))
                    glueTo(objects, {b, i}, other, joints);
            }
        }
    return joints;
}

} // namespace knead
