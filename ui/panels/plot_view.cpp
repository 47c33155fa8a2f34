#include "ui/panels/plot_view.h"

#include "ui/panels/plot_strokes.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr double left = 78; // of the area [pixels]
constexpr double right = 14;
constexpr double top = 24;
constexpr double bottom = 28;
constexpr double labelSpacing = 90;   // along x [pixels]
constexpr double rowSpacing = 34;     // along y [pixels]
constexpr double shortestTime = 1e-6; // that is plotted, also of a single moment [s]

bool hasPoints(const std::vector<PlotLine>& all)
{
    return std::any_of(all.begin(), all.end(), [](const PlotLine& line) { return !line.points.empty(); });
}

/// The last value at or before x; none where the line has not begun or is interrupted.
std::optional<double> valueAt(const PlotLine& line, double x)
{
    auto next = std::upper_bound(line.points.begin(), line.points.end(), x,
                                 [](double at, const QPointF& point) { return at < point.x(); });
    if (next == line.points.begin())
        return std::nullopt;
    const double value = (--next)->y();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace

double roundStep(double least)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1 - 1e-9))
            return factor * power;
    return 10 * power;
}

PlotView::PlotView(QWidget* parent)
    : QWidget(parent)
{
    setObjectName("plot");
    setMouseTracking(true);
    setFocusPolicy(Qt::NoFocus);
}

QSize PlotView::sizeHint() const
{
    return {520, 150};
}

QSize PlotView::minimumSizeHint() const
{
    return {220, 90};
}

void PlotView::show(std::vector<PlotLine> lines, Quantity quantity, const QString& title)
{
    m_lines = std::move(lines);
    m_quantity = quantity;
    m_title = title;
    update();
}

void PlotView::setHint(const QString& hint)
{
    m_hint = hint;
    update();
}

PlotView::Axis PlotView::fitted(double lowest, double highest, double labels) const
{
    const double size = std::max({highest - lowest, 1e-9 * std::max(std::abs(lowest), std::abs(highest)), 1e-12});
    const double step = roundStep(size / std::max(1.0, labels));
    return {std::floor(lowest / step + 1e-9) * step, std::ceil(highest / step - 1e-9) * step, step};
}

/// Time to its end; values from 0, so that small noise stays small.
void PlotView::fitAxes()
{
    double last = 0;
    double first = std::numeric_limits<double>::max();
    double lowest = 0;
    double highest = 0;
    for (const PlotLine& line : m_lines)
        for (const QPointF& point : line.points) {
            first = std::min(first, point.x());
            last = std::max(last, point.x());
            if (std::isfinite(point.y())) {
                lowest = std::min(lowest, point.y());
                highest = std::max(highest, point.y());
            }
        }
    first = std::min(first, last);
    last = std::max(last, first + shortestTime);
    m_x = fitted(first, last, area().width() / labelSpacing);
    m_x.begin = first;
    m_x.end = last;
    m_y = fitted(lowest, highest, area().height() / rowSpacing);
    if (m_y.end <= m_y.begin)
        m_y.end = m_y.begin + m_y.step;
}

QRectF PlotView::area() const
{
    return {left, top, std::max(10.0, width() - left - right), std::max(10.0, height() - top - bottom)};
}

QPointF PlotView::pixelOf(const QPointF& value) const
{
    const QRectF box = area();
    return {box.left() + (value.x() - m_x.begin) / (m_x.end - m_x.begin) * box.width(),
            box.bottom() - (value.y() - m_y.begin) / (m_y.end - m_y.begin) * box.height()};
}

void PlotView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (!hasPoints(m_lines)) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(16, 8, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, m_hint);
        return;
    }
    fitAxes();
    paintGrid(painter);
    paintLines(painter);
    paintLegend(painter);
    paintCursor(painter);
}

void PlotView::paintGrid(QPainter& painter) const
{
    const QRectF box = area();
    const QColor line = palette().color(QPalette::Mid);
    const QColor words = palette().color(QPalette::PlaceholderText);
    QFont small = font();
    small.setPointSizeF(0.88 * small.pointSizeF());
    painter.setFont(small);
    const double firstX = std::ceil(m_x.begin / m_x.step - 1e-9) * m_x.step;
    for (double x = firstX; x <= m_x.end + 1e-9 * m_x.step; x += m_x.step) {
        const QPointF at = pixelOf({x, m_y.begin});
        painter.setPen(QPen(line, 1));
        painter.drawLine(QPointF(at.x(), box.top()), QPointF(at.x(), box.bottom()));
        painter.setPen(words);
        const QString time = formatReading(std::abs(x) < 1e-9 * m_x.step ? 0 : x, Quantity::Time);
        const double size = painter.fontMetrics().horizontalAdvance(time) + 2;
        const double from = std::min(at.x() - size / 2, width() - size); // the last one would be cut off
        painter.drawText(QRectF(from, box.bottom() + 4, size, 20), Qt::AlignHCenter | Qt::AlignTop, time);
    }
    const int rows = static_cast<int>(std::lround((m_y.end - m_y.begin) / m_y.step));
    for (int row = 0; row <= rows; ++row) {
        const double y = m_y.begin + row * m_y.step;
        const QPointF at = pixelOf({m_x.begin, y});
        const bool isZero = std::abs(y) < 1e-9 * m_y.step;
        painter.setPen(QPen(isZero ? words : line, 1));
        painter.drawLine(QPointF(box.left(), at.y()), QPointF(box.right(), at.y()));
        painter.setPen(words);
        painter.drawText(QRectF(0, at.y() - 10, left - 8, 20), Qt::AlignRight | Qt::AlignVCenter,
                         formatReading(isZero ? 0 : y, m_quantity));
    }
}

void PlotView::paintLines(QPainter& painter) const
{
    painter.setClipRect(area().adjusted(-2, -2, 2, 2));
    for (const PlotLine& line : m_lines) {
        painter.setPen(QPen(line.color, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        QPolygonF whole;
        const auto finish = [&] { strokeInPieces(painter, thinned(std::exchange(whole, {}))); };
        for (const QPointF& point : line.points)
            if (std::isfinite(point.y()))
                whole << pixelOf(point);
            else
                finish();
        finish();
    }
    painter.setClipping(false);
}

void PlotView::paintLegend(QPainter& painter) const
{
    QFont strong = font();
    strong.setWeight(QFont::DemiBold);
    painter.setFont(strong);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QPointF(8, top - 9), m_title);
    double x = std::max(left, 8.0 + painter.fontMetrics().horizontalAdvance(m_title) + 20);
    painter.setFont(font());
    for (const PlotLine& line : m_lines) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(line.color);
        painter.drawRoundedRect(QRectF(x, top - 17, 10, 10), 2, 2);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QPointF(x + 15, top - 8), line.name);
        x += 15 + painter.fontMetrics().horizontalAdvance(line.name) + 16;
    }
}

/// A line through the time under the mouse, and what the lines are there.
void PlotView::paintCursor(QPainter& painter) const
{
    const QRectF box = area();
    if (!m_cursor || *m_cursor < box.left() || *m_cursor > box.right())
        return;
    const double x = m_x.begin + (*m_cursor - box.left()) / box.width() * (m_x.end - m_x.begin);
    painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DashLine));
    painter.drawLine(QPointF(*m_cursor, box.top()), QPointF(*m_cursor, box.bottom()));
    QStringList rows{formatReading(x, Quantity::Time)};
    for (const PlotLine& line : m_lines)
        if (const auto value = valueAt(line, x)) {
            rows << QStringLiteral("%1: %2").arg(line.name, formatReading(*value, m_quantity));
            painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
            painter.setBrush(line.color);
            painter.drawEllipse(pixelOf({x, *value}), 4, 4);
        }
    const QString text = rows.join('\n');
    QRectF label = painter.boundingRect(QRectF(0, 0, 400, 400), Qt::AlignLeft, text).adjusted(-6, -4, 6, 4);
    label.moveTop(box.top() + 4);
    label.moveLeft(*m_cursor + 10 + label.width() < box.right() ? *m_cursor + 10 : *m_cursor - 10 - label.width());
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(palette().color(QPalette::ToolTipBase));
    painter.drawRoundedRect(label, 4, 4);
    painter.setPen(palette().color(QPalette::ToolTipText));
    painter.drawText(label.adjusted(6, 4, -6, -4), Qt::AlignLeft, text);
}

void PlotView::mouseMoveEvent(QMouseEvent* event)
{
    m_cursor = event->position().x();
    update();
}

void PlotView::leaveEvent(QEvent* event)
{
    m_cursor.reset();
    update();
    QWidget::leaveEvent(event);
}

} // namespace knead
