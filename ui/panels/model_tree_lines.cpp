// Which lines the model tree has, and how they look.
#include "ui/panels/model_tree.h"

#include "ui/document/tool_kinds.h"
#include "ui/language/said.h"
#include "ui/theme.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace knead {

namespace {

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
    painter.end();
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // in a selected line, too, it is the color of the part
    return icon;
}

QTreeWidgetItem* makeItem(QTreeWidgetItem* parent, const QString& text, const QIcon& image, TreeItem type)
{
    auto* item = new QTreeWidgetItem(parent, {text});
    item->setIcon(0, image);
    item->setData(0, tree_roles::type, static_cast<int>(type));
    item->setFlags(Qt::ItemIsEnabled);
    return item;
}

constexpr Qt::ItemFlags selectable = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
constexpr Qt::ItemFlags grouping =
    Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsAutoTristate | Qt::ItemIsDropEnabled;

const char* iconOf(Level level)
{
    switch (level) {
    case Level::Part:
        return "part";
    case Level::Face:
        return "select-face";
    case Level::Edge:
        return "select-edge";
    case Level::Object:
        return "objects";
    case Level::Connection:
        break;
    }
    return "select-connection";
}

void clearChildren(QTreeWidgetItem* item)
{
    qDeleteAll(item->takeChildren());
}

} // namespace

QTreeWidgetItem* ModelTree::makeHeading(const QString& text, const char* image, TreeItem type)
{
    auto* item = new QTreeWidgetItem(this, {text});
    item->setIcon(0, icon(image));
    item->setData(0, tree_roles::type, static_cast<int>(type));
    item->setFlags(Qt::ItemIsEnabled);
    return item;
}

void ModelTree::build()
{
    clear();
    m_listedTools.clear();
    m_tools = m_fixtures = m_sets = m_exports = nullptr;
    if (m_document.history().isEmpty()) // it was closed
        return;
    const Model& model = *m_document.content().model;
    auto* root = makeHeading(QFileInfo(QString::fromStdString(model.file)).fileName(), "assembly", TreeItem::File);
    root->setFlags(Qt::ItemIsEnabled | Qt::ItemIsDropEnabled);
    root->setToolTip(0, QString::fromStdString(model.file));
    addGroups(root);
    if (model.tree.part)
        addParts(model.tree, root);
    for (const PartNode& child : model.tree.children)
        addParts(child, root);
    m_tools = makeHeading(tr("Tools"), "block", TreeItem::Tools);
    m_fixtures = makeHeading(tr("Fixtures"), "fix", TreeItem::Fixtures);
    m_sets = makeHeading(tr("Selections"), "selection", TreeItem::Sets);
    m_exports = makeHeading(tr("Exports"), "export", TreeItem::Exports);
    expandAll();
    listTools();
    listFixtures();
    listSets();
    listExports();
    filter(m_filter);
}

void ModelTree::addGroups(QTreeWidgetItem* parent)
{
    m_shownGroups.clear();
    const Model& model = *m_document.content().model;
    for (const ModelNotes::Group& group : m_document.notes().groups()) {
        m_shownGroups.emplace_back(group.name, group.parts);
        const QString name = QString::fromStdString(group.name);
        QTreeWidgetItem* item = makeItem(parent, name, icon("group"), TreeItem::Group);
        item->setFlags(grouping | Qt::ItemIsEditable);
        item->setData(0, tree_roles::name, name);
        for (const std::size_t part : group.parts)
            if (part < model.parts.size())
                addPart(part, QString::fromStdString(model.parts[part].name), item);
    }
}

void ModelTree::addParts(const PartNode& node, QTreeWidgetItem* parent)
{
    const QString name = QString::fromStdString(node.name);
    const auto addUngrouped = [&](QTreeWidgetItem* to) {
        if (m_document.notes().groupOf(*node.part) == nullptr)
            addPart(*node.part, name, to);
    };
    if (node.part && node.children.empty()) {
        addUngrouped(parent);
        return;
    }
    QTreeWidgetItem* assembly =
        makeItem(parent, name.isEmpty() ? tr("Assembly") : name, icon("assembly"), TreeItem::Assembly);
    assembly->setFlags(grouping);
    if (node.part)
        addUngrouped(assembly);
    for (const PartNode& child : node.children)
        addParts(child, assembly);
    if (assembly->childCount() == 0) // all of it is in groups
        delete assembly;
}

void ModelTree::addPart(std::size_t part, const QString& name, QTreeWidgetItem* parent)
{
    const auto& bodies = m_document.content().bodies;
    const auto body = std::find_if(bodies.begin(), bodies.end(), [part](const auto& b) { return b->part == part; });
    if (body == bodies.end()) {
        QTreeWidgetItem* item = makeItem(parent, name, icon("surface"), TreeItem::Surface);
        const bool isShown = !m_document.content().model->parts[part].mesh.empty();
        item->setFlags(isShown ? Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsEditable : Qt::NoItemFlags);
        item->setToolTip(0, tr("Not a closed solid: it is not simulated."));
        if (isShown)
            markVisible(item, part);
        dress(item);
        return;
    }
    QTreeWidgetItem* item = makeItem(parent, QString::fromStdString((*body)->name), {}, TreeItem::Part);
    item->setFlags(selectable | Qt::ItemIsUserCheckable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled);
    markVisible(item, part);
    item->setData(0, tree_roles::id, static_cast<std::uint32_t>(body - bodies.begin()));
    item->setData(0, tree_roles::lock, m_document.isLocked(selectionOf(item)));
    dress(item);
}

/// Name and color of a part.
void ModelTree::dress(QTreeWidgetItem* item)
{
    const QVariant index = item->data(0, tree_roles::part);
    if (!index.isValid())
        return;
    const auto part = static_cast<std::size_t>(index.toULongLong());
    const Model& model = *m_document.content().model;
    const bool isBody = typeOf(item) == TreeItem::Part;
    const QString name =
        isBody ? m_document.nameOfBody(item->data(0, tree_roles::id).toUInt()) : m_document.nameOfPart(part);
    item->setText(0, name);
    item->setData(0, tree_roles::name, name);
    if (isBody)
        item->setIcon(0, swatch(m_document.appearance().partColor(model, part)));
    if (isBody && !m_document.appearance().chosenName(part).empty())
        item->setToolTip(0, said(Message("ModelTree", "In the file: %1").with(model.parts[part].name)));
    else if (isBody)
        item->setToolTip(0, {});
}

/// Gives an item the check box that hides its part.
void ModelTree::markVisible(QTreeWidgetItem* item, std::size_t part)
{
    item->setData(0, tree_roles::part, static_cast<qulonglong>(part));
    item->setCheckState(0, m_hiddenParts.contains(part) ? Qt::Unchecked : Qt::Checked);
}

void ModelTree::listTools()
{
    std::vector<ListedTool> tools;
    for (const ToolState& tool : m_document.frame()->snapshot->tools)
        tools.push_back({tool.id, tool.name, tool.kind});
    if (tools == m_listedTools)
        return;
    m_listedTools = tools;
    clearChildren(m_tools);
    for (const ListedTool& tool : tools) {
        QTreeWidgetItem* item =
            makeItem(m_tools, QString::fromStdString(tool.name), icon(lookOf(tool.kind).icon), TreeItem::Tool);
        item->setFlags(selectable | Qt::ItemIsEditable);
        item->setData(0, tree_roles::name, QString::fromStdString(tool.name));
        item->setData(0, tree_roles::id, tool.id);
        item->setData(0, tree_roles::lock, m_document.isLocked(selectionOf(item)));
    }
    m_tools->setExpanded(true);
    filterBelow(m_tools, m_filter, false);
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
        QTreeWidgetItem* item = makeItem(m_fixtures, text, icon("fix"), TreeItem::Fixture);
        item->setFlags(selectable | Qt::ItemIsEditable);
        item->setData(0, tree_roles::name, QString::fromStdString(fixture.name));
        item->setData(0, tree_roles::id, fixture.key);
        item->setData(0, tree_roles::lock, m_document.isLocked(selectionOf(item)));
    }
    m_fixtures->setExpanded(true);
    filterBelow(m_fixtures, m_filter, false);
}

void ModelTree::listSets()
{
    const QString current = currentItem() != nullptr && typeOf(currentItem()) == TreeItem::Set
                                ? currentItem()->data(0, tree_roles::name).toString()
                                : QString();
    clearChildren(m_sets);
    for (const SelectionSet& set : m_document.notes().sets()) {
        const QString name = QString::fromStdString(set.name);
        QTreeWidgetItem* item = makeItem(m_sets, name, icon(iconOf(set.level)), TreeItem::Set);
        item->setFlags(selectable | Qt::ItemIsEditable);
        item->setData(0, tree_roles::name, name);
        std::size_t count = 0;
        for (const auto& [part, items] : set.items)
            count += items.size();
        item->setToolTip(0, said(Message("ModelTree", "%1 selected things; a click selects them again").with(count)));
        if (name == current)
            setCurrentItem(item, 0, QItemSelectionModel::NoUpdate);
    }
    m_sets->setExpanded(true);
    filterBelow(m_sets, m_filter, false);
}

void ModelTree::listExports()
{
    clearChildren(m_exports);
    for (const ModelNotes::Export& one : m_document.notes().exports()) {
        const QString file = QFile::decodeName(one.file.c_str());
        QTreeWidgetItem* item = makeItem(m_exports, QFileInfo(file).fileName(), icon("export"), TreeItem::Export);
        item->setData(0, tree_roles::file, file);
        const QDateTime time = QDateTime::fromSecsSinceEpoch(static_cast<qint64>(one.wallTime));
        item->setToolTip(0, file + '\n' + QLocale().toString(time, QLocale::ShortFormat));
    }
    m_exports->setExpanded(true);
    filterBelow(m_exports, m_filter, false);
}

void ModelTree::showLocks()
{
    for (QTreeWidgetItem* item : all())
        if (item->data(0, tree_roles::lock).isValid())
            item->setData(0, tree_roles::lock, m_document.isLocked(selectionOf(item)));
}

} // namespace knead
