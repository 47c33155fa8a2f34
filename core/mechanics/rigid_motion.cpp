#include "core/mechanics/rigid_motion.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

// A body of one object, or of objects in a row, must not divide by zero when it is turned.
constexpr double leastInertiaShare = 1e-6;

} // namespace

RigidMotion::RigidMotion(const ObjectState& state, const Vec3& velocity, const Vec3& angularVelocity)
    : m_velocity(velocity)
    , m_angularVelocity(angularVelocity)
{
    double mass = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
        mass += state.mass[i];
        m_center += state.mass[i] * state.position.at(i);
    }
    m_center /= mass;
    m_arms.resize(state.size());
    for (std::size_t i = 0; i < state.size(); ++i)
        m_arms.set(i, state.position.at(i) - m_center);
    measure(state.mass);
    m_angularMomentum = m_inertia * m_angularVelocity;
    m_velocityBefore = m_velocity;
    m_angularVelocityBefore = m_angularVelocity;
    m_angularMomentumBefore = m_angularMomentum;
}

RigidMotion::RigidMotion(Memory memory, const LaneVector<double>& mass)
    : m_arms(std::move(memory.arms))
    , m_center(memory.center)
    , m_rotation(memory.rotation)
    , m_velocity(memory.velocity)
    , m_angularVelocity(memory.angularVelocity)
    , m_angularMomentum(memory.angularMomentum)
    , m_velocityBefore(memory.velocity)
    , m_angularVelocityBefore(memory.angularVelocity)
    , m_angularMomentumBefore(memory.angularMomentum)
{
    measure(mass);
}

RigidMotion::Memory RigidMotion::memory() const
{
    return {.arms = m_arms,
            .center = m_center,
            .rotation = m_rotation,
            .velocity = m_velocity,
            .angularVelocity = m_angularVelocity,
            .angularMomentum = m_angularMomentum};
}

/// Mass, radius and inertia of the objects on their arms.
void RigidMotion::measure(const LaneVector<double>& mass)
{
    for (std::size_t i = 0; i < m_arms.size(); ++i) {
        const Vec3 arm = m_arms.at(i);
        m_mass += mass[i];
        m_radius = std::max(m_radius, arm.norm());
        m_inertia += mass[i] * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    }
    m_inertia += leastInertiaShare * (m_inertia.trace() + 1e-12 * m_mass) * Mat3::Identity();
}

Mat3 RigidMotion::inverseInertia() const
{
    const Mat3 turn = m_rotation.toRotationMatrix();
    return turn * m_inertia.inverse() * turn.transpose();
}

Mat3 RigidMotion::inertia() const
{
    const Mat3 turn = m_rotation.toRotationMatrix();
    return turn * m_inertia * turn.transpose();
}

RigidMotion::Load RigidMotion::loadOf(const ObjectState& state, const Vec3& gravity) const
{
    Load load;
    load.force = m_mass * gravity;
    for (std::size_t i = 0; i < state.size(); ++i) {
        const Vec3 arm = state.position.at(i) - m_center;
        load.force += state.force.at(i) + state.damping.at(i);
        load.torque += arm.cross(state.force.at(i) + state.damping.at(i));
        load.braking += state.damping.at(i);
        load.brakingTorque += arm.cross(state.damping.at(i));
    }
    return load;
}

void RigidMotion::kick(const ObjectState& state, const Vec3& gravity, double dt)
{
    const Load load = loadOf(state, gravity);
    m_velocity += dt / m_mass * load.force;
    m_angularMomentum += dt * load.torque;
    m_angularVelocity = inverseInertia() * m_angularMomentum;
}

double RigidMotion::advance(ObjectState& state, const Vec3& gravity, double dt)
{
    const Load load = loadOf(state, gravity);
    m_velocityBefore = m_velocity;
    m_angularVelocityBefore = m_angularVelocity;
    m_angularMomentumBefore = m_angularMomentum;
    m_velocity += dt / m_mass * load.force;
    m_angularMomentum += dt * load.torque;
    m_angularVelocity = inverseInertia() * m_angularMomentum;
    m_center += dt * m_velocity;
    // The turn at the middle of the step, so that a free top keeps its energy to second order.
    const Quaternion before = m_rotation;
    m_rotation = turned(m_angularVelocity, dt / 2);
    m_angularVelocity = inverseInertia() * m_angularMomentum;
    m_rotation = before;
    m_rotation = turned(m_angularVelocity, dt);
    m_angularVelocity = inverseInertia() * m_angularMomentum;
    place(state);
    return 0.5 * dt *
           (load.braking.dot(m_velocity + m_velocityBefore) +
            load.brakingTorque.dot(m_angularVelocity + m_angularVelocityBefore));
}

Quaternion RigidMotion::turned(const Vec3& spin, double time) const
{
    const double angle = spin.norm() * time;
    return angle > 0 ? (Quaternion(Eigen::AngleAxisd(angle, spin.normalized())) * m_rotation).normalized() : m_rotation;
}

void RigidMotion::moveWith(ObjectState& state, const Vec3& velocity, const Vec3& angularVelocity, double dt)
{
    m_velocityBefore = m_velocity;
    m_angularVelocityBefore = m_angularVelocity;
    m_angularMomentumBefore = m_angularMomentum;
    m_velocity = velocity;
    m_angularVelocity = angularVelocity;
    m_center += dt * velocity;
    m_rotation = turned(angularVelocity, dt);
    m_angularMomentum = inertia() * angularVelocity;
    place(state);
}

double RigidMotion::presentKinetic() const
{
    return 0.5 * (m_mass * m_velocity.squaredNorm() + m_angularVelocity.dot(m_angularMomentum));
}

void RigidMotion::place(ObjectState& state) const
{
    const Mat3 turn = m_rotation.toRotationMatrix();
    for (std::size_t i = 0; i < state.size(); ++i) {
        const Vec3 arm = turn * m_arms.at(i);
        state.position.set(i, m_center + arm);
        state.velocity.set(i, m_velocity + m_angularVelocity.cross(arm));
    }
}

double RigidMotion::conservedKinetic() const
{
    return 0.5 * (m_mass * m_velocityBefore.dot(m_velocity) + 0.5 * (m_angularVelocityBefore.dot(m_angularMomentum) +
                                                                     m_angularVelocity.dot(m_angularMomentumBefore)));
}

double RigidMotion::kinetic() const
{
    const Vec3 velocity = 0.5 * (m_velocity + m_velocityBefore);
    return 0.5 *
           (m_mass * velocity.squaredNorm() +
            0.25 * (m_angularVelocity + m_angularVelocityBefore).dot(m_angularMomentum + m_angularMomentumBefore));
}

double RigidMotion::largestSpeed() const
{
    return m_velocity.norm() + m_angularVelocity.norm() * m_radius;
}

RigidMotion rigidMotionOf(const ObjectState& state)
{
    const RigidMotion still(state, Vec3::Zero(), Vec3::Zero());
    Vec3 momentum = Vec3::Zero();
    Vec3 angularMomentum = Vec3::Zero();
    for (std::size_t i = 0; i < state.size(); ++i) {
        momentum += state.mass[i] * state.velocity.at(i);
        angularMomentum += (state.position.at(i) - still.center()).cross(state.mass[i] * state.velocity.at(i));
    }
    return {state, momentum / still.mass(), still.inverseInertia() * angularMomentum};
}

} // namespace knead
