#include "ui/frame/main_window.h"

#include "ui/actions.h"
#include "ui/commands/command_palette.h"
#include "ui/commands/shortcuts.h"
#include "ui/display.h"
#include "ui/document/tool_kinds.h"
#include "ui/frame/features.h"
#include "ui/frame/notices.h"
#include "ui/frame/window_menus.h"
#include "ui/interaction/hands.h"
#include "ui/materials/material_store.h"
#include "ui/measuring/measuring.h"
#include "ui/modes.h"
#include "ui/panels/banner.h"
#include "ui/panels/display_panel.h"
#include "ui/panels/fixture_panel.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/home_page.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/material_panel.h"
#include "ui/panels/model_panel.h"
#include "ui/panels/model_tree.h"
#include "ui/panels/panel_area.h"
#include "ui/panels/press_button.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/status_readings.h"
#include "ui/panels/timeline_panel.h"
#include "ui/panels/tool_panel.h"
#include "ui/project/project_keeper.h"
#include "ui/units.h"
#include "ui/viewport/view_grid.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QProcess>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace knead {

namespace {

constexpr int layoutVersion = 2; // of the docks; layouts of another version are not restored
constexpr const char* selectionBarShown = "selectionBar/shown";

} // namespace

MainWindow::MainWindow(Services services, QWidget* parent)
    : QMainWindow(parent)
    , m_atStart(PreferencesFeature::begin())
    , m_services(std::move(services))
    , m_actions(std::make_unique<Actions>(this))
    , m_modes(new Modes(this))
    , m_docks(*this)
{
    m_document.setTasks(&m_tasks);
    m_document.history().setPacking(m_services.packing);
    setObjectName("mainWindow");
    setWindowTitle(tr("Knead"));
    setWindowIcon(icon("knead"));
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    makeCenter();
    makePanels();
    makeStatusBar();
    makeFeatures();
    makeSelectionBar();
    m_docks.arrange();
    makeMenus();
    connectActions();
    connectTasks();
    keepHintClear();
    connect(&m_document, &Document::changed, this, &MainWindow::documentChanged);
    selectionChanged();
    m_docks.hideLaterOnes();
    m_layout = saveState();
    makeCommands();
    resize(firstSize(screen()->availableSize())); // panels that were not laid out yet took more
    restoreSettings();
    m_notices->note(tr("Ready. Open a part with Ctrl+O, or drop a file on the window."));
}

QSize MainWindow::firstSize(const QSize& available)
{
    constexpr QSize wanted(1280, 800);
    constexpr QSize frame(16, 48); // about; the system draws it, and its size is known when the window is shown
    return wanted.boundedTo(available - frame);
}

/// The view lets go of the keyboard and of the document while that is still there.
MainWindow::~MainWindow()
{
    disconnect(qApp, nullptr, this, nullptr);
    hide();
    m_tasks.stop();
    delete m_features->preferences; // its dialog asks for the window's actions to the end
    delete m_features->help;
    delete centralWidget();
}

void MainWindow::open(const QStringList& paths)
{
    m_features->imports->open(paths);
}

void MainWindow::open(const ImportChoices& request)
{
    m_features->imports->open(request);
}

ProjectKeeper& MainWindow::projects()
{
    return m_features->projects->keeper();
}

Measuring& MainWindow::measuring()
{
    return m_features->measuring->measuring();
}

ProbeSet& MainWindow::probes()
{
    return m_features->probes->probes();
}

Hands& MainWindow::hands()
{
    return m_features->hands->hands();
}

// --- what it consists of --------------------------------------------------------------------------------------------------

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
    auto* row = new QHBoxLayout; // the bar for selecting comes before the pages
    row->setSpacing(0);
    row->addWidget(m_pages, 1);
    column->addLayout(row, 1);
    m_banner->layOver(*m_pages);
    setCentralWidget(center);
}

void MainWindow::makePanels()
{
    auto* log = new LogPanel(this);
    m_notices = new Notices(*m_banner, *log, this);
    m_bench.reset(new Workbench{*this, m_services, m_document, m_tasks, *m_notices, m_docks, *m_views, *m_viewport});
    m_materials = new MaterialStore(m_services, this);
    connect(m_materials, &MaterialStore::failed, this,
            [this](const QString& sentence) { m_notices->problem(sentence); });
    if (!m_materials->damage().isEmpty()) // once the window is there
        QMetaObject::invokeMethod(
            this, [this] { m_notices->problem(m_materials->damage()); }, Qt::QueuedConnection);

    m_tree = new ModelTree(m_document, this);
    m_history = new HistoryPanel(m_document);
    m_properties = new QStackedWidget(this);
    m_properties->setObjectName("properties");
    auto* nothing = new QLabel(tr("Nothing selected."), m_properties);
    nothing->setProperty("role", "dimmed");
    nothing->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    nothing->setMargin(12);
    auto* material = new MaterialPanel(m_document, *m_materials);
    connect(material, &MaterialPanel::refillRequested, this,
            [this](double spacing) { m_features->imports->refill(spacing); });
    m_properties->addWidget(nothing); // in the order of Selection::Kind
    m_properties->addWidget(scrolled(material));
    m_properties->addWidget(scrolled(new ToolPanel(m_document)));
    m_properties->addWidget(scrolled(new FixturePanel(m_document)));
    m_timeline = new TimelinePanel(m_document);
    m_timeline->addButton(m_actions->recordVideo);
    m_display = new Display(m_document, *m_viewport, *m_actions, this);

    m_docks.add("modelDock", tr("Model"), new ModelPanel(m_tree));
    m_docks.add("historyDock", tr("History"), m_history);
    m_docks.add("propertiesDock", tr("Properties"), m_properties);
    m_docks.add("displayDock", tr("Display"), scrolled(new DisplayPanel(*m_display)));
    m_docks.add("logDock", tr("Log"), log);
    m_docks.add("timelineDock", tr("Timeline"), m_timeline)
        .titleBarWidget()
        ->setToolTip(tr("Drag to move the timeline"));
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

/// Each is handed what it takes; the order says no more than who takes whom.
void MainWindow::makeFeatures()
{
    m_features = std::make_unique<Features>();
    Features& f = *m_features;
    const Workbench& bench = *m_bench;
    auto* recent = new QMenu(tr("Open &recent"), this);
    recent->setObjectName("recentMenu");
    recent->setToolTipsVisible(true);
    f.projects = new ProjectsFeature(bench, *m_actions, *m_tree, *m_home, *recent);
    f.recipes = new RecipesFeature(bench, *f.projects, *m_actions->exportRecipe);
    f.imports = new ImportFeature(bench, *m_actions, *f.projects, *f.recipes);
    f.exports = new ExportFeature(bench, *m_actions->exportMeshes);
    connect(f.recipes, &RecipesFeature::exportWanted, m_actions->exportMeshes, &QAction::trigger);
    f.simulation = new SimulationFeature(bench, *m_actions, *m_readings, *f.imports);
    f.views = new ViewsFeature(bench, *m_actions);
    f.measuring = new MeasuringFeature(bench, *m_modes);
    f.comparison = new ComparisonFeature(bench, f.measuring->measuring());
    f.probes = new ProbesFeature(bench, f.measuring->measuring(), f.projects->keeper());
    f.hands = new HandsFeature(bench, *m_modes);
    f.recording = new RecordingFeature(bench, *m_actions->recordVideo, *m_actions->recordPictures);
    f.selection = new SelectionFeature(bench, {*m_actions, *m_modes, *m_tree, *m_properties, *m_materials, *m_display});
    f.help = new HelpFeature(bench, *m_actions);
    m_recent = recent;
    connect(m_home, &HomePage::openClicked, this, [this] { m_features->imports->askForFile(false); });
    connect(&f.measuring->measuring(), &Measuring::promptChanged, this, &MainWindow::showHint);
    connect(&f.hands->hands(), &Hands::modeChanged, this, &MainWindow::showHint);
    statusBar()->insertWidget(0, &f.selection->reading());
}

/// Beside the view, where the hand is.
void MainWindow::makeSelectionBar()
{
    m_selectionBar = m_features->selection->newBar(centralWidget());
    auto* row = qobject_cast<QBoxLayout*>(centralWidget()->layout()->itemAt(0)->layout());
    row->insertWidget(0, m_selectionBar);
    connect(m_selectionBar->toggleViewAction(), &QAction::triggered, this,
            [](bool on) { QSettings().setValue(selectionBarShown, on); });
    connect(m_pages, &QStackedWidget::currentChanged, this, &MainWindow::showSelectionBar);
    showSelectionBar();
}

/// The bar beside the view comes and goes with the view, unless a person does not want it.
void MainWindow::showSelectionBar()
{
    const bool isView = m_pages->currentWidget() == m_views;
    m_selectionBar->toggleViewAction()->setEnabled(isView);
    m_selectionBar->setVisible(isView && QSettings().value(selectionBarShown, true).toBool());
}

void MainWindow::makeMenus()
{
    m_addTool = new QMenu(tr("Add tool"), this);
    m_addTool->setIcon(icon("add-block"));
    m_addTool->setObjectName("addTool");
    m_addTool->setEnabled(false);
    m_addTool->menuAction()->setToolTip(tr("Put a tool above the part to push it with"));
    auto* examples = new QMenu(tr("E&xamples"), this);
    examples->setObjectName("examplesMenu");
    m_home->fillExamples(*examples);
    const MenuSources sources{*m_actions, *m_features, *m_display, *m_timeline, *m_recent, *examples, *m_addTool};
    QMenu* panels = fillMenuBar(*this, sources);
    m_features->help->setToolBar(makeToolBar(*this, sources));
    listPanels(*this, *panels, *m_selectionBar, *m_actions);
}

/// After all panels, menus and actions are there.
void MainWindow::makeCommands()
{
    m_shortcuts = new Shortcuts(*this);
    m_palette = new CommandPalette(*this, [this](const QAction& action) { return whyDisabled(action); });
    m_features->preferences = new PreferencesFeature(*m_bench, *m_actions, *m_shortcuts, m_atStart);
    PreferencesFeature* preferences = m_features->preferences;
    connect(m_actions->palette, &QAction::triggered, this, [this] { m_palette->open(); });
    connect(m_actions->resetLayout, &QAction::triggered, this, &MainWindow::resetLayout);
    connect(m_actions->fullScreen, &QAction::triggered, this,
            [this](bool isFull) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, isFull)); });
    connect(preferences, &PreferencesFeature::applied, this, &MainWindow::followPreferences);
    connect(preferences, &PreferencesFeature::wordsChanged, this, &MainWindow::sayAllAnew);
    connect(m_features->simulation, &SimulationFeature::threadsChosen, preferences, &PreferencesFeature::chooseThreads);
    connect(m_history, &HistoryPanel::allowedMemoryChanged, preferences, &PreferencesFeature::followStored);
}

void MainWindow::connectActions()
{
    const Actions& a = *m_actions;
    connect(a.quit, &QAction::triggered, this, &QWidget::close);
    connect(a.newWindow, &QAction::triggered, this, [this] { // a program of its own, as when it is started anew
        if (!QProcess::startDetached(QCoreApplication::applicationFilePath(), {}))
            m_notices->problem(tr("Another window could not be opened."));
    });
    connect(a.firstPage, &QAction::toggled, this, &MainWindow::showFirstPage);
    connect(a.cancel, &QAction::triggered, this, &MainWindow::cancel);
    for (QAction* action : a.addTool)
        connect(action, &QAction::triggered, this, [this, action] {
            m_document.addTool(toolsToAdd()[static_cast<std::size_t>(action->data().toInt())]);
            m_viewport->setFocus(); // the arrow keys shall drive it
        });
    for (const QuantityField* field : findChildren<QuantityField*>()) // the keys are the view's again
        connect(field, &QuantityField::finished, this, [this] {
            if (m_viewport->isVisible())
                m_viewport->setFocus();
        });
    connect(qApp, &QApplication::focusChanged, this, &MainWindow::showHint); // keys drive in the view only
    connect(a.fixFaces, &QAction::toggled, m_viewport, &ViewportWidget::setFixing);
    m_modes->add(a.fixFaces);
    connect(m_modes, &Modes::changed, this, &MainWindow::showHint);
    connect(m_pages, &QStackedWidget::currentChanged, this, &MainWindow::showHint);
    connect(m_timeline, &TimelinePanel::looked, m_viewport, &ViewportWidget::lookBack);
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
            [this](const QString&, const QString& sentence) { m_notices->problem(sentence); });
    connect(&m_tasks, &TaskRunner::cancelled, this,
            [this](const QString& title) { m_notices->note(tr("%1: cancelled, nothing has changed.").arg(title)); });
}

/// A message in the status bar and the hint share a place: one at a time.
void MainWindow::keepHintClear()
{
    const auto showHintWhenFree = [this] {
        m_hint->setVisible(!m_tasks.isRunning() && statusBar()->currentMessage().isEmpty());
    };
    connect(&m_tasks, &TaskRunner::started, statusBar(), &QStatusBar::clearMessage);
    connect(&m_tasks, &TaskRunner::started, m_hint, &QWidget::hide);
    connect(&m_tasks, &TaskRunner::finished, this, showHintWhenFree);
    connect(statusBar(), &QStatusBar::messageChanged, this, showHintWhenFree);
}

void MainWindow::restoreSettings()
{
    const QSettings settings;
    m_features->preferences->apply();
    m_features->preferences->applyLook();
    restoreGeometry(settings.value("geometry").toByteArray());
    m_actions->fullScreen->setChecked(isFullScreen());
    restoreState(settings.value("docks").toByteArray(), layoutVersion);
    m_display->restore();
    m_views->restore();
}

void MainWindow::resetLayout()
{
    restoreState(m_layout);
    m_docks.size();
}

void MainWindow::followPreferences(const Preferences& now)
{
    m_readings->showUnits(now.lengthUnit + ", N, MPa");
    m_history->showAllowedMemory(now.historyMegabytes);
    projects().setKeepingInterval(now.keepingInterval);
    m_features->simulation->showThreads(now.threads);
}

/// After another language or unit: what was put together of texts and numbers, and what is drawn.
void MainWindow::sayAllAnew()
{
    m_features->preferences->applyLook();
    m_features->projects->showTitle();
    m_features->projects->listRecent();
    showHint();
    for (QuantityField* field : findChildren<QuantityField*>())
        field->setValue(field->value());
    QEvent anew(QEvent::LanguageChange); // for those who put words and numbers together; a language sends another one
    QApplication::sendEvent(this, &anew);
    if (m_document.isEmpty())
        return;
    for (const Document::Change what :
         {Document::Change::Frame, Document::Change::Selection, Document::Change::Fixtures, Document::Change::Moment})
        emit m_document.changed(what);
}

// --- what it tells of the document ----------------------------------------------------------------------------------------

void MainWindow::documentChanged(Document::Change what)
{
    switch (what) {
    case Document::Change::Model:
        modelChanged();
        break;
    case Document::Change::Frame:
        m_features->simulation->showFrame();
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
        m_features->simulation->showSurroundings();
        historyChanged();
        break;
    }
}

void MainWindow::modelChanged()
{
    const FilledModel& content = m_document.content();
    const bool isSimulated = !content.bodies.empty();
    m_selectionBar->setVisible(
        QSettings().value(selectionBarShown, true).toBool()); // the view is laid out, and drawn, once
    m_pages->setCurrentWidget(m_views);
    m_actions->firstPage->setChecked(false);
    m_actions->setDocumentOpen(true, isSimulated);
    m_features->views->showArrangement();
    m_addTool->setEnabled(isSimulated);
    m_modes->leave();
    m_features->simulation->showSurroundings();
    m_readings->setVisible(isSimulated);
    m_viewport->setFocus();
    m_viewport->fit();
    m_features->simulation->showFrame();
    m_features->imports->tellOfModel();
    m_features->simulation->showWalls(content.fineness);
    m_features->imports->showImport();
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
    else if (measuring().tool().isPicking())
        m_hint->setText(measuring().tool().prompt());
    else if (m_actions->fixFaces->isChecked())
        m_hint->setText(tr("Click faces to hold or free them   Esc: done"));
    else if (const QString hint = hands().hint(); !hint.isEmpty())
        m_hint->setText(hint);
    else if (m_document.selection().kind == Selection::Kind::Tool && !m_viewport->hasFocus() &&
             QApplication::focusWidget() != nullptr)
        m_hint->setText(tr("Click into the view: arrows then drive the tool   Middle: orbit"));
    else if (m_document.selection().kind == Selection::Kind::Tool)
        m_hint->setText(tr("Arrows, PgUp, PgDn: drive   Shift: slower   Middle: orbit"));
    else
        m_hint->setText(tr("Middle: orbit   Shift+middle: pan   Wheel: zoom"));
}

/// What is open stays so, and time stands still meanwhile: nobody sees it.
void MainWindow::showFirstPage(bool on)
{
    if (m_document.isEmpty())
        return;
    if (on)
        m_document.pause();
    m_pages->setCurrentWidget(on ? static_cast<QWidget*>(m_home) : m_views);
    if (!on)
        m_viewport->setFocus();
}

/// Esc: comes back from the first page; gives up what the mouse draws or drags, else stops the task, else leaves the
/// mode, else comes back from the past, else selects nothing.
void MainWindow::cancel()
{
    if (m_viewport->cancelDrag())
        return;
    if (m_actions->firstPage->isChecked() && !m_tasks.isRunning()) {
        m_actions->firstPage->setChecked(false);
        return;
    }
    if (m_tasks.isRunning())
        m_tasks.cancel();
    else if (m_modes->leave())
        return;
    else if (m_timeline->isLookingBack())
        m_timeline->stopLooking();
    else if (!hands().leaveKeys())
        m_document.select({});
}

/// Why an action cannot be done now. Whoever makes an action can say it in its property "whyDisabled".
QString MainWindow::whyDisabled(const QAction& action) const
{
    const Actions& a = *m_actions;
    QString own = action.property("whyDisabled").toString();
    if (!own.isEmpty())
        return own;
    if (&action == a.undo)
        return tr("There is nothing to undo.");
    if (&action == a.redo)
        return tr("There is nothing to redo.");
    if (m_document.isEmpty())
        return tr("Open a part first.");
    if (m_document.content().bodies.empty())
        return tr("Nothing in this part is closed, so nothing can be simulated.");
    if (&action == a.step)
        return tr("Pause first.");
    if (&action == a.pressIt)
        return tr("Only a part to which nothing was done yet is pressed like this.");
    if (&action == a.remove)
        return tr("Select a tool or a fixture first.");
    const SelectionActions& s = m_features->selection->actions();
    if (QList<const QAction*>{s.within, s.keep, s.fix, s.renormalize, s.glue}.contains(&action))
        return tr("Select something first.");
    return tr("Not possible now.");
}

// --- what comes and goes --------------------------------------------------------------------------------------------------

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.empty() && std::all_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); })) {
        m_home->showDrop(true);
        event->acceptProposedAction();
    }
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent* event)
{
    m_home->showDrop(false);
    QMainWindow::dragLeaveEvent(event);
}

void MainWindow::dropEvent(QDropEvent* event)
{
    m_home->showDrop(false);
    activateWindow(); // the keys that follow are for this window, not for the one it comes from
    event->acceptProposedAction();
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        paths << url.toLocalFile();
    m_features->imports->openInstead(paths);
}

/// First what is not saved is asked about, and then the window closes by itself.
void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_features->projects->mayClose([this] { close(); })) {
        event->ignore();
        return;
    }
    m_tasks.cancel();
    projects().close();
    QSettings settings;
    settings.setValue("geometry", saveGeometry());
    settings.setValue("docks", saveState(layoutVersion));
    QMainWindow::closeEvent(event);
}

} // namespace knead
