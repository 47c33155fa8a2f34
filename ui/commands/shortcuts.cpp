#include "ui/commands/shortcuts.h"

#include "ui/commands/listed_actions.h"
#include "ui/language/retranslation.h"

#include <QAction>
#include <QMainWindow>
#include <QSettings>

#include <algorithm>

namespace knead {

namespace {

// Properties of actions.
constexpr const char* tipWithKeys = "tipWithKeys";       // as it was put together last
constexpr const char* tipFollowsText = "tipFollowsText"; // it has no tip of its own

QString settingOf(const QAction* action)
{
    return "shortcuts/" + action->objectName();
}

QList<QKeySequence> keysFrom(const QStringList& texts)
{
    QList<QKeySequence> keys;
    for (const QString& text : texts)
        keys << QKeySequence(text, QKeySequence::PortableText);
    return keys;
}

QStringList textsOf(const QList<QKeySequence>& keys)
{
    QStringList texts;
    for (const QKeySequence& key : keys)
        texts << key.toString(QKeySequence::PortableText);
    return texts;
}

} // namespace

Shortcuts::Shortcuts(QMainWindow& window)
    : QObject(&window)
    , m_window(window)
{
    const auto actions = listedActions(window);
    QList<const QAction*> chosen;
    for (const ListedAction& one : actions) {
        follow(one.action);
        if (one.action->objectName().isEmpty())
            continue;
        m_usual[one.action] = one.action->shortcuts();
        const QVariant kept = QSettings().value(settingOf(one.action));
        if (kept.isValid()) {
            one.action->setShortcuts(keysFrom(kept.toStringList()));
            chosen.append(one.action);
        }
    }
    // What a person gave an action is no longer the usual key of another one, which may be new.
    for (const ListedAction& one : actions) {
        if (chosen.contains(one.action))
            continue;
        QList<QKeySequence> keys = one.action->shortcuts();
        const auto isTaken = [&chosen](const QKeySequence& key) {
            return std::ranges::any_of(chosen,
                                       [&key](const QAction* other) { return other->shortcuts().contains(key); });
        };
        if (keys.removeIf(isTaken) > 0)
            one.action->setShortcuts(keys);
    }
}

QList<QKeySequence> Shortcuts::usual(const QAction* action) const
{
    const auto found = m_usual.find(action);
    return found == m_usual.end() ? QList<QKeySequence>{} : found->second;
}

void Shortcuts::set(QAction* action, const QList<QKeySequence>& keys)
{
    if (!knows(action) || action->shortcuts() == keys)
        return;
    action->setShortcuts(keys);
    if (keys == usual(action))
        QSettings().remove(settingOf(action));
    else
        QSettings().setValue(settingOf(action), textsOf(keys));
    emit changed(action);
}

void Shortcuts::resetAll()
{
    for (const ListedAction& one : listedActions(m_window))
        if (knows(one.action))
            reset(one.action);
}

QAction* Shortcuts::holder(const QKeySequence& key, const QAction* except) const
{
    if (key.isEmpty())
        return nullptr;
    for (const ListedAction& one : listedActions(m_window))
        if (one.action != except && one.action->shortcuts().contains(key))
            return one.action;
    return nullptr;
}

QString Shortcuts::takenFor(const QKeySequence& key)
{
    static const QList<int> driving = {Qt::Key_Left, Qt::Key_Right,  Qt::Key_Up,
                                       Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown};
    if (key.isEmpty())
        return {};
    const QKeyCombination first = key[0];
    const bool isPlain = (first.keyboardModifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    return isPlain && driving.contains(first.key()) ? tr("drives the selected tool") : QString();
}

/// The tip is put together again whenever text, tip or keys change, in whatever language.
void Shortcuts::follow(QAction* action)
{
    action->setProperty(tipFollowsText, action->toolTip() == plainText(action->text()));
    showKeys(action);
    connect(action, &QAction::changed, this, [action] { showKeys(action); });
}

void Shortcuts::showKeys(QAction* action)
{
    QString tip = action->toolTip();
    if (action->property(tipFollowsText).toBool())
        tip = plainText(action->text());
    else if (tip == action->property(tipWithKeys).toString())
        tip = action->property(tipWithoutKeys).toString();
    const QString keys = QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText);
    const QString whole = keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys);
    action->setProperty(tipWithoutKeys, tip);
    action->setProperty(tipWithKeys, whole);
    if (action->toolTip() != whole)
        action->setToolTip(whole);
}

} // namespace knead
