#include "ui/viewport/section_handles.h"

#include "ui/screen_reader.h"

#include <QFontMetrics>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knead {

namespace {

constexpr int dividerWidth = 34;     // with its knob [pixels]
constexpr int lineWidth = 10;        // of what can be grabbed of the line beside its knob [pixels]
constexpr int knobSize = 30;         // [pixels]
constexpr double dividerStep = 0.02; // of the width
constexpr double leastShare = 0.02;

/// Two triangles that point away from the middle, along x.
QPainterPath doubleArrow(double size)
{
    QPainterPath path;
    for (const double side : {-1.0, 1.0}) {
        path.moveTo(side * 0.30 * size, 0);
        path.lineTo(side * 0.11 * size, -0.17 * size);
        path.lineTo(side * 0.11 * size, 0.17 * size);
        path.closeSubpath();
    }
    return path;
}

void paintKnob(QPainter& painter, const QPointF& center, double size, double angle, const QPalette& palette,
               bool hasFocus)
{
    painter.save();
    painter.translate(center);
    painter.setPen(
        QPen(hasFocus ? palette.color(QPalette::Highlight) : palette.color(QPalette::Mid), hasFocus ? 2 : 1));
    painter.setBrush(palette.color(QPalette::ToolTipBase));
    painter.drawEllipse(QPointF(), 0.42 * size, 0.42 * size);
    painter.rotate(angle);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette.color(QPalette::Highlight));
    painter.drawPath(doubleArrow(size));
    painter.restore();
}

} // namespace

DividerHandle::DividerHandle(QWidget* parent)
    : QWidget(parent)
{
    setObjectName("dividerHandle");
    setCursor(Qt::SplitHCursor);
    setFocusPolicy(Qt::ClickFocus);
    setToolTip(tr("Drag: the original on the left, the part as it is on the right"));
    readAs(*this, QAccessible::Grip, [] { return QString(); });
    setAccessibleName(tr("Divider between before and after"));
    hide();
}

void DividerHandle::placeAt(double share)
{
    m_share = share;
    const int middle = static_cast<int>(std::lround(share * parentWidget()->width()));
    const QSize before = size();
    setGeometry(middle - dividerWidth / 2, 0, dividerWidth, parentWidget()->height());
    if (size() != before || mask().isEmpty()) { // beside the line the view keeps the mouse
        const QRegion line((width() - lineWidth) / 2, 0, lineWidth, height());
        QRect knob(0, 0, knobSize, knobSize);
        knob.moveCenter(rect().center());
        setMask(line | QRegion(knob, QRegion::Ellipse));
    }
}

void DividerHandle::moveTo(double share)
{
    emit dragged(std::clamp(share, leastShare, 1 - leastShare));
}

void DividerHandle::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle = QRectF(rect()).center();
    painter.setPen(QPen(palette().color(QPalette::ToolTipBase), 4));
    painter.drawLine(QPointF(middle.x(), 0), QPointF(middle.x(), height()));
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.6));
    painter.drawLine(QPointF(middle.x(), 0), QPointF(middle.x(), height()));
    paintKnob(painter, middle, knobSize, 0, palette(), hasFocus());
}

void DividerHandle::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        event->ignore(); // the view turns
    m_grabbed = event->position().x() - width() / 2.0;
}

void DividerHandle::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton)
        moveTo((mapToParent(event->position()).x() - m_grabbed) / parentWidget()->width());
    else
        event->ignore();
}

void DividerHandle::mouseReleaseEvent(QMouseEvent* event)
{
    event->setAccepted(event->button() == Qt::LeftButton);
}

void DividerHandle::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)
        moveTo(m_share + (event->key() == Qt::Key_Left ? -dividerStep : dividerStep));
    else
        QWidget::keyPressEvent(event);
}

SectionKnob::SectionKnob(QWidget* parent)
    : QWidget(parent)
{
    setObjectName("sectionKnob");
    resize(knobSize, knobSize);
    setCursor(Qt::SizeAllCursor);
    setFocusPolicy(Qt::ClickFocus);
    setToolTip(tr("Drag to move the section plane; arrow keys move it by a hundredth of the part"));
    readAs(*this, QAccessible::Grip, [] { return QString(); });
    setAccessibleName(tr("Section plane"));
    hide();
}

void SectionKnob::placeAt(const QPointF& center, const QPointF& direction)
{
    m_direction = direction;
    move((center - QRectF(rect()).center()).toPoint());
    update();
}

void SectionKnob::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double angle = std::atan2(m_direction.y(), m_direction.x()) * 180 / std::numbers::pi;
    paintKnob(painter, QRectF(rect()).center(), knobSize, angle, palette(), hasFocus());
}

void SectionKnob::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        emit grabbed(mapToParent(event->position()));
    else
        event->ignore(); // the view turns
}

void SectionKnob::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton)
        emit dragged(mapToParent(event->position()));
    else
        event->ignore();
}

/// A release that belongs to no press of the view would be half of a click there.
void SectionKnob::mouseReleaseEvent(QMouseEvent* event)
{
    event->setAccepted(event->button() == Qt::LeftButton);
}

void SectionKnob::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Right)
        emit stepped(1);
    else if (event->key() == Qt::Key_Down || event->key() == Qt::Key_Left)
        emit stepped(-1);
    else
        QWidget::keyPressEvent(event);
}

} // namespace knead
