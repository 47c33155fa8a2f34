// How touching skins become joined: adhesion, glue and healing. Part of Contacts.
#include "core/mechanics/contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

// Skins that grow together are joined across this distance, in spacings: straight across and diagonally, as in a lattice.
constexpr double healingReach = 1.6;
// A healed object has about twice the connections across the seam that a lattice has.
constexpr double healedWeight = 0.5;
// A tool is between skins that meet so near to it [spacings].
constexpr double toolReach = 1;
// Of material that has no elongation a joint ends, when it is stretched, once it has flowed by this [log strain]: it would flow
// without end, and threads of them hold together what is far apart.
constexpr double mostFlow = 1;

} // namespace

double Contacts::skinOf(const ObjectRef& object) const
{
    const Aggregate& aggregate = m_bodies[object.body].connections->aggregate();
    const double a = aggregate.lattice.spacing;
    return std::min(2 * aggregate.volume[object.object] / a, a * a);
}

/// Skins do not grow together or stick over a tool that is inside: the rim of a dent over a ball, the sides of a cut beside a knife.
bool Contacts::isToolBetween(const ContactPair& pair, std::span<const RigidSurface> surfaces) const
{
    const ObjectRef& a = m_objects[pair.objects.first].ref;
    const ObjectRef& b = m_objects[pair.objects.second].ref;
    if (a.body != b.body)
        return false;
    const bool maySeal = materialOf(a).heals() || materialOf(a).adhesion > 0 || materialOf(b).adhesion > 0;
    const double reach = toolReach * spacingOf(a);
    const Vec3 middle = 0.5 * (placeOf(m_objects[pair.objects.first]) + placeOf(m_objects[pair.objects.second]));
    return maySeal && std::any_of(surfaces.begin(), surfaces.end(), [&](const RigidSurface& surface) {
               return !surface.isFloor && surface.reach(reach).contains(middle) &&
                      surface.nearest(middle).distance < reach;
           });
}

/// Each contact bears adhesion times the lesser of the skins that belong to its objects. Its nominal length is such that it
/// begins with the energy that the contact has.
void Contacts::joinIfSticky(ContactPair& pair, double distance, double energy)
{
    const ObjectRef& a = m_objects[pair.objects.first].ref;
    const ObjectRef& b = m_objects[pair.objects.second].ref;
    double adhesion = std::min(materialOf(a).adhesion, materialOf(b).adhesion);
    for (const ObjectRef& object : {a, b})
        if (m_bodies[object.body].kind == BodyKind::glue)
            adhesion = materialOf(object).adhesion;
    if (adhesion <= 0)
        return;
    m_newJoints.push_back({.first = a,
                           .second = b,
                           .nominalLength = distance + std::sqrt(2 * energy / pair.parameters.stiffness),
                           .stiffness = pair.parameters.stiffness,
                           .damping = pair.parameters.damping,
                           .friction = pair.parameters.friction,
                           .tolerance = adhesion * std::min(skinOf(a), skinOf(b)),
                           .yieldStrain = std::numeric_limits<double>::infinity(),
                           .flowTime = 0,
                           .ductility = std::numeric_limits<double>::infinity()});
    pair.joined = true;
}

Joint Contacts::healed(const ObjectRef& a, const ObjectRef& b) const
{
    const double spacing = std::min(spacingOf(a), spacingOf(b));
    const ConnectionLaw law = lawBetween(materialOf(a), materialOf(b), spacing);
    const double length =
        (m_bodies[a.body].state->position.at(a.object) - m_bodies[b.body].state->position.at(b.object)).norm();
    const double stiffness = healedWeight * law.stiffness * spacing;
    return {.first = a,
            .second = b,
            .nominalLength = length,
            .stiffness = stiffness,
            .damping = law.dampingTime * stiffness,
            .friction = 0,
            .tolerance = stiffness * length * law.breakingStrain,
            .yieldStrain = law.yieldStrain,
            .flowTime = law.flowTime,
            .ductility = std::min(law.ductility, mostFlow),
            .healed = true};
}

/// Pressed together for the longer of the two healing times, sliding less than a spacing in it. @return whether they healed
bool Contacts::healIfPressed(ContactPair& pair, const ContactState& state, double dt)
{
    const ContactObject& first = m_objects[pair.objects.first];
    const ContactObject& second = m_objects[pair.objects.second];
    const Material& one = materialOf(first.ref);
    const Material& other = materialOf(second.ref);
    const bool canHeal = one.heals() && other.heals() && !pair.healed &&
                         m_bodies[first.ref.body].kind == BodyKind::deformable &&
                         m_bodies[second.ref.body].kind == BodyKind::deformable;
    if (!canHeal)
        return false;
    const double time = std::max(one.healingTime, other.healingTime);
    const double normalSpeed = state.relativeVelocity.dot(state.normal);
    const double slide = (state.relativeVelocity - normalSpeed * state.normal).norm();
    pair.pressed = slide * time < spacingOf(first.ref) ? pair.pressed + dt : 0;
    if (pair.pressed < time)
        return false;
    m_newJoints.push_back(healed(first.ref, second.ref));
    const double reach = healingReach * std::min(spacingOf(first.ref), spacingOf(second.ref));
    const auto joinAround = [&](const ContactObject& center, const ContactObject& opposite) {
        m_bodies[opposite.ref.body].connections->forEachConnection(
            opposite.ref.object, [&](ObjectIndex neighbor, const ConnectionId&) {
                const ObjectRef there{opposite.ref.body, neighbor};
                const bool isSelf = there == center.ref;
                const Joint joint = healed(center.ref, there);
                const std::uint32_t index = m_indexOf[there.body][neighbor];
                const bool touches = !isSelf && index < m_objects.size() && joint.nominalLength < reach &&
                                     (there.body != center.ref.body || !areNeighbors(center, m_objects[index]));
                if (touches)
                    m_newJoints.push_back(joint);
            });
    };
    joinAround(first, second);
    joinAround(second, first);
    return true;
}

void Contacts::makeNewJoints()
{
    if (m_newJoints.empty())
        return;
    m_joints.add(std::move(m_newJoints));
    m_newJoints.clear();
    for (ContactPair& pair : m_pairs)
        noteJoint(pair);
}

void Contacts::noteJoint(ContactPair& pair) const
{
    const Joint* joint = m_joints.find(m_objects[pair.objects.first].ref, m_objects[pair.objects.second].ref);
    pair.joined = joint != nullptr;
    pair.healed = joint != nullptr && joint->healed;
}

} // namespace knead
