#include "ui/commands/make_action.h"

#include "ui/theme.h"

#include <QAction>
#include <QCoreApplication>
#include <QWidget>

namespace knead {

QAction* makeAction(QWidget& window, const ActionLook& look, const char* context)
{
    auto* action = new QAction(QCoreApplication::translate(context, look.text), &window);
    action->setObjectName(look.name);
    if (look.icon != nullptr)
        action->setIcon(icon(look.icon));
    if (*look.keys != '\0')
        action->setShortcuts(QKeySequence::listFromString(look.keys));
    if (look.tip != nullptr)
        action->setToolTip(QCoreApplication::translate(context, look.tip));
    window.addAction(action);
    return action;
}

QAction* makeSwitch(QWidget& window, const ActionLook& look, bool isOn, const char* context)
{
    QAction* action = makeAction(window, look, context);
    action->setCheckable(true);
    action->setChecked(isOn);
    return action;
}

} // namespace knead
