#include "ui/panels/force_plot.h"

#include "ui/panels/plot_strokes.h"
#include "ui/units.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr int leftMargin = 56;
constexpr int rightMargin = 14;
constexpr int bottomMargin = 34;
constexpr int legendHeight = 24;
constexpr int swatch = 14;

// Okabe and Ito's colors, told apart by everyone; in an order that is strong on white and on black.
const std::array<QColor, 7> curveColors = {QColor(0xe6, 0x7e, 0x00), QColor(0x1f, 0x83, 0xd6), QColor(0x00, 0x9e, 0x73),
                                           QColor(0xcc, 0x5f, 0xa0), QColor(0xd5, 0x3e, 0x2a), QColor(0x56, 0xb4, 0xe9),
                                           QColor(0xb8, 0xa8, 0x1e)};

struct ForceUnit {
    double newtons;
    const char* name;
};
constexpr ForceUnit units[] = {{1e-6, "µN"}, {1e-3, "mN"}, {1, "N"}, {1e3, "kN"}, {1e6, "MN"}};

ForceUnit unitFor(double largest)
{
    ForceUnit best = units[2];
    if (largest > 0)
        best = units[0];
    for (const ForceUnit& unit : units)
        if (largest >= unit.newtons)
            best = unit;
    return best;
}

QString tickText(double value, double step)
{
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    return QString::number(std::abs(value) < step / 1e6 ? 0 : value, 'f', decimals);
}

} // namespace

ForcePlot::ForcePlot(QWidget* parent)
    : QWidget(parent)
{
    setObjectName("forcePlot");
    setMouseTracking(true);
}

void ForcePlot::show(ForceRecord record)
{
    m_record = std::move(record);
    fitScales();
    update();
}

void ForcePlot::show(ForceComponent component)
{
    m_component = component;
    fitScales();
    update();
}

bool ForcePlot::isHidden(std::size_t curve) const
{
    const ForceRecord::Curve& it = m_record.curves[curve];
    return m_hidden.contains({it.isTool, it.id});
}

/// Steps of 1, 2 or 5 times a power of ten, with ends on whole steps.
ForcePlot::Scale ForcePlot::niceScale(double low, double high, int ticks)
{
    const double rough = std::max(high - low, 1e-12) / std::max(ticks, 1);
    const double power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {5.0, 2.0, 1.0})
        if (factor * power >= rough * (1 - 1e-9))
            step = factor * power;
    return {step * std::floor(low / step + 1e-9), step * std::ceil(high / step - 1e-9), step};
}

void ForcePlot::fitScales()
{
    double low = 0;
    double high = 0;
    for (std::size_t c = 0; c < m_record.curves.size(); ++c) {
        if (isHidden(c))
            continue;
        for (const std::optional<Vec3>& force : m_record.curves[c].forces)
            if (force) {
                low = std::min(low, valueOf(*force, m_component));
                high = std::max(high, valueOf(*force, m_component));
            }
    }
    const ForceUnit unit = unitFor(std::max(-low, high));
    m_unit = unit.newtons;
    m_unitName = QString::fromUtf8(unit.name);
    if (high == low)
        high = low + m_unit;
    const QRectF area = plotArea();
    m_forces = niceScale(low / m_unit, high / m_unit, std::max(2, static_cast<int>(area.height() / 32)));
    m_times = niceScale(0, std::max(m_record.end, 0.1), std::max(2, static_cast<int>(area.width() / 90)));
    m_times.high = std::max(m_record.end, 0.1); // time needs no room beyond its end
}

QRectF ForcePlot::plotArea() const
{
    return QRectF(rect()).adjusted(leftMargin, legendHeight + 4, -rightMargin, -bottomMargin);
}

QPointF ForcePlot::placeOf(double time, double force) const
{
    const QRectF area = plotArea();
    const double x = area.left() + area.width() * (time - m_times.low) / (m_times.high - m_times.low);
    const double y = area.bottom() - area.height() * (force / m_unit - m_forces.low) / (m_forces.high - m_forces.low);
    return {x, y};
}

QColor ForcePlot::colorOf(std::size_t curve) const
{
    return curveColors[curve % curveColors.size()];
}

void ForcePlot::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    fitScales(); // the size decides how many numbers there is room for
    drawAxes(painter);
    if (m_record.curves.empty() || m_record.times.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(plotArea(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Add a tool and press Space: forces over time appear here."));
        return;
    }
    painter.save();
    painter.setClipRect(plotArea().adjusted(-1, -2, 1, 2));
    for (std::size_t c = m_record.curves.size(); c-- > 0;)
        if (!isHidden(c))
            drawCurve(painter, c);
    painter.restore();
    drawLegend(painter);
    drawReadings(painter);
}

void ForcePlot::drawAxes(QPainter& painter) const
{
    const QRectF area = plotArea();
    QColor grid = palette().color(QPalette::Mid);
    grid.setAlphaF(0.6F);
    const QColor text = palette().color(QPalette::PlaceholderText);
    for (double value = m_forces.low; value <= m_forces.high + m_forces.step / 2; value += m_forces.step) {
        const double y = placeOf(0, value * m_unit).y();
        painter.setPen(QPen(grid, std::abs(value) < m_forces.step / 1e3 ? 1.6 : 1));
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(text);
        painter.drawText(QRectF(0, y - 10, leftMargin - 6, 20), Qt::AlignRight | Qt::AlignVCenter,
                         tickText(value, m_forces.step));
    }
    for (double value = 0; value <= m_times.high * (1 + 1e-9); value += m_times.step) {
        const double x = placeOf(value, 0).x();
        painter.setPen(QPen(grid, 1));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(text);
        painter.drawText(QRectF(x - 40, area.bottom() + 3, 80, 16), Qt::AlignHCenter | Qt::AlignTop,
                         tickText(value, m_times.step));
    }
    painter.drawText(QRectF(area.left(), height() - 17, area.width(), 16), Qt::AlignRight | Qt::AlignVCenter,
                     tr("Time [s]"));
    painter.drawText(QRectF(4, 2, leftMargin + 30, legendHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("Force [%1]").arg(m_unitName));
}

void ForcePlot::drawCurve(QPainter& painter, std::size_t curve) const
{
    const ForceRecord::Curve& it = m_record.curves[curve];
    painter.setPen(QPen(colorOf(curve), 1.8, it.isTool ? Qt::SolidLine : Qt::DashLine, Qt::RoundCap, Qt::RoundJoin));
    QPolygonF line;
    const auto finish = [&] { strokeInPieces(painter, thinned(std::exchange(line, {}))); };
    for (std::size_t i = 0; i < it.forces.size(); ++i)
        if (it.forces[i])
            line << placeOf(m_record.times[i], valueOf(*it.forces[i], m_component));
        else
            finish();
    finish();
}

QRect ForcePlot::legendArea(std::size_t curve) const
{
    int left = leftMargin + 44;
    for (std::size_t c = 0; c < m_record.curves.size(); ++c) {
        const int text = fontMetrics().horizontalAdvance(QString::fromStdString(m_record.curves[c].name));
        const QRect area(left, 2, swatch + 6 + text + 10, legendHeight);
        if (c == curve)
            return area;
        left += area.width() + 6;
    }
    return {};
}

void ForcePlot::drawLegend(QPainter& painter) const
{
    for (std::size_t c = 0; c < m_record.curves.size(); ++c) {
        const QRect area = legendArea(c);
        painter.setOpacity(isHidden(c) ? 0.4 : 1);
        painter.setPen(QPen(colorOf(c), 3, m_record.curves[c].isTool ? Qt::SolidLine : Qt::DotLine, Qt::FlatCap));
        painter.drawLine(area.left(), area.center().y(), area.left() + swatch, area.center().y());
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(area.adjusted(swatch + 6, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                         QString::fromStdString(m_record.curves[c].name));
    }
    painter.setOpacity(1);
}

std::size_t ForcePlot::sampleNear(double x) const
{
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < m_record.times.size(); ++i)
        if (std::abs(placeOf(m_record.times[i], 0).x() - x) < std::abs(placeOf(m_record.times[nearest], 0).x() - x))
            nearest = i;
    return nearest;
}

void ForcePlot::drawReadings(QPainter& painter) const
{
    const QRectF area = plotArea();
    if (m_cursor < area.left() || m_cursor > area.right())
        return;
    const std::size_t at = sampleNear(m_cursor);
    const double x = placeOf(m_record.times[at], 0).x();
    painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1, Qt::DotLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    QStringList lines(tr("%1 s").arg(m_record.times[at], 0, 'f', 2));
    for (std::size_t c = 0; c < m_record.curves.size(); ++c) {
        if (isHidden(c) || !m_record.curves[c].forces[at])
            continue;
        const double force = valueOf(*m_record.curves[c].forces[at], m_component);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colorOf(c));
        painter.drawEllipse(placeOf(m_record.times[at], force), 3.5, 3.5);
        lines << QStringLiteral("%1: %2").arg(QString::fromStdString(m_record.curves[c].name),
                                              formatReading(force, Quantity::Force));
    }
    QRectF box = painter.boundingRect(area, Qt::AlignLeft, lines.join('\n')).adjusted(-6, -4, 6, 4);
    box.moveTopLeft({x + 10, area.top() + 4});
    if (box.right() > area.right())
        box.moveRight(x - 10);
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(palette().color(QPalette::ToolTipBase));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(palette().color(QPalette::ToolTipText));
    painter.drawText(box.adjusted(6, 4, -6, -4), Qt::AlignLeft, lines.join('\n'));
}

void ForcePlot::mousePressEvent(QMouseEvent* event)
{
    for (std::size_t c = 0; c < m_record.curves.size(); ++c)
        if (legendArea(c).contains(event->pos())) {
            const std::pair key(m_record.curves[c].isTool, m_record.curves[c].id);
            if (m_hidden.erase(key) == 0)
                m_hidden.insert(key);
            fitScales();
            update();
        }
}

void ForcePlot::mouseMoveEvent(QMouseEvent* event)
{
    m_cursor = event->position().x();
    update();
}

void ForcePlot::leaveEvent(QEvent* event)
{
    m_cursor = -1;
    update();
    QWidget::leaveEvent(event);
}

} // namespace knead
