#include "ui/interaction/gizmo_hand.h"

#include "ui/interaction/gizmo_painter.h"
#include "ui/viewport/pixel_of.h"
#include "ui/viewport/viewport_widget.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>
#include <numbers>
#include <utility>

namespace knead {

namespace {

/// Names of the directions of a handle's values.
std::array<const char*, 2> namesOf(GizmoPart part)
{
    static constexpr const char* axes[] = {"X", "Y", "Z"};
    const int axis = axisOf(part);
    switch (motionOf(part)) {
    case GizmoMotion::plane:
        return {axes[(axis + 1) % 3], axes[(axis + 2) % 3]};
    case GizmoMotion::free:
        return {"\u2192", "\u2191"};
    default:
        return {axes[axis], ""};
    }
}

/// @param way -1: the difference
GizmoAmount sum(const GizmoAmount& a, const GizmoAmount& b, double way = 1)
{
    return {{a.values[0] + way * b.values[0], a.values[1] + way * b.values[1]}, a.count};
}

QString valueText(double value, Quantity quantity)
{
    constexpr double finest = 1e-8; // [m], [rad]; rounding is not worth a digit
    constexpr int digits = 4;
    const double unit = quantity == Quantity::Angle ? std::numbers::pi / 180 : 1; // digits of what is read
    const double shown = std::abs(value) < finest ? 0 : QString::number(value / unit, 'g', digits).toDouble();
    return formatQuantity(shown * unit, quantity);
}

} // namespace

GizmoHand::GizmoHand(Document& document, ViewportWidget& view, const HandSettings& settings)
    : ViewHand(document, view)
    , m_settings(settings)
    , m_overlay(new ViewOverlay(view, *this, "gizmo"))
{
    connect(&document, &Document::changed, this, &GizmoHand::documentChanged);
    connect(&document, &Document::stopping, this, &GizmoHand::letGo);
    connect(&settings, &HandSettings::changed, m_overlay, &ViewOverlay::refresh);
}

void GizmoHand::setOn(bool on)
{
    m_isOn = on;
    if (!on && m_drag)
        finish();
    m_overlay->refresh();
}

void GizmoHand::documentChanged(Document::Change what)
{
    if (what == Document::Change::Model)
        letGo();
    if (m_drag && m_document.tool(m_drag->tool) == nullptr)
        letGo();
    if (what != Document::Change::History)
        m_overlay->refresh();
}

std::optional<Gizmo> GizmoHand::gizmo() const
{
    const Selection& selection = m_document.selection();
    const ToolState* tool = selection.kind == Selection::Kind::Tool ? m_document.tool(selection.id) : nullptr;
    if (!m_isOn || tool == nullptr || m_view.isLookingBack())
        return {};
    if (!m_drag && (m_view.isFixing() || m_view.hasMode()))
        return {};
    Pose frame = tool->pose;
    if (!m_settings.choices().ownAxes)
        frame.rotation = Quaternion::Identity();
    return Gizmo(frame, m_view.camera(), m_view.window());
}

void GizmoHand::setLit(GizmoPart part)
{
    if (part == m_lit)
        return;
    if (part != GizmoPart::none)
        m_view.forgetHover();
    m_lit = part;
    m_view.setCursor(part == GizmoPart::none ? m_view.usualCursor() : Qt::PointingHandCursor);
    m_overlay->refresh();
}

bool GizmoHand::mousePressed(QMouseEvent& event)
{
    if (m_drag && event.button() == Qt::RightButton)
        return true;
    if (m_drag && event.button() == Qt::LeftButton) // the number that was typed holds
        finish();
    const std::optional<Gizmo> handles = gizmo();
    if (event.button() != Qt::LeftButton || !handles || m_view.isPressedAside()) // what nobody saw is not grabbed
        return false;
    const GizmoPart part = handles->partAt(pixelOf(event.position()));
    if (part == GizmoPart::none)
        return false;
    if (m_document.isGoing())
        return true; // what would be held may be gone on arrival
    const ToolId tool = m_document.selection().id;
    const int values = handles->amount(part, {}, {}).count;
    const Pose pose = m_document.poseToMoveFrom(tool);
    const GizmoAmount none{{}, values};
    m_drag = Drag{tool, part, pose, pose, *handles, m_view.camera(), pixelOf(event.position()), {}, none, none, none};
    m_typed.clear();
    m_cursor = event.position();
    m_view.setFocus(Qt::MouseFocusReason);
    setLit(part);
    m_view.setCursor(Qt::ClosedHandCursor);
    m_document.beginGesture();
    m_overlay->refresh();
    return true;
}

bool GizmoHand::mouseMoved(QMouseEvent& event)
{
    const QPointF before = std::exchange(m_cursor, event.position());
    if (m_drag) {
        if (m_view.navigatesWith(event.buttons()))
            return false;
        if (!(event.buttons() & Qt::LeftButton)) // let go while a number is typed
            return true;
        if (m_typed.isEmpty() && m_view.camera() != m_drag->camera)
            lookAnew(before);
        const Pixel mouse{m_cursor.x() - m_drag->aside.x, m_cursor.y() - m_drag->aside.y};
        const GizmoAmount since =
            m_drag->gizmo.amount(m_drag->part, m_drag->from, mouse, sum(m_drag->byMouse, m_drag->before, -1));
        m_drag->byMouse = sum(m_drag->before, since);
        follow(event.modifiers() & Qt::ControlModifier);
        return true;
    }
    const std::optional<Gizmo> handles = event.buttons() == Qt::NoButton ? gizmo() : std::nullopt;
    setLit(handles ? handles->partAt(pixelOf(m_cursor)) : GizmoPart::none);
    return m_lit != GizmoPart::none;
}

bool GizmoHand::mouseReleased(QMouseEvent& event)
{
    if (!m_drag || event.button() != Qt::LeftButton)
        return false;
    if (m_typed.isEmpty()) // else Enter ends it, or Esc
        finish();
    return true;
}

Quantity GizmoHand::quantity() const
{
    return motionOf(m_drag->part) == GizmoMotion::turn ? Quantity::Angle : Quantity::Length;
}

/// The view was turned under the hand: the handle goes on from where it is, as it is seen now.
void GizmoHand::lookAnew(const QPointF& cursor)
{
    Drag& drag = *m_drag;
    const Pose reached = drag.gizmo.moved(drag.start, drag.part, drag.asked);
    if (motionOf(drag.part) == GizmoMotion::free) { // its directions are those of the view
        drag.start = reached;
        drag.byMouse.values = drag.asked.values = {};
    }
    drag.before = drag.byMouse;
    drag.gizmo = drag.gizmo.seenFrom(reached.position, m_view.camera(), m_view.window());
    drag.camera = m_view.camera();
    drag.from = pixelOf(cursor);
    drag.aside = {};
    if (motionOf(drag.part) == GizmoMotion::turn || !drag.gizmo.isVisible())
        return;
    const Pixel middle =
        drag.gizmo.middlePixel(); // the mouse may be far from the handle: it counts as if it were there
    drag.aside = {drag.from.x - middle.x, drag.from.y - middle.y};
    drag.from = middle;
}

/// Sends the tool to where mouse and keys want it.
void GizmoHand::follow(bool isSnapped)
{
    if (!m_document.isInGesture()) { // undone under the hand
        letGo();
        return;
    }
    m_isSnapped = isSnapped;
    GizmoAmount asked = m_drag->byMouse;
    if (isSnapped)
        asked = snapped(asked,
                        quantity() == Quantity::Angle ? m_settings.choices().turnStep : m_settings.choices().moveStep);
    if (const std::optional<GizmoAmount> typed = m_typed.applied(asked, quantity()))
        asked = *typed;
    else
        asked = m_drag->asked; // what is typed is no number yet
    if (asked != m_drag->asked) {
        m_drag->asked = asked;
        m_document.bringTool(m_drag->tool, m_drag->gizmo.moved(m_drag->start, m_drag->part, asked));
    }
    m_overlay->refresh();
}

void GizmoHand::finish()
{
    m_drag.reset();
    m_typed.clear();
    m_document.endGesture();
    setLit(GizmoPart::none);
    m_overlay->refresh();
}

/// While time runs the tool goes back as it came, no faster than it may.
void GizmoHand::cancel()
{
    const Drag drag = *std::exchange(m_drag, {});
    m_typed.clear();
    const bool isMoved = drag.asked != GizmoAmount{{}, drag.asked.count} || drag.start.position != drag.home.position;
    if (m_document.isPlaying() && isMoved)
        m_document.post(SetManipulatorMotion{drag.tool, GoTo{drag.home}});
    m_document.takeBackGesture();
    setLit(GizmoPart::none);
    m_overlay->refresh();
}

/// Somebody else ended the gesture.
void GizmoHand::letGo()
{
    if (!std::exchange(m_drag, {}))
        return;
    m_typed.clear();
    m_document.endGesture(Document::Ends::soon);
    setLit(GizmoPart::none);
    m_overlay->refresh();
}

bool GizmoHand::wantsKey(const QKeyEvent& event) const
{
    const int key = event.key();
    return m_drag && (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter ||
                      TypedValue::belongs(event, !m_typed.isEmpty()));
}

bool GizmoHand::keyPressed(QKeyEvent& event)
{
    if (!m_drag)
        return false;
    if (event.key() == Qt::Key_Control) {
        follow(true);
        return true;
    }
    if (!wantsKey(event))
        return false;
    if (event.key() == Qt::Key_Escape)
        cancel();
    else if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        finish();
    else if (m_typed.take(event, m_drag->asked.count))
        follow(m_isSnapped);
    return true;
}

/// Whoever turns to another widget has done with it.
void GizmoHand::keyboardLost()
{
    if (m_drag && !m_typed.isEmpty())
        finish();
}

QString GizmoHand::note() const
{
    if (!m_drag)
        return {};
    const std::array<const char*, 2> names = namesOf(m_drag->part);
    QStringList parts;
    for (int i = 0; i < m_drag->asked.count; ++i) {
        const QString name = QString::fromUtf8(names[static_cast<std::size_t>(i)]);
        const bool isTyped = !m_typed.isEmpty() && (m_typed.current() == i || !m_typed.text(i).isEmpty());
        const QString caret = m_typed.current() == i ? QStringLiteral("|") : QString();
        parts << name + ' ' + (isTyped ? m_typed.text(i) + caret + " = " : QString()) +
                     valueText(m_drag->asked.values[static_cast<std::size_t>(i)], quantity());
    }
    return parts.join(QStringLiteral("   "));
}

QRect GizmoHand::overlayArea() const
{
    const std::optional<Gizmo> handles = gizmo();
    if (!handles)
        return {};
    QRect area = gizmoArea(*handles);
    if (m_drag)
        area |= cursorNoteArea(note(), m_cursor, m_view.rect(), m_overlay->font());
    return area;
}

void GizmoHand::drawOverlay(QPainter& painter) const
{
    const std::optional<Gizmo> handles = gizmo();
    if (!handles || !handles->isVisible())
        return;
    drawGizmo(painter, *handles, m_drag ? m_drag->part : m_lit, m_drag.has_value());
    if (m_drag)
        drawCursorNote(painter, note(), cursorNoteArea(note(), m_cursor, m_view.rect(), m_overlay->font()),
                       m_overlay->palette());
}

} // namespace knead
