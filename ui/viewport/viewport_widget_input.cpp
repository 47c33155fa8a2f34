// Mouse and keys in the view: navigating, selecting, moving tools.
#include "ui/viewport/pixel_of.h"
#include "ui/viewport/view_cube.h"
#include "ui/viewport/viewport_widget.h"

#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QVariantAnimation>
#include <QWheelEvent>

namespace knead {

void ViewportWidget::setNavigation(const NavigationPreset& preset)
{
    m_navigation = &preset;
}

/// The left button is, where it is pressed as the second one of a gesture.
bool ViewportWidget::isForNavigation(const QMouseEvent& press) const
{
    const Qt::MouseButtons held = press.buttons() | press.button();
    if (press.button() == Qt::LeftButton)
        return m_isNavigating && m_navigation->usesLeft(held, press.modifiers());
    return m_navigation->motion(held, press.modifiers()).has_value();
}

void ViewportWidget::mousePressEvent(QMouseEvent* event)
{
    m_lastMouse = event->globalPosition();
    if (isForNavigation(*event)) {
        m_turning->stop();
        m_isNavigating = true;
        m_navigationStart = pixelOf(event->position());
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
    if (navigatesWith(event->buttons())) {
        if (const auto motion = m_navigation->motion(event->buttons(), event->modifiers()))
            setCamera(cameraAfterDrag(m_camera, *motion, step, m_navigationStart, window()));
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
    if (m_isNavigating && !m_navigation->uses(event->buttons())) {
        m_isNavigating = false;
        setCursor(usualCursor());
    }
    if (event->button() == Qt::LeftButton) {
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
    setCamera(cameraAfterScroll(m_camera, *m_navigation, *event, window()));
    event->accept();
}

bool ViewportWidget::event(QEvent* event)
{
    if (event->type() != QEvent::NativeGesture)
        return ViewportBridge::event(event);
    const auto& gesture = static_cast<const QNativeGestureEvent&>(*event);
    if (gesture.gestureType() != Qt::ZoomNativeGesture)
        return ViewportBridge::event(event);
    m_turning->stop();
    setCamera(cameraAfterPinch(m_camera, gesture, mapFromGlobal(gesture.globalPosition()), window()));
    event->accept();
    return true;
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
