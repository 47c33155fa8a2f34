#include "core/mechanics/rigid_surface.h"

#include <limits>

namespace knead {

SurfacePoint RigidSurface::nearest(const Vec3& place) const
{
    return PlacedSurface(*this).nearest(place);
}

Pose RigidSurface::poseBefore(double duration) const
{
    const double speed = angularVelocity.norm();
    const Quaternion back(speed > 0 ? Eigen::AngleAxisd(-speed * duration, angularVelocity / speed)
                                    : Eigen::AngleAxisd::Identity());
    return {pose.position - duration * velocity, back * pose.rotation};
}

PlacedSurface::PlacedSurface(const RigidSurface& surface)
    : m_surface(surface)
    , m_rotation(surface.isFloor ? Mat3::Identity() : surface.pose.rotation.toRotationMatrix())
{
}

SurfacePoint PlacedSurface::nearest(const Vec3& place) const
{
    if (m_surface.isFloor)
        return {place.z() - m_surface.pose.position.z(), Vec3::UnitZ()};
    SurfacePoint point = surfaceOf(m_surface.shape, placeIn(place));
    point.normal = toWorld(point.normal);
    return point;
}

Box RigidSurface::reach(double margin) const
{
    if (isFloor) {
        const double infinite = std::numeric_limits<double>::max();
        return {Vec3(-infinite, -infinite, -infinite), Vec3(infinite, infinite, pose.position.z() + margin)};
    }
    const Vec3 extent = pose.rotation.toRotationMatrix().cwiseAbs() * (0.5 * shape.size) + Vec3::Constant(margin);
    return {pose.position - extent, pose.position + extent};
}

} // namespace knead
