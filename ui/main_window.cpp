#include "ui/main_window.h"

#include "ui/actions.h"
#include "ui/display.h"
#include "ui/document/tool_kinds.h"
#include "ui/hands/hands.h"
#include "ui/language/words_of_files.h"
#include "ui/measuring/measuring.h"
#include "ui/modes.h"
#include "ui/panels/banner.h"
#include "ui/panels/home_page.h"
#include "ui/panels/import_panel.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/material_panel.h"
#include "ui/panels/model_tree.h"
#include "ui/panels/performance_panel.h"
#include "ui/panels/simulation_panel.h"
#include "ui/panels/status_readings.h"
#include "ui/panels/timeline_panel.h"
#include "ui/project/project_keeper.h"
#include "ui/selection_actions.h"
#include "ui/units.h"
#include "ui/viewport/view_grid.h"

#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QScreen>
#include <QSettings>
#include <QSignalBlocker>
#include <QStackedWidget>

namespace knead {

MainWindow::MainWindow(Services services, QWidget* parent)
    : QMainWindow(parent)
    , m_services(std::move(services))
    , m_actions(std::make_unique<Actions>(this))
    , m_modes(new Modes(this))
{
    m_document.setTasks(&m_tasks);
    m_document.history().setPacking(m_services.packing);
    setObjectName("mainWindow");
    setWindowTitle(tr("Knead"));
    setWindowIcon(icon("knead"));
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    makeCenter();
    makeMaterials();
    makeDocks();
    makeDisplay();
    makeSimulation();
    makeMeasuring();
    makeProbes();
    makeHands();
    makeMenus();
    makeToolBar();
    makeStatusBar();
    makeSelection();
    makeProjects();
    connectFileActions();
    connectSimulationActions();
    connectViewActions();
    connectViews();
    connectTasks();
    connectRecording();
    connectHands();
    connect(&m_document, &Document::changed, this, &MainWindow::documentChanged);
    connect(&m_document, &Document::stopping, this, [this] { showSteppable(false); });
    connect(&m_document, &Document::recipeEnded, this, [this](const QString& sentence) { m_log->add(sentence); });
    connect(&m_document, &Document::balanced, this, &MainWindow::showBalance);
    connect(&m_document, &Document::notBalanced, this, [this](const QString& sentence) {
        m_shownImbalance = sentence;
        showProblem(sentence);
    });
    connect(&m_document, &Document::notice, this, [this](const QString& sentence) { showProblem(sentence); });
    selectionChanged();
    makeShell();
    resize(QSize(1280, 800).boundedTo(screen()->availableSize())); // panels that were not laid out yet took more
    restoreSettings();
    m_log->add(tr("Ready. Open a part with Ctrl+O, or drop a file on the window."));
}

/// The view lets go of the keyboard and of the document while that is still there.
MainWindow::~MainWindow()
{
    hide();
    m_shell.reset();
    delete centralWidget();
}

void MainWindow::connectFileActions()
{
    connect(m_actions->open, &QAction::triggered, this, [this] { askForFile(false); });
    connect(m_actions->openWithChoices, &QAction::triggered, this, [this] { askForFile(true); });
    connect(m_import, &ImportPanel::unitChosen, this, &MainWindow::takeIn);
    connect(m_import, &ImportPanel::healingChosen, this, &MainWindow::takeHealed);
    connect(m_import, &ImportPanel::fillingChosen, this, &MainWindow::fillOpenParts);
    connect(m_actions->exportMeshes, &QAction::triggered, this, &MainWindow::askForExport);
    connect(m_actions->exportRecipe, &QAction::triggered, this, &MainWindow::askForRecipe);
    connect(m_actions->quit, &QAction::triggered, this, &QWidget::close);
    connect(m_actions->cancel, &QAction::triggered, this, &MainWindow::cancel);
    connect(m_actions->controls, &QAction::triggered, this, &MainWindow::showControls);
    connect(m_actions->about, &QAction::triggered, this, &MainWindow::showAbout);
    connect(m_home, &HomePage::openClicked, this, [this] { askForFile(false); });
    connect(m_home, &HomePage::fileChosen, this, &MainWindow::openRecent);
}

void MainWindow::connectSimulationActions()
{
    connect(m_actions->undo, &QAction::triggered, &m_document, &Document::undo);
    connect(m_actions->redo, &QAction::triggered, &m_document, &Document::redo);
    connect(m_actions->play, &QAction::triggered, &m_document, &Document::togglePlay);
    connect(m_actions->step, &QAction::triggered, &m_document, &Document::stepOnce);
    connect(m_actions->findBalance, &QAction::triggered, &m_document, &Document::findBalance);
    connect(m_actions->reset, &QAction::triggered, &m_document, &Document::reset);
    connect(m_actions->pressIt, &QAction::triggered, &m_document, &Document::pressIt);
    connect(m_actions->gravity, &QAction::toggled, this, &MainWindow::setGravity);
    connect(m_actions->keepUp, &QAction::toggled, &m_document, &Document::keepUp);
    connect(m_actions->floor, &QAction::toggled, this, &MainWindow::setFloor);
    connect(m_actions->renormalize, &QAction::triggered, &m_document, &Document::renormalize);
    connect(m_actions->refillNow, &QAction::triggered, &m_document, &Document::refillNow);
    connect(m_actions->cutHere, &QAction::triggered, this, [this] {
        if (const std::optional<CutPlane>& plane = m_viewport->options().section.plane)
            m_document.cutAlong(plane->offset * plane->normal, plane->normal);
        else
            showRemark(tr("Turn the section plane on (Shift+S) and put it where the cut shall be."));
    });
    for (QAction* action : m_actions->addTool)
        connect(action, &QAction::triggered, this, [this, action] {
            m_document.addTool(toolsToAdd()[static_cast<std::size_t>(action->data().toInt())]);
            m_viewport->setFocus(); // the arrow keys shall drive it
        });
    connect(m_actions->fixFaces, &QAction::toggled, m_viewport, &ViewportWidget::setFixing);
    m_modes->add(m_actions->fixFaces);
    connect(m_modes, &Modes::changed, this, &MainWindow::showHint);
    connect(m_pages, &QStackedWidget::currentChanged, this, &MainWindow::showHint);
    connect(m_actions->remove, &QAction::triggered, &m_document, &Document::removeSelected);
    connect(m_material, &MaterialPanel::refillRequested, this, &MainWindow::refill);
    connect(m_timeline, &TimelinePanel::looked, m_viewport, &ViewportWidget::lookBack);
    connect(m_banner, &Banner::remedyClicked, this, [this] {
        if (m_remedy)
            m_remedy();
    });
}

void MainWindow::connectViewActions()
{
    const Actions& a = *m_actions;
    connect(a.fit, &QAction::triggered, m_viewport, &ViewportWidget::fit);
    const std::pair<QAction*, Vec3> views[] = {{a.front, {0, -1, 0}},    {a.back, {0, 1, 0}}, {a.right, {1, 0, 0}},
                                               {a.left, {-1, 0, 0}},     {a.top, {0, 0, 1}},  {a.bottom, {0, 0, -1}},
                                               {a.isometric, {1, -1, 1}}};
    for (const auto& [action, direction] : views)
        connect(action, &QAction::triggered, this, [this, towards = direction] { m_viewport->lookFrom(towards); });
    connect(a.perspective, &QAction::toggled, m_viewport, &ViewportWidget::setPerspective);
    for (QAction* action : {a.objects, a.allObjects, a.edges, a.openEdges, a.grid})
        connect(action, &QAction::toggled, this, &MainWindow::optionsChanged);
    connect(a.hide, &QAction::triggered, m_tree, &ModelTree::toggleSelectedBody);
    connect(m_tree, &ModelTree::hiddenChanged, this, [this](const std::set<std::size_t>& hiddenParts) {
        SceneOptions options = m_viewport->options();
        options.hiddenParts = hiddenParts;
        m_viewport->setOptions(options);
    });
}

void MainWindow::connectTasks()
{
    connect(&m_tasks, &TaskRunner::started, m_taskReading, &TaskReading::begin);
    connect(&m_tasks, &TaskRunner::progressed, m_taskReading, &TaskReading::progress);
    connect(&m_tasks, &TaskRunner::finished, m_taskReading, &TaskReading::end);
    connect(m_taskReading, &TaskReading::cancelClicked, &m_tasks, &TaskRunner::cancel);
    connect(&m_tasks, &TaskRunner::failed, this,
            [this](const QString&, const QString& sentence) { showProblem(inWords(sentence.toStdString())); });
    connect(&m_tasks, &TaskRunner::cancelled, this,
            [this](const QString& title) { m_log->add(tr("%1: cancelled, nothing has changed.").arg(title)); });
}

void MainWindow::restoreSettings()
{
    const QSettings settings;
    applyPreferences();
    applyLook();
    restoreGeometry(settings.value("geometry").toByteArray());
    restoreState(settings.value("docks").toByteArray(), layoutVersion);
    m_display->restore();
    m_views->restore();
}

bool MainWindow::isBusy()
{
    if (m_tasks.isRunning())
        showProblem(tr("%1 is still going on: wait for it, or cancel it with Esc.").arg(m_tasks.title()));
    return m_tasks.isRunning();
}

void MainWindow::documentChanged(Document::Change what)
{
    switch (what) {
    case Document::Change::Content:
        contentChanged();
        break;
    case Document::Change::Frame:
        frameChanged();
        break;
    case Document::Change::Selection:
        selectionChanged();
        break;
    case Document::Change::Filling:
    case Document::Change::Fixtures:
        break;
    case Document::Change::History:
        historyChanged();
        break;
    case Document::Change::Moment:
        showSurroundings();
        historyChanged();
        break;
    }
}

void MainWindow::contentChanged()
{
    const Content& content = m_document.content();
    const QString name = QFileInfo(QString::fromStdString(content.model->file)).fileName();
    showSelectionBar(true); // before the view is there: it is laid out, and drawn, once
    m_pages->setCurrentWidget(m_views);
    const bool isSimulated = !content.bodies.empty();
    m_actions->setDocumentOpen(true, isSimulated);
    showViews();
    m_addTool->setEnabled(isSimulated);
    m_modes->leave();
    showSurroundings();
    m_readings->setVisible(isSimulated);
    m_viewport->setFocus();
    m_viewport->fit();
    frameChanged();
    const Snapshot& start = *m_document.frame()->snapshot;
    if (!isSimulated)
        m_log->add(tr("%1: %2, %3 surfaces to look at, nothing to simulate.")
                       .arg(name, QString::fromStdString(content.model->format), formatCount(content.surfaces.size())));
    else
        m_log->add(tr("%1: %2, %3 objects of spacing %4, %5 connections, time step %6.")
                       .arg(name, QString::fromStdString(content.model->format), formatCount(start.objects),
                            formatQuantity(content.spacing, Quantity::Length), formatCount(start.connections),
                            formatReading(start.timeStep, Quantity::Time)));
    for (const std::string& warning : content.warnings)
        m_log->add(inWords(warning), LogPanel::Kind::Warning);
    showWalls(content.fineness);
    showImport();
}

/// Menu and buttons say what they would undo and redo.
void MainWindow::historyChanged()
{
    const auto show = [](QAction* action, const QString& verb, const std::optional<QString>& name) {
        action->setEnabled(name.has_value());
        action->setText(name ? tr("%1 \"%2\"").arg(verb, *name) : verb);
    };
    show(m_actions->undo, tr("Undo"), m_document.undoName());
    show(m_actions->redo, tr("Redo"), m_document.redoName());
}

/// The switches say what the simulation has.
void MainWindow::showSurroundings()
{
    const Snapshot& snapshot = *m_document.frame()->snapshot;
    const QSignalBlocker gravityBlocker(m_actions->gravity);
    const QSignalBlocker floorBlocker(m_actions->floor);
    m_actions->gravity->setChecked(!snapshot.gravity.isZero());
    m_actions->floor->setChecked(snapshot.floorHeight.has_value());
}

/// Before a frame shows it: who pauses and steps at once does not wait for one.
void MainWindow::showSteppable(bool isPlaying)
{
    m_actions->step->setEnabled(!isPlaying && !m_document.content().bodies.empty());
}

void MainWindow::frameChanged()
{
    const Snapshot& snapshot = *m_document.frame()->snapshot;
    const std::pair surroundings(!snapshot.gravity.isZero(), snapshot.floorHeight.has_value());
    if (std::exchange(m_surroundings, surroundings) != surroundings) // by a recipe, for one
        showSurroundings();
    m_readings->show(snapshot);
    m_performance->show(snapshot);
    m_actions->setPlaying(snapshot.playing);
    showSteppable(m_document.isPlaying());
    showHealth(snapshot.health);
    showNotice(snapshot.notice);
}

void MainWindow::showProblem(const QString& sentence, const QString& remedyText, std::function<void()> remedy)
{
    m_remedy = std::move(remedy);
    m_banner->show(sentence, remedyText);
    m_log->add(sentence, LogPanel::Kind::Error);
}

void MainWindow::selectionChanged()
{
    const Selection::Kind kind = m_document.selection().kind;
    m_properties->setCurrentIndex(static_cast<int>(kind));
    m_actions->remove->setEnabled(kind == Selection::Kind::Tool || kind == Selection::Kind::Fixture);
    showHint();
}

void MainWindow::showHint()
{
    if (m_pages->currentWidget() != m_views)
        m_hint->clear(); // there is nothing to turn
    else if (m_measuring->tool().isPicking())
        m_hint->setText(m_measuring->tool().prompt());
    else if (m_actions->fixFaces->isChecked())
        m_hint->setText(tr("Click faces to hold or free them   Esc: done"));
    else if (const QString hint = m_hands->hint(); !hint.isEmpty())
        m_hint->setText(hint);
    else if (m_document.selection().kind == Selection::Kind::Tool)
        m_hint->setText(tr("Arrows, PgUp, PgDn: drive   Shift: slower   Middle: orbit"));
    else
        m_hint->setText(tr("Middle: orbit   Shift+middle: pan   Wheel: zoom"));
}

void MainWindow::optionsChanged()
{
    SceneOptions options = m_viewport->options();
    const ObjectDisplay shown = m_actions->allObjects->isChecked() ? ObjectDisplay::All : ObjectDisplay::Surface;
    options.objects = m_actions->objects->isChecked() ? shown : ObjectDisplay::Off;
    options.edges = m_actions->edges->isChecked();
    options.openEdges = m_actions->openEdges->isChecked();
    options.grid = m_actions->grid->isChecked();
    m_viewport->setOptions(options);
}

void MainWindow::setGravity(bool on)
{
    m_document.post(SetGravity{on ? m_simulation->wantedGravity() : Vec3(Vec3::Zero())});
}

void MainWindow::setFloor(bool on)
{
    const Snapshot& now = *m_document.frame()->snapshot;
    SetFloor command{{}, now.floorFriction, now.floorAdhesion};
    if (on)
        command.height = m_document.content().box.min().z();
    m_document.post(command);
}

/// Esc: gives up what the mouse draws or drags, else stops the task, else leaves the mode, else comes back from the past, else
/// selects nothing.
void MainWindow::cancel()
{
    if (m_viewport->cancelDrag())
        return;
    if (m_tasks.isRunning())
        m_tasks.cancel();
    else if (m_modes->leave())
        return;
    else if (m_timeline->isLookingBack())
        m_timeline->stopLooking();
    else if (!m_hands->leaveKeys())
        m_document.select({});
}

} // namespace knead
