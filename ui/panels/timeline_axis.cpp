#include "ui/panels/timeline_axis.h"

#include "ui/document/entry_names.h"
#include "ui/panels/plot_axis.h"
#include "ui/screen_reader.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr int margin = 12;       // left and right [px]
constexpr int bandHeight = 6;    // of what was filmed [px]
constexpr int tickHeight = 18;   // [px]
constexpr int grabReach = 5;     // [px]
constexpr int tickSpacing = 70;  // at least, between numbers [px]
constexpr double shortest = 0.1; // the axis is never shorter [s]

QPainterPath star(const QPointF& center, double radius)
{
    constexpr int points = 10;
    QPolygonF polygon;
    for (int i = 0; i < points; ++i) {
        const double angle = M_PI * (2.0 * i / points - 0.5);
        const double distance = i % 2 == 0 ? radius : 0.45 * radius;
        polygon << center + distance * QPointF(std::cos(angle), std::sin(angle));
    }
    QPainterPath path;
    path.addPolygon(polygon);
    path.closeSubpath();
    return path;
}

/// Of the numbers [px].
int rulerHeight()
{
    return withText(16);
}

} // namespace

TimelineAxis::TimelineAxis(std::function<QString(History::Entry)> nameOf, QWidget* parent)
    : QWidget(parent)
    , m_nameOf(std::move(nameOf))
{
    setObjectName("timelineAxis");
    setMouseTracking(true);
    setMinimumWidth(110);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::TabFocus);
    readAs(
        *this, QAccessible::Slider, [this] { return spokenPlace(); },
        [this] {
            return ReadRange{0, m_timeline.end, m_looking.value_or(m_timeline.present)};
        });
    setAccessibleName(tr("Timeline"));
}

QSize TimelineAxis::sizeHint() const
{
    return {400, rulerHeight() + tickHeight + 12};
}

void TimelineAxis::show(Timeline timeline)
{
    m_timeline = std::move(timeline);
    tellReader(*this);
    update();
}

void TimelineAxis::lookAt(std::optional<double> at)
{
    m_looking = at;
    tellReader(*this);
    update();
}

double TimelineAxis::shownLength() const
{
    return std::max(shortest, m_timeline.end);
}

QPoint TimelineAxis::placeOf(double at) const
{
    const double width = std::max(1, this->width() - 2 * margin);
    return {margin + static_cast<int>(std::lround(at / shownLength() * width)), rulerHeight() + tickHeight / 2 + 4};
}

double TimelineAxis::atPlace(double x) const
{
    const double width = std::max(1, this->width() - 2 * margin);
    const double at = std::clamp((x - margin) / width * shownLength(), 0.0, m_timeline.end);
    const Timeline::Tick* tick = m_timeline.tickNear(at, reach());
    return tick == nullptr ? at : tick->at;
}

double TimelineAxis::reach() const
{
    return grabReach * shownLength() / std::max(1, width() - 2 * margin);
}

void TimelineAxis::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    }
    paintRuler(painter);
    if (m_timeline.ticks.empty())
        return;
    paintFilm(painter);
    paintFillings(painter);
    paintTicks(painter);
    paintHeads(painter);
    if (lacksFilm()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(margin, 0, -margin, -1), Qt::AlignHCenter | Qt::AlignBottom,
                         tr("no film kept"));
    }
}

void TimelineAxis::paintRuler(QPainter& painter) const
{
    QFont font = painter.font();
    font.setPointSizeF(0.85 * font.pointSizeF());
    painter.setFont(font);
    const PlotAxis axis = PlotAxis::between(0, shownLength(), 1.0 * (width() - 2 * margin) / tickSpacing);
    for (const double at : axis.labels()) {
        const int x = placeOf(at).x();
        painter.setPen(palette().color(QPalette::Mid));
        painter.drawLine(QPointF(x + 0.5, rulerHeight()), QPointF(x + 0.5, height() - 4));
        painter.setPen(palette().color(QPalette::PlaceholderText));
        const QString text = at == 0 ? tr("0 s") : localNumber(at, 'f', axis.decimals());
        const int textWidth = painter.fontMetrics().horizontalAdvance(text);
        painter.drawText(std::clamp(x - textWidth / 2, 1, width() - textWidth - 1), rulerHeight() - 4, text);
    }
}

/// A groove, filled where there are pictures.
void TimelineAxis::paintFilm(QPainter& painter) const
{
    const int middle = placeOf(0).y();
    const auto band = [&](double from, double to) {
        const int left = placeOf(from).x();
        return QRectF(left, middle - bandHeight / 2, std::max(1, placeOf(to).x() - left), bandHeight);
    };
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    painter.drawRoundedRect(band(0, m_timeline.end), bandHeight / 2.0, bandHeight / 2.0);
    painter.setBrush(palette().color(QPalette::Highlight));
    const auto& pictures = m_timeline.pictures;
    constexpr double gap = 8 * PlaybackCache::interval; // thinned frames are further apart
    const auto tickAt = [&](double at) {
        const Timeline::Tick* tick = m_timeline.tickNear(at, gap);
        return tick == nullptr ? at : tick->at;
    };
    for (std::size_t i = 0; i < pictures.size();) {
        std::size_t last = i;
        while (last + 1 < pictures.size() && pictures[last + 1].at - pictures[last].at < gap)
            ++last;
        const double from = pictures[i].at;
        const double to = pictures[last].at;
        painter.drawRect(band(std::min(from, tickAt(from)), std::max(to, tickAt(to))));
        i = last + 1;
    }
}

/// Small, for they say what the program did, and not a person.
void TimelineAxis::paintFillings(QPainter& painter) const
{
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    for (const double at : m_timeline.fillings) {
        const QPoint place = placeOf(at);
        painter.drawLine(QPointF(place.x() + 0.5, place.y() + bandHeight / 2 + 2),
                         QPointF(place.x() + 0.5, place.y() + bandHeight / 2 + 6));
    }
}

/// Stars over lines: much can happen at one time.
void TimelineAxis::paintTicks(QPainter& painter) const
{
    for (const Timeline::Tick& tick : m_timeline.ticks) {
        const QPoint place = placeOf(tick.at);
        const bool isAhead = tick.at > m_timeline.present;
        painter.setPen(QPen(palette().color(isAhead ? QPalette::PlaceholderText : QPalette::Text), 1.5));
        painter.drawLine(QPointF(place.x() + 0.5, place.y() - tickHeight / 2 + 2),
                         QPointF(place.x() + 0.5, place.y() + tickHeight / 2 - 2));
    }
    painter.setPen(QPen(palette().color(QPalette::Window), 1.5));
    painter.setBrush(QColor("#e6a23c"));
    for (const Timeline::Tick& tick : m_timeline.ticks)
        if (tick.isKey)
            painter.drawPath(star(QPointF(placeOf(tick.at)) + QPointF(0.5, 0), 8));
}

/// Where the simulation is: a filled handle; where one looks: a line through all but the numbers.
void TimelineAxis::paintHeads(QPainter& painter) const
{
    const QPoint present = placeOf(m_timeline.present);
    painter.setPen(QPen(palette().color(QPalette::Base), 2));
    painter.setBrush(palette().color(QPalette::Highlight));
    painter.drawEllipse(QPointF(present) + QPointF(0.5, 0), 6.5, 6.5);
    if (!m_looking)
        return;
    const double x = placeOf(*m_looking).x() + 0.5;
    const QColor color("#d9622b");
    painter.setPen(QPen(color, 2));
    painter.drawLine(QPointF(x, rulerHeight()), QPointF(x, height() - 2));
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPolygon(
        QPolygonF({{x - 6, 1.0 * rulerHeight()}, {x + 6, 1.0 * rulerHeight()}, {x, 1.0 * rulerHeight() + 8}}));
}

QString TimelineAxis::textAt(double at) const
{
    const Timeline::Tick* near = m_timeline.tickNear(at, 1e-9);
    if (near == nullptr)
        return timeText(at) + (m_timeline.isFilledAnewAt(at, reach()) ? '\n' + tr("Filled anew") : QString());
    QStringList names;
    for (const Timeline::Tick& tick : m_timeline.ticks)
        if (std::abs(tick.at - near->at) < 1e-9)
            names << m_nameOf(tick.entry);
    constexpr int most = 6;
    if (names.size() > most)
        names = QStringList{tr("... and %1 before").arg(names.size() - most)} + names.mid(names.size() - most);
    return timeText(near->at) + '\n' + names.join('\n') + '\n' + tr("Double-click: go there");
}

/// For those who do not see it: the time, and the last entry up to there.
QString TimelineAxis::spokenPlace() const
{
    const double at = m_looking.value_or(m_timeline.present);
    const Timeline::Tick* last = nullptr;
    for (const Timeline::Tick& tick : m_timeline.ticks)
        if (tick.at <= at + 1e-9 && (last == nullptr || tick.at >= last->at))
            last = &tick;
    return last == nullptr ? timeText(at) : tr("%1, entry %2").arg(timeText(at), m_nameOf(last->entry));
}

/// Arrows go from picture to picture, Home and End to the ends; Enter goes to the entry there, as a double click does.
void TimelineAxis::keyPressEvent(QKeyEvent* event)
{
    if (!isOwnKey(*event) || m_timeline.ticks.empty()) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) {
        emit stepped(event->key() == Qt::Key_Left ? -1 : 1);
    } else if (event->key() == Qt::Key_Home || event->key() == Qt::Key_End) {
        emit grabbed();
        emit dragged(event->key() == Qt::Key_Home ? 0 : m_timeline.end);
    } else {
        emit doubleClicked(m_looking.value_or(m_timeline.present));
    }
}

bool TimelineAxis::isOwnKey(const QKeyEvent& event)
{
    constexpr Qt::Key own[] = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Home, Qt::Key_End, Qt::Key_Return, Qt::Key_Enter};
    const bool isPlain = (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    return isPlain && std::ranges::find(own, event.key()) != std::end(own);
}

bool TimelineAxis::event(QEvent* event)
{
    // The window uses some of them otherwise.
    if (event->type() == QEvent::ShortcutOverride && isOwnKey(static_cast<QKeyEvent&>(*event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::FontChange)
        updateGeometry();
    if (event->type() != QEvent::ToolTip || m_timeline.ticks.empty())
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), textAt(atPlace(help->pos().x())), this);
    return true;
}

void TimelineAxis::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || m_timeline.ticks.empty())
        return;
    emit grabbed();
    emit dragged(atPlace(event->position().x()));
}

void TimelineAxis::mouseMoveEvent(QMouseEvent* event)
{
    if (m_timeline.ticks.empty())
        return;
    const double at = atPlace(event->position().x());
    if (event->buttons() & Qt::LeftButton)
        emit dragged(at);
    setCursor(m_timeline.tickNear(at, 1e-9) != nullptr ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void TimelineAxis::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !m_timeline.ticks.empty())
        emit released(atPlace(event->position().x()));
}

void TimelineAxis::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !m_timeline.ticks.empty())
        emit doubleClicked(atPlace(event->position().x()));
}

void TimelineAxis::leaveEvent(QEvent* event)
{
    unsetCursor();
    QWidget::leaveEvent(event);
}

} // namespace knead
