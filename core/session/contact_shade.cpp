#include "core/session/contact_shade.h"

#include "core/mechanics/rigid_surface.h"
#include "core/session/vertex_shades.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

constexpr double reachOfPart = 0.3; // in sizes: each distance of an imported part takes microseconds

/// Area of the shadow that a convex tool throws along a direction u of its frame [m^2]: sum of A |n . u| / 2 over faces.
double silhouetteArea(const ToolShape& shape, const Vec3& direction)
{
    const Vec3 u = direction.cwiseAbs();
    const Vec3& s = shape.size;
    switch (shape.kind) {
    case ToolKind::ball:
        return std::numbers::pi * s.x() * s.x() / 4;
    case ToolKind::cylinder:
        return std::numbers::pi * s.x() * s.x() / 4 * u.z() + s.x() * s.z() * std::hypot(u.x(), u.y());
    case ToolKind::wedge: // both slanting faces have sx (0, +-sz, -sy / 2) for A n; the ends are triangles
        return s.y() * s.z() * u.x() / 2 +
               s.x() *
                   (s.y() * u.z() + std::abs(s.z() * u.y() - s.y() * u.z() / 2) + s.z() * u.y() + s.y() * u.z() / 2) /
                   2;
    case ToolKind::box:
    case ToolKind::plate:
    case ToolKind::part: // as its box
        break;
    }
    return s.y() * s.z() * u.x() + s.z() * s.x() * u.y() + s.x() * s.y() * u.z();
}

/// Share of the light from above that a ball keeps off, see contactShades().
/// @param h its distance in radii, at least 1 @param c cosine of the angle between it and the normal
double formFactor(double h, double c)
{
    const double beyond = std::max(h * h - 1, 1e-9);
    const double cut = 1 - h * h * c * c;
    if (cut <= 0)
        return std::max(0.0, c) / (h * h);
    const double slope = std::sqrt(beyond / std::max(1 - c * c, 1e-9));
    const double disk = c * std::acos(std::clamp(-c * slope, -1.0, 1.0)) - std::sqrt(cut * beyond);
    return std::clamp((disk / (h * h) + std::atan(std::sqrt(cut / beyond))) / std::numbers::pi, 0.0, 1.0);
}

/// A tool, with what tells quickly that a vertex has nothing of it.
class Occluder {
public:
    explicit Occluder(const ToolState& tool)
        : m_surface{.id = tool.id,
                    .shape = {tool.kind, fittingSize(tool.kind, tool.size, tool.part.get()), tool.part},
                    .pose = tool.pose}
        , m_reach(m_surface.shape.size.maxCoeff() * (tool.kind == ToolKind::part ? reachOfPart : 1))
        , m_radius(m_surface.shape.size.norm() / 2)
        , m_box(m_surface.reach(m_reach))
    {
    }

    const Box& box() const { return m_box; }

    double shade(const Vec3& place, const Vec3& normal) const
    {
        if (normal.dot(m_surface.pose.position - place) <= -m_radius)
            return 1;
        const Vec3 local = m_surface.pose.toLocal(place);
        if (boxSurface(m_surface.shape.size, local).distance >= m_reach)
            return 1;
        const SurfacePoint nearest = surfaceOf(m_surface.shape, local);
        if (nearest.distance >= m_reach)
            return 1;
        const double gap = std::max(0.0, nearest.distance);
        const double radius = std::sqrt(silhouetteArea(m_surface.shape, nearest.normal) / std::numbers::pi);
        const double cosine = -normal.dot(m_surface.pose.rotation * nearest.normal);
        const double share = gap / m_reach;
        const double fade = (1 - share * share) * (1 - share * share);
        return 1 - contactDarkest * formFactor(1 + gap / radius, cosine) * fade;
    }

private:
    RigidSurface m_surface;
    double m_reach;  ///< farther away it changes nothing [m]
    double m_radius; ///< of a ball around it [m]
    Box m_box;       ///< that its reach lies in
};

} // namespace

std::vector<float> contactShades(std::span<const float> points, std::span<const float> normals,
                                 std::span<const ToolState> tools)
{
    const std::vector<Occluder> occluders(tools.begin(), tools.end());
    if (occluders.empty())
        return {};
    return vertexShades(points, normals, [&](const Vec3& place, const Vec3& normal) {
        double shade = 1;
        for (const Occluder& tool : occluders)
            if (tool.box().contains(place))
                shade *= tool.shade(place, normal);
        return shade;
    });
}

} // namespace knead
