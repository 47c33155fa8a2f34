#include "ui/panels/press_button.h"

#include <QAction>
#include <QEvent>

namespace knead {

namespace {

constexpr int lowerMargin = 24; // to the lower edge of the view [px]

} // namespace

PressButton::PressButton(QAction* action, QWidget* view)
    : QToolButton(view)
{
    setObjectName("pressButton");
    setProperty("role", "primary");
    setDefaultAction(action);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    view->installEventFilter(this);
    connect(action, &QAction::enabledChanged, this, &PressButton::follow);
    follow();
}

void PressButton::follow()
{
    const bool isOffered = defaultAction()->isEnabled();
    setVisible(isOffered);
    if (isOffered) {
        place();
        raise();
    }
}

void PressButton::place()
{
    const QSize size = sizeHint();
    setGeometry((parentWidget()->width() - size.width()) / 2, parentWidget()->height() - size.height() - lowerMargin,
                size.width(), size.height());
}

bool PressButton::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::LanguageChange)
        place();
    if (event->type() == QEvent::Resize || event->type() == QEvent::ChildAdded)
        raise(); // above views that came later
    return QToolButton::eventFilter(object, event);
}

} // namespace knead
