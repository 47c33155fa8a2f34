#include "ui/modes.h"

#include <QAction>
#include <QActionGroup>

namespace knead {

Modes::Modes(QObject* parent)
    : QObject(parent)
    , m_group(new QActionGroup(this))
{
    m_group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
}

void Modes::add(QAction* mode)
{
    m_group->addAction(mode);
    connect(mode, &QAction::toggled, this, &Modes::changed);
}

QAction* Modes::current() const
{
    return m_group->checkedAction();
}

bool Modes::leave()
{
    QAction* left = current();
    if (left != nullptr)
        left->setChecked(false);
    return left != nullptr;
}

} // namespace knead
