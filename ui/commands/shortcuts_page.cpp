#include "ui/commands/shortcuts_page.h"

#include "ui/commands/fuzzy_match.h"
#include "ui/commands/listed_actions.h"
#include "ui/commands/shortcuts.h"
#include "ui/theme.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <map>

namespace knead {

namespace {

enum ShortcutColumn { TextColumn, KeysColumn };

QString keysOf(const QAction* action)
{
    return QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText);
}

/// Texts begin where others do.
QIcon blank()
{
    QPixmap pixmap(16, 16);
    pixmap.fill(Qt::transparent);
    return pixmap;
}

QAction* actionOf(const QTreeWidgetItem* item)
{
    return item == nullptr ? nullptr : static_cast<QAction*>(item->data(TextColumn, Qt::UserRole).value<QObject*>());
}

} // namespace

ShortcutsPage::ShortcutsPage(QMainWindow& window, Shortcuts& shortcuts, QWidget* parent)
    : QWidget(parent)
    , m_window(window)
    , m_shortcuts(shortcuts)
    , m_search(new QLineEdit(this))
    , m_list(new QTreeWidget(this))
    , m_key(new QKeySequenceEdit(this))
    , m_conflict(new QLabel(this))
    , m_take(new QPushButton(this))
    , m_clear(new QPushButton(tr("No key"), this))
    , m_reset(new QPushButton(tr("As it came"), this))
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    makeList();
    makeEditor();
    fill();
    connect(&m_shortcuts, &Shortcuts::changed, this, &ShortcutsPage::showKeys);
}

void ShortcutsPage::makeList()
{
    m_search->setObjectName("shortcutSearch");
    m_search->setPlaceholderText(tr("Search an action or a key"));
    m_search->setClearButtonEnabled(true);
    m_list->setObjectName("shortcutList");
    m_list->setColumnCount(2);
    m_list->setHeaderLabels({tr("Action"), tr("Keys")});
    m_list->header()->setSectionResizeMode(TextColumn, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(KeysColumn, QHeaderView::ResizeToContents);
    m_list->header()->setStretchLastSection(false);
    m_list->setUniformRowHeights(true);
    m_list->setProperty("role", "framed");
    layout()->addWidget(m_search);
    layout()->addWidget(m_list);
    connect(m_search, &QLineEdit::textChanged, this, &ShortcutsPage::filter);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ShortcutsPage::choose);
}

void ShortcutsPage::makeEditor()
{
    m_key->setObjectName("shortcutKey");
    m_key->setMinimumWidth(withText(150)); // what it asks for is read
    m_take->setObjectName("shortcutTake");
    m_clear->setObjectName("shortcutClear");
    m_reset->setObjectName("shortcutReset");
    m_conflict->setObjectName("shortcutConflict");
    m_conflict->setWordWrap(true);
    m_conflict->setProperty("role", "slow");
    auto* row = new QHBoxLayout;
    row->addWidget(new QLabel(tr("Press the new key:"), this));
    row->addWidget(m_key, 1);
    row->addWidget(m_clear);
    row->addWidget(m_reset);
    auto* below = new QHBoxLayout;
    below->addWidget(m_conflict, 1);
    below->addWidget(m_take);
    auto* column = qobject_cast<QVBoxLayout*>(layout());
    column->addLayout(row);
    column->addLayout(below);
    connect(m_key, &QKeySequenceEdit::keySequenceChanged, this, &ShortcutsPage::typed);
    connect(m_take, &QPushButton::clicked, this, &ShortcutsPage::take);
    connect(m_clear, &QPushButton::clicked, this, [this] { give({}); });
    connect(m_reset, &QPushButton::clicked, this, [this] {
        if (QAction* action = current())
            m_shortcuts.reset(action);
        choose();
    });
    choose();
}

void ShortcutsPage::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        fill();
    QWidget::changeEvent(event);
}

void ShortcutsPage::fill()
{
    m_list->clear();
    std::map<QString, QTreeWidgetItem*> menus;
    for (const ListedAction& one : listedActions(m_window)) {
        if (!m_shortcuts.knows(one.action))
            continue;
        QTreeWidgetItem*& menu = menus[one.menu];
        if (menu == nullptr) {
            menu = new QTreeWidgetItem(m_list, {one.menu.isEmpty() ? tr("Elsewhere") : one.menu});
            menu->setFlags(Qt::ItemIsEnabled);
            menu->setExpanded(true);
        }
        auto* item = new QTreeWidgetItem(menu, {one.text});
        item->setIcon(TextColumn, one.action->icon().isNull() ? blank() : one.action->icon());
        item->setData(TextColumn, Qt::UserRole, QVariant::fromValue<QObject*>(one.action.data()));
        showKeys(one.action);
    }
    filter(m_search->text());
}

/// Keys that are not as they came are bold.
void ShortcutsPage::showKeys(const QAction* action)
{
    for (int m = 0; m < m_list->topLevelItemCount(); ++m)
        for (int i = 0; i < m_list->topLevelItem(m)->childCount(); ++i) {
            QTreeWidgetItem* item = m_list->topLevelItem(m)->child(i);
            if (actionOf(item) != action)
                continue;
            item->setText(KeysColumn, keysOf(action));
            QFont font = m_list->font();
            font.setBold(action->shortcuts() != m_shortcuts.usual(action));
            item->setFont(KeysColumn, font);
        }
}

void ShortcutsPage::filter(const QString& wanted)
{
    for (int m = 0; m < m_list->topLevelItemCount(); ++m) {
        QTreeWidgetItem* menu = m_list->topLevelItem(m);
        bool isAny = false;
        for (int i = 0; i < menu->childCount(); ++i) {
            const bool fits = fuzzyMatch(wanted, menu->child(i)->text(TextColumn)).has_value() ||
                              menu->child(i)->text(KeysColumn).contains(wanted, Qt::CaseInsensitive);
            menu->child(i)->setHidden(!fits);
            isAny |= fits;
        }
        menu->setHidden(!isAny);
    }
}

QAction* ShortcutsPage::current() const
{
    return actionOf(m_list->currentItem());
}

void ShortcutsPage::choose()
{
    const QAction* action = current();
    const QSignalBlocker blocker(m_key);
    m_key->setKeySequence(action == nullptr ? QKeySequence() : action->shortcut());
    for (QWidget* widget : std::initializer_list<QWidget*>{m_key, m_clear, m_reset})
        widget->setEnabled(action != nullptr);
    m_conflict->clear();
    m_take->hide();
}

/// A key that is free is given at once.
void ShortcutsPage::typed()
{
    QAction* action = current();
    if (action == nullptr || m_key->keySequence().isEmpty())
        return;
    const QKeySequence key(m_key->keySequence()[0]); // one is enough
    m_conflict->clear();
    m_take->hide();
    const QString name = key.toString(QKeySequence::NativeText);
    const QString purpose = Shortcuts::takenFor(key);
    const QAction* holder = m_shortcuts.holder(key, action);
    if (!purpose.isEmpty()) {
        m_conflict->setText(tr("%1 %2: choose another key.").arg(name, purpose));
    } else if (holder != nullptr) {
        m_conflict->setText(tr("%1 already does \"%2\".").arg(name, plainText(holder->text())));
        m_take->setText(tr("Take it from there"));
        m_take->setVisible(m_shortcuts.knows(holder));
    } else {
        give(key);
    }
}

void ShortcutsPage::take()
{
    const QKeySequence key(m_key->keySequence()[0]);
    if (QAction* holder = m_shortcuts.holder(key, current())) {
        QList<QKeySequence> rest = holder->shortcuts();
        rest.removeAll(key);
        m_shortcuts.set(holder, rest);
    }
    give(key);
}

void ShortcutsPage::give(const QKeySequence& key)
{
    if (QAction* action = current())
        m_shortcuts.set(action, key.isEmpty() ? QList<QKeySequence>{} : QList<QKeySequence>{key});
    choose();
}

} // namespace knead
