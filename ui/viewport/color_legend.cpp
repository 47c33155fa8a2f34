#include "ui/viewport/color_legend.h"

#include "ui/viewport/skin_shading.h"

#include <QCoreApplication>
#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

// In heights of a line.
constexpr double padding = 0.6;
constexpr double barWidth = 0.95;
constexpr double barHeight = 11;
constexpr double leastBarHeight = 4; // in low views
constexpr double tickLength = 0.3;
constexpr double remarkWidth = 13;

int lines(const QFontMetrics& metrics, double count)
{
    return static_cast<int>(std::lround(count * metrics.height()));
}

constexpr int keptClear = 126; // of the height of a view: the view cube above, and the corner [pixels]

QRect remarkBox(const QFontMetrics& metrics, const QString& remark)
{
    return metrics.boundingRect(QRect(0, 0, lines(metrics, remarkWidth), 10'000), Qt::TextWordWrap, remark);
}

QString remarkOf(const ColorScale& scale, bool isPast)
{
    if (scale.isKnown)
        return {};
    if (isPast)
        return ColorLegend::tr("Looking back does not keep this of material that has flowed or is pressed: "
                               "return to the present, or choose displacement or strain.");
    return ColorLegend::tr("This moment does not tell it yet: it comes with the next step.");
}

} // namespace

QSize legendSize(const QFontMetrics& metrics, const ScaleText& text, const QString& remark)
{
    const int margin = 2 * lines(metrics, padding);
    const int title = metrics.horizontalAdvance(text.title);
    if (!remark.isEmpty()) {
        const QSize box = remarkBox(metrics, remark).size();
        return {std::max(title, box.width()) + margin, box.height() + lines(metrics, 1.4) + margin};
    }
    int numbers = 0;
    for (const ScaleText::Tick& tick : text.ticks)
        numbers = std::max(numbers, metrics.horizontalAdvance(tick.text));
    const int row = lines(metrics, barWidth + 2 * tickLength) + numbers;
    return {std::max(title, row) + margin, lines(metrics, barHeight + 2.1) + margin};
}

void paintLegend(QPainter& painter, const QRect& place, const ColorScale& scale, const ScaleText& text,
                 const QString& remark, const LegendColors& colors)
{
    const QFontMetrics metrics = painter.fontMetrics();
    const int margin = lines(metrics, padding);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(colors.line);
    painter.setBrush(colors.ground);
    painter.drawRoundedRect(QRectF(place).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
    const QRect inside = place.adjusted(margin, margin, -margin, -margin);
    painter.setPen(colors.text);
    painter.drawText(inside, Qt::AlignTop | Qt::AlignLeft, text.title);
    if (!remark.isEmpty()) {
        painter.drawText(inside.adjusted(0, lines(metrics, 1.4), 0, 0), Qt::TextWordWrap, remark);
        return;
    }
    const int high = std::min(lines(metrics, barHeight), inside.height() - lines(metrics, 1.6) - lines(metrics, 0.5));
    const QRect bar(inside.left(), inside.top() + lines(metrics, 1.6), lines(metrics, barWidth), high);
    const ColorTable& table = colorTable(scale.map);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (int y = 0; y < bar.height(); ++y) {
        const auto& color =
            table[static_cast<std::size_t>(255 * (bar.height() - 1 - y) / std::max(1, bar.height() - 1))];
        painter.fillRect(QRect(bar.left(), bar.top() + y, bar.width(), 1), QColor(color[0], color[1], color[2]));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(colors.line);
    painter.drawRect(bar.adjusted(0, 0, -1, -1));
    painter.setPen(colors.text);
    const bool areDense = static_cast<int>(text.ticks.size()) * metrics.height() > high + metrics.height();
    for (std::size_t t = 0; t < text.ticks.size(); t += areDense ? 2 : 1) {
        const ScaleText::Tick& tick = text.ticks[t];
        const int y = bar.top() + static_cast<int>(std::lround((1 - tick.share) * (bar.height() - 1)));
        const int end = bar.right() + 1 + lines(metrics, tickLength);
        painter.drawLine(bar.right() + 1, y, end, y);
        painter.drawText(
            QRect(end + lines(metrics, tickLength), y - metrics.height() / 2, inside.width(), metrics.height()),
            Qt::AlignLeft | Qt::AlignVCenter, tick.text);
    }
}

ColorLegend::ColorLegend(QWidget* parent)
    : QWidget(parent)
{
    setObjectName("colorLegend");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void ColorLegend::show(const ColorScale& scale, bool isPast)
{
    const QString remark = remarkOf(scale, isPast);
    if (isVisible() && !m_isCurvature && scale == m_scale && remark == m_remark) {
        resize(sizeHint()); // the view may be of another height
        return;
    }
    m_isCurvature = false;
    m_scale = scale;
    m_remark = remark;
    say();
    QWidget::show();
}

void ColorLegend::showCurvature()
{
    if (isVisible() && m_isCurvature) {
        resize(sizeHint());
        return;
    }
    m_isCurvature = true;
    m_scale = curvatureScale();
    m_remark.clear();
    say();
    QWidget::show();
}

/// In words and units of now.
void ColorLegend::say()
{
    m_text = m_isCurvature ? curvatureText() : textOf(m_scale);
    QStringList numbers;
    for (const ScaleText::Tick& tick : m_text.ticks)
        numbers << tick.text;
    setAccessibleName(m_text.title);
    setAccessibleDescription(m_remark.isEmpty() ? numbers.join(", ") : m_remark);
    resize(sizeHint());
    update();
}

/// Comes with another unit of lengths, too.
void ColorLegend::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && isVisible())
        say();
}

QSize ColorLegend::sizeHint() const
{
    QSize size = legendSize(fontMetrics(), m_text, m_remark);
    if (m_remark.isEmpty()) {
        const int least = size.height() - lines(fontMetrics(), barHeight - leastBarHeight);
        size.setHeight(std::clamp(parentWidget()->height() - keptClear, least, size.height()));
    }
    return size;
}

void ColorLegend::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    QColor ground = palette().color(QPalette::ToolTipBase);
    ground.setAlpha(225);
    paintLegend(painter, rect(), m_scale, m_text, m_remark,
                {ground, palette().color(QPalette::WindowText), palette().color(QPalette::Mid)});
}

} // namespace knead
