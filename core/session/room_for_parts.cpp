#include "core/session/room_for_parts.h"

#include "core/geometry/refine.h"
#include "core/geometry/surface_distance.h"
#include "core/geometry/surface_ray.h"
#include "core/mechanics/tool_shape.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double besideShare = 0.1;         // of the size of what is put beside others: from these
constexpr double mostAlong = 25;            // places of a box, along an axis
constexpr std::size_t mostTriangles = 4000; // of a surface below which places are tried

/// Whether a place of a box is meant, of those about a distance apart, its middle among them.
template <typename Meant>
bool anyIn(const Box& box, double apart, Meant meant)
{
    const Eigen::Array3d sizes = box.sizes().array();
    const Eigen::Array3d counts = (2 * (sizes / (2 * apart)).floor() + 1).min(mostAlong);
    const Eigen::Array3d step = sizes / counts;
    for (double u = 0.5; u < counts.x(); ++u)
        for (double v = 0.5; v < counts.y(); ++v)
            for (double w = 0.5; w < counts.z(); ++w)
                if (meant(Vec3(box.min() + (Eigen::Array3d(u, v, w) * step).matrix())))
                    return true;
    return false;
}

/// Places so deep below the triangles of a closed surface, or in the middle where it is thinner.
std::vector<Vec3> placesBelow(const TriangleMesh& surface, double depth)
{
    const double size = boxOfPlaces(surface.vertices).diagonal().norm();
    const TriangleMesh mesh = refine(surface, std::max(4 * depth, size / 40), mostTriangles);
    const SurfaceRay ray(mesh, 1);
    std::vector<Vec3> places;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto corners = cornersOf(mesh.vertices, mesh.triangles[t]);
        const Vec3 inward = -crossOf(corners).normalized();
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
        if (const auto exit = ray.firstExit(middle, inward, t))
            places.push_back(middle + std::min(depth, exit->distance / 2) * inward);
    }
    return places;
}

} // namespace

/// A part or a tool. What takes long to find is found when it is asked for.
class RoomForParts::Solid {
public:
    explicit Solid(TriangleMesh surface)
        : m_surface(std::move(surface))
        , m_box(boxOfPlaces(m_surface.vertices))
    {
    }

    const Box& box() const { return m_box; }

    /// Below the surface [m]; negative: outside.
    double depthAt(const Vec3& place)
    {
        if (!m_distance)
            m_distance.emplace(m_surface);
        return -m_distance->nearest(place).signedDistance;
    }

    const std::vector<Vec3>& places(double depth)
    {
        if (!m_places)
            m_places = placesBelow(m_surface, depth);
        return *m_places;
    }

private:
    TriangleMesh m_surface;
    Box m_box;
    std::optional<SurfaceDistance> m_distance;
    std::optional<std::vector<Vec3>> m_places;
};

RoomForParts::RoomForParts(const Snapshot& now, double depth)
    : m_depth(depth)
    , m_floor(now.floorHeight)
    , m_falls(now.gravity.z() < 0)
{
    for (const ToolState& tool : now.tools) {
        TriangleMesh surface = meshOf({tool.kind, tool.size, tool.part});
        for (Vec3& vertex : surface.vertices)
            vertex = tool.pose.toWorld(vertex);
        m_solids.push_back(std::make_unique<Solid>(std::move(surface)));
        m_tools.push_back(m_solids.back()->box());
    }
}

RoomForParts::~RoomForParts() = default;

RoomForParts::Solids RoomForParts::solidsOf(const Model& model)
{
    Solids solids;
    for (const Part& part : model.parts)
        if (part.canBeFilled())
            solids.push_back(std::make_unique<Solid>(part.mesh));
    return solids;
}

void RoomForParts::add(const Model& model)
{
    for (const Part& part : model.parts)
        m_parts.extend(boxOfPlaces(part.mesh.vertices));
    for (auto& solid : solidsOf(model))
        m_solids.push_back(std::move(solid));
}

/// Thick things have a place deep in both; of thin ones the inside of one reaches into the other.
bool RoomForParts::isInside(const Solids& solids, const Vec3& by, TaskControl& control) const
{
    const auto reachInto = [&](Solid& solid, Solid& other) {
        const Box common = solid.box().translated(by).intersection(other.box());
        if (common.isEmpty())
            return false;
        control.throwIfCancelled();
        const auto isBelow = [&](Solid& deep, const Vec3& place) { return deep.depthAt(place) > 1e-3 * m_depth; };
        for (const Vec3& place : solid.places(m_depth))
            if (common.contains(place + by) && isBelow(other, place + by))
                return true;
        for (const Vec3& place : other.places(m_depth))
            if (common.contains(place) && isBelow(solid, place - by))
                return true;
        return anyIn(common, 2 * m_depth, [&](const Vec3& place) {
            return other.depthAt(place) > m_depth && solid.depthAt(place - by) > m_depth;
        });
    };
    return std::ranges::any_of(solids, [&](const auto& solid) {
        return std::ranges::any_of(m_solids, [&](const auto& other) { return reachInto(*solid, *other); });
    });
}

/// Behind all parts, and behind tools that are in the way there.
Vec3 RoomForParts::beside(const Box& box) const
{
    const double gap = besideShare * std::max(box.diagonal().norm(), m_parts.diagonal().norm());
    Vec3 by(0, 0, m_floor.value_or(m_parts.min().z()) - box.min().z());
    const auto goBehind = [&](const Box& other) { by.x() = other.max().x() + gap - box.min().x(); };
    goBehind(m_parts);
    const auto isInTheWay = [&](const Box& tool) { return !box.translated(by).intersection(tool).isEmpty(); };
    for (auto tool = std::ranges::find_if(m_tools, isInTheWay); tool != m_tools.end();
         tool = std::ranges::find_if(m_tools, isInTheWay))
        goBehind(*tool);
    return by;
}

Vec3 RoomForParts::wayFor(const Model& model, TaskControl& control) const
{
    Box box;
    for (const Part& part : model.parts)
        box.extend(boxOfPlaces(part.mesh.vertices));
    Vec3 by = Vec3::Zero();
    if (box.isEmpty() || m_parts.isEmpty())
        return by;
    if (m_floor && m_falls && box.min().z() < *m_floor - m_depth)
        by.z() = *m_floor - box.min().z();
    return isInside(solidsOf(model), by, control) ? beside(box) : by;
}

} // namespace knead
