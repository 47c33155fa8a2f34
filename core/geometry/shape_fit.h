#pragma once

#include "core/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace knead {

/// A circle in space.
struct Circle {
    Vec3 center = Vec3::Zero();  ///< [m]
    Vec3 normal = Vec3::UnitZ(); ///< of its plane, unit
    double radius = 0;           ///< [m]
};

/// The circle through three places; none when they lie on a line.
std::optional<Circle> circleThrough(const Vec3& a, const Vec3& b, const Vec3& c);

/// The angle of two directions, 0 .. pi [rad]; 0 when one has no length.
double angleBetween(const Vec3& a, const Vec3& b);

/// Where in a triangle a place is, or what of it is nearest: shares of the corners, 0 .. 1, which add up to 1.
Vec3 nearestShares(const std::array<Vec3, 3>& corners, const Vec3& place);

/// A plane in the middle of a patch of triangles.
struct PlaneFit {
    Vec3 center = Vec3::Zero();  ///< of the area [m]
    Vec3 normal = Vec3::UnitZ(); ///< mean by area, unit; outward as the triangles are
    double deviation = 0;        ///< largest distance of a vertex [m]
};

/// The cylinder or the ball that a patch of triangles is part of.
struct RoundFit {
    enum class Form { cylinder, ball };
    Form form = Form::cylinder;
    Vec3 center = Vec3::Zero(); ///< of the ball; of a cylinder in the middle of the patch's length [m]
    Vec3 axis = Vec3::UnitZ();  ///< of a cylinder, unit
    double radius = 0;          ///< [m]
    double deviation = 0;       ///< largest distance of a vertex from it [m]
};

/// @param triangles of the mesh's, at least one
PlaneFit fitPlane(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles, std::span<const Vec3> places);

/// Whichever of the two is nearer to the vertices; none for flat patches and those of fewer than four vertices.
/// The axis is what the normals have least of; center and radius are least squares.
/// @param places of the mesh's vertices [m]
/// @param vertices those that count of a patch: as many first ones of the mesh's as lie on the true surface, since the middles
///        of split edges lie on chords
std::optional<RoundFit> fitRound(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles,
                                 std::span<const Vec3> places, std::size_t vertices);

} // namespace knead
