#include "ui/panels/picture_card.h"

#include "ui/theme.h"

#include <QApplication>
#include <QEvent>
#include <QPainter>
#include <QPainterPath>

namespace knead {

namespace {

constexpr int roundness = 7;
constexpr int lines = 46; // height of what is below the picture, of texts of the usual size [pixels]

/// For pictures that have none of their own. Dark parts stand out from it in dark windows, too.
QLinearGradient backgroundOf(const QRect& place)
{
    const QPalette colors = QApplication::palette();
    const QColor base = colors.color(QPalette::Base);
    const QColor mid = colors.color(QPalette::Mid);
    QLinearGradient background(place.topLeft(), place.bottomLeft());
    background.setColorAt(0, base.lightness() < mid.lightness() ? mid.lighter(160) : base);
    background.setColorAt(1, mid);
    return background;
}

} // namespace

PictureCard::PictureCard(const QImage& picture, const QString& name, const QString& about, QWidget* parent)
    : QPushButton(name, parent)
    , m_picture(picture)
    , m_about(about)
{
    setCursor(Qt::PointingHandCursor);
    setAccessibleDescription(about);
    setFixedSize(sizeHint());
    setAttribute(Qt::WA_Hover);
}

QSize PictureCard::sizeHint() const
{
    return {pictureSize.width(), pictureSize.height() + withText(lines)};
}

void PictureCard::changeEvent(QEvent* event)
{
    QPushButton::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        setFixedSize(sizeHint());
}

void PictureCard::paintEvent(QPaintEvent* /*event*/)
{
    // The style sheet of buttons has colored the widget's own palette.
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isLit = underMouse() || hasFocus();
    const QRectF frame = QRectF(rect()).adjusted(1, 1, -1, -1);
    QPainterPath shape;
    shape.addRoundedRect(frame, roundness, roundness);
    painter.fillPath(shape, QApplication::palette().color(isDown() ? QPalette::Button : QPalette::Base));
    painter.save();
    painter.setClipPath(shape);
    drawPicture(painter, QRect(QPoint(0, 0), pictureSize));
    painter.restore();
    painter.strokePath(shape,
                       QPen(QApplication::palette().color(isLit ? QPalette::Highlight : QPalette::Mid), isLit ? 2 : 1));

    const QRect words = rect().adjusted(10, pictureSize.height() + 5, -10, -5);
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    painter.setPen(QApplication::palette().color(QPalette::Text));
    painter.drawText(words, Qt::AlignTop | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(text(), Qt::ElideMiddle, words.width()));
    painter.setFont(font());
    painter.setPen(QApplication::palette().color(QPalette::PlaceholderText));
    painter.drawText(words, Qt::AlignBottom | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(m_about, Qt::ElideLeft, words.width())); // of a path, the end
}

void PictureCard::drawPicture(QPainter& painter, const QRect& place)
{
    if (!m_picture.isNull()) {
        painter.fillRect(place, backgroundOf(place));
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(place, m_picture);
        return;
    }
    painter.fillRect(place, QApplication::palette().color(QPalette::AlternateBase));
    const QSize sign(40, 40);
    knead::icon("part").paint(&painter, QRect(place.center() - QPoint(20, 20), sign), Qt::AlignCenter, QIcon::Disabled);
}

} // namespace knead
