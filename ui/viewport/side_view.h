#pragma once

#include "ui/viewport/force_labels.h"
#include "ui/viewport/viewport_bridge.h"
#include "ui/viewport/viewport_widget.h"

namespace knead {

class ColorLegend;
class DividerHandle;

/// Shows what a ViewportWidget shows, from elsewhere. It takes over what became another only when it draws, so that what is not
/// drawn costs nothing. Under the mouse things light up in all views; a press makes it the active view, which is when the
/// ViewportWidget takes its place, and goes on to that one. Window thread.
class SideView final : public ViewportBridge {
    Q_OBJECT
public:
    /// @param view outlives it
    SideView(const Document& document, ViewportWidget& view, QWidget* parent);
    ~SideView() override;

    const Camera& camera() const { return m_camera; }
    /// Drawn with the next drawing.
    void setCamera(const Camera& camera);

    /// What is shown is older than what should be.
    bool isStale() const { return m_isStale; }
    /// Draws it at the next opportunity, unless nobody sees it.
    void draw();

    std::optional<QPointF>
    widgetPosition(const Vec3& place) const; ///< where a place is seen, in this widget's coordinates
    WindowSize window() const;
    std::size_t drawings() const { return m_drawings; } ///< how often it was drawn, for tests

signals:
    void becameStale();
    void pressed();                        ///< it is to be the active view; the press follows
    void zoomed();                         ///< by a wheel or fingers on a touchpad, which also pan
    void hovered(const QPointF& position); ///< no button is pressed
    void left();                           ///< the mouse is elsewhere

protected:
    void aboutToRender() override;
    bool isMoving() const override;
    void becameStill() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool event(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void note(SceneChange what);
    void takeOver();
    void placeOverlays();
    void passOn(const QMouseEvent& event);

    const Document& m_document;
    ViewportWidget& m_view;
    std::unique_ptr<SceneView> m_scene;
    ColorLegend* m_legend;
    DividerHandle* m_divider;
    ForceLabels m_labels{this};
    Camera m_camera;
    Qt::MouseButtons m_held; ///< that were pressed here and passed on
    QPointF m_heldAt;        ///< where the mouse was last, on the screen
    unsigned m_changes = 0;  ///< a bit for each SceneChange that is not taken over
    bool m_isStale = true;
    bool m_hasMoved = false; ///< since it was drawn last
    std::size_t m_drawings = 0;
};

} // namespace knead
