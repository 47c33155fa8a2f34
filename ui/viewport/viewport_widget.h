#pragma once

#include "ui/viewport/force_labels.h"
#include "ui/viewport/manipulation.h"
#include "ui/viewport/navigation.h"
#include "ui/viewport/region_tool.h"
#include "ui/viewport/scene_view.h"
#include "ui/viewport/viewport_bridge.h"

#include <cstdint>
#include <memory>
#include <utility>

class QLabel;
class QVariantAnimation;

namespace knead {

class SurfaceFieldOverlay;
class SurfaceFieldsPreparer;

/// What of a scene became another.
enum class SceneChange { content, style, looks, options, frame, marks, fields };

/// The view of a document: draws it, navigates, and passes the left button and the arrow keys on to the material.
class ViewportWidget final : public ViewportBridge {
    Q_OBJECT
public:
    explicit ViewportWidget(Document& document, QWidget* parent = nullptr);
    ~ViewportWidget() override;

    const Camera& camera() const { return m_camera; }
    const SceneOptions& options() const { return m_options; }
    void setOptions(const SceneOptions& options);
    const SceneStyle& style() const { return m_style; }
    void setStyle(const SceneStyle& style);
    const SceneMarks& marks() const { return m_marks; }
    /// What was found out for the options; null: nothing, or nothing yet.
    const SurfaceFieldsPointer& fields() const { return m_fields; }
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
    /// What the view shows, without the cube, to be known again by when it is small.
    QImage portrait();

    /// Shows a frame of the past with a caption, until null brings the present back. Tools cannot be moved meanwhile.
    void lookBack(const FramePointer& frame, const QString& caption);
    bool isLookingBack() const { return m_past != nullptr; }
    /// The same with what would come of something, before it is done.
    /// @param fields of the frame, in place of what the options ask for; null: none
    void lookAhead(const FramePointer& frame, const SurfaceFieldsPointer& fields, const QString& caption);

    void fit();
    /// What lies on the view, so that fit() leaves the part beside it.
    /// @param taken from the sides of the view; nothing: it lies there no more
    void keepFree(const QObject* what, const Insets& taken);
    Insets taken() const; ///< by all that lies on it
    /// Moves the view, smoothly, so that the middle of a box is in that of what is free, and the box nearly fills it.
    /// @param from see lookFrom(); nothing: the present direction
    void flyTo(const Box& box, const std::optional<Vec3>& from = {});
    /// Turns the view, smoothly, to look from a direction.
    void lookFrom(const Vec3& direction);
    void setPerspective(bool on);
    /// How the mouse moves the camera, from the next press on.
    void setNavigation(const NavigationPreset& preset);
    const NavigationPreset& navigation() const { return *m_navigation; }
    /// Whether the view moves with buttons that are held: what was pressed began that.
    bool navigatesWith(Qt::MouseButtons held) const { return m_isNavigating && m_navigation->uses(held); }
    /// Whether a press moves the view from now on, so that it is nobody else's.
    bool isForNavigation(const QMouseEvent& press) const;
    void setTurningSmoothly(bool on);
    /// Looks from elsewhere, at once.
    void jumpTo(const Camera& camera);
    /// Where the view looks from, or will when it has turned.
    Camera cameraAfterTurning() const;
    bool showsAll() const;                          ///< whether all that is drawn but the ground is within the view
    Box sceneBox() const { return m_scene->box(); } ///< of all that is drawn but the ground [m]
    /// What lies under a pixel of another view of the same scene lights up, as if the mouse were over it here.
    void hoverFrom(const Camera& camera, const WindowSize& window, const Pixel& pixel);
    /// The line between before and after; nothing where there is none. @param share of the width, 0 .. 1
    void moveDivider(double share);
    /// Wall time that other views of the same scene take for a drawing [s]: frames come as seldom as all of them need.
    void setTimeOfOthers(double seconds) { m_secondsOfOthers = seconds; }
    /// A press that comes now was made in another view, which shows no handles.
    void setPressedAside(bool on) { m_isPressedAside = on; }
    bool isPressedAside() const { return m_isPressedAside; }
    /// Where the caption of a frame of the past lies from the top [pixels].
    void setCaptionTop(int top);

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
    void sceneChanged(knead::SceneChange what);
    void cameraChanged(); ///< also on each step of turning smoothly

protected:
    void aboutToRender() override;
    bool isMoving() const override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void lookAt(const FramePointer& frame, const QString& caption);
    void documentChanged(Document::Change what);
    void updateMarks();
    void setSurfaceFields(const SurfaceFieldsPointer& fields);
    void takeMaterials();
    void showFrame();
    bool isAtRest();
    bool isForTools(const QPointF& position);
    std::optional<Vec3> cubeSideAt(const QPointF& position) const;
    std::vector<SceneMarks::Face> fixedFaces() const;
    void setCamera(const Camera& camera);
    void turnTo(const Camera& camera);
    void beginContent();
    void askForSurfaceFields();

    Document& m_document;
    Manipulation* m_manipulation;
    RegionTool* m_regions;
    QWidget* m_regionOverlay;
    std::unique_ptr<SceneView> m_scene;
    SurfaceFieldsPreparer* m_sights;
    SurfaceFieldOverlay* m_overlay;
    std::shared_ptr<const Model> m_model;
    Box m_restBox; ///< of the content [m]
    SceneOptions m_options;
    SceneStyle m_style;
    Camera m_camera;
    QVariantAnimation* m_turning;
    Camera m_turnStart;
    Camera m_turnEnd;
    SceneMarks m_marks;
    SurfaceFieldsPointer m_fields;
    std::optional<SceneMarks::Face> m_highlight;
    std::optional<Qt::CursorShape> m_mode; ///< that has the left button
    std::pair<std::uint64_t, bool>
        m_rest;          ///< Snapshot::rest of the frame that was shown last, and whether it told what presses
    FramePointer m_past; ///< that is looked at; null: the present
    QLabel* m_caption;
    QPointF m_lastMouse; ///< on the screen: the view may come to lie elsewhere under the mouse
    const NavigationPreset* m_navigation = &navigationPreset({});
    bool m_isNavigating = false;
    Pixel m_navigationStart; ///< where the mouse was pressed
    bool m_isPressedAside = false;
    double m_secondsOfOthers = 0;
    ForceLabels m_labels{this};
    std::map<const QObject*, Insets> m_taken; ///< by what lies there
    SurfaceFieldsPointer m_foretold; ///< of m_past, where that is still to come; null: what the options ask for
    std::uint64_t m_opening = 0;     ///< of the document that was shown last
};

} // namespace knead
