#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <span>

namespace knead {

/// A point or vector in space, SI units, double precision.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// The matrix that makes v x w of w.
inline Mat3 crossMatrix(const Vec3& v)
{
    Mat3 cross;
    cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return cross;
}

/// An axis-aligned box; empty() until a point is added with extend().
using Box = Eigen::AlignedBox3d;

inline Box boxOfPlaces(std::span<const Vec3> places)
{
    Box box;
    for (const Vec3& place : places)
        box.extend(place);
    return box;
}

/// Where a rigid thing is: x = rotation * X + position.
struct Pose {
    Vec3 position = Vec3::Zero();                 ///< [m]
    Quaternion rotation = Quaternion::Identity(); ///< unit length

    Vec3 toWorld(const Vec3& local) const { return rotation * local + position; }
    Vec3 toLocal(const Vec3& world) const { return rotation.conjugate() * (world - position); }
};

} // namespace knead
