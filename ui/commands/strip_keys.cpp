#include "ui/commands/strip_keys.h"

#include <QChildEvent>
#include <QKeyEvent>
#include <QToolButton>

#include <algorithm>

namespace knead {

namespace {

/// Where an arrow leads in a strip: one back, one on, or nowhere.
int stepOf(int key)
{
    if (key == Qt::Key_Left || key == Qt::Key_Up)
        return -1;
    return key == Qt::Key_Right || key == Qt::Key_Down ? 1 : 0;
}

bool isKeyOfStrip(const QKeyEvent& event)
{
    const bool isPlain = (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    return isPlain && (stepOf(event.key()) != 0 || event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter);
}

} // namespace

StripKeys::StripKeys(QWidget& strip)
    : QObject(&strip)
    , m_strip(strip)
{
    for (QToolButton* button : buttons())
        take(*button);
    strip.installEventFilter(this);
}

QList<QToolButton*> StripKeys::buttons() const
{
    QList<QToolButton*> all = m_strip.findChildren<QToolButton*>(Qt::FindDirectChildrenOnly);
    all.removeIf(
        [](const QToolButton* button) { return button->objectName().startsWith("qt_"); }); // Qt's own, for more
    return all;
}

void StripKeys::take(QToolButton& button)
{
    if (!buttons().contains(&button))
        return;
    if (&button != m_stop)
        button.setFocusPolicy(Qt::NoFocus);
    button.installEventFilter(this);
    chooseStop();
}

/// Tab stops at the first button that can be pressed until arrows lead to another; at the first again once that one cannot.
void StripKeys::chooseStop()
{
    const auto canBePressed = [](const QToolButton* button) { return button->isEnabled() && !button->isHidden(); };
    if (m_stop && canBePressed(m_stop))
        return;
    const QList<QToolButton*> all = buttons();
    if (const auto first = std::ranges::find_if(all, canBePressed); first != all.end())
        makeStop(**first);
}

void StripKeys::makeStop(QToolButton& button)
{
    if (m_stop)
        m_stop->setFocusPolicy(Qt::NoFocus);
    m_stop = &button;
    button.setFocusPolicy(Qt::TabFocus);
}

/// Past what cannot be pressed now, and not beyond the ends.
void StripKeys::move(const QToolButton& from, int by)
{
    const QList<QToolButton*> all = buttons();
    qsizetype at = all.indexOf(&from);
    do
        at += by;
    while (at >= 0 && at < all.size() && (!all[at]->isEnabled() || !all[at]->isVisible()));
    if (at < 0 || at >= all.size())
        return;
    makeStop(*all[at]);
    all[at]->setFocus(Qt::TabFocusReason);
}

bool StripKeys::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_strip && event->type() == QEvent::ChildPolished)
        if (auto* button = qobject_cast<QToolButton*>(static_cast<QChildEvent*>(event)->child()))
            take(*button);
    auto* button = qobject_cast<QToolButton*>(watched);
    if (button != nullptr && (event->type() == QEvent::EnabledChange || event->type() == QEvent::HideToParent ||
                              event->type() == QEvent::ShowToParent))
        chooseStop();
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (button == nullptr || !isKey || !isKeyOfStrip(*static_cast<QKeyEvent*>(event)))
        return QObject::eventFilter(watched, event);
    event->accept();
    if (event->type() == QEvent::KeyPress) {
        const int step = stepOf(static_cast<QKeyEvent*>(event)->key());
        if (step == 0)
            button->click();
        else
            move(*button, step);
    }
    return true;
}

} // namespace knead
