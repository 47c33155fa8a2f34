#pragma once

#include "ui/viewport/camera.h"

#include <array>
#include <cstdint>
#include <vector>

namespace knead {

/// Handles of a gizmo. In groups of three: along, across and about x, y, z.
enum class GizmoPart : std::uint8_t {
    none,
    free, ///< in the plane of the view
    moveX,
    moveY,
    moveZ,
    planeX, ///< across x: in the plane of y and z
    planeY,
    planeZ,
    turnX,
    turnY,
    turnZ,
};
inline constexpr std::array allGizmoParts = {GizmoPart::free,   GizmoPart::moveX,  GizmoPart::moveY,  GizmoPart::moveZ,
                                             GizmoPart::planeX, GizmoPart::planeY, GizmoPart::planeZ, GizmoPart::turnX,
                                             GizmoPart::turnY,  GizmoPart::turnZ};

enum class GizmoMotion : std::uint8_t { none, free, move, plane, turn };
GizmoMotion motionOf(GizmoPart part);
int axisOf(GizmoPart part); ///< 0, 1, 2: x, y, z; 0 for those without

/// How far a handle was moved: along its one or two directions [m], or about its axis [rad].
struct GizmoAmount {
    std::array<double, 2> values{};
    int count = 1; ///< of values that count
    friend bool operator==(const GizmoAmount&, const GizmoAmount&) = default;
};

/// Handles that move and turn a thing, as large on the screen wherever it is. Geometry only: a value that knows no window.
class Gizmo {
public:
    /// @param frame where the handles stand and along which axes they lie
    Gizmo(const Pose& frame, const Camera& camera, const WindowSize& window);

    /// The same handles at another place, seen otherwise.
    Gizmo seenFrom(const Vec3& position, const Camera& camera, const WindowSize& window) const
    {
        return {{position, m_frame.rotation}, camera, window};
    }

    static constexpr double ring = 92;       ///< radius of the rings [pixels]
    static constexpr double shaftBegin = 20; ///< of an arrow, from the middle [pixels]
    static constexpr double shaftEnd = 76;
    static constexpr double planeBegin = 26; ///< of a plane's square, along both of its axes [pixels]
    static constexpr double planeEnd = 44;
    static constexpr double middle = 9; ///< radius of the free handle [pixels]

    bool isVisible() const { return m_middle.has_value(); } ///< it lies before the eye
    Pixel middlePixel() const { return *m_middle; }

    Vec3 axis(int index) const { return m_frame.rotation * Vec3::Unit(index); } ///< unit
    /// A place given in pixels along the axes of the gizmo.
    Pixel pixelOf(const Vec3& pixels) const;
    /// The front half of a ring, as seen.
    std::vector<Pixel> ringLine(int index) const;
    /// Corners of the square of a plane.
    std::array<Pixel, 4> planeCorners(int index) const;

    /// Whether a handle is turned so that it can be used: arrows seen from their tips and planes seen from their sides cannot.
    bool isUsable(GizmoPart part) const;
    /// The handle at a place of the window, the nearest one of those within reach.
    GizmoPart partAt(const Pixel& pixel) const;

    /// How far a handle goes when the mouse that took it at `from` is at `to`.
    /// @param before the amount so far, so that turns go on beyond half a turn
    GizmoAmount amount(GizmoPart part, const Pixel& from, const Pixel& to, const GizmoAmount& before = {}) const;
    /// Where the thing is then.
    Pose moved(const Pose& start, GizmoPart part, const GizmoAmount& amount) const;
    /// Directions of the values of a handle that moves; unit.
    std::array<Vec3, 2> directions(GizmoPart part) const;

private:
    double distanceTo(GizmoPart part, const Pixel& pixel) const;
    std::optional<Vec3> onPlane(const Pixel& pixel, const Vec3& normal) const;
    double alongAxis(const Pixel& pixel, const Vec3& direction) const;
    double angle(int index, const Pixel& from, const Pixel& to) const;
    Vec3 towardsEye() const;

    Pose m_frame;
    Camera m_camera;
    WindowSize m_window;
    std::optional<Pixel> m_middle;
    double m_scale = 1; ///< at the gizmo [m/pixel]
};

/// Rounded to whole steps.
/// @param step > 0
GizmoAmount snapped(const GizmoAmount& amount, double step);

} // namespace knead
