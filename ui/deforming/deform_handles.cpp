#include "ui/deforming/deform_handles.h"

#include "ui/viewport/pixel_of.h"
#include "ui/viewport/projector.h"
#include "ui/viewport/viewport_widget.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr double grabReach = 14;          // [pixels]
constexpr double knobRadius = 8;          // [pixels]
constexpr double arrowLength = 26;        // to either side [pixels]
constexpr double arrowHead = 9;           // [pixels]
constexpr double areaMargin = 60;         // around the corners of what is drawn [pixels]
constexpr std::size_t mostEdges = 40'000; // of the ghost; more would be felt at each turn of the view
const QColor valueColor(0xff, 0xb0, 0x2e);
const QColor rimColor(0, 0, 0, 110);

QPointF pointOf(const Pixel& pixel)
{
    return {pixel.x, pixel.y};
}

QColor frameColor(const QWidget& widget)
{
    return widget.palette().color(QPalette::Highlight);
}

void drawHead(QPainter& painter, const QPointF& tip, const QPointF& along)
{
    const QPointF across(-along.y(), along.x());
    const QPointF neck = tip - arrowHead * along;
    painter.drawPolygon(QPolygonF({tip, neck + 0.5 * arrowHead * across, neck - 0.5 * arrowHead * across}));
}

/// To both sides of a place, with a dark rim so that it is seen on anything.
void drawDoubleArrow(QPainter& painter, const QPointF& place, const QPointF& along, const QColor& color, double width)
{
    const QPointF first = place - arrowLength * along;
    const QPointF last = place + arrowLength * along;
    for (const auto& [pen, extra] : {std::pair(rimColor, 2.4), std::pair(color, 0.0)}) {
        painter.setPen(QPen(pen, width + extra, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(first + 0.6 * arrowHead * along, last - 0.6 * arrowHead * along);
    }
    painter.setPen(QPen(rimColor, 1));
    painter.setBrush(color);
    drawHead(painter, first, -along);
    drawHead(painter, last, along);
}

} // namespace

DeformHandles::DeformHandles(Document& document, ViewportWidget& view)
    : ViewHand(document, view)
    , m_overlay(new ViewOverlay(view, *this, "deformHandles"))
{
}

void DeformHandles::show(const DeformFrames& frames, const FramePointer& ghost)
{
    m_frames = frames;
    setGhost(ghost);
    m_overlay->refresh();
}

void DeformHandles::setGhost(const FramePointer& ghost)
{
    if (std::exchange(m_ghost, ghost) == ghost)
        return;
    m_ghostBox = {};
    m_ghostEdges = 0;
    if (!m_ghost)
        return;
    for (std::size_t b = 0; b < m_ghost->bodies.size(); ++b) {
        m_ghostEdges += m_ghost->filled[b]->render.edges.size();
        for (const Vec3& place : m_ghost->bodies[b]->places)
            m_ghostBox.extend(place);
    }
}

void DeformHandles::showGhost(const FramePointer& ghost)
{
    m_frames.reset();
    m_drag.reset();
    setGhost(ghost);
    m_overlay->refresh();
}

void DeformHandles::hide()
{
    showGhost(nullptr);
    setLit(DeformHandle::none);
}

DeformHandle DeformHandles::handleAt(const QPointF& position) const
{
    DeformHandle nearest = DeformHandle::none;
    double least = grabReach;
    if (m_frames && !m_view.isPressedAside())
        for (const DeformHandle handle : {DeformHandle::value, DeformHandle::from, DeformHandle::to})
            if (const auto seen = m_view.widgetPosition(m_frames->placeOf(handle))) {
                const double reach = QLineF(*seen, position).length();
                if (reach < least) {
                    least = reach;
                    nearest = handle;
                }
            }
    return nearest;
}

void DeformHandles::setLit(DeformHandle handle)
{
    if (std::exchange(m_lit, handle) == handle)
        return;
    m_view.setCursor(handle == DeformHandle::none ? m_view.usualCursor() : Qt::PointingHandCursor);
    m_overlay->refresh();
}

bool DeformHandles::mousePressed(QMouseEvent& event)
{
    if (event.button() != Qt::LeftButton)
        return false;
    const DeformHandle handle = handleAt(event.position());
    if (handle == DeformHandle::none)
        return false;
    const auto seen = m_view.widgetPosition(m_frames->placeOf(handle));
    m_drag = Drag{handle, m_frames->valueOf(handle), event.position() - *seen};
    m_cursor = event.position();
    m_view.setFocus(Qt::MouseFocusReason);
    setLit(handle);
    m_view.setCursor(Qt::ClosedHandCursor);
    return true;
}

bool DeformHandles::mouseMoved(QMouseEvent& event)
{
    m_cursor = event.position();
    if (!m_drag) {
        if (m_frames && event.buttons() == Qt::NoButton)
            setLit(handleAt(m_cursor));
        return m_lit != DeformHandle::none && event.buttons() == Qt::NoButton;
    }
    if (m_view.navigatesWith(event.buttons()))
        return false;
    if (!(event.buttons() & Qt::LeftButton) || !m_frames)
        return true;
    const DeformHandle handle = m_drag->handle;
    double value = m_frames->draggedTo(handle, pixelOf(m_cursor - m_drag->aside), m_view.camera(), m_view.window());
    if (event.modifiers() & Qt::ControlModifier)
        value = snapped(value, m_frames->quantityOf(handle));
    m_frames = m_frames->with(handle, value);
    m_overlay->refresh();
    emit dragged(handle, m_frames->valueOf(handle));
    return true;
}

bool DeformHandles::mouseReleased(QMouseEvent& event)
{
    if (!m_drag || event.button() != Qt::LeftButton)
        return false;
    m_drag.reset();
    setLit(DeformHandle::none);
    setLit(handleAt(event.position()));
    m_overlay->refresh();
    return true;
}

void DeformHandles::mouseLeft()
{
    if (!m_drag)
        setLit(DeformHandle::none);
}

bool DeformHandles::wantsKey(const QKeyEvent& event) const
{
    const bool isEnter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    return (isEnter && (m_frames || m_ghost)) || (m_drag && event.key() == Qt::Key_Escape);
}

bool DeformHandles::keyPressed(QKeyEvent& event)
{
    if (!wantsKey(event))
        return false;
    if (event.key() == Qt::Key_Escape) {
        const Drag given = *std::exchange(m_drag, {});
        m_frames = m_frames->with(given.handle, given.before);
        setLit(DeformHandle::none);
        m_overlay->refresh();
        emit dragged(given.handle, given.before);
    } else if (!event.isAutoRepeat() && !m_drag)
        emit confirmed();
    return true;
}

QString DeformHandles::note() const
{
    const double value = m_frames->valueOf(m_drag->handle);
    constexpr int digits = 4;
    const Quantity quantity = m_frames->quantityOf(m_drag->handle);
    return quantity == Quantity::Number ? localNumber(value, 'g', digits) : formatReading(value, quantity);
}

QRect DeformHandles::overlayArea() const
{
    QPolygonF seen;
    const auto add = [&](const Vec3& place) {
        if (const auto pixel = m_view.widgetPosition(place))
            seen << *pixel;
    };
    if (m_frames) {
        for (const DeformHandle plane : {DeformHandle::from, DeformHandle::to})
            for (const Vec3& corner : m_frames->cornersOf(plane))
                add(corner);
        add(m_frames->placeOf(DeformHandle::value));
    }
    if (!m_ghostBox.isEmpty())
        for (int corner = 0; corner < 8; ++corner)
            add(m_ghostBox.corner(static_cast<Box::CornerType>(corner)));
    if (seen.isEmpty())
        return {};
    QRect area = seen.boundingRect().adjusted(-areaMargin, -areaMargin, areaMargin, areaMargin).toAlignedRect();
    if (m_drag)
        area |= cursorNoteArea(note(), m_cursor, m_view.rect(), m_overlay->font());
    return area;
}

void DeformHandles::drawGhost(QPainter& painter) const
{
    if (m_ghostEdges > mostEdges)
        return;
    const Projector project(m_view.camera(), m_view.window());
    QList<QLineF> lines;
    for (std::size_t b = 0; b < m_ghost->bodies.size(); ++b) {
        const RenderMesh& mesh = m_ghost->filled[b]->render;
        if (m_view.options().hiddenParts.contains(m_ghost->filled[b]->part))
            continue;
        for (const auto& edge : mesh.edges) {
            const auto from = project(m_ghost->bodies[b]->point(edge[0]));
            const auto to = project(m_ghost->bodies[b]->point(edge[1]));
            if (from && to)
                lines << QLineF(pointOf(*from), pointOf(*to));
        }
    }
    QColor color = m_overlay->palette().color(QPalette::PlaceholderText);
    color.setAlphaF(0.75F);
    painter.setPen(QPen(color, 1, Qt::SolidLine));
    painter.drawLines(lines);
}

void DeformHandles::drawPlane(QPainter& painter, DeformHandle plane) const
{
    QPolygonF corners;
    for (const Vec3& corner : m_frames->cornersOf(plane))
        if (const auto seen = m_view.widgetPosition(corner))
            corners << *seen;
    QColor color = frameColor(*m_overlay);
    painter.setPen(QPen(color, m_lit == plane ? 2.6 : 1.6));
    color.setAlphaF(m_lit == plane ? 0.20F : 0.09F);
    painter.setBrush(color);
    painter.drawPolygon(corners);
}

/// In the view, of unit length: where the handle goes when its value grows.
QPointF DeformHandles::directionOf(DeformHandle handle) const
{
    const double step = 1e-3 * (handle == DeformHandle::value && m_frames->quantityOf(handle) != Quantity::Length
                                    ? 1
                                    : m_frames->box.diagonal().norm());
    const auto here = m_view.widgetPosition(m_frames->placeOf(handle));
    const auto next = m_view.widgetPosition(m_frames->with(handle, m_frames->valueOf(handle) + step).placeOf(handle));
    const auto last = m_view.widgetPosition(m_frames->with(handle, m_frames->valueOf(handle) - step).placeOf(handle));
    if (!here || !next || !last)
        return {1, 0};
    const QPointF way = *next - *last;
    const double length = std::hypot(way.x(), way.y());
    return length > 1e-9 ? way / length : QPointF(1, 0);
}

void DeformHandles::drawArrow(QPainter& painter, DeformHandle plane) const
{
    if (const auto place = m_view.widgetPosition(m_frames->placeOf(plane)))
        drawDoubleArrow(painter, *place, directionOf(plane), frameColor(*m_overlay), m_lit == plane ? 4 : 2.6);
}

void DeformHandles::drawKnob(QPainter& painter) const
{
    const auto place = m_view.widgetPosition(m_frames->placeOf(DeformHandle::value));
    if (!place)
        return;
    const bool isLit = m_lit == DeformHandle::value;
    drawDoubleArrow(painter, *place, directionOf(DeformHandle::value), valueColor, isLit ? 4 : 2.6);
    painter.setPen(QPen(rimColor, 1.5));
    painter.setBrush(valueColor);
    painter.drawEllipse(*place, knobRadius + (isLit ? 2 : 0), knobRadius + (isLit ? 2 : 0));
}

void DeformHandles::drawOverlay(QPainter& painter) const
{
    if (m_ghost)
        drawGhost(painter);
    if (!m_frames)
        return;
    for (const DeformHandle plane : {DeformHandle::from, DeformHandle::to})
        drawPlane(painter, plane);
    for (const DeformHandle plane : {DeformHandle::from, DeformHandle::to})
        drawArrow(painter, plane);
    drawKnob(painter);
    if (m_drag)
        drawCursorNote(painter, note(), cursorNoteArea(note(), m_cursor, m_view.rect(), m_overlay->font()),
                       m_overlay->palette());
}

} // namespace knead
