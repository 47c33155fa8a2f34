#include "core/mechanics/contact_joining.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

namespace {

// Skins that grow together are joined across this distance, in spacings: straight across and diagonally, as in a
// lattice.
constexpr double healingReach = 1.6;
// A healed object has about twice the connections across the seam that a lattice has.
constexpr double healedWeight = 0.5;
// A tool is between skins that meet so near to it [spacings].
constexpr double toolReach = 1;
// Of material that has no elongation a joint ends, when it is stretched, once it has flowed by this [log strain]: it
// would flow without end, and threads of them hold together what is far apart.
constexpr double mostFlow = 1;

/// Of what grows together where it is now.
Joint healed(const ContactObjects& objects, const ObjectRef& a, const ObjectRef& b)
{
    const double spacing = std::min(objects.spacingOf(a), objects.spacingOf(b));
    const ConnectionLaw law = lawBetween(objects.materialOf(a), objects.materialOf(b), spacing);
    const double length =
        (objects.bodies()[a.body].state->position.at(a.object) - objects.bodies()[b.body].state->position.at(b.object))
            .norm();
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

} // namespace

bool isToolBetween(const ContactPair& pair, const ContactObjects& objects, std::span<const RigidSurface> surfaces)
{
    const ObjectRef& a = objects[pair.objects.first].ref;
    const ObjectRef& b = objects[pair.objects.second].ref;
    if (a.body != b.body)
        return false;
    const bool maySeal =
        objects.materialOf(a).heals() || objects.materialOf(a).adhesion > 0 || objects.materialOf(b).adhesion > 0;
    const double reach = toolReach * objects.spacingOf(a);
    const Vec3 middle =
        0.5 * (objects.placeOf(objects[pair.objects.first]) + objects.placeOf(objects[pair.objects.second]));
    return maySeal && std::any_of(surfaces.begin(), surfaces.end(), [&](const RigidSurface& surface) {
               return !surface.isFloor && surface.reach(reach).contains(middle) &&
                      surface.nearest(middle).distance < reach;
           });
}

/// Each contact bears adhesion times the lesser of the skins that belong to its objects. Its nominal length is such
/// that it begins with the energy that the contact has.
void ContactJoining::joinIfSticky(ContactPair& pair, const ContactObjects& objects, double distance, double energy)
{
    const ObjectRef& a = objects[pair.objects.first].ref;
    const ObjectRef& b = objects[pair.objects.second].ref;
    double adhesion = std::min(objects.materialOf(a).adhesion, objects.materialOf(b).adhesion);
    for (const ObjectRef& object : {a, b})
        if (objects.kindOf(object) == BodyKind::glue)
            adhesion = objects.materialOf(object).adhesion;
    if (adhesion <= 0)
        return;
    m_new.push_back({.first = a,
                     .second = b,
                     .nominalLength = distance + std::sqrt(2 * energy / pair.parameters.stiffness),
                     .stiffness = pair.parameters.stiffness,
                     .damping = pair.parameters.damping,
                     .friction = pair.parameters.friction,
                     .tolerance = adhesion * std::min(objects.skinOf(a), objects.skinOf(b)),
                     .yieldStrain = std::numeric_limits<double>::infinity(),
                     .flowTime = 0,
                     .ductility = std::numeric_limits<double>::infinity()});
    pair.joined = true;
}

bool ContactJoining::healIfPressed(ContactPair& pair, const ContactObjects& objects, const ContactState& state,
                                   double dt)
{
    const ContactObject& first = objects[pair.objects.first];
    const ContactObject& second = objects[pair.objects.second];
    const Material& one = objects.materialOf(first.ref);
    const Material& other = objects.materialOf(second.ref);
    const bool canHeal = one.heals() && other.heals() && !pair.healed &&
                         objects.kindOf(first.ref) == BodyKind::deformable &&
                         objects.kindOf(second.ref) == BodyKind::deformable;
    if (!canHeal)
        return false;
    const double time = std::max(one.healingTime, other.healingTime);
    const double normalSpeed = state.relativeVelocity.dot(state.normal);
    const double slide = (state.relativeVelocity - normalSpeed * state.normal).norm();
    pair.pressed = slide * time < objects.spacingOf(first.ref) ? pair.pressed + dt : 0;
    if (pair.pressed < time)
        return false;
    m_new.push_back(healed(objects, first.ref, second.ref));
    const double reach = healingReach * std::min(objects.spacingOf(first.ref), objects.spacingOf(second.ref));
    const auto joinAround = [&](const ContactObject& center, const ContactObject& opposite) {
        objects.bodies()[opposite.ref.body].connections->forEachConnection(
            opposite.ref.object, [&](ObjectIndex neighbor, const ConnectionId&) {
                const ObjectRef there{opposite.ref.body, neighbor};
                const bool isSelf = there == center.ref;
                const Joint joint = healed(objects, center.ref, there);
                const std::uint32_t index = objects.numberOf(there);
                const bool touches = !isSelf && index < objects.size() && joint.nominalLength < reach &&
                                     (there.body != center.ref.body || !objects.areNeighbors(center, objects[index]));
                if (touches)
                    m_new.push_back(joint);
            });
    };
    joinAround(first, second);
    joinAround(second, first);
    return true;
}

void ContactJoining::makeNew(const ContactObjects& objects, std::vector<ContactPair>& pairs)
{
    if (m_new.empty())
        return;
    m_joints.add(std::move(m_new));
    m_new.clear();
    for (ContactPair& pair : pairs)
        noteJoint(pair, objects, m_joints);
}

} // namespace knead
