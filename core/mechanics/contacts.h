#pragma once

#include "core/mechanics/contact_crowd.h"
#include "core/mechanics/contact_joining.h"
#include "core/mechanics/contact_listing.h"
#include "core/mechanics/contact_report.h"
#include "core/mechanics/cutting_edges.h"
#include "core/mechanics/surface_contacts.h"

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace knead {

/// Contact connections: found by the vicinity calculation between objects near the skin, of one body or two, and
/// between the skin and rigid surfaces (SurfaceContacts). They exist while the ends touch.
///
/// The radius of an object in contact is its depth below the skin, so that contact begins when the skins meet.
/// Objects feel each other when they are half to one and a half spacings deep: so large, spheres a spacing apart let
/// nothing through between them. Sheets too thin to have such objects, and the ends of broken connections, take part
/// with half a spacing.
///
/// Within a body, objects that are joined by one or two connections do not touch each other.
///
/// Where both materials are adhesive, or one body is glue, touching makes a joint that holds up to the least
/// adhesion. Where both heal, skins that stay pressed together for the longer healing time grow together.
///
/// Who does what: ContactObjects know which objects may touch and what they are like, ContactListing when candidates
/// are due, ContactPair and KeptLengths what pairs remember, ContactJoining makes joints. Here they come together.
class Contacts {
public:
    using BodyView = ContactBody;
    using Report = ContactReport;
    using Friction = ContactFriction;

    /// Pairs that overlap at the start keep that distance as nominal length: no force until pressed.
    Contacts(std::vector<BodyView> bodies, VicinityMethod method);

    /// What is kept of the past; all else follows from the places and materials of the bodies.
    struct Memory {
        struct Pair {
            ObjectRef first;
            ObjectRef second;
            double value = 0;
        };
        std::vector<Pair> keptLengths;  ///< nominal lengths of pairs that have their own [m]
        std::vector<Pair> pressedTimes; ///< how long pairs have been pressed together now [s]
        struct Held {
            ObjectRef first;
            ObjectRef second;
            FrictionMemory friction; ///< on the first
        };
        std::vector<Held> holds;                     ///< of pairs
        std::vector<SurfaceContacts::Touch> touches; ///< of rigid surfaces
        std::vector<CuttingEdges::Hold> edges;       ///< of knives
        std::vector<ObjectRef> facingSlit;           ///< objects that face their own body across a slit
        std::vector<Joint> joints;
        double frequency = 0; ///< see updateParameters() [rad/s]
    };

    /// @pre ends of broken connections are contact objects, see connectionsBroke()
    Memory memory() const;

    /// As they were, with the bodies as they were. Pairs of what is no contact object are left out.
    Contacts(std::vector<BodyView> bodies, VicinityMethod method, const Memory& memory);

    /// Takes over changed materials and masses.
    /// @param frequency the largest one of the deformable bodies, which rigid ones must not exceed [rad/s]
    void updateParameters(double frequency);

    /// The same where nothing else has changed. Where all bodies deform nothing depends on it, and lists of what is near stay.
    /// @param frequency the same, > 0
    void setFrequency(double frequency);

    void setKind(std::uint32_t body, BodyKind kind);

    /// Joins bodies that touch as if they were one, see gluedJoints().
    void glueTouching();

    /// Objects of a body are others: what they overlap with at once is where the old ones were, and keeps its
    /// distance.
    void keepDistancesOf(std::uint32_t body);

    /// Ends of newly broken connections become contact objects; where they overlap now, they keep their distance.
    void connectionsBroke(std::span<const RigidSurface> surfaces);

    /// Energy of contacts with surfaces that ended as their skin tore, since the last call [J].
    double takeReleased() { return std::exchange(m_released, 0.0); }

    /// Lists candidates again when objects or surfaces have moved too far towards each other, or the surfaces are
    /// others.
    /// @param travel how far the fastest object may have moved since the last call [m]
    /// @param surfaceTravel the same for the surfaces [m]
    void updateVicinity(std::span<const RigidSurface> surfaces, double travel, double surfaceTravel);

    /// Steps of the implicit scheme bring together what is further apart, and explicit ones are shorter the stiffer
    /// the springs at tools and the floor are: these are softer there.
    /// @return change of the energy that those springs store [J]
    double setScheme(std::span<const RigidSurface> surfaces, bool isImplicit);

    /// Forces a new list at the next updateVicinity(): surfaces were added or removed, or the state was replaced.
    void invalidate() { m_listing.invalidate(); }

    /// Adds contact and joint forces to the states of the bodies; makes and ends joints, but not in a trial.
    Report computeForces(std::span<const RigidSurface> surfaces, const ContactStep& step);

    /// See SurfaceContacts::beginStep(). @pre updateVicinity() of these surfaces
    void beginStep(std::span<const RigidSurface> surfaces, double duration)
    {
        m_surfaceContacts.beginStep(m_objects.bodies(), surfaces, duration);
        m_edges.begin(m_objects.bodies(), surfaces, duration);
    }

    /// The connections that knives went through in the step, with everything where it is after it. Per body
    std::vector<std::vector<BrokenConnection>> cuts(std::span<const RigidSurface> surfaces) const
    {
        return m_edges.cuts(m_objects.bodies(), surfaces);
    }

    /// Tools and the floor were just put somewhere: what is in material already begins without force, see
    /// SurfaceContacts.
    void keepInside(std::span<const RigidSurface> surfaces);

    /// How far the skin of a body is in a surface [m]; negative: not at all.
    double deepest(std::uint32_t body, const RigidSurface& surface) const
    {
        return m_surfaceContacts.deepest(m_objects.bodies()[body], body, surface);
    }

    /// What presses on the objects now: the springs of contacts with surfaces and with other objects, without
    /// dampers, friction and joints. Changes nothing. Per body and object [N]
    std::vector<std::vector<Vec3>> pressingForces(std::span<const RigidSurface> surfaces,
                                                  const ContactStep& step) const;

    /// Stiffness that contacts and joints add to the objects of a body [N/m].
    /// @param crowding contacts at a time that one object may have
    std::vector<double> addedStiffness(std::uint32_t body, double crowding) const;

    /// Whether time alone changes something: skins that are pressed together heal, material is pushed out of a tool
    /// that was put there.
    bool isWaiting() const;

    /// Whether material is being pushed out of a tool that was put into it.
    bool isPushingOut() const { return m_surfaceContacts.isWaiting(); }

    const Joints& joints() const { return m_joining.joints(); }
    const VicinityStatistics& statistics() const { return m_statistics; } ///< of the last listing
    std::size_t listings() const { return m_listing.count(); }            ///< of pairs, so far

private:
    void listPairs(std::span<const RigidSurface> surfaces);
    void keepDistances();
    void addHolds(const std::vector<Memory::Held>& holds);
    std::vector<ContactPair> pairsOf(const std::vector<Memory::Pair>& remembered) const;
    void pushApart(ContactPair& pair, std::span<const RigidSurface> surfaces, const ContactStep& step, Report& report);

    ContactObjects m_objects;
    std::vector<ContactPair> m_pairs; ///< that may touch, sorted
    KeptLengths m_kept;
    ContactJoining m_joining;
    SurfaceContacts m_surfaceContacts;
    CuttingEdges m_edges;
    ContactCrowd m_crowd;
    ContactListing m_listing;
    std::unique_ptr<Vicinity> m_vicinity;
    VicinityStatistics m_statistics;
    std::vector<std::size_t> m_brokenSeen; ///< per body: broken connections taken into account
    double m_released = 0;                 ///< see takeReleased() [J]
    double m_frequency = 0;                ///< see updateParameters() [rad/s]
    bool m_isImplicit = true;
};

} // namespace knead
