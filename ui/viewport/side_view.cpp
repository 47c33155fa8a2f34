#include "ui/viewport/side_view.h"

#include "ui/viewport/color_legend.h"
#include "ui/viewport/pixel_of.h"
#include "ui/viewport/section_handles.h"
#include "ui/viewport/view_cube.h"

#include <QApplication>
#include <QMouseEvent>
#include <QNativeGestureEvent>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr int legendInset = 12; // from the corner [pixels]
constexpr int legendRoom = 320; // height of a view that has one: they say the same in all of them [pixels]
constexpr unsigned allChanges = ~0U;

unsigned bitOf(SceneChange what)
{
    return 1U << static_cast<unsigned>(what);
}

} // namespace

SideView::SideView(const Document& document, ViewportWidget& view, QWidget* parent)
    : ViewportBridge(parent)
    , m_document(document)
    , m_view(view)
    , m_scene(std::make_unique<SceneView>(renderWindow()))
    , m_legend(new ColorLegend(this))
    , m_divider(new DividerHandle(this))
    , m_changes(allChanges)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::NoFocus); // keys go to the active view
    m_divider->setFocusPolicy(Qt::NoFocus);
    m_divider->hide();
    connect(m_divider, &DividerHandle::dragged, &view, &ViewportWidget::moveDivider);
    connect(&view, &ViewportWidget::sceneChanged, this, &SideView::note);
}

SideView::~SideView() = default;

void SideView::note(SceneChange what)
{
    m_changes |= bitOf(what);
    if (what == SceneChange::content && !isVisible())
        m_scene->setModel({}); // what nobody sees keeps nothing of a part that is gone
    m_hasMoved = m_hasMoved || what == SceneChange::frame || what == SceneChange::options;
    m_isStale = true;
    emit becameStale();
}

void SideView::setCamera(const Camera& camera)
{
    m_camera = camera;
    m_hasMoved = true;
    m_isStale = true;
    emit becameStale();
}

void SideView::draw()
{
    if (!isVisible())
        return;
    m_isStale = false; // it is under way, however long the paint event takes
    if (std::exchange(m_hasMoved, false))
        requestSketch();
    else
        requestRender();
}

bool SideView::isMoving() const
{
    return m_document.isPlaying() && !m_view.isLookingBack();
}

/// In its turn, like all it draws.
void SideView::becameStill()
{
    m_isStale = true;
    emit becameStale();
}

WindowSize SideView::window() const
{
    return {static_cast<double>(std::max(1, width())), static_cast<double>(std::max(1, height()))};
}

std::optional<QPointF> SideView::widgetPosition(const Vec3& place) const
{
    const std::optional<Pixel> pixel = m_camera.project(place, window());
    return pixel ? std::optional(QPointF(pixel->x, pixel->y)) : std::nullopt;
}

/// In the order in which one thing rests on another.
void SideView::takeOver()
{
    const unsigned changes = std::exchange(m_changes, 0U);
    const auto isOther = [changes](SceneChange what) { return (changes & bitOf(what)) != 0; };
    const bool isAnew = isOther(SceneChange::content);
    if (isOther(SceneChange::style))
        m_scene->setStyle(m_view.style());
    if (m_document.isEmpty())
        return;
    if (isAnew)
        m_scene->setModel(m_document.content());
    if (isAnew || isOther(SceneChange::looks))
        m_scene->setAppearance(m_document.appearance());
    if (m_document.frame() && (isAnew || isOther(SceneChange::looks)))
        m_scene->setMaterials(m_document.frame()->snapshot->materials);
    if (isAnew || isOther(SceneChange::options))
        m_scene->setOptions(m_view.options());
    if (isAnew || isOther(SceneChange::frame))
        m_scene->showFrame(m_view.shownFrame());
    if (isAnew || isOther(SceneChange::marks))
        m_scene->setMarks(m_view.marks());
    if (isAnew || isOther(SceneChange::fields))
        m_scene->setSurfaceFields(m_view.fields());
}

void SideView::aboutToRender()
{
    ++m_drawings;
    takeOver();
    m_scene->cube().setWindow(window());
    m_scene->setCamera(m_camera);
    placeOverlays();
}

void SideView::placeOverlays()
{
    m_labels.place(m_scene->labels(), [this](const Vec3& place) { return widgetPosition(place); });
    const std::optional<ColorScale> scale = m_scene->scale();
    const bool hasRoom = height() >= legendRoom;
    if (scale && hasRoom)
        m_legend->show(*scale, m_view.isLookingBack());
    else if (m_view.options().shading == Shading::curvature && !m_scene->box().isEmpty() && hasRoom)
        m_legend->showCurvature();
    else
        m_legend->hide();
    m_legend->move(width() - m_legend->width() - legendInset, height() - m_legend->height() - legendInset);
    const std::optional<double>& divider = m_view.options().divider;
    m_divider->setVisible(divider.has_value());
    if (divider)
        m_divider->placeAt(*divider);
}

void SideView::mousePressEvent(QMouseEvent* event)
{
    if (event->buttons() == event->button()) // one more button in a drag belongs to the view that is dragged in
        emit pressed();
    m_view.setPressedAside(true);
    passOn(*event);
    m_view.setPressedAside(false);
}

void SideView::mouseDoubleClickEvent(QMouseEvent* event)
{
    mousePressEvent(event);
}

/// What was pressed here goes on in the active view, which has come to this place.
void SideView::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() != Qt::NoButton) {
        passOn(*event);
        return;
    }
    if (m_view.regions().shape() != RegionShape::Brush) // the brush is where the active view is
        m_view.hoverFrom(m_camera, window(), pixelOf(event->position()));
    setCursor(m_view.usualCursor());
    emit hovered(event->position());
}

void SideView::mouseReleaseEvent(QMouseEvent* event)
{
    passOn(*event);
}

void SideView::passOn(const QMouseEvent& event)
{
    m_held = event.buttons();
    m_heldAt = event.globalPosition();
    QMouseEvent passed(event.type(), m_view.mapFromGlobal(event.globalPosition()), event.globalPosition(),
                       event.button(), event.buttons(), event.modifiers(), event.pointingDevice());
    QApplication::sendEvent(&m_view, &passed);
}

/// Nobody is told any more when the buttons are let go: what they do ends here.
void SideView::hideEvent(QHideEvent* event)
{
    ViewportBridge::hideEvent(event);
    const Qt::MouseButtons held = std::exchange(m_held, {});
    for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton})
        if (held.testFlag(button))
            passOn(QMouseEvent(QEvent::MouseButtonRelease, {}, m_heldAt, button, Qt::NoButton, Qt::NoModifier));
}

void SideView::leaveEvent(QEvent* event)
{
    m_view.forgetHover();
    emit left();
    ViewportBridge::leaveEvent(event);
}

void SideView::wheelEvent(QWheelEvent* event)
{
    setCamera(cameraAfterScroll(m_camera, m_view.navigation(), *event, window()));
    emit zoomed();
    event->accept();
}

bool SideView::event(QEvent* event)
{
    if (event->type() != QEvent::NativeGesture)
        return ViewportBridge::event(event);
    const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
    if (gesture.gestureType() != Qt::ZoomNativeGesture)
        return ViewportBridge::event(event);
    setCamera(cameraAfterPinch(m_camera, gesture, mapFromGlobal(gesture.globalPosition()), window()));
    emit zoomed();
    event->accept();
    return true;
}

} // namespace knead
