#include "ui/panels/fitting_tool_bar.h"

#include <QAction>
#include <QActionEvent>
#include <QEvent>
#include <QKeyEvent>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

/// What the text adds to the width of a button [pixels], as QToolButton::sizeHint() has it.
int textWidth(const QToolButton& button, const QString& text)
{
    const QFontMetrics metrics = button.fontMetrics();
    return metrics.size(Qt::TextShowMnemonic, text).width() + 2 * metrics.horizontalAdvance(' ') + 4;
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

void FittingToolBar::setTurns(QAction* action, std::function<QStringList()> texts)
{
    m_turns[action] = std::move(texts);
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

/// QToolBar gives its buttons no focus.
void FittingToolBar::actionEvent(QActionEvent* event)
{
    QToolBar::actionEvent(event);
    if (event->type() != QEvent::ActionAdded)
        return;
    if (QToolButton* button = buttonOf(event->action())) {
        button->setFocusPolicy(Qt::TabFocus);
        button->installEventFilter(this);
    }
}

/// Space goes on meaning the simulation, so Enter presses.
bool FittingToolBar::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        auto* button = qobject_cast<QToolButton*>(watched);
        if (button != nullptr && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
            event->accept();
            if (event->type() == QEvent::KeyPress)
                button->click();
            return true;
        }
    }
    return QToolBar::eventFilter(watched, event);
}

/// Changes nothing that is right already, so that it comes to rest.
void FittingToolBar::fit()
{
    int taken = sizeHint().width();
    for (QAction* action : m_texts)
        if (const QToolButton* button = buttonOf(action); button != nullptr && hasText(*button))
            taken -= roomForText(action);
    bool isRoom = true;
    for (QAction* action : m_texts) {
        QToolButton* button = buttonOf(action);
        if (button == nullptr)
            continue;
        taken += roomForText(action);
        isRoom = isRoom && taken <= width();
        if (hasText(*button) != isRoom)
            button->setToolButtonStyle(isRoom ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
        const int more = isRoom ? roomForText(action) - textWidth(*button, button->text()) : 0;
        const int least = more > 0 ? button->sizeHint().width() + more : 0;
        if (button->minimumWidth() != least)
            button->setMinimumWidth(least);
    }
}

int FittingToolBar::roomForText(QAction* action) const
{
    const QToolButton& button = *buttonOf(action);
    int room = textWidth(button, button.text());
    if (const auto turns = m_turns.find(action); turns != m_turns.end())
        for (const QString& text : turns->second())
            room = std::max(room, textWidth(button, text));
    return room;
}

QToolButton* FittingToolBar::buttonOf(QAction* action) const
{
    return qobject_cast<QToolButton*>(widgetForAction(action));
}

} // namespace knead
