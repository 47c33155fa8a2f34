#include "ui/panels/history_panel.h"

#include "ui/document/entry_names.h"
#include "ui/language/said.h"
#include "ui/theme.h"
#include "ui/units.h"

#include <QDateTime>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QScopedValueRollback>
#include <QSettings>
#include <QSpinBox>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace knead {

namespace {

enum Column { name, mark, simulated, made, columnCount };
constexpr int entryRole = Qt::UserRole;
constexpr int updateTime = 30; // [ms]
constexpr double bytesPerMegabyte = 1 << 20U;
constexpr const char* memorySetting = "history/megabytes";

Document::Entry entryOf(const QTreeWidgetItem* item)
{
    return item->data(name, entryRole).toUInt();
}

QString clockTime(double wallTime)
{
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(1000 * wallTime));
    const bool isToday = time.date() == QDate::currentDate();
    return isToday ? time.toString("HH:mm:ss") : QLocale().toString(time, QLocale::ShortFormat);
}

/// "57 kB", "1.5 MB"
QString memoryText(std::size_t bytes)
{
    const double value = static_cast<double>(bytes) / bytesPerMegabyte;
    if (value < 0.95)
        return HistoryPanel::tr("%1 kB").arg(std::ceil(1024 * value), 0, 'f', 0);
    return HistoryPanel::tr("%1 MB").arg(localNumber(value, 'f', value < 10 ? 1 : 0));
}

/// The tree with keys of its own: Enter goes to an entry.
class EntryTree final : public QTreeWidget {
public:
    using QTreeWidget::QTreeWidget;

protected:
    void keyPressEvent(QKeyEvent* event) override
    {
        const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
        if (isEnter && state() != EditingState && currentItem() != nullptr)
            emit itemClicked(currentItem(), name);
        else
            QTreeWidget::keyPressEvent(event);
    }

    QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override
    {
        const QModelIndex index = QTreeWidget::moveCursor(action, modifiers);
        return index.siblingAtColumn(name); // the keyboard stays with the names
    }

    /// Only names can be typed.
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override
    {
        return index.column() == name && QTreeWidget::edit(index, trigger, event);
    }
};

/// With all that is in it.
void expand(QTreeWidgetItem* item)
{
    for (int i = 0; i < item->childCount(); ++i)
        expand(item->child(i));
    item->setExpanded(item->childCount() > 0);
}

} // namespace

/// What depends on where the document is, is asked for when it is drawn: thousands of rows need not be told.
class HistoryPanel::Row final : public QTreeWidgetItem {
public:
    Row(const HistoryPanel& panel, Entry entry)
        : m_panel(panel)
        , m_entry(entry)
    {
    }

    QVariant data(int column, int role) const override
    {
        const QVariant look = m_panel.lookOf(m_entry, column, role);
        return look.isValid() ? look : QTreeWidgetItem::data(column, role);
    }

private:
    const HistoryPanel& m_panel;
    Entry m_entry;
};

HistoryPanel::HistoryPanel(Document& document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_tree(new EntryTree(this))
    , m_used(new QLabel(this))
    , m_allowed(new QSpinBox(this))
    , m_soon(new QTimer(this))
{
    setObjectName("historyPanel");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    makeTree();
    makeFoot();
    m_soon->setSingleShot(true);
    m_soon->setInterval(updateTime);
    connect(m_soon, &QTimer::timeout, this, &HistoryPanel::bringUpToDate);
    connect(&document, &Document::changed, this, &HistoryPanel::documentChanged);
    connect(&document.history(), &DocumentHistory::edited, this, [this](Entry entry) { m_edited.insert(entry); });
}

void HistoryPanel::makeTree()
{
    m_tree->setObjectName("historyTree");
    m_tree->setAccessibleName(tr("What was done"));
    m_tree->setColumnCount(columnCount);
    m_tree->setHeaderLabels({tr("What was done"), QString(), tr("Time"), tr("Made at")});
    m_tree->headerItem()->setToolTip(simulated, tr("Simulated time at its end"));
    m_tree->headerItem()->setToolTip(mark, tr("Key moments: memory is kept for them longest"));
    m_tree->headerItem()->setIcon(mark, icon("star"));
    m_tree->setIconSize({16, 16});
    m_tree->setIndentation(14);
    m_tree->setUniformRowHeights(true);
    m_tree->setAllColumnsShowFocus(true);
    m_tree->setTextElideMode(Qt::ElideRight);
    m_tree->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    QHeaderView* header = m_tree->header();
    header->setStretchLastSection(false);
    header->setMinimumSectionSize(24);
    header->setSectionResizeMode(name, QHeaderView::Stretch);
    header->setSectionResizeMode(mark, QHeaderView::Fixed);
    header->resizeSection(mark, 24);
    for (const Column column : {simulated, made})
        header->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    header->setResizeContentsPrecision(50); // rows that are measured beside those in sight
    connect(m_tree, &QTreeWidget::itemClicked, this, &HistoryPanel::entryClicked);
    connect(m_tree, &QTreeWidget::itemChanged, this, &HistoryPanel::entryEdited);
    connect(m_tree, &QWidget::customContextMenuRequested, this, &HistoryPanel::askWhatToDo);
    layout()->addWidget(m_tree);
}

void HistoryPanel::makeFoot()
{
    auto* foot = new QWidget(this);
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(6);
    m_used->setObjectName("historyMemory");
    m_used->setProperty("role", "dimmed");
    m_allowed->setObjectName("historyMemoryAllowed");
    m_allowed->setAccessibleName(tr("Memory of the history"));
    m_allowed->setRange(static_cast<int>(DocumentHistory::leastMemory >> 20U), 1 << 16);
    m_allowed->setSingleStep(64);
    m_allowed->setSuffix(tr(" MB"));
    m_allowed->setKeyboardTracking(false);
    m_allowed->setToolTip(tr("What moments may take. The oldest ones are dropped, and found again by repeating"));
    const std::size_t usual = History::defaultMemory >> 20U;
    m_allowed->setValue(QSettings().value(memorySetting, static_cast<qulonglong>(usual)).toInt());
    const auto allow = [this](int megabytes) {
        m_document.history().setMemory(static_cast<std::size_t>(megabytes) << 20U);
    };
    allow(m_allowed->value());
    connect(m_allowed, &QSpinBox::valueChanged, this, [this, allow](int megabytes) {
        QSettings().setValue(memorySetting, megabytes);
        allow(megabytes);
        emit allowedMemoryChanged();
    });
    row->addWidget(m_used);
    row->addWidget(new QLabel(tr("of"), foot));
    row->addWidget(m_allowed);
    row->addStretch(1);
    layout()->addWidget(foot);
}

void HistoryPanel::showAllowedMemory(int megabytes)
{
    m_allowed->setValue(megabytes);
}

void HistoryPanel::documentChanged(Document::Change what)
{
    if (what != Document::Change::History && what != Document::Change::Moment)
        return;
    if (isVisible() && !m_soon->isActive())
        m_soon->start();
}

void HistoryPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_soon->start();
}

void HistoryPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() != QEvent::LanguageChange)
        return;
    for (Entry entry = 0; entry < m_items.size(); ++entry)
        m_edited.insert(entry);
    m_soon->start();
}

void HistoryPanel::bringUpToDate()
{
    if (m_document.history().isEmpty()) {
        m_tree->clear();
        m_items.clear();
        m_edited.clear();
        m_used->clear();
        return;
    }
    if (m_tree->findChild<QLineEdit*>() != nullptr) { // a name is being typed
        m_soon->start();
        return;
    }
    const QScopedValueRollback updating(m_isUpdating, true);
    const History& tree = m_document.history().tree();
    if (!isListed())
        build();
    for (auto entry = static_cast<Entry>(m_items.size()); entry < tree.records().size(); ++entry)
        addEntry(entry);
    m_tree->setRootIsDecorated(m_tree->topLevelItemCount() < static_cast<int>(m_items.size())); // there are branches
    showEntries();
    m_used->setText(memoryText(tree.memory()));
}

/// Whether the list is that of the document.
bool HistoryPanel::isListed() const
{
    return m_listed == m_document.history().documentNumber();
}

void HistoryPanel::build()
{
    const History& tree = m_document.history().tree();
    m_tree->clear();
    m_items.assign(tree.records().size(), nullptr);
    m_edited.clear();
    m_listed = m_document.history().documentNumber();
    addWay(outlineOf(tree), m_tree->invisibleRootItem());
    m_tree->expandAll();
}

void HistoryPanel::addWay(const std::vector<OutlineRow>& way, QTreeWidgetItem* parent)
{
    for (const OutlineRow& row : way) {
        m_items[row.entry] = makeRow(row.entry);
        parent->addChild(m_items[row.entry]);
        for (const auto& branch : row.branches)
            addWay(branch, m_items[row.entry]);
    }
}

/// As outlineOf() has it: what was done before from the same entry on moves aside, under that.
void HistoryPanel::addEntry(Entry entry)
{
    const History& tree = m_document.history().tree();
    QTreeWidgetItem* before = m_items[tree.record(entry).parent];
    QTreeWidgetItem* list = before->parent() == nullptr ? m_tree->invisibleRootItem() : before->parent();
    const int place = list->indexOfChild(before) + 1;
    int end = place; // another branch may follow
    while (end < list->childCount() && tree.record(entryOf(list->child(end))).parent == entryOf(list->child(end - 1)))
        ++end;
    QList<QTreeWidgetItem*> others;
    for (; end > place; --end)
        others.prepend(list->takeChild(end - 1));
    before->addChildren(others);
    if (!others.empty())
        expand(before);
    m_items.push_back(makeRow(entry));
    list->insertChild(place, m_items.back());
}

QTreeWidgetItem* HistoryPanel::makeRow(Entry entry)
{
    const History& tree = m_document.history().tree();
    const HistoryRecord& record = tree.record(entry);
    const bool beginsStart = entry == 0 || record.start != tree.record(record.parent).start;
    auto* row = new Row(*this, entry);
    row->setData(name, entryRole, entry);
    row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
    const auto modelOf = [this](std::uint32_t start) { return m_document.history().starts()[start].start.model; };
    const bool isDeformed = beginsStart && modelOf(record.start) != modelOf(tree.record(record.parent).start);
    const bool isRefilled = beginsStart && entry != 0;
    row->setIcon(name, icon(isDeformed ? "deform" : isRefilled ? "refill" : iconOf(kindOf(record, beginsStart))));
    row->setText(made, clockTime(record.wallTime));
    for (const Column column : {simulated, made})
        row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    m_edited.insert(entry);
    return row;
}

void HistoryPanel::showEntries()
{
    const History& tree = m_document.history().tree();
    m_isOnWay.assign(m_items.size(), false);
    for (const Entry entry : tree.pathTo(tree.current()))
        m_isOnWay[entry] = true;
    for (const Entry entry : std::exchange(m_edited, {}))
        showEntry(entry);
    QTreeWidgetItem* current = m_items[tree.current()];
    if (m_tree->currentItem() != current) {
        m_tree->setCurrentItem(current, name);
        m_tree->scrollToItem(current);
    }
    m_tree->viewport()->update();
}

void HistoryPanel::showEntry(Entry entry)
{
    const HistoryRecord& record = m_document.history().tree().record(entry);
    m_items[entry]->setText(name, said(record.label()));
    m_items[entry]->setText(simulated, timeText(record.time));
    m_items[entry]->setIcon(mark, record.isKey ? icon("star-full") : QIcon());
}

/// @return invalid where the row looks as it was told to
QVariant HistoryPanel::lookOf(Entry entry, int column, int role) const
{
    if (!isListed() || entry >= m_isOnWay.size())
        return {};
    if (role == Qt::ForegroundRole && (column != name || !m_isOnWay[entry]))
        return palette().brush(QPalette::PlaceholderText);
    if (role == Qt::FontRole && column == name && entry == m_document.history().tree().current()) {
        QFont font = m_tree->font();
        font.setBold(true);
        return font;
    }
    return role == Qt::ToolTipRole ? tipOf(entry, column) : QVariant();
}

QVariant HistoryPanel::tipOf(Entry entry, int column) const
{
    const HistoryRecord& record = m_document.history().tree().record(entry);
    if (column == mark)
        return record.isKey ? tr("A key moment; click: no longer one") : tr("Mark as a key moment");
    if (column != name)
        return {};
    const QString kept = record.moment ? tr("Kept, %1").arg(memoryText(record.moment->size()))
                                       : tr("Found again by repeating what leads to it");
    return tr("%1\nSimulated: %2, step %3\n%4")
        .arg(said(record.label()), timeText(record.time), formatCount(record.step), kept);
}

void HistoryPanel::entryClicked(QTreeWidgetItem* item, int column)
{
    const Entry entry = entryOf(item);
    if (!isListed())
        return;
    if (column == mark)
        toggleKey(entry);
    else if (entry != m_document.history().tree().current())
        m_document.goToEntry(entry);
}

void HistoryPanel::entryEdited(QTreeWidgetItem* item, int column)
{
    if (m_isUpdating || column != name || !isListed())
        return;
    if (const QString typed = item->text(name).trimmed(); !typed.isEmpty())
        m_document.history().rename(entryOf(item), typed);
    m_edited.insert(entryOf(item));
    m_soon->start();
}

void HistoryPanel::toggleKey(Entry entry)
{
    if (!isListed())
        return; // closed while the menu was open
    DocumentHistory& history = m_document.history();
    history.setKey(entry, !history.tree().record(entry).isKey);
}

void HistoryPanel::renameEntry(QTreeWidgetItem* item)
{
    m_tree->setCurrentItem(item, name);
    m_tree->editItem(item, name);
}

void HistoryPanel::askWhatToDo(const QPoint& place)
{
    QTreeWidgetItem* item = m_tree->itemAt(place);
    if (item == nullptr || !isListed())
        return;
    const Entry entry = entryOf(item);
    const bool isKey = m_document.history().tree().record(entry).isKey;
    auto* menu = new QMenu(this);
    menu->setObjectName("historyMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const bool isCurrent = entry == m_document.history().tree().current();
    QAction* go = menu->addAction(tr("Go here, and branch from here with what is done next"), this,
                                  [this, entry] { m_document.goToEntry(entry); });
    go->setEnabled(!isCurrent);
    menu->addSeparator();
    menu->addAction(tr("Rename"), QKeySequence(Qt::Key_F2), this, [this, entry] {
        if (isListed() && entry < m_items.size())
            renameEntry(m_items[entry]);
    });
    menu->addAction(icon(isKey ? "star" : "star-full"), isKey ? tr("No longer a key moment") : tr("Mark as key moment"),
                    this, [this, entry] { toggleKey(entry); });
    menu->popup(m_tree->viewport()->mapToGlobal(place));
}

} // namespace knead
