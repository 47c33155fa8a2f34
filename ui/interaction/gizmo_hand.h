#pragma once

#include "ui/document/document.h"
#include "ui/interaction/gizmo.h"
#include "ui/interaction/hand_settings.h"
#include "ui/interaction/typed_value.h"
#include "ui/interaction/view_hand.h"
#include "ui/interaction/view_overlay.h"

#include <QPointF>

#include <optional>

namespace knead {

/// The gizmo of the selected tool: its handles are dragged with the mouse; with Ctrl in steps; numbers can be typed meanwhile;
/// Enter ends it there, Esc takes it back. While time runs the tool follows no faster than its speed limit, and stalls at its
/// force limit. A drag is one entry of the history.
class GizmoHand final : public ViewHand, private OverlayDrawing {
    Q_OBJECT
public:
    GizmoHand(Document& document, ViewportWidget& view, const HandSettings& settings);

    void setOn(bool on);
    /// As it is drawn; nothing without a selected tool.
    std::optional<Gizmo> gizmo() const;
    bool isDragging() const { return m_drag.has_value(); }
    QString note() const; ///< what stands beside the cursor while a handle is dragged, with unit

protected:
    bool mousePressed(QMouseEvent& event) override;
    bool mouseMoved(QMouseEvent& event) override;
    bool mouseReleased(QMouseEvent& event) override;
    bool wantsKey(const QKeyEvent& event) const override;
    bool keyPressed(QKeyEvent& event) override;
    void keyboardLost() override;

private:
    struct Drag {
        ToolId tool = 0;
        GizmoPart part = GizmoPart::none;
        Pose home;  ///< of the tool, when the handle was taken
        Pose start; ///< from where the amounts count
        Gizmo gizmo;
        Camera camera; ///< that the gizmo is seen with
        Pixel from;
        Pixel aside; ///< of the mouse, from where it is taken to be
        GizmoAmount byMouse;
        GizmoAmount asked;  ///< snapped, or typed
        GizmoAmount before; ///< by the mouse, until it was at `from`
    };

    void documentChanged(Document::Change what);
    void setLit(GizmoPart part);
    void lookAnew(const QPointF& cursor);
    void follow(bool isSnapped);
    void finish();
    void cancel();
    void letGo();
    Quantity quantity() const;

    QRect overlayArea() const override;
    void drawOverlay(QPainter& painter) const override;

    const HandSettings& m_settings;
    ViewOverlay* m_overlay;
    bool m_isOn = true;
    GizmoPart m_lit = GizmoPart::none;
    std::optional<Drag> m_drag;
    TypedValue m_typed;
    bool m_isSnapped = false; ///< Ctrl is held
    QPointF m_cursor;
};

} // namespace knead
