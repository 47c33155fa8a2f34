#pragma once

#include "core/mechanics/contact_law.h"
#include "core/mechanics/object_state.h"
#include "core/mechanics/point_spread.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// An object of any body.
struct ObjectRef {
    std::uint32_t body = 0;
    ObjectIndex object = 0;
    friend auto operator<=>(const ObjectRef&, const ObjectRef&) = default;
};

/// The force of a contact or joint at the end of a step, and how it answers to the relative velocity of its ends, for the
/// implicit scheme.
struct ContactTangent {
    ObjectRef first;
    std::optional<ObjectRef> second; ///< none: a rigid surface
    std::uint32_t surface = 0;       ///< which one
    const PointSpread* spread =
        nullptr;                    ///< where the first is no object but a point between objects of its body, else null
    Vec3 force = Vec3::Zero();      ///< on the first [N]
    Vec3 normal = Vec3::Zero();     ///< of the skins that push each other, towards the first; 0: a joint
    Mat3 resistance = Mat3::Zero(); ///< symmetric, not negative [N s/m]
    Vec3 drag = Vec3::Zero();       ///< of what slips: drag normal^T comes to it [N s/m]
};

/// A connection between two objects that are no neighbors on a lattice: of skins that stick together (adhesion, glue) or have
/// grown together (healing). It pushes and pulls, and ends when its tension exceeds its tolerance force.
struct Joint {
    ObjectRef first; ///< the lower one
    ObjectRef second;
    double nominalLength = 0; ///< l [m]
    double stiffness = 0;     ///< k [N/m]
    double damping = 0;       ///< b [N s/m]
    double friction = 0;      ///< u of eq 7 while it is pressed; healed ones have none
    double tolerance = 0;     ///< t [N]; may be infinite
    double yieldStrain = 0;   ///< beyond it l flows; infinite: never
    double flowTime = 0;      ///< [s]
    double ductility = 0;     ///< sum of flow after which it ends when stretched; infinite: never
    double plasticStrain = 0; ///< sum of its flow
    bool healed = false;      ///< grown together, not only sticking
};

/// All joints of a scene, sorted by their objects.
class Joints {
public:
    struct Report {
        double energy = 0;        ///< stored [J]
        double frictionPower = 0; ///< <= 0 [W]
        double plastic = 0;       ///< flowed off since the last call [J]
        double fracture = 0;      ///< of joints that ended [J]
        std::size_t ended = 0;
        std::vector<ContactTangent> tangents; ///< of a trial
    };

    Joints() = default;

    /// As they were: what all() gave.
    explicit Joints(std::vector<Joint> sorted)
        : m_joints(std::move(sorted))
    {
    }

    /// Adds joints. Between objects that have one, only a healed joint takes the place of one that merely sticks. Their order
    /// does not matter.
    void add(std::vector<Joint> joints);

    const Joint* find(const ObjectRef& a, const ObjectRef& b) const; ///< null when there is none
    bool connects(const ObjectRef& a, const ObjectRef& b) const { return find(a, b) != nullptr; }
    const std::vector<Joint>& all() const { return m_joints; }
    std::uint64_t version() const { return m_version; } ///< grows whenever joints come or go

    /// Flow, ends of overloaded joints (neither of them in a trial), then forces added to the states of the bodies.
    Report computeForces(std::span<ObjectState* const> bodies, const ContactStep& step);

    /// Adds the stiffness of its joints to every object of a body [N/m].
    void addStiffness(std::uint32_t body, std::vector<double>& stiffness) const;

private:
    std::vector<Joint> m_joints;
    std::uint64_t m_version = 0;
};

} // namespace knead
