#include "ui/selection/selection_feature.h"

#include "core/session/region_contents.h"
#include "ui/commands/availability.h"
#include "ui/commands/strip_keys.h"
#include "ui/display.h"
#include "ui/frame/docks.h"
#include "ui/frame/notices.h"
#include "ui/interaction/hands_feature.h"
#include "ui/language/said.h"
#include "ui/modes.h"
#include "ui/panels/model_panel.h"
#include "ui/panels/model_tree.h"
#include "ui/panels/panel_area.h"
#include "ui/panels/selection_panel.h"
#include "ui/selection/selection_model.h"
#include "ui/simulation/simulation_feature.h"
#include "ui/units.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>

#include <numeric>

#include <utility>

namespace knead {

namespace {

constexpr double brushStep = 1.25; // of the radius

/// Everything of a kind that a body has.
Region::Items allOf(Level level, const FilledModel& content, const FilledBody& body)
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

SelectionFeature::SelectionFeature(const Workbench& bench, const Parts& parts)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_simulation(parts.simulation)
    , m_hands(parts.hands)
    , m_modes(parts.modes)
    , m_tree(parts.tree)
    , m_properties(parts.properties)
    , m_display(parts.display)
    , m_actions(bench.window)
    , m_panel(new SelectionPanel(bench.document, parts.materials))
    , m_reading(new QLabel(&bench.window))
{
    m_properties.addWidget(scrolled(m_panel));
    m_reading->setObjectName("selectionReading");
    m_reading->setContentsMargins(8, 0, 0, 0);
    m_reading->hide();
    bench.window.statusBar()->insertWidget(0, m_reading);
    connectSelection();
    connectTree();
    sayWhyNot();
}

QMenu* SelectionFeature::newMenu()
{
    const SelectionActions& s = m_actions;
    auto* select = new QMenu(tr("Se&lect"), &m_bench.window);
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
    return select;
}

QToolBar* SelectionFeature::newBar(QWidget* parent)
{
    auto* bar = new QToolBar(tr("Selecting"), parent);
    bar->setObjectName("selectionBar");
    bar->setOrientation(Qt::Vertical);
    bar->setIconSize({20, 20});
    bar->setStyleSheet("QToolBar { border: none; border-right: 1px solid palette(mid); padding: 6px 3px; }");
    bar->addActions(m_actions.levels);
    bar->addSeparator();
    bar->addActions(m_actions.shapes);
    new StripKeys(*bar);
    return bar;
}

void SelectionFeature::connectSelection()
{
    const SelectionActions& s = m_actions;
    SelectionModel& selected = m_bench.document.selected();
    for (QAction* level : s.levels)
        connect(level, &QAction::triggered, this, [this, level] {
            m_modes.leave();
            m_bench.document.selected().setLevel(static_cast<Level>(level->data().toInt()));
        });
    for (QAction* shape : s.shapes)
        connect(shape, &QAction::triggered, this, [this, shape] {
            m_modes.leave();
            m_bench.viewport.regions().setShape(static_cast<RegionShape>(shape->data().toInt()));
        });
    RegionTool& regions = m_bench.viewport.regions();
    for (const auto& [action, factor] : {std::pair(s.smallerBrush, 1 / brushStep), std::pair(s.largerBrush, brushStep)})
        connect(action, &QAction::triggered, this, [this, &regions, by = factor] {
            if (!m_hands.changeBrush(by))
                regions.setBrushRadius(regions.brushRadius() * by);
        });
    connect(s.through, &QAction::triggered, &selected, &SelectionModel::setThrough);
    connect(&selected, &SelectionModel::levelChanged, this, &SelectionFeature::showLevel);
    connect(&selected, &SelectionModel::changed, this, &SelectionFeature::showSelected);
    connect(s.all, &QAction::triggered, this, &SelectionFeature::selectAll);
    connect(s.none, &QAction::triggered, &selected, &SelectionModel::clear);
    const auto atPanel = [this](void (SelectionPanel::*begin)()) {
        return [this, begin] {
            m_properties.setCurrentIndex(static_cast<int>(Selection::Kind::Region));
            m_bench.docks.show("propertiesDock");
            (m_panel->*begin)();
        };
    };
    connect(s.within, &QAction::triggered, this, atPanel(&SelectionPanel::beginWithin));
    connect(s.keep, &QAction::triggered, this, atPanel(&SelectionPanel::beginKeeping));
    connect(s.fix, &QAction::triggered, m_panel, &SelectionPanel::fix);
    connect(s.renormalize, &QAction::triggered, m_panel, &SelectionPanel::renormalize);
    connect(s.glue, &QAction::triggered, m_panel, &SelectionPanel::glue);
    connect(m_panel, &SelectionPanel::withinRequested, this, &SelectionFeature::selectWithin);
    connect(&m_bench.document, &Document::changed, this, [this](Document::Change what) {
        if (what == Document::Change::Model)
            showSelected();
        if (what == Document::Change::Model || what == Document::Change::Selection)
            showLock();
    });
    connect(m_panel, &SelectionPanel::read, m_reading, &QLabel::setText);
    showLevel();
}

void SelectionFeature::connectTree()
{
    const SelectionActions& s = m_actions;
    m_tree.addAction(s.rename);
    m_bench.viewport.addAction(s.rename);
    connect(s.rename, &QAction::triggered, &m_tree, &ModelTree::renameCurrent);
    connect(s.color, &QAction::triggered, &m_tree, &ModelTree::colorSelected);
    connect(s.uncolor, &QAction::triggered, &m_tree, &ModelTree::uncolorSelected);
    connect(s.hide, &QAction::triggered, &m_tree, &ModelTree::toggleSelectedBody);
    connect(s.lock, &QAction::triggered, &m_tree, &ModelTree::lockSelected);
    connect(s.group, &QAction::triggered, &m_tree, &ModelTree::groupSelected);
    connect(s.ungroup, &QAction::triggered, &m_tree, &ModelTree::ungroupSelected);
    connect(s.isolate, &QAction::triggered, &m_tree, &ModelTree::isolateSelected);
    connect(s.showAll, &QAction::triggered, &m_tree, &ModelTree::showAll);
    connect(s.search, &QAction::triggered, this, [this] {
        m_bench.docks.show("modelDock");
        qobject_cast<ModelPanel*>(m_tree.parentWidget())->beginSearch();
    });
    connect(&m_tree, &ModelTree::hiddenChanged, this, [this](const std::set<std::size_t>& hiddenParts) {
        SceneOptions options = m_bench.viewport.options();
        options.hiddenParts = hiddenParts;
        m_bench.viewport.setOptions(options);
    });
    connect(&m_tree, &ModelTree::toolClicked, &m_bench.viewport,
            [this] { m_bench.viewport.setFocus(); }); // whose keys drive it
    connect(&m_tree, &ModelTree::problem, this, [this](const QString& sentence) { m_bench.notices.problem(sentence); });
    connect(&m_bench.document.notes(), &ModelNotes::changed, this, &SelectionFeature::showLock);
    m_tree.setMenu([this](QMenu& menu, TreeItem type) { fillTreeMenu(menu, static_cast<int>(type)); });
}

void SelectionFeature::sayWhyNot()
{
    Availability& when = m_bench.availability;
    const SelectionActions& s = m_actions;
    when.needPart({s.rename, s.color, s.uncolor, s.group, s.ungroup, s.isolate, s.showAll, s.search});
    when.needBodies(s.levels + s.shapes +
                    QList{s.through, s.smallerBrush, s.largerBrush, s.all, s.none, s.lock, s.hide});
    when.needBodies({s.within, s.keep, s.fix, s.renormalize, s.glue}, [this]() -> std::optional<QString> {
        if (m_bench.document.selected().region().isEmpty())
            return tr("Select something first.");
        return {};
    });
}

/// @param type a TreeItem
void SelectionFeature::fillTreeMenu(QMenu& menu, int type) const
{
    const SelectionActions& s = m_actions;
    switch (static_cast<TreeItem>(type)) {
    case TreeItem::Part:
        menu.addActions({s.rename, s.color, s.uncolor});
        menu.addSeparator();
        menu.addActions({s.hide, s.isolate, s.showAll});
        menu.addSeparator();
        menu.addActions({s.lock, s.group, s.ungroup});
        menu.addSeparator();
        menu.addActions({s.fix, m_simulation.actions().renormalize, s.glue, s.keep});
        break;
    case TreeItem::Surface:
        menu.addActions({s.rename, s.color, s.uncolor, s.showAll});
        break;
    case TreeItem::Group:
        menu.addActions({s.rename, s.ungroup});
        menu.addSeparator();
        menu.addActions({s.hide, s.isolate, s.showAll, s.lock});
        break;
    case TreeItem::Assembly:
        menu.addActions({s.hide, s.isolate, s.showAll, s.lock, s.group});
        break;
    case TreeItem::Tool:
    case TreeItem::Fixture:
        menu.addActions({s.rename, s.lock, m_hands.actions().remove});
        break;
    case TreeItem::Set:
        menu.addSeparator();
        menu.addActions({s.rename, s.fix, s.renormalize, s.within});
        break;
    case TreeItem::File:
        menu.addActions({s.showAll, s.search});
        break;
    case TreeItem::Tools:
        menu.addActions(m_hands.actions().addTool);
        break;
    case TreeItem::Fixtures:
    case TreeItem::Sets:
    case TreeItem::Exports:
    case TreeItem::Export:
        break;
    }
}

/// To select objects one has to see them.
void SelectionFeature::showLevel()
{
    const SelectionModel& selected = m_bench.document.selected();
    const Level level = selected.level();
    m_actions.levels.at(static_cast<int>(level))->setChecked(true);
    m_actions.through->setChecked(selected.isThrough());
    m_display.lendObjects(level == Level::Object || level == Level::Connection);
}

/// What can be done with it; how much it is says the selection panel.
void SelectionFeature::showSelected()
{
    const bool isAnything = !m_bench.document.selected().region().isEmpty() && !m_bench.document.isEmpty();
    m_bench.availability.update();
    m_reading->setVisible(isAnything);
    showLock();
}

/// What is locked may not be changed in the properties. It can be read to its end: the page around it scrolls.
void SelectionFeature::showLock()
{
    const bool isLocked = !m_bench.document.isEmpty() && m_bench.document.isLocked(m_bench.document.selection());
    for (int page = 0; page < m_properties.count(); ++page)
        if (const auto* area = qobject_cast<QScrollArea*>(m_properties.widget(page)))
            area->widget()->setEnabled(page != m_properties.currentIndex() || !isLocked);
}

void SelectionFeature::selectAll()
{
    const FilledModel& content = m_bench.document.content();
    Region region;
    region.level = m_bench.document.selected().level();
    for (BodyId body = 0; body < content.bodies.size(); ++body)
        if (!m_tree.hiddenParts().contains(content.bodies[body]->part))
            region = united(region, regionOf(region.level, body, allOf(region.level, content, *content.bodies[body])));
    m_bench.document.selected().select(region);
}

void SelectionFeature::selectWithin(double distance)
{
    if (m_bench.document.isEmpty() || m_bench.document.selected().region().isEmpty() || m_bench.isBusy())
        return;
    const auto work = [bodies = m_bench.document.content(), frame = m_bench.document.frame(), distance,
                       region = m_bench.document.selected().region()](TaskControl& control) {
        control.report(0, "measuring distances");
        return objectsWithin(region, distance, bodies, *frame);
    };
    m_bench.tasks.run<Region>(
        said(Message("SelectionFeature", "Selecting within %1")
                 .with(formatQuantity(distance, Quantity::Length).toStdString())),
        work,
        [this, model = m_bench.document.content().model, spacing = m_bench.document.content().spacing](Region found) {
            const FilledModel& now = m_bench.document.content();
            if (now.model != model || now.spacing != spacing) // it is of another filling
                return;
            std::erase_if(found.items,
                          [&](const auto& own) { return m_tree.hiddenParts().contains(now.bodies[own.first]->part); });
            m_bench.document.selected().select(found);
        });
}

} // namespace knead
