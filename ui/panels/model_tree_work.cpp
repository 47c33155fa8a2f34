// What is done to the selected lines of the model tree.
#include "ui/panels/model_tree.h"

#include "ui/language/said.h"
#include <QColorDialog>
#include <QDropEvent>
#include <QTimer>

#include <algorithm>

namespace knead {

namespace {

Color colorOf(const QColor& color)
{
    return {static_cast<float>(color.redF()), static_cast<float>(color.greenF()), static_cast<float>(color.blueF())};
}

} // namespace

std::vector<QTreeWidgetItem*> ModelTree::chosen() const
{
    const QList<QTreeWidgetItem*> items = selectedItems();
    std::vector<QTreeWidgetItem*> result(items.begin(), items.end());
    if (result.empty() && currentItem() != nullptr)
        result.push_back(currentItem());
    return result;
}

std::set<std::size_t> ModelTree::partsBelow(QTreeWidgetItem* item) const
{
    std::set<std::size_t> parts;
    if (const QVariant part = item->data(0, tree_roles::part); part.isValid())
        parts.insert(part.toULongLong());
    for (int i = 0; i < item->childCount(); ++i)
        parts.merge(partsBelow(item->child(i)));
    return parts;
}

std::set<std::size_t> ModelTree::chosenParts() const
{
    std::set<std::size_t> parts;
    for (QTreeWidgetItem* item : chosen())
        parts.merge(partsBelow(item));
    return parts;
}

void ModelTree::renameCurrent()
{
    QTreeWidgetItem* item = currentItem() != nullptr ? currentItem() : find(m_document.selection());
    if (item == nullptr || !item->data(0, tree_roles::name).isValid())
        return;
    window()->activateWindow();
    setFocus();
    scrollToItem(item);
    editItem(item);
}

void ModelTree::rename(QTreeWidgetItem* item, const QString& name)
{
    const QString before = item->data(0, tree_roles::name).toString();
    const QString wanted = name.trimmed();
    if (wanted == before)
        return;
    const TreeItem type = typeOf(item);
    // The line may be another one afterwards, and the editor is still open.
    const auto later = [this](std::function<void()> action) { QTimer::singleShot(0, this, std::move(action)); };
    if (type == TreeItem::Part || type == TreeItem::Surface) {
        const auto part = static_cast<std::size_t>(item->data(0, tree_roles::part).toULongLong());
        later([this, part, wanted] { m_document.renamePart(part, wanted); });
    } else if (type == TreeItem::Tool) {
        later([this, id = selectionOf(item).id, wanted] { m_document.renameTool(id, wanted); });
    } else if (type == TreeItem::Fixture) {
        later([this, key = selectionOf(item).id, wanted] { m_document.renameFixture(key, wanted); });
    } else if (type == TreeItem::Group) {
        later([this, before, wanted] { m_document.notes().renameGroup(before.toStdString(), wanted.toStdString()); });
    } else if (type == TreeItem::Set) {
        later([this, before, wanted] {
            if (!m_document.notes().renameSet(before.toStdString(), wanted.toStdString()) && !wanted.isEmpty())
                emit problem(
                    said(Message("ModelTree", "There is a selection called \"%1\" already: choose another name.")
                             .with(wanted.toStdString())));
        });
    }
}

void ModelTree::colorSelected()
{
    const std::set<std::size_t> parts = chosenParts();
    if (parts.empty())
        return;
    const Color now = m_document.appearance().partColor(*m_document.content().model, *parts.begin());
    auto* dialog = new QColorDialog(QColor::fromRgbF(now.r, now.g, now.b), window());
    dialog->setObjectName("partColorDialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    dialog->setWindowTitle(parts.size() == 1 ? tr("Color of the part") : tr("Color of %1 parts").arg(parts.size()));
    connect(dialog, &QColorDialog::colorSelected, this, [this, parts, opening = m_opening](const QColor& color) {
        if (opening != m_document.opening()) // another part was opened meanwhile
            return;
        for (const std::size_t part : parts)
            m_document.colorPart(part, colorOf(color));
    });
    dialog->open();
}

void ModelTree::uncolorSelected()
{
    for (const std::size_t part : chosenParts())
        m_document.colorPart(part, std::nullopt);
}

void ModelTree::lockSelected()
{
    std::vector<Selection> lockable;
    const std::vector<QTreeWidgetItem*> lines = chosen();
    for (QTreeWidgetItem* item : all()) {
        const auto isBelow = [&] {
            for (const QTreeWidgetItem* above = item; above != nullptr; above = above->parent())
                if (std::find(lines.begin(), lines.end(), above) != lines.end())
                    return true;
            return false;
        };
        if (item->data(0, tree_roles::lock).isValid() && isBelow())
            lockable.push_back(selectionOf(item));
    }
    const bool areLocked =
        std::all_of(lockable.begin(), lockable.end(), [this](const Selection& s) { return m_document.isLocked(s); });
    for (const Selection& selection : lockable)
        m_document.setLocked(selection, !areLocked);
}

void ModelTree::groupSelected()
{
    const std::set<std::size_t> parts = chosenParts();
    if (parts.empty())
        return;
    const std::string name = m_document.notes().freeGroupName();
    m_document.notes().addGroup(name, parts);
    for (QTreeWidgetItem* item : all())
        if (typeOf(item) == TreeItem::Group && item->data(0, tree_roles::name).toString().toStdString() == name) {
            setCurrentItem(item, 0, QItemSelectionModel::NoUpdate);
            editItem(item);
        }
}

void ModelTree::ungroupSelected()
{
    for (QTreeWidgetItem* item : chosen())
        if (typeOf(item) == TreeItem::Group) {
            m_document.notes().removeGroup(item->data(0, tree_roles::name).toString().toStdString());
            return; // the lines are others now
        }
    if (const std::set<std::size_t> parts = chosenParts(); !parts.empty())
        m_document.notes().takeOutOfGroup(parts);
}

// --- dragging -------------------------------------------------------------------------------------------------------------

void ModelTree::dragMoveEvent(QDragMoveEvent* event)
{
    QTreeWidget::dragMoveEvent(event);
    const QTreeWidgetItem* target = itemAt(event->position().toPoint());
    const bool canDrop = target != nullptr && (typeOf(target) == TreeItem::Group || typeOf(target) == TreeItem::File ||
                                               typeOf(target) == TreeItem::Assembly);
    event->setAccepted(canDrop);
}

/// Onto a group: into it; onto anything else above: out of the one they are in.
void ModelTree::dropEvent(QDropEvent* event)
{
    const QTreeWidgetItem* target = itemAt(event->position().toPoint());
    const std::set<std::size_t> parts = chosenParts();
    event->setDropAction(Qt::CopyAction); // else the view takes the dragged lines away
    event->accept();
    if (target == nullptr || parts.empty())
        return;
    const bool isGroup = typeOf(target) == TreeItem::Group;
    const std::string name = target->data(0, tree_roles::name).toString().toStdString();
    QTimer::singleShot(0, this, [this, isGroup, name, parts] { // the view is in the middle of the dragging
        if (isGroup)
            m_document.notes().addGroup(name, parts);
        else
            m_document.notes().takeOutOfGroup(parts);
    });
}

} // namespace knead
