#include "ui/panels/model_tree.h"

#include "ui/document/tool_kinds.h"
#include "ui/theme.h"

#include <QFileInfo>
#include <QPainter>
#include <QScopedValueRollback>

#include <algorithm>

namespace knead {

namespace {

constexpr int kindRole = Qt::UserRole;
constexpr int idRole = Qt::UserRole + 1;
constexpr int partRole = Qt::UserRole + 2; ///< index into Model::parts

Selection selectionOf(const QTreeWidgetItem* item)
{
    if (item == nullptr || !item->data(0, kindRole).isValid())
        return {};
    return {static_cast<Selection::Kind>(item->data(0, kindRole).toInt()), item->data(0, idRole).toUInt()};
}

void markItem(QTreeWidgetItem* item, const Selection& selection)
{
    item->setData(0, kindRole, static_cast<int>(selection.kind));
    item->setData(0, idRole, selection.id);
}

/// A swatch in the color of the part.
QIcon swatch(const Color& color)
{
    constexpr int side = 32;
    QPixmap pixmap(side, side);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0, 0, 0, 110), 2));
    painter.setBrush(QColor::fromRgbF(color.r, color.g, color.b));
    painter.drawRoundedRect(3, 3, side - 6, side - 6, 6, 6);
    return QIcon(pixmap);
}

QTreeWidgetItem* makeItem(QTreeWidgetItem* parent, const QString& text, const QIcon& image)
{
    auto* item = new QTreeWidgetItem(parent, {text});
    item->setIcon(0, image);
    return item;
}

void clearChildren(QTreeWidgetItem* item)
{
    qDeleteAll(item->takeChildren());
}

} // namespace

ModelTree::ModelTree(Document& document, QWidget* parent)
    : QTreeWidget(parent)
    , m_document(document)
{
    setObjectName("modelTree");
    setHeaderHidden(true);
    setIndentation(16);
    setIconSize({16, 16});
    setUniformRowHeights(true);
    connect(&document, &Document::changed, this, &ModelTree::documentChanged);
    connect(this, &QTreeWidget::currentItemChanged, this, &ModelTree::currentChanged);
    connect(this, &QTreeWidget::itemChanged, this, &ModelTree::itemChecked);
}

void ModelTree::documentChanged(Document::Change what)
{
    const QScopedValueRollback updating(m_isUpdating, true);
    switch (what) {
    case Document::Change::Content:
        build();
        break;
    case Document::Change::Frame:
        listTools();
        break;
    case Document::Change::Fixtures:
        listFixtures();
        break;
    case Document::Change::Selection:
    case Document::Change::History:
    case Document::Change::Moment:
        break;
    }
    if (what != Document::Change::Frame)
        showSelection();
}

void ModelTree::build()
{
    clear();
    m_listedTools.clear();
    const Model& model = *m_document.content().model;
    auto* root = new QTreeWidgetItem(this, {QFileInfo(QString::fromStdString(model.file)).fileName()});
    root->setIcon(0, icon("assembly"));
    root->setToolTip(0, QString::fromStdString(model.file));
    if (model.tree.part)
        addParts(model.tree, root);
    for (const PartNode& child : model.tree.children)
        addParts(child, root);
    m_tools = new QTreeWidgetItem(this, {tr("Tools")});
    m_tools->setIcon(0, icon("block"));
    m_fixtures = new QTreeWidgetItem(this, {tr("Fixtures")});
    m_fixtures->setIcon(0, icon("fix"));
    for (QTreeWidgetItem* group : {root, m_tools, m_fixtures})
        group->setFlags(Qt::ItemIsEnabled);
    expandAll();
    listTools();
    listFixtures();
}

void ModelTree::addParts(const PartNode& node, QTreeWidgetItem* parent)
{
    const QString name = QString::fromStdString(node.name);
    if (node.part && node.children.empty()) {
        addPart(*node.part, name, parent);
        return;
    }
    QTreeWidgetItem* group = makeItem(parent, name.isEmpty() ? tr("Assembly") : name, icon("assembly"));
    group->setFlags(Qt::ItemIsEnabled);
    if (node.part)
        addPart(*node.part, name, group);
    for (const PartNode& child : node.children)
        addParts(child, group);
}

void ModelTree::addPart(std::size_t part, const QString& name, QTreeWidgetItem* parent)
{
    const auto& bodies = m_document.content().bodies;
    const auto body = std::find_if(bodies.begin(), bodies.end(), [part](const auto& b) { return b->part == part; });
    if (body == bodies.end()) {
        QTreeWidgetItem* item = makeItem(parent, name, icon("surface"));
        const bool isShown = !m_document.content().model->parts[part].mesh.empty();
        item->setFlags(isShown ? Qt::ItemIsEnabled | Qt::ItemIsUserCheckable : Qt::NoItemFlags);
        item->setToolTip(0, tr("Not a closed solid: it is not simulated."));
        if (isShown)
            markVisible(item, part);
        return;
    }
    QTreeWidgetItem* item = makeItem(parent, QString::fromStdString((*body)->name), swatch((*body)->color));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    markVisible(item, part);
    markItem(item, {Selection::Kind::Body, static_cast<std::uint32_t>(body - bodies.begin())});
}

/// Gives an item the check box that hides its part.
void ModelTree::markVisible(QTreeWidgetItem* item, std::size_t part)
{
    item->setData(0, partRole, static_cast<qulonglong>(part));
    item->setCheckState(0, m_document.content().model->parts[part].visible ? Qt::Checked : Qt::Unchecked);
}

void ModelTree::listTools()
{
    std::vector<ListedTool> tools;
    for (const ToolState& tool : m_document.frame()->snapshot->tools)
        tools.push_back({tool.id, tool.name, tool.kind});
    m_tools->setHidden(tools.empty());
    if (tools == m_listedTools)
        return;
    m_listedTools = tools;
    clearChildren(m_tools);
    for (const ListedTool& tool : tools)
        markItem(makeItem(m_tools, QString::fromStdString(tool.name), icon(lookOf(tool.kind).icon)),
                 {Selection::Kind::Tool, tool.id});
    m_tools->setExpanded(true);
    showSelection();
}

void ModelTree::listFixtures()
{
    clearChildren(m_fixtures);
    for (const FaceFixture& fixture : m_document.fixtures().list()) {
        const QString faces = fixture.faces.empty()       ? tr("objects")
                              : fixture.faces.size() == 1 ? tr("1 face")
                                                          : tr("%1 faces").arg(fixture.faces.size());
        const QString text = QStringLiteral("%1 (%2)").arg(QString::fromStdString(fixture.name), faces);
        markItem(makeItem(m_fixtures, text, icon("fix")), {Selection::Kind::Fixture, fixture.key});
    }
    m_fixtures->setHidden(m_fixtures->childCount() == 0);
    m_fixtures->setExpanded(true);
}

QTreeWidgetItem* ModelTree::find(const Selection& selection) const
{
    for (QTreeWidgetItemIterator it(const_cast<ModelTree*>(this)); *it != nullptr; ++it)
        if (selection.kind != Selection::Kind::None && selectionOf(*it) == selection)
            return *it;
    return nullptr;
}

void ModelTree::showSelection()
{
    const QScopedValueRollback updating(m_isUpdating, true);
    QTreeWidgetItem* item = find(m_document.selection());
    setCurrentItem(item);
    if (item == nullptr)
        clearSelection();
}

void ModelTree::currentChanged()
{
    const Selection selection = selectionOf(currentItem());
    if (!m_isUpdating && selection.kind != Selection::Kind::None)
        m_document.select(selection);
}

void ModelTree::itemChecked(QTreeWidgetItem* /*item*/)
{
    if (m_isUpdating)
        return;
    std::set<std::size_t> hiddenParts;
    for (QTreeWidgetItemIterator it(this); *it != nullptr; ++it)
        if ((*it)->data(0, partRole).isValid() && (*it)->checkState(0) == Qt::Unchecked)
            hiddenParts.insert((*it)->data(0, partRole).toULongLong());
    emit hiddenChanged(hiddenParts);
}

void ModelTree::hideParts(const std::set<std::size_t>& parts)
{
    {
        const QScopedValueRollback updating(m_isUpdating, true);
        for (QTreeWidgetItemIterator it(this); *it != nullptr; ++it)
            if (const QVariant part = (*it)->data(0, partRole); part.isValid())
                (*it)->setCheckState(0, parts.contains(part.toULongLong()) ? Qt::Unchecked : Qt::Checked);
    }
    emit hiddenChanged(parts);
}

void ModelTree::toggleSelectedBody()
{
    QTreeWidgetItem* item = find(m_document.selection());
    if (item != nullptr && selectionOf(item).kind == Selection::Kind::Body)
        item->setCheckState(0, item->checkState(0) == Qt::Checked ? Qt::Unchecked : Qt::Checked);
}

} // namespace knead
