#pragma once

#include "core/geometry/vec3.h"

#include <optional>

namespace knead {

/// A straight line of sight.
struct Ray {
    Vec3 origin = Vec3::Zero();     ///< [m]
    Vec3 direction = Vec3::UnitX(); ///< unit

    /// Where it meets the plane through a place; where it goes along the plane: that place.
    Vec3 onPlane(const Vec3& place, const Vec3& normal) const
    {
        const double slope = direction.dot(normal);
        return slope == 0 ? place : Vec3(origin + ((place - origin).dot(normal) / slope) * direction);
    }
};

/// A place in a window of pixels, y downwards.
struct Pixel {
    double x = 0;
    double y = 0;
};

struct WindowSize {
    double width = 1;
    double height = 1;
    double aspect() const { return width / height; }
};

/// Of a window, from its sides [pixels].
struct Insets {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

/// Where the person looks from: a turntable about the world's z axis. A value; knows no graphics library.
struct Camera {
    Vec3 target = Vec3::Zero(); ///< point of rotation, in the middle of the view [m]
    double distance = 1;        ///< of the eye from the target [m]
    double yaw = -0.785398;     ///< of the eye about z, seen from the target; 0 looks from +x [rad]
    double pitch = 0.615480;    ///< of the eye above the horizon, -pi/2 .. pi/2 [rad]
    bool perspective = true;

    static constexpr double viewAngle = 30; ///< full height of the view in perspective [degrees]

    Vec3 towardsEye() const; ///< unit
    Vec3 right() const;      ///< unit, to the right of the window
    Vec3 up() const;         ///< unit, to the top of the window
    Vec3 eye() const { return target + distance * towardsEye(); }

    /// Height of what is seen at the target [m]; equal in both projections, so that switching does not jump.
    double viewHeight() const;

    /// What lies under a pixel.
    Ray ray(const Pixel& pixel, const WindowSize& window) const;
    /// Where a place is seen; empty behind the eye.
    std::optional<Pixel> project(const Vec3& place, const WindowSize& window) const;

    void orbit(double dx, double dy); ///< by a mouse motion [pixels]
    void pan(double dx, double dy, const WindowSize& window);
    /// Scales the view by `factor` (< 1 comes nearer) and keeps what is under the pixel there.
    void zoom(double factor, const Pixel& pixel, const WindowSize& window);
    /// The same by a mouse wheel. @param turned in eighths of a degree, > 0 comes nearer
    void zoomByWheel(double turned, const Pixel& pixel, const WindowSize& window);
    /// Shows the whole box from the present direction.
    void fit(const Box& box, double aspect);
    /// The same in what is left of a window between things that lie on it: the box takes nine tenths of that, on the side that is
    /// short of room.
    /// @param taken from its sides [pixels]; more than half of it is not given up
    void fit(const Box& box, const WindowSize& window, const Insets& taken);
    /// Looks from a direction, for example (0, -1, 0) for the front; straight from above the front stays below.
    void lookFrom(const Vec3& direction);

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Between two cameras, 0 <= s <= 1, turning the short way round.
Camera blend(const Camera& from, const Camera& to, double s);

/// The world axis (positive or negative) closest to a direction, x before y before z when they tie; `horizontal`
/// leaves out z.
Vec3 nearestAxis(const Vec3& direction, bool horizontal);

} // namespace knead
