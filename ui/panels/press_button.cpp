#include "ui/panels/press_button.h"

#include <QAction>
#include <QEvent>

namespace knead {

namespace {

constexpr int lowerMargin = 24; // to the lower edge of the view [px]

} // namespace

PressButton::PressButton(Document& document, QAction* action, QWidget* view)
    : QToolButton(view)
    , m_document(document)
{
    setObjectName("pressButton");
    setProperty("role", "primary");
    setDefaultAction(action);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    view->installEventFilter(this);
    connect(&document, &Document::changed, this, &PressButton::follow);
    follow(Document::Change::Model);
}

void PressButton::follow(Document::Change /*what*/)
{
    const bool isOffered = m_document.canPressIt();
    if (defaultAction()->isEnabled() != isOffered)
        defaultAction()->setEnabled(isOffered);
    if (isVisibleTo(parentWidget()) == isOffered)
        return;
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
