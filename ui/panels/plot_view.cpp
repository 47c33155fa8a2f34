#include "ui/panels/plot_view.h"

#include "ui/panels/plot_strokes.h"
#include "ui/screen_reader.h"
#include "ui/theme.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr double right = 14;          // of the area [pixels]
constexpr double labelSpacing = 90;   // along x [pixels]
constexpr double rowSpacing = 34;     // along y [pixels]
constexpr double shortestTime = 1e-6; // that is plotted, also of a single moment [s]

// Of the area, with room for texts of any size [pixels].
double areaLeft()
{
    return withText(78);
}

double areaTop()
{
    return withText(24);
}

double areaBottom()
{
    return withText(28);
}

bool hasPoints(const std::vector<PlotLine>& all)
{
    return std::any_of(all.begin(), all.end(), [](const PlotLine& line) { return !line.points.empty(); });
}

/// What an axis goes to where there is nothing but 0, SI.
double smallOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Length:
        return 1e-3;
    case Quantity::Pressure:
        return 1e3;
    case Quantity::Strain:
        return 0.01;
    default:
        return 1;
    }
}

/// The sample nearest to x; none where the line has not begun or is interrupted.
std::optional<QPointF> sampleAt(const PlotLine& line, double x)
{
    auto next = std::lower_bound(line.points.begin(), line.points.end(), x,
                                 [](const QPointF& point, double at) { return point.x() < at; });
    if (next == line.points.end() || (next != line.points.begin() && x - std::prev(next)->x() < next->x() - x)) {
        if (next == line.points.begin())
            return std::nullopt;
        --next;
    }
    return std::isfinite(next->y()) ? std::optional(*next) : std::nullopt;
}

} // namespace

PlotView::PlotView(QWidget* parent)
    : QWidget(parent)
{
    setObjectName("plot");
    setMouseTracking(true);
    setFocusPolicy(Qt::NoFocus);
    readAs(*this, QAccessible::Chart, [this] { return spoken(); });
}

QSize PlotView::sizeHint() const
{
    return {520, 150};
}

QSize PlotView::minimumSizeHint() const
{
    return {220, 90};
}

void PlotView::show(std::vector<PlotLine> lines, Quantity quantity, const QString& title,
                    const std::optional<PlotRange>& least)
{
    m_least = least;
    m_lines = std::move(lines);
    m_quantity = quantity;
    m_title = title;
    setAccessibleName(title);
    update();
}

void PlotView::setHint(const QString& hint)
{
    m_hint = hint;
    update();
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
            if (!isHidden(line) && std::isfinite(point.y())) {
                lowest = std::min(lowest, point.y());
                highest = std::max(highest, point.y());
            }
        }
    if (m_least) {
        first = std::min(first, m_least->begin);
        last = std::max(last, m_least->end);
    }
    first = std::min(first, last);
    last = std::max(last, first + shortestTime);
    if (lowest == highest)
        highest = smallOf(m_quantity); // all of it is 0
    m_x = PlotAxis::between(first, last, area().width() / labelSpacing);
    m_y = PlotAxis::around(lowest, highest, area().height() / rowSpacing);
}

QRectF PlotView::area() const
{
    return {areaLeft(), areaTop(), std::max(10.0, width() - areaLeft() - right),
            std::max(10.0, height() - areaTop() - areaBottom())};
}

QPointF PlotView::placeOf(const QPointF& value) const
{
    const QRectF box = area();
    return {box.left() + m_x.shareOf(value.x()) * box.width(), box.bottom() - m_y.shareOf(value.y()) * box.height()};
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
    for (const double x : m_x.labels()) {
        const QPointF at = placeOf({x, m_y.begin});
        painter.setPen(QPen(line, 1));
        painter.drawLine(QPointF(at.x(), box.top()), QPointF(at.x(), box.bottom()));
        painter.setPen(words);
        const QString time = formatReading(x, Quantity::Time);
        const double size = painter.fontMetrics().horizontalAdvance(time) + 2;
        const double from = std::min(at.x() - size / 2, width() - size); // the last one would be cut off
        painter.drawText(QRectF(from, box.bottom() + 4, size, withText(20)), Qt::AlignHCenter | Qt::AlignTop, time);
    }
    for (const double y : m_y.labels()) {
        const QPointF at = placeOf({m_x.begin, y});
        painter.setPen(QPen(y == 0 ? words : line, 1));
        painter.drawLine(QPointF(box.left(), at.y()), QPointF(box.right(), at.y()));
        painter.setPen(words);
        painter.drawText(QRectF(0, at.y() - withText(10), areaLeft() - 8, withText(20)),
                         Qt::AlignRight | Qt::AlignVCenter, formatReading(y, m_quantity));
    }
}

void PlotView::paintLines(QPainter& painter) const
{
    painter.setClipRect(area().adjusted(-2, -2, 2, 2));
    for (const PlotLine& line : m_lines) {
        if (isHidden(line))
            continue;
        painter.setPen(QPen(line.color, 2, line.style, Qt::RoundCap, Qt::RoundJoin));
        QPolygonF whole;
        const auto finish = [&] { strokeInPieces(painter, thinned(std::exchange(whole, {}))); };
        for (const QPointF& point : line.points)
            if (std::isfinite(point.x()) && std::isfinite(point.y()))
                whole << placeOf(point);
            else
                finish();
        finish();
    }
    painter.setClipping(false);
}

QFont PlotView::titleFont() const
{
    QFont strong = font();
    strong.setWeight(QFont::DemiBold);
    return strong;
}

QRectF PlotView::legendArea(std::size_t line) const
{
    double x = std::max(areaLeft(), 8.0 + QFontMetrics(titleFont()).horizontalAdvance(m_title) + 20);
    const auto widthOf = [this](const PlotLine& one) { return 15 + fontMetrics().horizontalAdvance(one.name); };
    for (std::size_t i = 0; i < line; ++i)
        x += widthOf(m_lines[i]) + 16;
    return {x, 0, static_cast<double>(widthOf(m_lines[line])), areaTop()};
}

void PlotView::paintLegend(QPainter& painter) const
{
    painter.setFont(titleFont());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QPointF(8, areaTop() - 9), m_title);
    painter.setFont(font());
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const double x = legendArea(i).left();
        painter.setOpacity(isHidden(m_lines[i]) ? 0.4 : 1);
        painter.setPen(QPen(m_lines[i].color, 3, m_lines[i].style, Qt::FlatCap));
        painter.drawLine(QPointF(x, areaTop() - 12), QPointF(x + 12, areaTop() - 12));
        painter.setOpacity(1);
        painter.setPen(palette().color(isHidden(m_lines[i]) ? QPalette::Disabled : QPalette::Active, QPalette::Text));
        painter.drawText(QPointF(x + 15, areaTop() - 8), m_lines[i].name);
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
    QStringList rows;
    double time = x;
    for (const PlotLine& line : m_lines)
        if (const auto sample = sampleAt(line, x); sample && !isHidden(line)) {
            time = sample->x();
            rows << QStringLiteral("%1: %2").arg(line.name, formatReading(sample->y(), m_quantity));
            painter.setPen(QPen(palette().color(QPalette::Base), 1.5));
            painter.setBrush(line.color);
            painter.drawEllipse(placeOf(*sample), 4, 4);
        }
    rows.prepend(formatReading(time, Quantity::Time));
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

/// For those who do not see it: what the lines come to.
QString PlotView::spoken() const
{
    QStringList ends;
    for (const PlotLine& line : m_lines)
        if (!line.points.empty() && !isHidden(line) && std::isfinite(line.points.back().y()))
            ends << QStringLiteral("%1: %2").arg(line.name, formatReading(line.points.back().y(), m_quantity));
    return ends.isEmpty() ? m_hint : ends.join(QStringLiteral(", "));
}

void PlotView::mousePressEvent(QMouseEvent* event)
{
    for (std::size_t i = 0; i < m_lines.size(); ++i)
        if (legendArea(i).contains(event->position())) {
            if (m_hidden.erase(m_lines[i].id) == 0)
                m_hidden.insert(m_lines[i].id);
            update();
        }
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
