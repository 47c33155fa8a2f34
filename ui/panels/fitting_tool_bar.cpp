#include "ui/panels/fitting_tool_bar.h"

#include <QAction>
#include <QEvent>
#include <QToolButton>

namespace knead {

namespace {

/// What the text adds to the width of a button [pixels], as QToolButton::sizeHint() has it.
int textWidth(const QToolButton& button)
{
    const QFontMetrics metrics = button.fontMetrics();
    return metrics.size(Qt::TextShowMnemonic, button.text()).width() + 2 * metrics.horizontalAdvance(' ') + 4;
}

bool hasText(const QToolButton& button)
{
    return button.toolButtonStyle() == Qt::ToolButtonTextBesideIcon;
}

} // namespace

void FittingToolBar::setTexts(const QList<QAction*>& actions)
{
    m_texts = actions;
    fit();
}

bool FittingToolBar::event(QEvent* event)
{
    const bool isDone = QToolBar::event(event);
    // Another width, or another text in a button.
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
        fit();
    return isDone;
}

/// Changes nothing that is right already, so that it comes to rest.
void FittingToolBar::fit()
{
    int taken = sizeHint().width();
    for (QAction* action : m_texts)
        if (const QToolButton* button = buttonOf(action); button != nullptr && hasText(*button))
            taken -= textWidth(*button);
    bool isRoom = true;
    for (QAction* action : m_texts) {
        QToolButton* button = buttonOf(action);
        if (button == nullptr)
            continue;
        taken += textWidth(*button);
        isRoom = isRoom && taken <= width();
        if (hasText(*button) != isRoom)
            button->setToolButtonStyle(isRoom ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    }
}

QToolButton* FittingToolBar::buttonOf(QAction* action) const
{
    return qobject_cast<QToolButton*>(widgetForAction(action));
}

} // namespace knead
