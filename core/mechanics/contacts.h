#pragma once

#include "core/aggregate/material.h"
#include "core/mechanics/contact_law.h"
#include "core/mechanics/manipulator.h"
#include "core/mechanics/object_state.h"
#include "core/mechanics/structural_connections.h"
#include "core/vicinity/uniform_grid.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// A rigid thing that objects may touch: the box of a manipulator, or everything below a horizontal floor.
struct RigidSurface {
    enum class Shape { box, floor };

    Shape shape = Shape::box;
    Vec3 size = Vec3::Zero();            ///< of a box [m]
    Pose pose;                           ///< of the box's center; of a floor only the height counts
    Vec3 velocity = Vec3::Zero();        ///< of the center [m/s]
    Vec3 angularVelocity = Vec3::Zero(); ///< [rad/s]
    double friction = 0;

    SurfacePoint nearest(const Vec3& place) const;
    Vec3 velocityAt(const Vec3& place) const { return velocity + angularVelocity.cross(place - pose.position); }
    Box reach(double margin) const; ///< where objects may touch it
};

/// What the objects do to a rigid surface.
struct SurfaceLoad {
    Vec3 force = Vec3::Zero();  ///< on the surface [N]
    Vec3 torque = Vec3::Zero(); ///< about its center [N m]
    double power = 0;           ///< of the surface on the material [W]
};

/// Contact connections: found by the vicinity calculation between objects near the skin of different bodies, and between
/// those and rigid surfaces. They exist while the ends touch.
///
/// The radius of an object in contact is its depth below the skin, so that contact begins when the skins meet and flat faces
/// are flat. Against rigid surfaces it may be negative (an object outside the skin, by the cut cells) and is limited to
/// one spacing either way; between two bodies it is at least a quarter of the spacing.
///
/// Candidates are listed with a margin and listed again when something has moved that far.
class Contacts {
public:
    struct BodyView {
        ObjectState* state;
        const Aggregate* aggregate;
        const StructuralConnections* connections;
        const Material* material;
    };

    /// Pairs of different bodies that overlap at the start keep that distance as nominal length: no force until pressed.
    explicit Contacts(std::vector<BodyView> bodies);

    /// Takes over changed materials.
    void updateParameters();

    /// Lists candidates again when objects or surfaces have moved too far, or the surfaces are others.
    /// @param travel how far the fastest object may have moved since the last call [m]
    /// @param surfaceTravel the same for the surfaces [m]
    void updateVicinity(std::span<const RigidSurface> surfaces, double travel, double surfaceTravel);

    /// Forces a new list at the next updateVicinity(): surfaces were added or removed, or the state was replaced.
    void invalidate() { m_valid = false; }

    struct Report {
        std::vector<SurfaceLoad> loads; ///< per surface
        double energy = 0;              ///< stored in contacts [J]
        double brakingPower = 0;        ///< of dampers and friction on the rigid surfaces [W]
        std::size_t count = 0;          ///< contacts that touch
    };

    /// Adds contact forces to the states of the bodies.
    Report computeForces(std::span<const RigidSurface> surfaces, double dt);

private:
    struct ContactObject {
        std::uint32_t body;
        ObjectIndex object;
        double reach;  ///< radius against rigid surfaces [m]
        double radius; ///< against other bodies [m]
        ContactParameters parameters;
    };
    struct ContactPair {
        VicinityPair objects;
        double nominalLength; ///< [m]
    };

    void rebuild(std::span<const RigidSurface> surfaces);
    std::vector<ContactPair> findPairs(double margin);
    ObjectState& stateOf(const ContactObject& object) const { return *m_bodies[object.body].state; }
    void pushApart(const ContactPair& pair, double dt, Report& report) const;
    void pushOff(const ContactObject& object, const RigidSurface& surface, double dt, SurfaceLoad& load,
                 Report& report) const;

    std::vector<BodyView> m_bodies;
    std::vector<ContactObject> m_objects;
    UniformGrid m_grid;
    std::vector<ContactPair> m_touchingAtStart; ///< sorted
    std::vector<ContactPair> m_pairs;
    std::vector<std::vector<std::uint32_t>> m_nearSurface; ///< per surface, indices into m_objects
    double m_margin = 0;                                   ///< [m]
    double m_travel = 0;
    double m_surfaceTravel = 0;
    bool m_valid = false;
};

} // namespace knead
