#include "ui/panels/choice_menu.h"

#include "ui/commands/availability.h"

#include <QActionGroup>
#include <QComboBox>
#include <QEvent>
#include <QMenu>

namespace knead {

namespace {

/// The actions can be done when the choice can be made; else they say why not, as its tip does.
class EnabledFollower final : public QObject {
public:
    EnabledFollower(const QComboBox* choice, QActionGroup* entries)
        : QObject(entries)
        , m_choice(choice)
        , m_entries(entries)
    {
        follow();
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::EnabledChange || event->type() == QEvent::DynamicPropertyChange)
            follow();
        return QObject::eventFilter(watched, event);
    }

private:
    void follow()
    {
        m_entries->setEnabled(m_choice->isEnabled());
        const QString reason = m_choice->property("whyDisabled").toString();
        if (reason.isEmpty()) // Availability knows
            return;
        for (QAction* entry : m_entries->actions()) {
            Availability::setWhyNot(*entry, reason);
            entry->setStatusTip(m_choice->isEnabled() ? QString() : reason);
        }
    }

    const QComboBox* m_choice;
    QActionGroup* m_entries;
};

} // namespace

QMenu* menuOf(QComboBox* choice, const QString& title, QWidget* window, const QString& whyNot)
{
    auto* menu = new QMenu(title, window);
    auto* entries = new QActionGroup(menu);
    for (int index = 0; index < choice->count(); ++index) {
        auto* action = new QAction(choice->itemText(index), window);
        action->setObjectName(QStringLiteral("%1-%2").arg(choice->objectName()).arg(index));
        action->setCheckable(true);
        const QString tip = choice->itemData(index, Qt::ToolTipRole).toString();
        action->setToolTip(tip.isEmpty() ? choice->toolTip() : tip);
        Availability::setWhyNot(*action, whyNot);
        entries->addAction(action);
        window->addAction(action);
        QObject::connect(action, &QAction::triggered, choice, [choice, index] {
            choice->setCurrentIndex(index);
            emit choice->activated(index);
        });
    }
    menu->addActions(entries->actions());
    choice->installEventFilter(new EnabledFollower(choice, entries));
    const auto follow = [entries](int index) {
        if (QAction* now = index < 0 ? entries->checkedAction() : entries->actions().at(index))
            now->setChecked(index >= 0);
    };
    entries->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional); // numbers of one's own are no entry
    follow(choice->currentIndex());
    QObject::connect(choice, &QComboBox::currentIndexChanged, menu, follow);
    QObject::connect(entries, &QActionGroup::triggered, menu, [choice, follow] { follow(choice->currentIndex()); });
    return menu;
}

} // namespace knead
