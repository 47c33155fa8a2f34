#include "ui/viewport/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace knead {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double radiansPerPixel = 0.0075;
constexpr double fittedShare = 0.9;       // of the free area, on the side that is short of room
constexpr double smallestDistance = 1e-6; // [m]
constexpr double largestDistance = 1e6;   // [m]

double tangent()
{
    return std::tan(Camera::viewAngle * pi / 360);
}

/// The pixel in units of half the window's height, y upwards.
Eigen::Vector2d centered(const Pixel& pixel, const WindowSize& window)
{
    return {(2 * pixel.x - window.width) / window.height, 1 - 2 * pixel.y / window.height};
}

/// Places that are to be seen between two lines of the window, see Camera::fit().
class FittedSide {
public:
    /// @param middle of the lines, from that of the window, and @param half the way between them, in halves of its height
    FittedSide(double middle, double half)
        : m_low((middle - half) * tangent())
        , m_high((middle + half) * tangent())
    {
    }

    void extend(double place, double before)
    {
        m_most = std::max(m_most, place + m_high * before);
        m_least = std::min(m_least, place + m_low * before);
    }

    double distance() const { return (m_most - m_least) / (m_high - m_low); } ///< of the eye, at least [m]
    /// Of the target, with as much room on either side. @param eye how far it is away [m]
    double aside(double eye) const { return (m_most - m_high * eye + m_least - m_low * eye) / 2; }

private:
    double m_low;
    double m_high;
    double m_most = -std::numeric_limits<double>::infinity();
    double m_least = std::numeric_limits<double>::infinity();
};

} // namespace

Vec3 Camera::towardsEye() const
{
    return {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
}

Vec3 Camera::right() const
{
    return {-std::sin(yaw), std::cos(yaw), 0};
}

Vec3 Camera::up() const
{
    return {-std::sin(pitch) * std::cos(yaw), -std::sin(pitch) * std::sin(yaw), std::cos(pitch)};
}

double Camera::viewHeight() const
{
    return 2 * distance * tangent();
}

Ray Camera::ray(const Pixel& pixel, const WindowSize& window) const
{
    const Eigen::Vector2d p = centered(pixel, window) * viewHeight() / 2;
    const Vec3 seen = target + p.x() * right() + p.y() * up();
    if (perspective)
        return {eye(), (seen - eye()).normalized()};
    // Far behind the eye, so that nothing in front of it is missed when zoomed in.
    return {seen + 1e3 * distance * towardsEye(), -towardsEye()};
}

std::optional<Pixel> Camera::project(const Vec3& place, const WindowSize& window) const
{
    const Vec3 offset = place - target;
    const double depth = perspective ? (distance - offset.dot(towardsEye())) / distance : 1;
    if (depth <= 1e-6)
        return std::nullopt;
    const double scale = window.height / (viewHeight() * depth);
    return Pixel{window.width / 2 + scale * offset.dot(right()), window.height / 2 - scale * offset.dot(up())};
}

void Camera::orbit(double dx, double dy)
{
    yaw = std::remainder(yaw - dx * radiansPerPixel, 2 * pi);
    pitch = std::clamp(pitch + dy * radiansPerPixel, -pi / 2, pi / 2);
}

void Camera::pan(double dx, double dy, const WindowSize& window)
{
    const double scale = viewHeight() / window.height;
    target += scale * (dy * up() - dx * right());
}

void Camera::zoom(double factor, const Pixel& pixel, const WindowSize& window)
{
    const double wanted = std::clamp(distance * factor, smallestDistance, largestDistance);
    const Eigen::Vector2d p = centered(pixel, window) * viewHeight() / 2;
    target += (1 - wanted / distance) * (p.x() * right() + p.y() * up());
    distance = wanted;
}

void Camera::zoomByWheel(double turned, const Pixel& pixel, const WindowSize& window)
{
    constexpr double zoomPerNotch = 0.86;
    constexpr double anglePerNotch = 120; // of a mouse wheel, in eighths of a degree
    zoom(std::pow(zoomPerNotch, turned / anglePerNotch), pixel, window);
}

void Camera::fit(const Box& box, double aspect)
{
    fit(box, {aspect, 1}, {});
}

/// A corner at x to the right of the middle of the box and z before it is seen at (x - c) / ((d - z) tan), in halves of the
/// window's height, where the target lies c aside and the eye d away. That all corners are seen between l and r asks for
///   c >= max(x + r z tan) - r d tan   and   c <= min(x + l z tan) - l d tan,
/// which can be met from d = (max(x + r z tan) - min(x + l z tan)) / ((r - l) tan) on. In parallel projection z counts as 0.
void Camera::fit(const Box& box, const WindowSize& window, const Insets& taken)
{
    if (box.isEmpty())
        return;
    const double width = std::max(window.width - taken.left - taken.right, window.width / 2);
    const double height = std::max(window.height - taken.top - taken.bottom, window.height / 2);
    FittedSide across((taken.left - taken.right) / window.height, fittedShare * width / window.height);
    FittedSide upwards((taken.bottom - taken.top) / window.height, fittedShare * height / window.height);
    double nearest = 0; // before the middle of the box
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 offset = box.corner(static_cast<Box::CornerType>(corner)) - box.center();
        const double before = perspective ? offset.dot(towardsEye()) : 0;
        nearest = std::max(nearest, before);
        across.extend(offset.dot(right()), before);
        upwards.extend(offset.dot(up()), before);
    }
    const double wanted = std::max({across.distance(), upwards.distance(), nearest + smallestDistance});
    distance = std::min(wanted, largestDistance);
    target = box.center() + across.aside(distance) * right() + upwards.aside(distance) * up();
}

void Camera::lookFrom(const Vec3& direction)
{
    const double horizontal = std::hypot(direction.x(), direction.y());
    pitch = std::atan2(direction.z(), horizontal);
    yaw = horizontal > 1e-9 ? std::atan2(direction.y(), direction.x()) : -pi / 2;
}

Camera blend(const Camera& from, const Camera& to, double s)
{
    Camera camera = to;
    camera.target = from.target + s * (to.target - from.target);
    camera.distance = from.distance * std::pow(to.distance / from.distance, s);
    camera.yaw = from.yaw + s * std::remainder(to.yaw - from.yaw, 2 * pi);
    camera.pitch = from.pitch + s * (to.pitch - from.pitch);
    return camera;
}

Vec3 nearestAxis(const Vec3& direction, bool horizontal)
{
    constexpr double tie = 1e-6; // the isometric view lies halfway; rounding must not decide there
    Eigen::Index axis = 0;
    for (Eigen::Index other = 1; other < (horizontal ? 2 : 3); ++other)
        if (std::abs(direction[other]) > std::abs(direction[axis]) + tie)
            axis = other;
    return direction[axis] < 0 ? Vec3(-Vec3::Unit(axis)) : Vec3(Vec3::Unit(axis));
}

} // namespace knead
