#pragma once

#include "core/mechanics/object_state.h"

namespace knead {

/// The motion of a rigid body with six degrees of freedom. It is made of the same objects as a deformable one: contact
/// forces act on them, and they follow the body.
class RigidMotion {
public:
    /// The objects where they are, moving at a common velocity about their center of mass.
    RigidMotion(const ObjectState& state, const Vec3& velocity, const Vec3& angularVelocity);

    /// What a motion goes on from; all else follows.
    struct Memory {
        VectorArray arms;           ///< objects from the center, at the start [m]
        Vec3 center = Vec3::Zero(); ///< [m]
        Quaternion rotation = Quaternion::Identity();
        Vec3 velocity = Vec3::Zero();        ///< [m/s]
        Vec3 angularVelocity = Vec3::Zero(); ///< [rad/s]
        Vec3 angularMomentum = Vec3::Zero(); ///< about the center [kg m^2/s]
    };
    Memory memory() const;

    /// As it was. @param mass per object, as it was then [kg]
    RigidMotion(Memory memory, const LaneVector<double>& mass);

    /// Puts the objects where the motion has them, with its velocities.
    void place(ObjectState& state) const;

    /// One step of semi-implicit Euler: momentum from state.force, state.damping and gravity, then position and rotation with
    /// the new velocities. Angular momentum about the center is integrated, so that a free body keeps it exactly.
    /// Positions and velocities of the objects follow. @return work of state.damping [J]
    double advance(ObjectState& state, const Vec3& gravity, double dt);

    /// Adds the momentum that present forces give in a time dt, see kick() of the semi-implicit scheme.
    void kick(const ObjectState& state, const Vec3& gravity, double dt);

    /// Moves on for a time dt with the given velocities; they are then those at the end. Positions and velocities of the
    /// objects follow. What gave it these velocities is up to the caller (the implicit scheme).
    void moveWith(ObjectState& state, const Vec3& velocity, const Vec3& angularVelocity, double dt);

    /// What the forces on the objects are together.
    struct Load {
        Vec3 force = Vec3::Zero();  ///< gravity included [N]
        Vec3 torque = Vec3::Zero(); ///< about the center [N m]
        Vec3 braking = Vec3::Zero();
        Vec3 brakingTorque = Vec3::Zero();
    };
    Load loadOf(const ObjectState& state, const Vec3& gravity) const;

    /// Kinetic energy of the products of velocities before and after the last step [J].
    double conservedKinetic() const;
    double kinetic() const; ///< of their means [J]

    double mass() const { return m_mass; }                            ///< [kg]
    const Vec3& center() const { return m_center; }                   ///< [m]
    const Vec3& velocity() const { return m_velocity; }               ///< [m/s]
    const Vec3& angularVelocity() const { return m_angularVelocity; } ///< [rad/s]
    const Vec3& angularMomentum() const { return m_angularMomentum; } ///< about the center [kg m^2/s]
    const Quaternion& rotation() const { return m_rotation; }         ///< from the start
    double radius() const { return m_radius; }                        ///< of the farthest object [m]
    double presentKinetic() const;                                    ///< [J]
    Mat3 inertia() const;                                             ///< in the world [kg m^2]
    Mat3 inverseInertia() const;                                      ///< in the world [1/(kg m^2)]
    double largestSpeed() const;                                      ///< of any of its points [m/s]

private:
    void measure(const LaneVector<double>& mass);
    Quaternion turned(const Vec3& spin, double time) const;

    VectorArray m_arms; ///< objects from the center, at the start [m]
    double m_mass = 0;
    double m_radius = 0;           ///< of the farthest object [m]
    Mat3 m_inertia = Mat3::Zero(); ///< about the center, at the start [kg m^2]
    Vec3 m_center = Vec3::Zero();
    Quaternion m_rotation = Quaternion::Identity();
    Vec3 m_velocity = Vec3::Zero();
    Vec3 m_angularVelocity = Vec3::Zero();
    Vec3 m_angularMomentum = Vec3::Zero();
    Vec3 m_velocityBefore = Vec3::Zero();
    Vec3 m_angularVelocityBefore = Vec3::Zero();
    Vec3 m_angularMomentumBefore = Vec3::Zero();
};

/// The rigid motion with the momenta that the objects have now.
RigidMotion rigidMotionOf(const ObjectState& state);

} // namespace knead
