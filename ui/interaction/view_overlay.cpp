#include "ui/interaction/view_overlay.h"

#include "ui/viewport/viewport_widget.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace knead {

namespace {

constexpr int noteDistance = 18; // from the cursor, below and to the right [pixels]
constexpr int notePadding = 6;   // [pixels]

QFont noteFont(QFont font)
{
    font.setBold(true);
    return font;
}

} // namespace

ViewOverlay::ViewOverlay(ViewportWidget& view, const OverlayDrawing& drawing, const char* name)
    : QWidget(&view)
    , m_view(view)
    , m_drawing(drawing)
{
    setObjectName(name);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    hide();
    connect(&view, &ViewportBridge::renderRequested, this, &ViewOverlay::refresh);
}

void ViewOverlay::refresh()
{
    const QRect area = m_drawing.overlayArea().intersected(m_view.rect());
    if (!area.isEmpty() && area != geometry())
        setGeometry(area);
    setVisible(!area.isEmpty());
    update();
}

void ViewOverlay::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(-pos());
    m_drawing.drawOverlay(painter);
}

QRect cursorNoteArea(const QString& text, const QPointF& cursor, const QRect& inside, const QFont& font)
{
    const QFontMetrics metrics(noteFont(font));
    QRect area(QPoint(), QSize(metrics.horizontalAdvance(text) + 2 * notePadding + 2, metrics.height() + notePadding));
    area.moveTopLeft(cursor.toPoint() + QPoint(noteDistance, noteDistance));
    area.moveLeft(std::clamp(area.left(), inside.left(), std::max(inside.left(), inside.right() - area.width())));
    if (area.bottom() > inside.bottom())
        area.moveBottom(cursor.toPoint().y() - noteDistance / 2);
    return area;
}

void drawCursorNote(QPainter& painter, const QString& text, const QRect& area, const QPalette& palette)
{
    painter.setFont(noteFont(painter.font()));
    painter.setPen(palette.color(QPalette::Mid));
    painter.setBrush(palette.color(QPalette::ToolTipBase));
    painter.drawRoundedRect(QRectF(area).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.setPen(palette.color(QPalette::ToolTipText));
    painter.drawText(area, Qt::AlignCenter, text);
}

} // namespace knead
