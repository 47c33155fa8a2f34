// What presses on objects at one moment, to be looked at. Part of Contacts.
#include "core/mechanics/contacts.h"

#include <algorithm>

namespace knead {

std::vector<std::vector<Vec3>> Contacts::pressingForces(std::span<const RigidSurface> surfaces,
                                                        const ContactStep& step) const
{
    std::vector<std::vector<Vec3>> forces;
    for (const BodyView& body : m_bodies)
        forces.emplace_back(body.connections->aggregate().size(), Vec3::Zero());
    const auto add = [&](const ContactObject& object, const Vec3& force) {
        forces[object.ref.body][object.ref.object] += force;
    };

    // Lists of its own: those of the steps stay as they are, and may not be there, as after going to a moment.
    const std::unique_ptr<Vicinity> vicinity = makeVicinity(VicinityMethod::uniformGrid);
    std::vector<ContactPair> pairs = findPairs(*vicinity, 0);
    takeOverLengths(pairs);
    for (const ContactPair& pair : pairs) {
        const ContactObject& first = m_objects[pair.objects.first];
        const ContactObject& second = m_objects[pair.objects.second];
        const Vec3 between = placeOf(first) - placeOf(second);
        const double distance = between.norm();
        if (pair.joined || pair.healed || distance >= pair.nominalLength || distance == 0)
            continue;
        const ContactState state{.overlap = pair.nominalLength - distance, .normal = between / distance};
        const Vec3 force = contactForce(state, pair.parameters, step).spring;
        add(first, force);
        add(second, -force);
    }
    m_surfaceContacts.addPressing(m_bodies, surfaces, forces);
    return forces;
}

} // namespace knead
