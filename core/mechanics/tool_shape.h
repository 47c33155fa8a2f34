#pragma once

#include "core/geometry/surface_distance.h"
#include "core/geometry/triangle_mesh.h"
#include "core/geometry/vec3.h"

#include <cstdint>
#include <iterator>
#include <memory>
#include <string_view>

namespace knead {

/// Forms of rigid tools. Each lies in its own frame, centered at the origin, in a box of edge lengths `size`. Moments keep
/// the numbers.
enum class ToolKind : std::uint8_t {
    box = 0,
    ball = 1,     ///< diameter size.x; size.y and size.z are the same
    cylinder = 2, ///< along its z; diameter size.x = size.y, length size.z
    wedge = 3,    ///< its edge runs along x at the low end of z; size.y is the thickness of its back
    plate = 4,    ///< a box that is thin along z
    part = 5,     ///< an imported part
};

inline constexpr ToolKind toolKinds[] = {ToolKind::box,   ToolKind::ball,  ToolKind::cylinder,
                                         ToolKind::wedge, ToolKind::plate, ToolKind::part};

inline constexpr ToolKind lastToolKind = toolKinds[std::size(toolKinds) - 1]; // by its number

std::string_view nameOf(ToolKind kind); ///< "box", "ball" ... as in recipes

/// Whether a tool of this form may roll freely about its center or its axis.
constexpr bool canRoll(ToolKind kind)
{
    return kind == ToolKind::ball || kind == ToolKind::cylinder;
}

/// Signed distance and outward direction from the surface of a tool.
struct SurfacePoint {
    double distance = 0;         ///< [m], negative inside
    Vec3 normal = Vec3::UnitZ(); ///< outward, unit
};

/// The surface of an imported part, ready to be touched. Immutable, shared.
class ToolPart {
public:
    /// Moves the part so that the middle of its box is the origin. @throws Problem when it is empty.
    explicit ToolPart(TriangleMesh mesh);
    /// With the numbers of another one, to the last bit, as from a file. @throws Problem when it is empty.
    ToolPart(TriangleMesh centered, const Vec3& center, const Vec3& size);
    ToolPart(const ToolPart&) = delete; // the distances hold on to the mesh
    ToolPart& operator=(const ToolPart&) = delete;

    const TriangleMesh& mesh() const { return m_mesh; }
    const Vec3& size() const { return m_size; }     ///< of its box [m]
    const Vec3& center() const { return m_center; } ///< where the middle of its box was [m]
    SurfacePoint nearest(const Vec3& point) const;

private:
    TriangleMesh m_mesh;
    Vec3 m_center;
    Vec3 m_size;
    SurfaceDistance m_distance;
};

/// A form with its measures.
struct ToolShape {
    ToolKind kind = ToolKind::box;
    Vec3 size = Vec3(0.02, 0.02, 0.02);   ///< [m], > 0
    std::shared_ptr<const ToolPart> part; ///< for ToolKind::part
};

/// Nearest point of the surface, seen from `point` in the tool's frame. Exact; O(1), O(lg n) for a part.
SurfacePoint surfaceOf(const ToolShape& shape, const Vec3& point);

/// The surface as triangles, in the tool's frame; round forms with 64 sides.
TriangleMesh meshOf(const ToolShape& shape);

/// The size that a form really has: of a ball all measures are the first, and so on; of a part its own.
Vec3 fittingSize(ToolKind kind, const Vec3& size, const ToolPart* part = nullptr);

/// Nearest point of the surface of a box of edge lengths `size` centered at the origin, seen from `point`.
SurfacePoint boxSurface(const Vec3& size, const Vec3& point);

} // namespace knead
