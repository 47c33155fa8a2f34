#pragma once

#include "core/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// A plane that cuts material off: what lies on the side that its normal points to.
struct CutPlane {
    Vec3 normal = Vec3::UnitX(); ///< unit
    double offset = 0;           ///< of the plane from the origin along the normal [m]

    double distance(const Vec3& place) const { return normal.dot(place) - offset; } ///< > 0: cut off [m]
    friend bool operator==(const CutPlane&, const CutPlane&) = default;
};

/// The face that a plane cuts out of what a closed surface bounds.
struct PlaneSection {
    std::vector<Vec3> points; ///< [m]
    std::vector<std::array<std::uint32_t, 3>>
        triangles; ///< of points, counter-clockwise seen from where the normal points to
    std::vector<std::array<std::uint32_t, 2>> outline; ///< of points; material lies to the left

    double area() const; ///< [m^2]
};

/// Two directions along a plane that make a right-handed frame with its normal: the columns (along, across, normal). The same
/// for equal normals.
Mat3 frameOf(const CutPlane& plane);

/// Where a plane cuts a surface. Each triangle that it crosses gives a side of the outline; the sides make loops, and loops
/// inside others are holes. A vertex in the plane counts as cut off, so that loops close whatever lies in it. Where the surface
/// is open, a loop is closed by a straight side. O(triangles + m^2) for m corners of the outline. Any thread.
/// @param places of the vertices [m]
/// @param tolerance corners that lie so near to the straight way between their neighbors are left out [m]
PlaneSection planeSection(std::span<const Vec3> places, std::span<const TriangleMesh::Triangle> triangles,
                          const CutPlane& plane, double tolerance = 0);

} // namespace knead
