#include "ui/panels/model_tree.h"

#include "core/model/part_tree.h"
#include "ui/panels/model_tree_delegate.h"
#include "ui/selection/selection_model.h"
#include "ui/theme.h"

#include <QMouseEvent>
#include <QScopedValueRollback>

#include <algorithm>

namespace knead {

TreeItem typeOf(const QTreeWidgetItem* item)
{
    return static_cast<TreeItem>(item->data(0, tree_roles::type).toInt());
}

Selection selectionOf(const QTreeWidgetItem* item)
{
    if (item == nullptr || !item->data(0, tree_roles::id).isValid())
        return {};
    const TreeItem type = typeOf(item);
    const Selection::Kind kind = type == TreeItem::Part      ? Selection::Kind::Body
                                 : type == TreeItem::Tool    ? Selection::Kind::Tool
                                 : type == TreeItem::Fixture ? Selection::Kind::Fixture
                                                             : Selection::Kind::None;
    return {kind, item->data(0, tree_roles::id).toUInt()};
}

ModelTree::ModelTree(Document& document, QWidget* parent)
    : QTreeWidget(parent)
    , m_document(document)
{
    setObjectName("modelTree");
    setAccessibleName(tr("Model"));
    setHeaderHidden(true);
    setIndentation(16);
    setIconSize({16, 16});
    setUniformRowHeights(true);
    setMouseTracking(true);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::EditKeyPressed);
    setDragDropMode(QAbstractItemView::InternalMove);
    setTextElideMode(Qt::ElideMiddle);
    auto* delegate = new ModelTreeDelegate(this);
    setItemDelegate(delegate);
    connect(delegate, &ModelTreeDelegate::renamed, this,
            [this](const QModelIndex& index, const QString& name) { rename(itemFromIndex(index), name); });
    connect(&document, &Document::changed, this, &ModelTree::documentChanged);
    connect(&document, &Document::appearanceChanged, this, &ModelTree::appearanceChanged);
    connect(&document.notes(), &ModelNotes::changed, this, &ModelTree::notesChanged);
    connect(&document.selected(), &SelectionModel::changed, this, &ModelTree::showSelection);
    connect(this, &QTreeWidget::itemSelectionChanged, this, &ModelTree::selectionChanged);
}

void ModelTree::documentChanged(Document::Change what)
{
    if (m_document.history().isEmpty() && what != Document::Change::Model) // there are no lines
        return;
    {
        const QScopedValueRollback updating(m_isUpdating, true);
        switch (what) {
        case Document::Change::Model:
            beginContent();
            break;
        case Document::Change::Frame:
            listTools();
            return;
        case Document::Change::Fixtures:
            listFixtures();
            break;
        case Document::Change::Moment:
            listFixtures();
            showLocks();
            break;
        case Document::Change::Selection:
            break;
        case Document::Change::Filling:
        case Document::Change::History:
            return;
        }
    }
    showSelection();
}

/// What is hidden of a model stays so when it is filled anew, or deformed.
void ModelTree::beginContent()
{
    const std::shared_ptr<const Model> before = std::exchange(m_model, m_document.content().model);
    if (std::exchange(m_opening, m_document.opening()) != m_document.opening() || !before) {
        m_hiddenParts = m_document.content().hiddenAtFirst();
        m_hiddenBefore.reset();
    } else {
        m_hiddenParts = stillHidden(m_hiddenParts, *before, *m_model);
        if (m_hiddenBefore)
            m_hiddenBefore = stillHidden(*m_hiddenBefore, *before, *m_model);
    }
    m_regionOfSet = m_regionBefore = {};
    build();
}

/// Groups change which lines there are; the rest only how they look.
void ModelTree::notesChanged()
{
    if (m_document.isEmpty() || topLevelItemCount() == 0)
        return;
    const QScopedValueRollback updating(m_isUpdating, true);
    std::vector<std::pair<std::string, std::set<std::size_t>>> groups;
    for (const ModelNotes::Group& group : m_document.notes().groups())
        groups.emplace_back(group.name, group.parts);
    if (groups != m_shownGroups)
        build();
    else {
        listSets();
        listExports();
        showLocks();
    }
    showSelection();
}

void ModelTree::appearanceChanged()
{
    const QScopedValueRollback updating(m_isUpdating, true);
    for (QTreeWidgetItem* item : all())
        dress(item);
}

std::vector<QTreeWidgetItem*> ModelTree::all() const
{
    std::vector<QTreeWidgetItem*> items;
    for (QTreeWidgetItemIterator it(const_cast<ModelTree*>(this)); *it != nullptr; ++it)
        items.push_back(*it);
    return items;
}

QTreeWidgetItem* ModelTree::find(const Selection& selection) const
{
    if (selection.kind == Selection::Kind::None)
        return nullptr;
    for (QTreeWidgetItem* item : all())
        if (selectionOf(item) == selection)
            return item;
    return nullptr;
}

// --- selecting ------------------------------------------------------------------------------------------------------------

/// Lines of what is selected: of faces and objects the parts that they belong to, or the set that has them.
void ModelTree::showSelection()
{
    const QScopedValueRollback updating(m_isUpdating, true);
    std::vector<QTreeWidgetItem*> lines;
    const Selection& selection = m_document.selection();
    if (selection.kind == Selection::Kind::Tool || selection.kind == Selection::Kind::Fixture) {
        if (QTreeWidgetItem* item = find(selection))
            lines.push_back(item);
    } else {
        const Region& region = m_document.selected().region();
        for (QTreeWidgetItem* item : all())
            if (const Selection own = selectionOf(item);
                own.kind == Selection::Kind::Body && region.items.contains(own.id))
                lines.push_back(item);
    }
    const QTreeWidgetItem* current = currentItem();
    const bool isAtSet = current != nullptr && typeOf(current) == TreeItem::Set && current->isSelected();
    if (isAtSet && selection.kind == Selection::Kind::Region && m_document.selected().region() == m_regionOfSet)
        return;
    if (std::find(lines.begin(), lines.end(), current) == lines.end())
        setCurrentItem(lines.empty() ? nullptr : lines.front(), 0, QItemSelectionModel::NoUpdate);
    clearSelection();
    for (QTreeWidgetItem* item : lines)
        item->setSelected(true);
}

void ModelTree::selectionChanged()
{
    if (m_isUpdating)
        return;
    const QScopedValueRollback updating(m_isUpdating, true); // the lines are as the person wants them
    Region parts;
    for (QTreeWidgetItem* item : selectedItems()) {
        const Selection selection = selectionOf(item);
        if (typeOf(item) == TreeItem::Set) {
            selectSet(item->data(0, tree_roles::name).toString().toStdString());
            return;
        }
        if (selection.kind == Selection::Kind::Tool || selection.kind == Selection::Kind::Fixture) {
            m_document.select(selection);
            return;
        }
        if (selection.kind == Selection::Kind::Body)
            parts.add(selection.id, 0);
    }
    if (!parts.isEmpty() || selectedItems().isEmpty())
        m_document.selected().select(parts);
}

void ModelTree::selectSet(const std::string& name)
{
    const SelectionSet* set = m_document.notes().set(name);
    if (set == nullptr)
        return;
    m_regionOfSet = m_document.regionOf(*set);
    m_document.selected().select(m_regionOfSet);
}

/// Eyes and locks are clicked without selecting their lines.
bool ModelTree::pressedButton(const QMouseEvent& event)
{
    QTreeWidgetItem* item = itemAt(event.position().toPoint());
    if (item == nullptr || event.button() != Qt::LeftButton)
        return false;
    using Button = ModelTreeDelegate::Button;
    const QModelIndex index = indexFromItem(item);
    const Button button = ModelTreeDelegate::buttonAt(index, visualRect(index), event.position().toPoint());
    if (button == Button::Eye) {
        {
            const QScopedValueRollback updating(m_isUpdating, true); // lines above and below follow by themselves
            item->setCheckState(0, item->checkState(0) == Qt::Unchecked ? Qt::Checked : Qt::Unchecked);
        }
        tellHidden();
    } else if (button == Button::Lock)
        m_document.setLocked(selectionOf(item), !item->data(0, tree_roles::lock).toBool());
    return button != Button::None;
}

void ModelTree::mousePressEvent(QMouseEvent* event)
{
    m_isOnButton = pressedButton(*event);
    m_regionBefore = m_document.selected().region();
    if (!m_isOnButton)
        QTreeWidget::mousePressEvent(event);
}

void ModelTree::mouseReleaseEvent(QMouseEvent* event)
{
    if (std::exchange(m_isOnButton, false))
        return;
    const QTreeWidgetItem* item = itemAt(event->position().toPoint());
    const bool isTool = item != nullptr && selectionOf(item).kind == Selection::Kind::Tool;
    QTreeWidget::mouseReleaseEvent(event);
    const bool isPlainClick = event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier;
    if (isTool && isPlainClick && state() == NoState && m_document.selection().kind == Selection::Kind::Tool)
        emit toolClicked();
}

void ModelTree::mouseDoubleClickEvent(QMouseEvent* event)
{
    m_isOnButton = pressedButton(*event);
    if (m_isOnButton)
        return;
    QTreeWidget::mouseDoubleClickEvent(event);
    renameCurrent();
}

// --- hiding ---------------------------------------------------------------------------------------------------------------

void ModelTree::tellHidden()
{
    std::set<std::size_t> hidden;
    for (const QTreeWidgetItem* item : all())
        if (item->data(0, tree_roles::part).isValid() && item->checkState(0) == Qt::Unchecked)
            hidden.insert(item->data(0, tree_roles::part).toULongLong());
    if (hidden == m_hiddenParts)
        return;
    m_hiddenParts = hidden;
    emit hiddenChanged(m_hiddenParts);
}

void ModelTree::hideParts(const std::set<std::size_t>& parts)
{
    {
        const QScopedValueRollback updating(m_isUpdating, true);
        for (QTreeWidgetItem* item : all())
            if (const QVariant part = item->data(0, tree_roles::part); part.isValid())
                item->setCheckState(0, parts.contains(part.toULongLong()) ? Qt::Unchecked : Qt::Checked);
    }
    m_hiddenParts = parts;
    emit hiddenChanged(parts);
}

void ModelTree::toggleSelectedBody()
{
    std::set<std::size_t> hidden = m_hiddenParts;
    const std::set<std::size_t> parts = chosenParts();
    const bool areHidden =
        std::all_of(parts.begin(), parts.end(), [&](std::size_t part) { return hidden.contains(part); });
    for (const std::size_t part : parts) {
        if (areHidden)
            hidden.erase(part);
        else
            hidden.insert(part);
    }
    if (hidden != m_hiddenParts)
        hideParts(hidden);
}

void ModelTree::isolateSelected()
{
    if (m_hiddenBefore) {
        hideParts(*std::exchange(m_hiddenBefore, std::nullopt));
        return;
    }
    const std::set<std::size_t> parts = chosenParts();
    if (parts.empty())
        return;
    std::set<std::size_t> hidden;
    for (const QTreeWidgetItem* item : all())
        if (const QVariant part = item->data(0, tree_roles::part);
            part.isValid() && !parts.contains(part.toULongLong()))
            hidden.insert(part.toULongLong());
    const std::set<std::size_t> before = m_hiddenParts;
    hideParts(hidden);
    m_hiddenBefore = before;
}

void ModelTree::showAll()
{
    m_hiddenBefore.reset();
    hideParts({});
}

// --- searching ------------------------------------------------------------------------------------------------------------

void ModelTree::filter(const QString& text)
{
    m_filter = text.trimmed();
    const QScopedValueRollback updating(m_isUpdating, true);
    for (int i = 0; i < topLevelItemCount(); ++i)
        filterBelow(topLevelItem(i), m_filter, false);
}

/// @return whether the line or one below it is shown
bool ModelTree::filterBelow(QTreeWidgetItem* item, const QString& text, bool isAboveShown)
{
    const bool isFound = isAboveShown || text.isEmpty() || item->text(0).contains(text, Qt::CaseInsensitive);
    bool isShown = isFound;
    for (int i = 0; i < item->childCount(); ++i)
        isShown = filterBelow(item->child(i), text, isFound && !text.isEmpty()) || isShown;
    const bool isHeading = item->parent() == nullptr && typeOf(item) != TreeItem::File;
    item->setHidden(!isShown || (isHeading && item->childCount() == 0));
    if (!text.isEmpty() && isShown)
        item->setExpanded(true);
    return isShown;
}

} // namespace knead
