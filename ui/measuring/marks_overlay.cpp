#include "ui/measuring/marks_overlay.h"

#include "ui/viewport/viewport_bridge.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double lineWidth = 2;
constexpr double haloWidth = 4.5; // of the light or dark line behind, which keeps it legible on any part
constexpr double dotRadius = 4;
constexpr QPointF textOffset{14, -14}; // [pixels]
constexpr double padding = 5;

} // namespace

MarksOverlay::MarksOverlay(ViewportBridge& view, SeenAt seenAt)
    : QWidget(&view)
    , m_view(view)
    , m_seenAt(std::move(seenAt))
{
    setObjectName("marksOverlay");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setGeometry(view.rect());
    hide();
    view.installEventFilter(this);
    connect(&view, &ViewportBridge::renderRequested, this, [this] { update(); });
}

/// Hidden while there is nothing to paint: then it costs nothing.
void MarksOverlay::show(std::vector<OverlayMark> marks)
{
    m_marks = std::move(marks);
    setVisible(!m_marks.empty() || !m_prompt.isEmpty());
    update();
}

void MarksOverlay::setPrompt(const QString& prompt)
{
    m_prompt = prompt;
    setVisible(!m_marks.empty() || !m_prompt.isEmpty());
    update();
}

bool MarksOverlay::eventFilter(QObject* /*watched*/, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        setGeometry(m_view.rect());
    return false;
}

QColor MarksOverlay::colorOf(const OverlayMark& mark) const
{
    if (mark.color.isValid())
        return mark.color;
    return mark.isStrong ? palette().color(QPalette::Highlight) : palette().color(QPalette::WindowText);
}

void MarksOverlay::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const OverlayMark& mark : m_marks)
        paintMark(painter, mark);
    std::vector<QRectF> taken;
    for (const OverlayMark& mark : m_marks)
        paintText(painter, mark, taken);
    if (!m_prompt.isEmpty())
        paintPrompt(painter);
}

void MarksOverlay::paintMark(QPainter& painter, const OverlayMark& mark) const
{
    std::vector<QPolygonF> lines;
    for (const std::vector<Vec3>& line : mark.mark.lines) {
        lines.emplace_back();
        for (const Vec3& place : line)
            if (const auto seen = m_seenAt(place))
                lines.back() << *seen;
            else
                lines.emplace_back(); // behind the eye: the line is interrupted
    }
    const QColor halo = palette().color(QPalette::Base);
    for (const QPen& pen : {QPen(halo, haloWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin),
                            QPen(colorOf(mark), lineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin)}) {
        painter.setPen(pen);
        painter.setBrush(Qt::NoBrush);
        for (const QPolygonF& line : lines)
            painter.drawPolyline(line);
    }
    painter.setPen(QPen(halo, 1.5));
    painter.setBrush(colorOf(mark));
    for (const Vec3& place : mark.mark.points)
        if (const auto seen = m_seenAt(place))
            painter.drawEllipse(*seen, dotRadius, dotRadius);
}

/// Beside its place; further down where another text is already.
void MarksOverlay::paintText(QPainter& painter, const OverlayMark& mark, std::vector<QRectF>& taken) const
{
    const auto seen = m_seenAt(mark.mark.label);
    if (mark.text.isEmpty() || !seen)
        return;
    QFont font = this->font();
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    QRectF box = painter.fontMetrics().boundingRect(mark.text);
    box.setSize(box.size() + QSizeF(2 * padding + 4, 2 * padding - 2));
    box.moveBottomLeft(*seen + textOffset);
    box.moveLeft(std::clamp(box.left(), 2.0, std::max(2.0, width() - box.width() - 2)));
    box.moveTop(std::clamp(box.top(), 2.0, std::max(2.0, height() - box.height() - 2)));
    const auto overlaps = [&](const QRectF& other) { return other.intersects(box); };
    for (auto found = std::find_if(taken.begin(), taken.end(), overlaps);
         found != taken.end() && box.bottom() < height(); found = std::find_if(taken.begin(), taken.end(), overlaps))
        box.moveTop(found->bottom() + 3);
    taken.push_back(box);
    painter.setPen(QPen(colorOf(mark), mark.isStrong ? 1.6 : 1));
    painter.setBrush(palette().color(QPalette::ToolTipBase));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(palette().color(QPalette::ToolTipText));
    painter.drawText(box, Qt::AlignCenter, mark.text);
}

void MarksOverlay::paintPrompt(QPainter& painter) const
{
    painter.setFont(font());
    QRectF box = painter.fontMetrics().boundingRect(m_prompt);
    box.setSize(box.size() + QSizeF(24, 12));
    box.moveTop(12);
    box.moveLeft((width() - box.width()) / 2);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    painter.setBrush(palette().color(QPalette::ToolTipBase));
    painter.drawRoundedRect(box, 6, 6);
    painter.setPen(palette().color(QPalette::ToolTipText));
    painter.drawText(box, Qt::AlignCenter, m_prompt);
}

} // namespace knead
