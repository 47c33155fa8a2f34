#include "ui/viewport/picker.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace knead {

namespace {

constexpr std::uint32_t leafSize = 8;

Eigen::Vector3f pointAt(std::span<const float> points, std::uint32_t vertex)
{
    return Eigen::Map<const Eigen::Vector3f>(points.data() + std::size_t{3} * vertex);
}

/// Where the ray enters the box, clipped to [0, limit]; empty when it misses.
std::optional<double> enter(const Ray& ray, const Vec3& lower, const Vec3& upper, double limit)
{
    double begin = 0;
    double end = limit;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        if (ray.direction[axis] == 0) {
            if (ray.origin[axis] < lower[axis] || ray.origin[axis] > upper[axis])
                return std::nullopt;
            continue;
        }
        double near = (lower[axis] - ray.origin[axis]) / ray.direction[axis];
        double far = (upper[axis] - ray.origin[axis]) / ray.direction[axis];
        if (near > far)
            std::swap(near, far);
        begin = std::max(begin, near);
        end = std::min(end, far);
    }
    return begin <= end ? std::optional(begin) : std::nullopt;
}

/// Moeller and Trumbore's test, both sides.
std::optional<double> meet(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const Vec3 p = ray.direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0)
        return std::nullopt;
    const Vec3 offset = ray.origin - a;
    const double u = offset.dot(p) / determinant;
    const Vec3 q = offset.cross(ab);
    const double v = ray.direction.dot(q) / determinant;
    const double distance = ac.dot(q) / determinant;
    if (u < 0 || v < 0 || u + v > 1 || distance < 0)
        return std::nullopt;
    return distance;
}

} // namespace

SurfacePicker::SurfacePicker(const RenderMesh& mesh, std::span<const float> points)
    : m_mesh(mesh)
    , m_order(mesh.triangles.size())
{
    std::vector<Eigen::Vector3f> centers;
    centers.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles)
        centers.push_back((pointAt(points, t[0]) + pointAt(points, t[1]) + pointAt(points, t[2])) / 3);
    std::iota(m_order.begin(), m_order.end(), 0U);
    build(0, static_cast<std::uint32_t>(m_order.size()), centers);
    refit(points);
}

void SurfacePicker::build(std::uint32_t begin, std::uint32_t end, const std::vector<Eigen::Vector3f>& centers)
{
    const std::size_t self = m_nodes.size();
    m_nodes.emplace_back();
    if (end - begin <= leafSize) {
        m_nodes[self].begin = begin;
        m_nodes[self].end = end;
        return;
    }
    Eigen::AlignedBox3f box;
    for (std::uint32_t i = begin; i < end; ++i)
        box.extend(centers[m_order[i]]);
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(m_order.begin() + begin, m_order.begin() + middle, m_order.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return centers[a][axis] < centers[b][axis]; });
    build(begin, middle, centers);
    m_nodes[self].right = static_cast<std::uint32_t>(m_nodes.size());
    build(middle, end, centers);
}

void SurfacePicker::refit(std::span<const float> points)
{
    m_points = points;
    for (std::size_t n = m_nodes.size(); n-- > 0;) { // children first
        Node& node = m_nodes[n];
        node.box.setEmpty();
        if (node.right != 0) {
            node.box.extend(m_nodes[n + 1].box);
            node.box.extend(m_nodes[node.right].box);
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i)
            for (const std::uint32_t v : m_mesh.triangles[m_order[i]])
                node.box.extend(pointAt(points, v));
    }
}

RayReach reachOf(const Ray& ray, const std::optional<CutPlane>& cut)
{
    if (!cut)
        return {};
    const double height = cut->distance(ray.origin);
    const double slope = cut->normal.dot(ray.direction);
    if (slope == 0)
        return height > 0 ? RayReach{1, 0} : RayReach{};
    RayReach reach;
    (slope > 0 ? reach.to : reach.from) = std::max(-height / slope, slope > 0 ? -1.0 : 0.0);
    return reach;
}

std::optional<SurfaceHit> SurfacePicker::pick(const Ray& ray, const RayReach& reach) const
{
    std::optional<SurfaceHit> best;
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
        const std::uint32_t n = open.back();
        open.pop_back();
        const Node& node = m_nodes[n];
        const double limit = best ? best->distance : reach.to;
        if (node.box.isEmpty() || !enter(ray, node.box.min().cast<double>(), node.box.max().cast<double>(), limit))
            continue;
        if (node.right != 0) {
            open.push_back(node.right);
            open.push_back(n + 1);
        } else {
            intersectLeaf(node, ray, reach, best);
        }
    }
    return best;
}

void SurfacePicker::intersectLeaf(const Node& node, const Ray& ray, const RayReach& reach,
                                  std::optional<SurfaceHit>& best) const
{
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
        const std::uint32_t triangle = m_order[i];
        const auto& t = m_mesh.triangles[triangle];
        const auto distance = meet(ray, pointAt(m_points, t[0]).cast<double>(), pointAt(m_points, t[1]).cast<double>(),
                                   pointAt(m_points, t[2]).cast<double>());
        if (distance && *distance >= reach.from && *distance <= (best ? best->distance : reach.to))
            best = SurfaceHit{*distance, triangle, m_mesh.faceOfTriangle[triangle]};
    }
}

std::optional<double> pickBox(const Ray& ray, const Vec3& size, const Pose& pose)
{
    const Ray local{pose.toLocal(ray.origin), pose.rotation.conjugate() * ray.direction};
    return enter(local, -size / 2, size / 2, std::numeric_limits<double>::max());
}

/// Goes on by the distance to the surface, which no step can pass, until it is there.
std::optional<double> pickTool(const Ray& ray, const ToolShape& shape, const Pose& pose)
{
    constexpr int mostSteps = 500;
    constexpr double closeness = 1e-4; // in sizes of the tool
    const double size = shape.size.norm();
    const std::optional<double> box = pickBox(ray, shape.size, pose);
    if (!box || shape.kind == ToolKind::box || shape.kind == ToolKind::plate)
        return box;
    double distance = *box;
    for (int step = 0; step < mostSteps && distance < *box + size; ++step) {
        const double gap = surfaceOf(shape, pose.toLocal(ray.origin + distance * ray.direction)).distance;
        if (gap < closeness * size)
            return distance;
        distance += gap;
    }
    return std::nullopt;
}

} // namespace knead
