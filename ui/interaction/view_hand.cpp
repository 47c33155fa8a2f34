#include "ui/interaction/view_hand.h"

#include "ui/language/said.h"
#include "ui/viewport/viewport_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

namespace knead {

ViewHand::ViewHand(Document& document, ViewportWidget& view)
    : QObject(&view)
    , m_document(document)
    , m_view(view)
{
    view.installEventFilter(this);
}

std::optional<PickHit> ViewHand::pressedBody(const QMouseEvent& event) const
{
    if (event.button() != Qt::LeftButton || m_view.isLookingBack() || m_document.isEmpty() || m_document.isGoing() ||
        m_view.isOnCube(event.position()))
        return {};
    const PickHit hit = m_view.hitAt(event.position());
    return hit.kind == PickHit::Kind::Body ? std::optional(hit) : std::nullopt;
}

QString ViewHand::whyNotNow(const QMouseEvent& event) const
{
    if (event.button() != Qt::LeftButton || !m_view.isLookingBack() || m_view.isOnCube(event.position()))
        return {};
    return notThePresent();
}

QString ViewHand::notThePresent()
{
    return said(Message("ViewHand", "What is seen here is not the present: Esc returns to it. To go on from an earlier "
                                    "moment, press Branch here beside the timeline."));
}

bool ViewHand::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != &m_view)
        return false;
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: // the second of two fast presses
        return !m_view.isForNavigation(static_cast<QMouseEvent&>(*event)) &&
               mousePressed(static_cast<QMouseEvent&>(*event));
    case QEvent::MouseMove:
        return mouseMoved(static_cast<QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
        return mouseReleased(static_cast<QMouseEvent&>(*event));
    case QEvent::Wheel:
        return wheelTurned(static_cast<QWheelEvent&>(*event));
    case QEvent::Leave:
        mouseLeft();
        return false;
    case QEvent::ShortcutOverride:
        if (!wantsKey(static_cast<QKeyEvent&>(*event)))
            return false;
        event->accept();
        return true;
    case QEvent::KeyPress:
        return keyPressed(static_cast<QKeyEvent&>(*event));
    case QEvent::KeyRelease:
        return keyReleased(static_cast<QKeyEvent&>(*event));
    case QEvent::FocusOut:
        keyboardLost();
        return false;
    default:
        return false;
    }
}

} // namespace knead
