#pragma once

#include "ui/viewport/manipulation.h"
#include "ui/viewport/region_tool.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/viewport_bridge.h"

#include <map>
#include <memory>

class QLabel;
class QVariantAnimation;

namespace knead {

class SightOverlay;
class SightPreparer;

/// The view of a document: draws it, navigates, and passes the left button and the arrow keys on to the material.
class ViewportWidget final : public ViewportBridge {
    Q_OBJECT
public:
    explicit ViewportWidget(Document& document, QWidget* parent = nullptr);
    ~ViewportWidget() override;

    const Camera& camera() const { return m_camera; }
    const SceneOptions& options() const { return m_options; }
    void setOptions(const SceneOptions& options);
    void setStyle(const SceneStyle& style);
    void setFixing(bool on);
    RegionTool& regions() { return *m_regions; } ///< how the left button selects
    bool isFixing() const { return m_manipulation->isFixing(); }
    /// Where the left button selects, a mode does something else with it. What is under way ends as it began.
    /// @param cursor of the mode; empty: the button selects again
    void setMode(std::optional<Qt::CursorShape> cursor);
    bool hasMode() const { return m_mode.has_value(); }
    Qt::CursorShape usualCursor() const; ///< as long as no button is pressed
    /// Gives up what the left button draws or drags. @return whether it did
    bool cancelDrag() { return m_regions->cancel() || m_manipulation->cancel(); }
    /// The mouse is busy with something on top of the scene.
    void forgetHover();
    /// What is shown and how, without what is selected or under the mouse.
    SceneLook look() const;

    /// Shows a frame of the past with a caption, until null brings the present back. Tools cannot be moved meanwhile.
    void lookBack(const FramePointer& frame, const QString& caption);
    bool isLookingBack() const { return m_past != nullptr; }

    void fit();
    /// Turns the view, smoothly, to look from a direction.
    void lookFrom(const Vec3& direction);
    void setPerspective(bool on);
    void setTurningSmoothly(bool on);
    /// Looks from elsewhere, at once.
    void jumpTo(const Camera& camera);

    /// Where a place is seen, in this widget's coordinates; for tests and labels.
    std::optional<QPointF> widgetPosition(const Vec3& place) const;
    std::optional<ColorScale> scale() const { return m_scene->scale(); } ///< see SceneView::scale()
    WindowSize window() const;
    Box materialBox() const; ///< of the bodies, at rest and as shown [m]
    /// What lies under a position in this widget.
    Ray rayAt(const QPointF& position) const;
    PickHit hitAt(const QPointF& position) { return m_manipulation->pick(rayAt(position)); }
    /// Whether a click there turns the view.
    bool isOnCube(const QPointF& position) const;
    /// What is drawn: the present, or a frame of the past; null while nothing is open.
    const FramePointer& shownFrame() const { return m_past ? m_past : m_document.frame(); }
    /// Sets a face apart by color, as under the mouse.
    void setHighlight(const std::optional<SceneMarks::Face>& face);

signals:
    void optionsChanged();

protected:
    void aboutToRender() override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void documentChanged(Document::Change what);
    void updateMarks();
    void hover(const QPointF& position);
    bool isForTools(const QPointF& position);
    std::vector<SceneMarks::Face> fixedFaces() const;
    void setCamera(const Camera& camera);
    void turnTo(const Camera& camera);
    void placeLabels();
    void beginContent();
    void askForSight();

    Document& m_document;
    Manipulation* m_manipulation;
    RegionTool* m_regions;
    QWidget* m_regionOverlay;
    std::unique_ptr<SceneView> m_scene;
    SightPreparer* m_sights;
    SightOverlay* m_overlay;
    std::shared_ptr<const Model> m_model;
    Box m_restBox; ///< of the content [m]
    SceneOptions m_options;
    SceneStyle m_style;
    Camera m_camera;
    QVariantAnimation* m_turning;
    Camera m_turnStart;
    Camera m_turnEnd;
    std::optional<SceneMarks::Face> m_highlight;
    std::optional<Qt::CursorShape> m_mode; ///< that has the left button
    FramePointer m_past;                   ///< that is looked at; null: the present
    QLabel* m_caption;
    QPointF m_lastMouse;
    bool m_isNavigating = false;
    std::map<ToolId, QLabel*> m_labels;
};

} // namespace knead
