// What the main window consists of and where it sits. What it does is in main_window.cpp.
#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/display.h"
#include "ui/measuring/measuring.h"
#include "ui/panels/banner.h"
#include "ui/panels/choice_menu.h"
#include "ui/panels/export_panel.h"
#include "ui/panels/fitting_tool_bar.h"
#include "ui/panels/fixture_panel.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/home_page.h"
#include "ui/panels/import_panel.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/material_panel.h"
#include "ui/panels/model_panel.h"
#include "ui/panels/model_tree.h"
#include "ui/panels/panel_area.h"
#include "ui/panels/performance_panel.h"
#include "ui/panels/press_button.h"
#include "ui/panels/status_readings.h"
#include "ui/panels/timeline_panel.h"
#include "ui/panels/tool_panel.h"
#include "ui/viewport/view_grid.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QScrollArea>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace knead {

namespace {

constexpr int leftWidth = 300;
constexpr int logHeight = 110;

QDockWidget* makeDock(QMainWindow* window, const QString& title, const char* name, QWidget* content,
                      Qt::DockWidgetArea area)
{
    auto* dock = new QDockWidget(title, window);
    dock->setObjectName(name);
    dock->setWidget(content);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable |
                      QDockWidget::DockWidgetFloatable);
    window->addDockWidget(area, dock);
    return dock;
}

/// What a low dock is held by: a narrow strip at its left.
class Grip final : public QWidget {
public:
    using QWidget::QWidget;

    QSize sizeHint() const override { return {14, 24}; }

protected:
    void paintEvent(QPaintEvent* /*event*/) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette().color(QPalette::PlaceholderText));
        for (int row = -2; row <= 2; ++row)
            for (const double column : {-2.5, 2.5})
                painter.drawEllipse(QRectF(rect()).center() + QPointF(column, 6.0 * row), 1.2, 1.2);
    }
};

} // namespace

void MainWindow::makeCenter()
{
    auto* center = new QWidget(this);
    auto* column = new QVBoxLayout(center);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_banner = new Banner(center);
    m_pages = new QStackedWidget(center);
    m_home = new HomePage(QString::fromStdString(m_services.examplesFolder), m_pages);
    m_views = new ViewGrid(m_document, m_pages);
    new PressButton(m_document, m_actions->pressIt, m_views);
    m_viewport = &m_views->active();
    m_pages->addWidget(m_home);
    m_pages->addWidget(m_views);
    column->addWidget(m_banner);
    column->addWidget(m_pages, 1);
    setCentralWidget(center);
}

void MainWindow::makeDocks()
{
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_tree = new ModelTree(m_document, this);
    m_properties = new QStackedWidget(this);
    m_properties->setObjectName("properties");
    auto* nothing = new QLabel(tr("Nothing selected."), m_properties);
    nothing->setProperty("role", "dimmed");
    nothing->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    nothing->setMargin(12);
    m_material = new MaterialPanel(m_document, *m_materials);
    m_properties->addWidget(nothing); // in the order of Selection::Kind
    m_properties->addWidget(scrolled(m_material));
    m_properties->addWidget(scrolled(new ToolPanel(m_document)));
    m_properties->addWidget(scrolled(new FixturePanel(m_document)));
    m_log = new LogPanel(this);
    m_import = new ImportPanel(this);
    m_export = new ExportPanel(this);
    m_performance = new PerformancePanel(this);

    QDockWidget* tree = makeDock(this, tr("Model"), "modelDock", new ModelPanel(m_tree), Qt::LeftDockWidgetArea);
    QDockWidget* history =
        makeDock(this, tr("History"), "historyDock", new HistoryPanel(m_document), Qt::LeftDockWidgetArea);
    makeDock(this, tr("Properties"), "propertiesDock", m_properties, Qt::LeftDockWidgetArea);
    QDockWidget* log = makeDock(this, tr("Log"), "logDock", m_log, Qt::BottomDockWidgetArea);
    m_timeline = new TimelinePanel(m_document);
    m_timeline->addButton(m_actions->recordVideo);
    QDockWidget* timeline = makeDock(this, tr("Timeline"), "timelineDock", m_timeline, Qt::BottomDockWidgetArea);
    timeline->setFeatures(timeline->features() | QDockWidget::DockWidgetVerticalTitleBar); // it is low
    auto* grip = new Grip(timeline);
    grip->setToolTip(tr("Drag to move the timeline"));
    timeline->setTitleBarWidget(grip);
    splitDockWidget(timeline, log, Qt::Vertical);
    QDockWidget* performance =
        makeDock(this, tr("Performance"), "performanceDock", m_performance, Qt::BottomDockWidgetArea);
    QDockWidget* report = makeDock(this, tr("Import report"), "importDock", m_import, Qt::BottomDockWidgetArea);
    tabifyDockWidget(tree, history);
    tree->raise();
    tabifyDockWidget(log, report);
    QDockWidget* exported = makeDock(this, tr("Export report"), "exportDock", m_export, Qt::BottomDockWidgetArea);
    tabifyDockWidget(report, exported);
    tabifyDockWidget(exported, performance);
    log->raise();
    sizeDocks();
}

/// As they come.
void MainWindow::sizeDocks()
{
    auto* tree = findChild<QDockWidget*>("modelDock");
    auto* properties = findChild<QDockWidget*>("propertiesDock");
    resizeDocks({tree, properties}, {leftWidth, leftWidth}, Qt::Horizontal);
    resizeDocks({tree, properties}, {1, 2}, Qt::Vertical);
    resizeDocks({findChild<QDockWidget*>("logDock")}, {logHeight}, Qt::Vertical);
}

void MainWindow::makeMenus()
{
    const Actions& a = *m_actions;
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->setObjectName("fileMenu");
    file->addActions({a.open, a.openWithChoices});
    m_recent = file->addMenu(tr("Open &recent"));
    m_recent->setObjectName("recentMenu");
    m_recent->setToolTipsVisible(true);
    file->addSeparator();
    file->addActions({a.save, a.saveAs, a.exportMeshes, a.exportRecipe});
    file->addSeparator();
    file->addAction(a.recover);
    file->addSeparator();
    file->addAction(a.quit);

    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    edit->addActions({a.undo, a.redo, a.cancel});
    edit->addSeparator();
    edit->addActions({a.palette, a.shortcuts, a.preferences});

    QMenu* simulation = menuBar()->addMenu(tr("&Simulation"));
    simulation->addActions({a.play, a.step, a.findBalance, a.reset, a.pressIt});
    simulation->addSeparator();
    simulation->addActions({a.gravity, a.floor, a.renormalize, a.refillNow, a.cutHere});
    simulation->addSeparator();
    const auto choice = [this](const char* name) { return findChild<QComboBox*>(name); };
    simulation->addMenu(menuOf(choice("simulationSpeed"), tr("Speed"), this));
    simulation->addMenu(menuOf(choice("gravityPreset"), tr("Gravity as on"), this));
    simulation->addMenu(menuOf(choice("tableKind"), tr("Table"), this));
    simulation->addMenu(menuOf(choice("integrator"), tr("Integrator"), this));
    simulation->addAction(a.keepUp);
    simulation->addSeparator();
    QMenu* film = simulation->addMenu(tr("Timeline"));
    film->addActions(m_timeline->actions());
    film->addMenu(menuOf(choice("filmRate"), tr("Speed of the film"), this));
    simulation->addActions({a.recordVideo, a.recordPictures});

    QMenu* tools = menuBar()->addMenu(tr("&Tools"));
    m_addTool = tools->addMenu(icon("add-block"), tr("Add tool"));
    m_addTool->setObjectName("addTool");
    m_addTool->addActions(a.addTool);
    m_addTool->setEnabled(false);
    m_addTool->menuAction()->setToolTip(tr("Put a tool above the part to push it with"));
    tools->addActions({a.fixFaces, a.remove});

    m_measuring->fillMenu(menuBar()->addMenu(tr("&Measure")));

    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addActions({a.fit, a.isometric, a.front, a.back, a.right, a.left, a.top, a.bottom});
    view->addSeparator();
    QMenu* views = view->addMenu(tr("Viewports"));
    views->setObjectName("viewportsMenu");
    views->setToolTipsVisible(true);
    views->addActions({a.oneView, a.twoViews, a.fourViews});
    views->addSeparator();
    views->addActions({a.viewAlone, a.nextView, a.linkedViews});
    view->addMenu(m_display->menu());
    view->addActions({a.perspective, a.edges, a.openEdges, a.grid, a.objects, a.allObjects, a.hide});
    view->addSeparator();
    view->addMenu(tr("Theme"))->addActions({a.lightTheme, a.darkTheme, a.systemTheme});
    view->addMenu(tr("Panels"))->setObjectName("panelsMenu"); // filled by listPanels()
    view->addAction(a.fullScreen);

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addActions({a.tour, a.controls, a.about});
}

void MainWindow::makeToolBar()
{
    auto* bar = new FittingToolBar(tr("Tool bar"), this);
    addToolBar(bar);
    bar->setObjectName("toolBar");
    bar->setMovable(false);
    bar->setIconSize({20, 20});
    bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
    const Actions& a = *m_actions;
    bar->addActions({a.open, a.save, a.exportMeshes});
    bar->addSeparator();
    bar->addActions({a.undo, a.redo});
    bar->addSeparator();
    bar->addActions({a.play, a.step, a.reset});
    bar->addSeparator();
    bar->addActions({m_addTool->menuAction(), a.fixFaces});
    qobject_cast<QToolButton*>(bar->widgetForAction(m_addTool->menuAction()))->setPopupMode(QToolButton::InstantPopup);
    bar->addSeparator();
    bar->addActions({a.gravity, a.floor, a.renormalize});
    bar->addSeparator();
    bar->addActions({m_display->menu()->menuAction(), a.fit});
    const auto buttonOf = [bar](QAction* action) { return qobject_cast<QToolButton*>(bar->widgetForAction(action)); };
    buttonOf(m_display->menu()->menuAction())->setPopupMode(QToolButton::InstantPopup);
    auto* measure = new QToolButton(bar);
    measure->setObjectName("measureButton");
    measure->setIcon(icon("measure"));
    measure->setToolTip(tr("Measure the part"));
    measure->setPopupMode(QToolButton::InstantPopup);
    measure->setMenu(menuBar()->findChild<QMenu*>("measureMenu"));
    bar->addWidget(measure);
    bar->setTexts({a.play, m_addTool->menuAction(), a.fixFaces, a.exportMeshes, m_display->menu()->menuAction(), a.open,
                   a.reset, a.renormalize, a.gravity, a.floor, a.step, a.save});
    bar->setTurns(a.play, &Actions::textsOfPlay);
}

void MainWindow::makeStatusBar()
{
    m_readings = new StatusReadings(this);
    m_readings->hide();
    m_taskReading = new TaskReading(this);
    m_hint = new QLabel(this);
    m_hint->setObjectName("navigationHint");
    m_hint->setProperty("role", "dimmed");
    m_hint->setContentsMargins(8, 0, 0, 0);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addWidget(m_hint);
    statusBar()->addWidget(m_taskReading);
    statusBar()->addPermanentWidget(m_readings);
}

} // namespace knead
