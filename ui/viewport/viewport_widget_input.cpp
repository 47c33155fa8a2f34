// Mouse and keys in the view: navigating, selecting, moving tools.
#include "ui/viewport/pixel_of.h"
#include "ui/viewport/view_cube.h"
#include "ui/viewport/viewport_widget.h"

#include <QMouseEvent>
#include <QVariantAnimation>
#include <QWheelEvent>

namespace knead {

void ViewportWidget::mousePressEvent(QMouseEvent* event)
{
    m_lastMouse = event->globalPosition();
    if (event->button() == Qt::MiddleButton) {
        m_turning->stop();
        m_isNavigating = true;
        setCursor(Qt::SizeAllCursor);
        return;
    }
    if (event->button() != Qt::LeftButton)
        return;
    if (const auto direction = cubeSideAt(event->position())) {
        lookFrom(*direction);
        return;
    }
    if (m_past)
        return;
    if (isForTools(event->position()))
        m_manipulation->press(rayAt(event->position()));
    else if (!m_mode)
        m_regions->press(pixelOf(event->position()), event->modifiers());
    setCursor(usualCursor());
}

/// The rest of the view is for selecting.
bool ViewportWidget::isForTools(const QPointF& position)
{
    m_regions->fields().look(m_camera, window());
    return m_manipulation->isFixing() || m_manipulation->picker().pick(rayAt(position)).kind == PickHit::Kind::Tool;
}

void ViewportWidget::hoverFrom(const Camera& camera, const WindowSize& window, const Pixel& pixel)
{
    if (m_past)
        return;
    m_manipulation->hover(camera.ray(pixel, window));
    m_regions->fields().look(camera, window);
    if (m_mode || m_manipulation->isFixing() || m_manipulation->hovered().kind == PickHit::Kind::Tool)
        m_regions->leave();
    else
        m_regions->hover(pixel);
}

void ViewportWidget::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF step = event->globalPosition() - m_lastMouse;
    m_lastMouse = event->globalPosition();
    if (m_isNavigating && event->buttons() & Qt::MiddleButton) {
        Camera camera = m_camera;
        if (event->modifiers() & (Qt::ShiftModifier | Qt::ControlModifier))
            camera.pan(step.x(), step.y(), window());
        else
            camera.orbit(step.x(), step.y());
        setCamera(camera);
    } else if (m_regions->isPressed()) {
        if (!(event->buttons() & Qt::LeftButton)) // of before the press, or let go where nobody could see it
            return;
        m_regions->fields().look(m_camera, window());
        m_regions->drag(pixelOf(event->position()));
    } else if (event->buttons() & Qt::LeftButton) {
        m_manipulation->drag(rayAt(event->position()), m_camera);
    } else {
        hoverFrom(m_camera, window(), pixelOf(event->position()));
    }
}

void ViewportWidget::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::MiddleButton) {
        m_isNavigating = false;
        setCursor(usualCursor());
    } else if (event->button() == Qt::LeftButton) {
        if (m_regions->isPressed())
            m_regions->release();
        m_manipulation->release();
    }
}

void ViewportWidget::leaveEvent(QEvent* event)
{
    m_manipulation->leave();
    m_regions->leave();
    ViewportBridge::leaveEvent(event);
}

void ViewportWidget::wheelEvent(QWheelEvent* event)
{
    m_turning->stop();
    Camera camera = m_camera;
    camera.zoomByWheel(event->angleDelta().y(), pixelOf(event->position()), window());
    setCamera(camera);
    event->accept();
}

void ViewportWidget::keyPressEvent(QKeyEvent* event)
{
    const bool isSlow = event->modifiers() & Qt::ShiftModifier;
    const bool isRepeated = event->isAutoRepeat() && m_document.isPlaying();
    if (m_past)
        ViewportBridge::keyPressEvent(event);
    else if (!isRepeated && !m_manipulation->keyPressed(event->key(), isSlow, m_camera))
        ViewportBridge::keyPressEvent(event);
}

void ViewportWidget::keyReleaseEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat() || !m_manipulation->keyReleased(event->key()))
        ViewportBridge::keyReleaseEvent(event);
}

void ViewportWidget::focusOutEvent(QFocusEvent* event)
{
    m_manipulation->releaseKeys();
    ViewportBridge::focusOutEvent(event);
}

} // namespace knead
