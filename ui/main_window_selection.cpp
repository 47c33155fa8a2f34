// Selecting in the main window, and what is done with lines of the model tree.
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/display.h"
#include "ui/modes.h"
#include "ui/panels/model_panel.h"
#include "ui/panels/model_tree.h"
#include "ui/panels/panel_area.h"
#include "ui/panels/selection_panel.h"
#include "ui/selection/region_contents.h"
#include "ui/selection/selection_model.h"
#include "ui/selection_actions.h"
#include "ui/units.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>

namespace knead {

namespace {

constexpr double brushStep = 1.25; // of the radius

/// Everything of a kind that a body has.
Region::Items allOf(Level level, const Content& content, const ContentBody& body)
{
    Region::Items items;
    const auto count = [&](std::size_t number) {
        items.resize(number);
        std::iota(items.begin(), items.end(), Region::Item{0});
    };
    switch (level) {
    case Level::Part:
        count(1);
        break;
    case Level::Face:
        count(content.model->parts[body.part].faces.size());
        break;
    case Level::Edge:
        count(body.render.chains);
        break;
    case Level::Object:
        count(body.aggregate->size());
        break;
    case Level::Connection:
        for (const ConnectionId& connection : allConnections(*body.aggregate))
            items.push_back(connectionItem(connection));
        break;
    }
    return items;
}

} // namespace

void MainWindow::makeSelection()
{
    m_selection = std::make_unique<SelectionActions>(this);
    m_selectionPanel = new SelectionPanel(m_document, *m_materials);
    m_properties->addWidget(scrolled(m_selectionPanel)); // in the order of Selection::Kind
    m_selectionReading = new QLabel(this);
    m_selectionReading->setObjectName("selectionReading");
    m_selectionReading->setContentsMargins(8, 0, 0, 0);
    statusBar()->insertWidget(0, m_selectionReading);
    m_selectionReading->hide();
    makeSelectionMenus();
    makeSelectionBar();
    connectSelection();
    connectTree();
}

void MainWindow::makeSelectionMenus()
{
    const SelectionActions& s = *m_selection;
    const auto menuWith = [this](QAction* action) {
        const auto menus = menuBar()->actions();
        const auto found = std::find_if(menus.begin(), menus.end(), [action](const QAction* one) {
            return one->menu()->actions().contains(action);
        });
        return (*found)->menu();
    };
    QMenu* edit = menuWith(m_actions->undo);
    edit->addSeparator();
    edit->addActions({s.rename, s.color, s.uncolor, s.lock, s.group, s.ungroup});
    edit->addSeparator();
    edit->addAction(s.search);
    QMenu* view = menuWith(m_actions->hide);
    view->insertActions(m_actions->hide, {s.isolate, s.showAll});

    auto* select = new QMenu(tr("Se&lect"), this);
    select->setObjectName("selectMenu");
    select->setToolTipsVisible(true);
    select->addActions(s.levels);
    select->addSeparator();
    select->addActions(s.shapes);
    select->addActions({s.smallerBrush, s.largerBrush, s.through});
    select->addSeparator();
    select->addActions({s.all, s.none, s.within});
    select->addSeparator();
    select->addActions({s.keep, s.fix, s.renormalize, s.glue});
    menuBar()->insertMenu(view->menuAction(), select);
}

/// Beside the view, where the hand is.
void MainWindow::makeSelectionBar()
{
    auto* bar = new QToolBar(tr("Selecting"), centralWidget());
    bar->setObjectName("selectionBar");
    bar->setOrientation(Qt::Vertical);
    bar->setIconSize({20, 20});
    bar->setStyleSheet("QToolBar { border: none; border-right: 1px solid palette(mid); padding: 6px 3px; }");
    bar->addActions(m_selection->levels);
    bar->addSeparator();
    bar->addActions(m_selection->shapes);
    auto* column = qobject_cast<QVBoxLayout*>(centralWidget()->layout());
    column->removeWidget(m_pages);
    auto* row = new QHBoxLayout;
    row->setSpacing(0);
    row->addWidget(bar);
    row->addWidget(m_pages, 1);
    column->addLayout(row, 1);
}

void MainWindow::connectSelection()
{
    const SelectionActions& s = *m_selection;
    SelectionModel& selected = m_document.selected();
    for (QAction* level : s.levels)
        connect(level, &QAction::triggered, this, [this, level] {
            m_modes->leave();
            m_document.selected().setLevel(static_cast<Level>(level->data().toInt()));
        });
    for (QAction* shape : s.shapes)
        connect(shape, &QAction::triggered, this, [this, shape] {
            m_modes->leave();
            m_viewport->regions().setShape(static_cast<RegionShape>(shape->data().toInt()));
        });
    RegionTool& regions = m_viewport->regions();
    connect(s.smallerBrush, &QAction::triggered, this,
            [&regions] { regions.setBrushRadius(regions.brushRadius() / brushStep); });
    connect(s.largerBrush, &QAction::triggered, this,
            [&regions] { regions.setBrushRadius(regions.brushRadius() * brushStep); });
    connect(s.through, &QAction::triggered, &selected, &SelectionModel::setThrough);
    connect(&selected, &SelectionModel::levelChanged, this, &MainWindow::showLevel);
    connect(&selected, &SelectionModel::changed, this, &MainWindow::showSelected);
    connect(s.all, &QAction::triggered, this, &MainWindow::selectAll);
    connect(s.none, &QAction::triggered, &selected, &SelectionModel::clear);
    const auto atPanel = [this](void (SelectionPanel::*begin)()) {
        return [this, begin] {
            m_properties->setCurrentIndex(static_cast<int>(Selection::Kind::Region));
            auto* dock = qobject_cast<QDockWidget*>(m_properties->parentWidget());
            dock->show();
            dock->raise();
            (m_selectionPanel->*begin)();
        };
    };
    connect(s.within, &QAction::triggered, this, atPanel(&SelectionPanel::beginWithin));
    connect(s.keep, &QAction::triggered, this, atPanel(&SelectionPanel::beginKeeping));
    connect(s.fix, &QAction::triggered, m_selectionPanel, &SelectionPanel::fix);
    connect(s.renormalize, &QAction::triggered, m_selectionPanel, &SelectionPanel::renormalize);
    connect(s.glue, &QAction::triggered, m_selectionPanel, &SelectionPanel::glue);
    connect(m_selectionPanel, &SelectionPanel::withinRequested, this, &MainWindow::selectWithin);
    connect(&m_document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Content) {
            m_selection->setDocumentOpen(true, !m_document.content().bodies.empty());
            showSelected();
        }
        if (what == Document::Change::Content || what == Document::Change::Selection)
            showLock();
    });
    connect(m_selectionPanel, &SelectionPanel::read, m_selectionReading, &QLabel::setText);
    showLevel();
}

void MainWindow::connectTree()
{
    const SelectionActions& s = *m_selection;
    m_tree->addAction(s.rename);
    m_viewport->addAction(s.rename);
    connect(s.rename, &QAction::triggered, m_tree, &ModelTree::renameCurrent);
    connect(s.color, &QAction::triggered, m_tree, &ModelTree::colorSelected);
    connect(s.uncolor, &QAction::triggered, m_tree, &ModelTree::uncolorSelected);
    connect(s.lock, &QAction::triggered, m_tree, &ModelTree::lockSelected);
    connect(s.group, &QAction::triggered, m_tree, &ModelTree::groupSelected);
    connect(s.ungroup, &QAction::triggered, m_tree, &ModelTree::ungroupSelected);
    connect(s.isolate, &QAction::triggered, m_tree, &ModelTree::isolateSelected);
    connect(s.showAll, &QAction::triggered, m_tree, &ModelTree::showAll);
    auto* panel = qobject_cast<ModelPanel*>(m_tree->parentWidget());
    connect(s.search, &QAction::triggered, this, [panel] {
        auto* dock = qobject_cast<QDockWidget*>(panel->parentWidget());
        dock->show();
        dock->raise();
        panel->beginSearch();
    });
    connect(m_tree, &ModelTree::toolClicked, m_viewport, [this] { m_viewport->setFocus(); }); // whose keys drive it
    connect(m_tree, &ModelTree::problem, this, [this](const QString& sentence) { showProblem(sentence); });
    connect(&m_document.notes(), &ModelNotes::changed, this, &MainWindow::showLock);
    m_tree->setMenu([this](QMenu& menu, TreeItem type) { fillTreeMenu(menu, static_cast<int>(type)); });
}

/// @param type a TreeItem
void MainWindow::fillTreeMenu(QMenu& menu, int type) const
{
    const SelectionActions& s = *m_selection;
    switch (static_cast<TreeItem>(type)) {
    case TreeItem::Part:
        menu.addActions({s.rename, s.color, s.uncolor});
        menu.addSeparator();
        menu.addActions({m_actions->hide, s.isolate, s.showAll});
        menu.addSeparator();
        menu.addActions({s.lock, s.group, s.ungroup});
        menu.addSeparator();
        menu.addActions({s.fix, m_actions->renormalize, s.glue, s.keep});
        break;
    case TreeItem::Surface:
        menu.addActions({s.rename, s.color, s.uncolor, s.showAll});
        break;
    case TreeItem::Group:
        menu.addActions({s.rename, s.ungroup});
        menu.addSeparator();
        menu.addActions({m_actions->hide, s.isolate, s.showAll, s.lock});
        break;
    case TreeItem::Assembly:
        menu.addActions({m_actions->hide, s.isolate, s.showAll, s.lock, s.group});
        break;
    case TreeItem::Tool:
    case TreeItem::Fixture:
        menu.addActions({s.rename, s.lock, m_actions->remove});
        break;
    case TreeItem::Set:
        menu.addSeparator();
        menu.addActions({s.rename, s.fix, s.renormalize, s.within});
        break;
    case TreeItem::File:
        menu.addActions({s.showAll, s.search});
        break;
    case TreeItem::Tools:
        menu.addActions(m_actions->addTool);
        break;
    case TreeItem::Fixtures:
    case TreeItem::Sets:
    case TreeItem::Exports:
    case TreeItem::Export:
        break;
    }
}

/// To select objects one has to see them.
void MainWindow::showLevel()
{
    const SelectionModel& selected = m_document.selected();
    const Level level = selected.level();
    m_selection->levels.at(static_cast<int>(level))->setChecked(true);
    m_selection->through->setChecked(selected.isThrough());
    m_display->lendObjects(level == Level::Object || level == Level::Connection);
}

/// What can be done with it; how much it is says the selection panel.
void MainWindow::showSelected()
{
    const bool isAnything = !m_document.selected().region().isEmpty() && !m_document.isEmpty();
    m_selection->setSelected(isAnything);
    m_selectionReading->setVisible(isAnything);
    showLock();
}

/// What is locked may not be changed in the properties. It can be read to its end: the page around it scrolls.
void MainWindow::showLock()
{
    const bool isLocked = !m_document.isEmpty() && m_document.isLocked(m_document.selection());
    for (int page = 0; page < m_properties->count(); ++page)
        if (const auto* area = qobject_cast<QScrollArea*>(m_properties->widget(page)))
            area->widget()->setEnabled(page != m_properties->currentIndex() || !isLocked);
}

void MainWindow::selectAll()
{
    const Content& content = m_document.content();
    Region region;
    region.level = m_document.selected().level();
    for (BodyId body = 0; body < content.bodies.size(); ++body)
        if (!m_tree->hiddenParts().contains(content.bodies[body]->part))
            region = united(region, regionOf(region.level, body, allOf(region.level, content, *content.bodies[body])));
    m_document.selected().select(region);
}

void MainWindow::selectWithin(double distance)
{
    if (m_document.isEmpty() || m_document.selected().region().isEmpty() || isBusy())
        return;
    const auto work = [bodies = m_document.content(), frame = m_document.frame(), distance,
                       region = m_document.selected().region()](TaskControl& control) {
        control.report(0, "measuring distances");
        return objectsWithin(region, distance, bodies, *frame);
    };
    m_tasks.run<Region>(
        tr("Selecting within %1").arg(formatQuantity(distance, Quantity::Length)), work,
        [this, model = m_document.content().model, spacing = m_document.content().spacing](Region found) {
            const Content& now = m_document.content();
            if (now.model != model || now.spacing != spacing) // it is of another filling
                return;
            std::erase_if(found.items,
                          [&](const auto& own) { return m_tree->hiddenParts().contains(now.bodies[own.first]->part); });
            m_document.selected().select(found);
        });
}

} // namespace knead
