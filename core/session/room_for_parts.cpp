#include "core/session/room_for_parts.h"

#include "core/geometry/surface_distance.h"
#include "core/mechanics/rigid_surface.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace knead {

namespace {

constexpr double besideShare = 0.1; // of the size of what is put beside others: from these
constexpr double mostSamples = 25;  // along an axis

Box movedBy(const Box& box, const Vec3& by)
{
    return box.translated(by);
}

/// Whether a place of a box is meant, of those about a distance apart, its middle among them.
template <typename Meant>
bool anyIn(const Box& box, double apart, Meant meant)
{
    const Eigen::Array3d sizes = box.sizes().array();
    const Eigen::Array3d counts = (2 * (sizes / (2 * apart)).floor() + 1).min(mostSamples);
    const Eigen::Array3d step = sizes / counts;
    for (double u = 0.5; u < counts.x(); ++u)
        for (double v = 0.5; v < counts.y(); ++v)
            for (double w = 0.5; w < counts.z(); ++w)
                if (meant(Vec3(box.min() + (Eigen::Array3d(u, v, w) * step).matrix())))
                    return true;
    return false;
}

} // namespace

RoomForParts::RoomForParts(const Snapshot& now, double depth)
    : m_depth(depth)
    , m_floor(now.floorHeight)
    , m_falls(now.gravity.z() < 0)
{
    for (const ToolState& tool : now.tools) {
        const RigidSurface surface{.shape = {tool.kind, tool.size, tool.part}, .pose = tool.pose};
        m_tools.push_back(
            {surface.reach(0), [surface](const Vec3& place) { return -surface.nearest(place).distance; }});
    }
}

std::vector<RoomForParts::Solid> RoomForParts::solidsOf(const Model& model)
{
    std::vector<Solid> solids;
    for (const Part& part : model.parts) {
        if (!part.canBeFilled())
            continue;
        const auto mesh = std::make_shared<const TriangleMesh>(part.mesh);
        const auto distance = std::make_shared<const SurfaceDistance>(*mesh);
        solids.push_back({boxOfPlaces(mesh->vertices),
                          [mesh, distance](const Vec3& place) { return -distance->nearest(place).signedDistance; }});
    }
    return solids;
}

void RoomForParts::add(const Model& model)
{
    for (const Part& part : model.parts)
        m_parts.extend(boxOfPlaces(part.mesh.vertices));
    for (Solid& solid : solidsOf(model))
        m_solids.push_back(std::move(solid));
}

bool RoomForParts::isInside(const std::vector<Solid>& solids, const Vec3& by) const
{
    const auto reachesInto = [&](const Solid& solid, const Solid& other) {
        const Box common = movedBy(solid.box, by).intersection(other.box);
        return !common.isEmpty() && anyIn(common, 2 * m_depth, [&](const Vec3& place) {
            return other.depthAt(place) > m_depth && solid.depthAt(place - by) > m_depth;
        });
    };
    return std::ranges::any_of(solids, [&](const Solid& solid) {
        for (const std::vector<Solid>* all : {&m_solids, &m_tools})
            for (const Solid& other : *all)
                if (reachesInto(solid, other))
                    return true;
        return false;
    });
}

/// Behind all parts, and behind tools that are in the way there.
Vec3 RoomForParts::beside(const Box& box) const
{
    const double gap = besideShare * std::max(box.diagonal().norm(), m_parts.diagonal().norm());
    Vec3 by(0, 0, m_floor.value_or(m_parts.min().z()) - box.min().z());
    const auto goBehind = [&](const Box& other) { by.x() = other.max().x() + gap - box.min().x(); };
    goBehind(m_parts);
    const auto isInTheWay = [&](const Solid& tool) { return !movedBy(box, by).intersection(tool.box).isEmpty(); };
    for (auto tool = std::ranges::find_if(m_tools, isInTheWay); tool != m_tools.end();
         tool = std::ranges::find_if(m_tools, isInTheWay))
        goBehind(tool->box);
    return by;
}

Vec3 RoomForParts::wayFor(const Model& model) const
{
    Box box;
    for (const Part& part : model.parts)
        box.extend(boxOfPlaces(part.mesh.vertices));
    Vec3 by = Vec3::Zero();
    if (box.isEmpty() || m_parts.isEmpty())
        return by;
    if (m_floor && m_falls && box.min().z() < *m_floor - m_depth)
        by.z() = *m_floor - box.min().z();
    return isInside(solidsOf(model), by) ? beside(box) : by;
}

} // namespace knead
