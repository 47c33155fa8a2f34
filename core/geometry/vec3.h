#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace knead {

/// A point or vector in space, SI units, double precision.
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

/// An axis-aligned box; empty() until a point is added with extend().
using Box = Eigen::AlignedBox3d;

/// Where a rigid thing is: x = rotation * X + position.
struct Pose {
    Vec3 position = Vec3::Zero();                 ///< [m]
    Quaternion rotation = Quaternion::Identity(); ///< unit length

    Vec3 toWorld(const Vec3& local) const { return rotation * local + position; }
    Vec3 toLocal(const Vec3& world) const { return rotation.conjugate() * (world - position); }
};

} // namespace knead
