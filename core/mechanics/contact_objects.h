#pragma once

#include "core/mechanics/contact_body.h"
#include "core/mechanics/contact_law.h"
#include "core/mechanics/joints.h"
#include "core/vicinity/vicinity.h"

#include <cstdint>
#include <vector>

namespace knead {

class SurfaceContacts;

/// An object of a body that may touch others.
struct ContactObject {
    ObjectRef ref;
    double radius = 0;      ///< against other objects [m]; 0: does not meet them
    bool isCut = false;     ///< has lost connections
    bool facesSlit = false; ///< faces its own body across a slit
    ContactParameters parameters;
};

/// The objects of all bodies that may touch others: those near the skin, body after body, then the ends of broken
/// connections in the order of breaking. And what they are like: where they are, what they are made of, which of them
/// may meet.
class ContactObjects {
public:
    static constexpr std::uint32_t none = 0xffffffffU;

    explicit ContactObjects(std::vector<ContactBody> bodies);

    const std::vector<ContactBody>& bodies() const { return m_bodies; }
    std::size_t size() const { return m_objects.size(); }
    const ContactObject& operator[](std::size_t number) const { return m_objects[number]; }
    auto begin() const { return m_objects.begin(); }
    auto end() const { return m_objects.end(); }

    /// Number of an object, or none.
    std::uint32_t numberOf(const ObjectRef& object) const { return m_numberOf[object.body][object.object]; }

    void setKind(std::uint32_t body, BodyKind kind) { m_bodies[body].kind = kind; }

    /// The end of a broken connection: from now on it may touch things on its own.
    void loosen(const ObjectRef& end);

    /// Objects within two nodes of each other with no way of at most two connections between them face each other
    /// across a slit: they may touch.
    void findSlits(std::uint32_t body);
    void markSlit(std::uint32_t number) { m_objects[number].facesSlit = true; }

    /// Takes over changed materials and masses. @param frequency see Contacts::updateParameters()
    void updateParameters(const SurfaceContacts& surfaces, double frequency);

    /// Of a contact between two.
    ContactParameters between(const ContactObject& a, const ContactObject& b) const;

    /// Whether two objects of a body are joined by one or two connections.
    bool areNeighbors(const ContactObject& a, const ContactObject& b) const;

    /// Pairs that may touch and are closer than the margin [m], sorted.
    std::vector<VicinityPair> findPairs(Vicinity& vicinity, double margin) const;

    ObjectState& stateOf(const ContactObject& object) const { return *m_bodies[object.ref.body].state; }
    Vec3 placeOf(const ContactObject& object) const { return stateOf(object).position.at(object.ref.object); }
    double distance(const VicinityPair& pair) const ///< [m]
    {
        return (placeOf(m_objects[pair.first]) - placeOf(m_objects[pair.second])).norm();
    }
    BodyKind kindOf(const ObjectRef& object) const { return m_bodies[object.body].kind; }
    const Material& materialOf(const ObjectRef& object) const
    {
        return m_bodies[object.body].materialOf(object.object);
    }
    double spacingOf(const ObjectRef& object) const { return m_bodies[object.body].spacing(); }
    double skinOf(const ObjectRef& object) const; ///< share of the body's surface [m^2]

private:
    void addSkin(std::uint32_t body);
    void add(const ContactObject& object);
    Vec3 outwardOf(const ContactObject& object) const;
    bool isOpen(const ContactObject& object) const;
    bool mayBeInContact(std::uint32_t first, std::uint32_t second, const std::vector<Vec3>& outward) const;

    std::vector<ContactBody> m_bodies;
    std::vector<ContactObject> m_objects;
    std::vector<std::vector<std::uint32_t>> m_numberOf; ///< per body and object, or none
};

} // namespace knead
