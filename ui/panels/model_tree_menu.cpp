// What the model tree offers for a line.
#include "ui/panels/model_tree.h"

#include "ui/language/said.h"
#include "ui/selection/selection_model.h"
#include "ui/theme.h"

#include <QContextMenuEvent>
#include <QDesktopServices>
#include <QFileInfo>
#include <QMenu>
#include <QUrl>

namespace knead {

void ModelTree::contextMenuEvent(QContextMenuEvent* event)
{
    const bool isByMouse = event->reason() == QContextMenuEvent::Mouse;
    QTreeWidgetItem* item = isByMouse ? itemAt(event->pos()) : currentItem();
    if (m_document.isEmpty() || item == nullptr)
        return;
    if (!isByMouse)
        m_regionBefore = m_document.selected().region();
    if (!item->isSelected())
        setCurrentItem(item);
    auto* menu = new QMenu(this);
    menu->setObjectName("modelMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    const TreeItem type = typeOf(item);
    if (type == TreeItem::Set)
        fillSetMenu(*menu, item->data(0, tree_roles::name).toString().toStdString());
    if (type == TreeItem::Export)
        fillExportMenu(*menu, item->data(0, tree_roles::file).toString());
    if (m_fillMenu)
        m_fillMenu(*menu, type);
    if (menu->isEmpty())
        delete menu;
    else
        menu->popup(isByMouse ? event->globalPos() : viewport()->mapToGlobal(visualItemRect(item).center()));
}

void ModelTree::fillSetMenu(QMenu& menu, const std::string& name)
{
    connect(menu.addAction(icon("selection"), tr("Select")), &QAction::triggered, this,
            [this, name] { selectSet(name); });
    // The click on the line selected what is in it; what is meant is what was selected before.
    QAction* replace = menu.addAction(tr("Keep the present selection here"));
    replace->setEnabled(!m_regionBefore.isEmpty());
    connect(replace, &QAction::triggered, this, [this, name, region = m_regionBefore] {
        m_document.keepSet(QString::fromStdString(name), region);
        selectSet(name);
    });
    connect(menu.addAction(icon("delete"), tr("Delete")), &QAction::triggered, this,
            [this, name] { m_document.notes().removeSet(name); });
}

void ModelTree::fillExportMenu(QMenu& menu, const QString& file)
{
    const QString folder = QFileInfo(file).absolutePath();
    connect(menu.addAction(icon("open"), tr("Show in its folder")), &QAction::triggered, this, [this, folder] {
        if (!QFileInfo::exists(folder) || !QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
            emit problem(said(Message("ModelTree", "The folder %1 cannot be shown: look for it with your file manager.")
                                  .with(folder.toStdString())));
    });
    connect(menu.addAction(icon("delete"), tr("Take off the list")), &QAction::triggered, this,
            [this, file] { m_document.notes().forgetExport(QFile::encodeName(file).toStdString()); });
}

} // namespace knead
