#pragma once

#include "core/mechanics/contact_pairs.h"
#include "core/mechanics/rigid_surface.h"

#include <span>
#include <vector>

namespace knead {

/// How touching skins become joined, and the joints that they have then. Skins stick together (adhesion, glue), and
/// grow together where they stay pressed (healing).
class ContactJoining {
public:
    ContactJoining() = default;
    explicit ContactJoining(Joints joints)
        : m_joints(std::move(joints))
    {
    }

    const Joints& joints() const { return m_joints; }
    Joints& joints() { return m_joints; }

    /// Joins a pair that touches where its materials are adhesive, from makeNew() on.
    /// @param distance of the objects [m] @param energy that the contact stores [J]
    void joinIfSticky(ContactPair& pair, const ContactObjects& objects, double distance, double energy);

    /// Counts the time for which a pair is pressed. It heals, from makeNew() on, after the longer of the two healing
    /// times, sliding less than a spacing in it. @param dt the step [s] @return whether it healed
    bool healIfPressed(ContactPair& pair, const ContactObjects& objects, const ContactState& state, double dt);

    /// The joints that the calls before have found come to be; pairs note it.
    void makeNew(const ContactObjects& objects, std::vector<ContactPair>& pairs);
    void makeNew(const ContactObjects& objects, std::vector<ContactPair>& pairs, std::vector<Joint> joints)
    {
        m_new = std::move(joints);
        makeNew(objects, pairs);
    }

private:
    Joints m_joints;
    std::vector<Joint> m_new; ///< found, but not there yet
};

/// Skins do not grow together or stick over a tool that is inside: the rim of a dent over a ball, the sides of a cut
/// beside a knife.
bool isToolBetween(const ContactPair& pair, const ContactObjects& objects, std::span<const RigidSurface> surfaces);

/// Joints of objects of bodies whose skins lie within half a spacing of each other, as if the bodies were one: as
/// stiff as the materials, and as strong as the weaker one. @pre bodies are at rest where their lattices are
std::vector<Joint> gluedJoints(const ContactObjects& objects);

} // namespace knead
