#include "ui/interaction/gizmo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace knead {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int ringPoints = 64;
constexpr double reach = 7;          // of a line, to both sides [pixels]
constexpr double shortestArrow = 18; // arrows that look shorter point at the eye [pixels]
constexpr double flattest = 0.2;     // sine of the angle at which a plane or ring can still be pointed at
constexpr double never = std::numeric_limits<double>::infinity();

Eigen::Vector2d vector(const Pixel& pixel)
{
    return {pixel.x, pixel.y};
}

double distanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    const Eigen::Vector2d way = b - a;
    const double length = way.squaredNorm();
    const double share = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0;
    return (p - a - share * way).norm();
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

bool isInside(const Eigen::Vector2d& p, const std::array<Pixel, 4>& corners)
{
    int left = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Eigen::Vector2d a = vector(corners[i]);
        left += cross(vector(corners[(i + 1) % 4]) - a, p - a) > 0 ? 1 : 0;
    }
    return left == 0 || left == 4;
}

} // namespace

GizmoMotion motionOf(GizmoPart part)
{
    if (part == GizmoPart::none || part == GizmoPart::free)
        return part == GizmoPart::none ? GizmoMotion::none : GizmoMotion::free;
    if (part <= GizmoPart::moveZ)
        return GizmoMotion::move;
    return part <= GizmoPart::planeZ ? GizmoMotion::plane : GizmoMotion::turn;
}

int axisOf(GizmoPart part)
{
    return part <= GizmoPart::free ? 0 : (static_cast<int>(part) - static_cast<int>(GizmoPart::moveX)) % 3;
}

Gizmo::Gizmo(const Pose& frame, const Camera& camera, const WindowSize& window)
    : m_frame(frame)
    , m_camera(camera)
    , m_window(window)
    , m_middle(camera.project(frame.position, window))
{
    const double depth = (camera.target - frame.position).dot(camera.towardsEye()) + camera.distance;
    m_scale = camera.viewHeight() * (camera.perspective ? depth / camera.distance : 1) / window.height;
}

Pixel Gizmo::pixelOf(const Vec3& pixels) const
{
    const Vec3 place = m_frame.position + m_scale * (m_frame.rotation * pixels);
    return m_camera.project(place, m_window).value_or(*m_middle);
}

Vec3 Gizmo::towardsEye() const
{
    return m_camera.perspective ? Vec3((m_camera.eye() - m_frame.position).normalized()) : m_camera.towardsEye();
}

std::vector<Pixel> Gizmo::ringLine(int index) const
{
    const Vec3 normal = axis(index);
    const Vec3 eye = towardsEye();
    // From one end of the front half to the other; of a ring seen from above all of it is front.
    const Vec3 side = normal.cross(eye);
    const bool isFull = side.norm() < flattest;
    const Vec3 begin = isFull ? axis((index + 1) % 3) : side.normalized();
    const Vec3 ahead = begin.cross(normal) * (begin.cross(normal).dot(eye) < 0 ? -1 : 1);
    std::vector<Pixel> line;
    for (int i = 0; i <= ringPoints; ++i) {
        const double angle = (isFull ? 2 * pi : pi) * i / ringPoints;
        const Vec3 place = std::cos(angle) * begin + std::sin(angle) * ahead;
        line.push_back(pixelOf(ring * (m_frame.rotation.conjugate() * place)));
    }
    return line;
}

std::array<Pixel, 4> Gizmo::planeCorners(int index) const
{
    const Vec3 u = Vec3::Unit((index + 1) % 3);
    const Vec3 v = Vec3::Unit((index + 2) % 3);
    return {pixelOf(planeBegin * u + planeBegin * v), pixelOf(planeEnd * u + planeBegin * v),
            pixelOf(planeEnd * u + planeEnd * v), pixelOf(planeBegin * u + planeEnd * v)};
}

bool Gizmo::isUsable(GizmoPart part) const
{
    if (!isVisible() || part == GizmoPart::none)
        return false;
    const Vec3 along = axis(axisOf(part));
    switch (motionOf(part)) {
    case GizmoMotion::move:
        return (vector(pixelOf(shaftEnd * Vec3::Unit(axisOf(part)))) - vector(*m_middle)).norm() > shortestArrow;
    case GizmoMotion::plane:
        return std::abs(along.dot(towardsEye())) > flattest;
    default:
        return true;
    }
}

/// [pixels]; infinite for what cannot be used, or is out of reach.
double Gizmo::distanceTo(GizmoPart part, const Pixel& pixel) const
{
    const Eigen::Vector2d p = vector(pixel);
    const int index = axisOf(part);
    double distance = never;
    switch (motionOf(part)) {
    case GizmoMotion::none:
        break;
    case GizmoMotion::free:
        return (p - vector(*m_middle)).norm() <= middle ? 0 : never;
    case GizmoMotion::plane:
        return isInside(p, planeCorners(index)) ? 0 : never;
    case GizmoMotion::move:
        distance = distanceToSegment(p, vector(pixelOf(shaftBegin * Vec3::Unit(index))),
                                     vector(pixelOf(shaftEnd * Vec3::Unit(index))));
        break;
    case GizmoMotion::turn:
        const std::vector<Pixel> line = ringLine(index);
        for (std::size_t i = 1; i < line.size(); ++i)
            distance = std::min(distance, distanceToSegment(p, vector(line[i - 1]), vector(line[i])));
        break;
    }
    return distance <= reach ? distance : never;
}

GizmoPart Gizmo::partAt(const Pixel& pixel) const
{
    GizmoPart nearest = GizmoPart::none;
    double least = never;
    for (const GizmoPart part : allGizmoParts) {
        if (!isUsable(part))
            continue;
        if (const double distance = distanceTo(part, pixel); distance < least) {
            least = distance;
            nearest = part;
        }
    }
    return nearest;
}

std::optional<Vec3> Gizmo::onPlane(const Pixel& pixel, const Vec3& normal) const
{
    const Ray ray = m_camera.ray(pixel, m_window);
    const double slope = ray.direction.dot(normal);
    if (std::abs(slope) < 1e-6)
        return {};
    const double way = (m_frame.position - ray.origin).dot(normal) / slope;
    return Vec3(ray.origin + way * ray.direction - m_frame.position);
}

/// Where the axis comes nearest to what lies under a pixel, from the middle [m].
double Gizmo::alongAxis(const Pixel& pixel, const Vec3& direction) const
{
    const Ray ray = m_camera.ray(pixel, m_window);
    const double slant = direction.dot(ray.direction);
    const Vec3 offset = ray.origin - m_frame.position;
    const double bottom = std::max(1 - slant * slant, 1e-6);
    return (offset.dot(direction) - slant * offset.dot(ray.direction)) / bottom;
}

/// Between two places of the mouse about an axis, -pi .. pi [rad]. A ring that is seen from its side turns by the way along it.
double Gizmo::angle(int index, const Pixel& from, const Pixel& to) const
{
    const Vec3 normal = axis(index);
    const Vec3 eye = towardsEye();
    if (std::abs(normal.dot(eye)) > flattest) {
        const std::optional<Vec3> a = onPlane(from, normal);
        const std::optional<Vec3> b = onPlane(to, normal);
        if (a && b)
            return std::atan2(a->cross(*b).dot(normal), a->dot(*b));
    }
    const Vec3 tangent = normal.cross(eye).normalized(); // of the point that is nearest to the eye
    const Eigen::Vector2d seen = vector(pixelOf(ring * (m_frame.rotation.conjugate() * tangent))) - vector(*m_middle);
    return (vector(to) - vector(from)).dot(seen.normalized()) / ring;
}

std::array<Vec3, 2> Gizmo::directions(GizmoPart part) const
{
    const int index = axisOf(part);
    switch (motionOf(part)) {
    case GizmoMotion::free:
        return {m_camera.right(), m_camera.up()};
    case GizmoMotion::plane:
        return {axis((index + 1) % 3), axis((index + 2) % 3)};
    default:
        return {axis(index), Vec3::Zero()};
    }
}

GizmoAmount Gizmo::amount(GizmoPart part, const Pixel& from, const Pixel& to, const GizmoAmount& before) const
{
    const std::array<Vec3, 2> way = directions(part);
    switch (motionOf(part)) {
    case GizmoMotion::move:
        return {{alongAxis(to, way[0]) - alongAxis(from, way[0]), 0}, 1};
    case GizmoMotion::turn: {
        const double now = angle(axisOf(part), from, to);
        return {{before.values[0] + std::remainder(now - before.values[0], 2 * pi), 0}, 1};
    }
    case GizmoMotion::free:
    case GizmoMotion::plane: {
        const Vec3 normal = motionOf(part) == GizmoMotion::free ? m_camera.towardsEye() : axis(axisOf(part));
        const std::optional<Vec3> a = onPlane(from, normal);
        const std::optional<Vec3> b = onPlane(to, normal);
        if (!a || !b)
            return {before.values, 2};
        return {{(*b - *a).dot(way[0]), (*b - *a).dot(way[1])}, 2};
    }
    case GizmoMotion::none:
        break;
    }
    return {};
}

Pose Gizmo::moved(const Pose& start, GizmoPart part, const GizmoAmount& amount) const
{
    Pose pose = start;
    const std::array<Vec3, 2> way = directions(part);
    if (motionOf(part) == GizmoMotion::turn)
        pose.rotation = (Quaternion(Eigen::AngleAxisd(amount.values[0], way[0])) * start.rotation).normalized();
    else
        pose.position += amount.values[0] * way[0] + amount.values[1] * way[1];
    return pose;
}

GizmoAmount snapped(const GizmoAmount& amount, double step)
{
    GizmoAmount whole = amount;
    for (double& value : whole.values)
        value = step * std::round(value / step);
    return whole;
}

} // namespace knead
