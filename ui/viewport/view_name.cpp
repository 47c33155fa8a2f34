#include "ui/viewport/view_name.h"

#include "ui/viewport/camera.h"

#include <QFontMetrics>
#include <QMouseEvent>
#include <QPainter>

namespace knead {

namespace {

constexpr int namePadding = 7;         // beside the text [pixels]
constexpr double sameDirection = 1e-4; // [rad]

QFont nameFont(QFont font, bool isActive)
{
    font.setBold(isActive);
    return font;
}

} // namespace

QString nameOfView(const Camera& camera)
{
    const std::pair<Vec3, QString> directions[] = {
        {{0, -1, 0}, ViewName::tr("Front")},    {{0, 1, 0}, ViewName::tr("Back")}, {{1, 0, 0}, ViewName::tr("Right")},
        {{-1, 0, 0}, ViewName::tr("Left")},     {{0, 0, 1}, ViewName::tr("Top")},  {{0, 0, -1}, ViewName::tr("Bottom")},
        {{1, -1, 1}, ViewName::tr("Isometric")}};
    for (const auto& [direction, name] : directions)
        if ((camera.towardsEye() - direction.normalized()).norm() < sameDirection)
            return name;
    return camera.perspective ? ViewName::tr("Perspective") : ViewName::tr("Parallel");
}

ViewName::ViewName(QWidget* parent)
    : QWidget(parent)
{
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setCursor(Qt::ArrowCursor); // not that of the lines around
    setToolTip(tr("Double click: this view alone, and all of them again"));
    hide();
}

void ViewName::show(const QString& name, bool isActive)
{
    if (name != m_name || isActive != m_isActive) {
        m_name = name;
        m_isActive = isActive;
        setAccessibleName(name);
        resize(sizeHint());
        update();
    }
    raise();
    QWidget::show();
}

QSize ViewName::sizeHint() const
{
    const QFontMetrics metrics(nameFont(font(), true)); // the same for both, so that nothing jumps
    return {metrics.horizontalAdvance(m_name) + 2 * namePadding, metrics.height() + namePadding};
}

void ViewName::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        resize(sizeHint());
}

void ViewName::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor ground = palette().color(QPalette::ToolTipBase);
    ground.setAlpha(200);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(rect(), 4, 4);
    painter.setFont(nameFont(font(), m_isActive));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect(), Qt::AlignCenter, m_name);
}

void ViewName::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        emit clicked();
}

void ViewName::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        emit doubleClicked();
}

} // namespace knead
