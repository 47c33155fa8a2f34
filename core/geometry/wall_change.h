#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace knead {

/// A wall that became thin.
struct ThinnedWall {
    Vec3 place = Vec3::Zero();  ///< on the surface, as it is now [m]
    std::uint32_t triangle = 0; ///< that the place is on
    double thickness = 0;       ///< now [m]
    double atRest = 0;          ///< of the same place [m]
};

/// Finds the walls of a body that became thin, by points that go along with its surface.
///
/// From points spread evenly over the area at rest a ray goes straight in, at rest and now. At rest it is a wall where the ray
/// leaves through a surface within 20 degrees of parallel, as with wallThickness(). Now it may be within 45: what is pressed
/// with a ball is no longer parallel.
///
/// A wall is thin when it is less than half of what it was at the same place. It is also thin when it is less than the spacing
/// of the objects and less than 0.8 of what it was: fewer than two objects across tell little of how it bends and tears. What was
/// that thin from the start says nothing about the work, and 0.8 is beyond what bending does to a wall.
///
/// Only what lay behind the place at rest is its other side: a bar that is dented at its side is no shorter.
///
/// One place alone may be a crease or a gap between two triangles: two others must be thin within the thickness it had.
class WallChange {
public:
    /// On the calling thread alone. @pre the mesh is closed
    /// @throws Cancelled
    explicit WallChange(const TriangleMesh& rest, TaskControl& control = TaskControl::none());

    /// The thinnest of the walls that became thin; none when none did. On the calling thread alone.
    /// @param now places of the vertices [m] @param spacing of the objects [m]; 0: only the half counts
    /// @throws Cancelled
    std::optional<ThinnedWall> thinnest(const std::vector<Vec3>& now, double spacing,
                                        TaskControl& control = TaskControl::none()) const;

private:
    struct WallPoint {
        std::uint32_t triangle = 0;
        double b = 0; ///< share of the triangle's second corner
        double c = 0; ///< of its third
        double thickness = 0;
        Vec3 opposite = Vec3::Zero(); ///< where the ray leaves [m]
    };

    void findWalls(const TriangleMesh& rest, TaskControl& control);
    bool isOpposite(const WallPoint& point, std::uint32_t triangle, double spacing) const;
    std::vector<ThinnedWall> thinOnes(const std::vector<Vec3>& now, double spacing, TaskControl& control) const;

    std::vector<TriangleMesh::Triangle> m_triangles;
    std::vector<Vec3> m_rest;        ///< places of the vertices [m]
    double m_orientation = 1;        ///< -1: triangles face inwards
    std::vector<WallPoint> m_points; ///< only those at walls
};

} // namespace knead
