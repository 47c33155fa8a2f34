#pragma once

#include "core/deformation/number_deformation.h"
#include "core/session/frame.h"
#include "ui/interaction/view_hand.h"
#include "ui/interaction/view_overlay.h"
#include "ui/units.h"
#include "ui/viewport/camera.h"

#include <QPointF>

#include <array>
#include <optional>

namespace knead {

/// What can be dragged of a deformation by numbers: its planes, and how much there is of it.
enum class DeformHandle { none, from, to, value };

/// A deformation by numbers as it stands in the view: frames at its planes with arrows, and a knob for its angle, factor or shift
/// where that takes the part. Geometry only: a value that knows no window.
struct DeformFrames {
    NumberDeformation deformation;
    Box box; ///< of the parts that are deformed [m]

    /// What a handle drags: a place along the axis [m]; an angle [rad], a factor or a shift [m].
    double valueOf(DeformHandle handle) const;
    DeformFrames with(DeformHandle handle, double value) const;
    Quantity quantityOf(DeformHandle handle) const;

    std::array<Vec3, 4> cornersOf(DeformHandle plane) const; ///< of the frame at a plane [m]
    Vec3 placeOf(DeformHandle handle) const;                 ///< where it is grabbed [m]

    /// The value at which the handle is seen nearest to a pixel, from that of now on.
    double draggedTo(DeformHandle handle, const Pixel& pixel, const Camera& camera, const WindowSize& window) const;

private:
    Vec3 across() const { return deformation.axis.cross(deformation.side); }
    double halfAlong(const Vec3& direction) const; ///< of a frame [m]
    double stepOf(DeformHandle handle) const;      ///< that changes little
};

/// Rounded to steps that are easy to say: 5 degrees, 0.05, 1 mm.
double snapped(double value, Quantity quantity);

/// Draws and drags them, with the edges of what is deformed as it is without: with Ctrl in steps, Esc gives a drag up, Enter is for the
/// whole. Owned by the view.
class DeformHandles final : public ViewHand, private OverlayDrawing {
    Q_OBJECT
public:
    DeformHandles(Document& document, ViewportWidget& view);

    /// @param ghost whose edges are drawn; null: none
    void show(const DeformFrames& frames, const FramePointer& ghost);
    /// Only the edges: there is nothing to drag.
    void showGhost(const FramePointer& ghost);
    void hide();
    const std::optional<DeformFrames>& frames() const { return m_frames; }
    bool isDragging() const { return m_drag.has_value(); }

signals:
    void dragged(knead::DeformHandle handle, double value);
    void confirmed(); ///< by Enter

protected:
    bool mousePressed(QMouseEvent& event) override;
    bool mouseMoved(QMouseEvent& event) override;
    bool mouseReleased(QMouseEvent& event) override;
    bool wantsKey(const QKeyEvent& event) const override;
    bool keyPressed(QKeyEvent& event) override;
    void mouseLeft() override;

private:
    struct Drag {
        DeformHandle handle = DeformHandle::none;
        double before = 0;
        QPointF aside; ///< of the mouse from the handle
    };

    DeformHandle handleAt(const QPointF& position) const;
    void setGhost(const FramePointer& ghost);
    void setLit(DeformHandle handle);
    QString note() const;
    QRect overlayArea() const override;
    void drawOverlay(QPainter& painter) const override;
    void drawGhost(QPainter& painter) const;
    void drawPlane(QPainter& painter, DeformHandle plane) const;
    void drawArrow(QPainter& painter, DeformHandle plane) const;
    void drawKnob(QPainter& painter) const;
    QPointF directionOf(DeformHandle handle) const;

    ViewOverlay* m_overlay;
    std::optional<DeformFrames> m_frames;
    FramePointer m_ghost;
    Box m_ghostBox;               ///< [m]
    std::size_t m_ghostEdges = 0; ///< of all bodies
    DeformHandle m_lit = DeformHandle::none;
    std::optional<Drag> m_drag;
    QPointF m_cursor;
};

} // namespace knead
