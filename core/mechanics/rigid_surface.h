#pragma once

#include "core/mechanics/tool_shape.h"

#include <cstdint>

namespace knead {

/// A rigid thing that objects may touch: a manipulator, or everything below a horizontal floor.
struct RigidSurface {
    static constexpr std::uint32_t floorId = 0xffffffffU;

    std::uint32_t id = 0; ///< of the tool, by which contacts know it again
    bool isFloor = false;
    ToolShape shape;                     ///< of a manipulator
    Pose pose;                           ///< of its center; of a floor only the height counts
    Vec3 velocity = Vec3::Zero();        ///< of the center [m/s]
    Vec3 angularVelocity = Vec3::Zero(); ///< [rad/s]
    double friction = 0;
    double adhesion = 0; ///< tension that what touched it bears [Pa]

    SurfacePoint nearest(const Vec3& place) const;
    Vec3 velocityAt(const Vec3& place) const { return velocity + angularVelocity.cross(place - pose.position); }
    Box reach(double margin) const; ///< where objects may touch it

    /// Where it was a while ago [s].
    Pose poseBefore(double duration) const;
};

/// The same for many places: its rotation is made a matrix once, and not a quaternion for each of them.
class PlacedSurface {
public:
    explicit PlacedSurface(const RigidSurface& surface); ///< which stays where it is meanwhile
    explicit PlacedSurface(const RigidSurface&&) = delete;

    const RigidSurface& operator*() const { return m_surface; }
    const RigidSurface* operator->() const { return &m_surface; }
    const Mat3& rotation() const { return m_rotation; } ///< local axes to the world's
    Vec3 toLocal(const Vec3& direction) const { return m_rotation.transpose() * direction; }
    Vec3 toWorld(const Vec3& direction) const { return m_rotation * direction; }
    Vec3 placeIn(const Vec3& place) const { return toLocal(place - m_surface.pose.position); }
    SurfacePoint nearest(const Vec3& place) const;

private:
    const RigidSurface& m_surface;
    Mat3 m_rotation;
};

/// What the objects do to a rigid surface.
struct SurfaceLoad {
    Vec3 force = Vec3::Zero();  ///< on the surface [N]
    Vec3 torque = Vec3::Zero(); ///< about its center [N m]
    double power = 0;           ///< of the surface on the material [W]
};

} // namespace knead
