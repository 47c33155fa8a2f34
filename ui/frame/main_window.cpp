#include "ui/frame/main_window.h"

#include "ui/commands/command_palette.h"
#include "ui/display.h"
#include "ui/frame/center.h"
#include "ui/frame/features.h"
#include "ui/frame/notices.h"
#include "ui/frame/status_line.h"
#include "ui/frame/window_menus.h"
#include "ui/interaction/hands.h"
#include "ui/interaction/view_hand.h"
#include "ui/materials/material_store.h"
#include "ui/measuring/measuring.h"
#include "ui/measuring/shown_place.h"
#include "ui/modes.h"
#include "ui/panels/banner.h"
#include "ui/panels/display_panel.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/home_page.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/model_panel.h"
#include "ui/panels/model_tree.h"
#include "ui/panels/panel_area.h"
#include "ui/panels/property_pages.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/status_readings.h"
#include "ui/panels/timeline_panel.h"
#include "ui/plain_texts.h"
#include "ui/project/project_keeper.h"
#include "ui/theme.h"
#include "ui/viewport/view_grid.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QProcess>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>

#include <algorithm>

namespace knead {

namespace {

constexpr int layoutVersion = 2; // of the docks; layouts of another version are not restored

/// Texts are as large as a person chose them before the window is made: all that is made in it takes its font.
QWidget* withChosenTexts(QWidget* parent)
{
    applyTextSize(readPreferences().textPercent);
    return parent;
}

} // namespace

MainWindow::MainWindow(Services services, QWidget* parent)
    : QMainWindow(withChosenTexts(parent))
    , m_atStart(PreferencesFeature::begin())
    , m_services(std::move(services))
    , m_availability(m_document, *this)
    , m_actions(std::make_unique<WindowActions>(*this))
    , m_modes(new Modes(this))
    , m_docks(*this)
{
    showTextsAsTheyStand();
    m_document.setTasks(&m_tasks);
    m_document.history().setPacking(m_services.packing);
    setObjectName("mainWindow");
    setWindowTitle(tr("Knead"));
    setWindowIcon(icon("knead"));
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    m_center = new Center(m_document, QString::fromStdString(m_services.examplesFolder), this);
    m_views = &m_center->views();
    m_viewport = &m_views->active();
    setCentralWidget(m_center);
    makePanels();
    m_status = new StatusLine(*statusBar(), m_tasks);
    makeFeatures();
    m_docks.arrange();
    makeMenus();
    connectActions();
    connectTasks();
    connect(&m_document, &Document::changed, this, &MainWindow::documentChanged);
    selectionChanged();
    m_availability.update();
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

Banner& MainWindow::banner()
{
    return m_center->banner();
}

// --- what it consists of --------------------------------------------------------------------------------------------------

void MainWindow::makePanels()
{
    auto* log = new LogPanel(this);
    m_notices = new Notices(banner(), *log, this);
    m_bench.reset(new Workbench{*this, m_services, m_document, m_tasks, *m_notices, m_docks, *m_views, *m_viewport,
                                m_availability});
    m_materials = new MaterialStore(m_services, this);
    connect(m_materials, &MaterialStore::failed, this,
            [this](const QString& sentence) { m_notices->problem(sentence); });
    if (!m_materials->damage().isEmpty()) // once the window is there
        QMetaObject::invokeMethod(
            this, [this] { m_notices->problem(m_materials->damage()); }, Qt::QueuedConnection);

    m_tree = new ModelTree(m_document, this);
    m_history = new HistoryPanel(m_document);
    m_properties = new PropertyPages(m_document, *m_materials, this);
    connect(m_properties, &PropertyPages::refillRequested, this,
            [this](double spacing) { m_features->imports->refill(spacing); });
    m_timeline = new TimelinePanel(m_document);
    m_display = new Display(*m_bench);

    m_docks.add("modelDock", tr("Model"), new ModelPanel(m_tree));
    m_docks.add("historyDock", tr("History"), m_history);
    m_docks.add("propertiesDock", tr("Properties"), m_properties);
    m_docks.add("displayDock", tr("Display"), scrolled(new DisplayPanel(*m_display)));
    m_docks.add("logDock", tr("Log"), log);
    m_docks.add("timelineDock", tr("Timeline"), m_timeline)
        .titleBarWidget()
        ->setToolTip(tr("Drag to move the timeline"));
}

/// Each is handed what it takes; the order says no more than who takes whom.
void MainWindow::makeFeatures()
{
    m_features = std::make_unique<Features>();
    Features& f = *m_features;
    const Workbench& bench = *m_bench;
    f.preferences = new PreferencesFeature(bench, m_atStart);
    f.views = new ViewsFeature(bench);
    f.projects = new ProjectsFeature(bench, *m_tree, m_center->home(), *f.views->actions().perspective);
    f.recipes = new RecipesFeature(bench, *f.projects);
    f.otherPart = new OtherPartFeature(bench, *f.projects);
    f.imports = new ImportFeature(bench, *f.projects, *f.recipes);
    f.exports = new ExportFeature(bench);
    connect(f.recipes, &RecipesFeature::exportWanted, f.exports->action(), &QAction::trigger);
    f.pictures = new PictureFeature(bench);
    f.simulation = new SimulationFeature(bench, m_status->readings(), *f.imports);
    f.measuring = new MeasuringFeature(bench, *m_modes);
    f.comparison = new ComparisonFeature(bench, f.measuring->measuring());
    f.probes = new ProbesFeature(bench, f.measuring->measuring(), f.projects->keeper());
    f.hands = new HandsFeature(bench, *m_modes);
    f.deforming = new DeformFeature(bench, *m_modes);
    connect(f.deforming, &DeformFeature::applied, f.exports, &ExportFeature::showDeformed);
    connect(f.imports, &ImportFeature::shapesTaken, f.exports, &ExportFeature::showDeformed);
    f.recording = new RecordingFeature(bench);
    f.trace = new TraceFeature(bench, f.projects->keeper());
    f.selection = new SelectionFeature(
        bench, {*f.simulation, *f.hands, *m_modes, *m_tree, *m_properties, *m_materials, *m_display});
    f.help = new HelpFeature(bench);
    showPlacesOfReports();
    m_timeline->addButton(f.recording->actions().video);
    connect(&m_center->home(), &HomePage::openClicked, this, [this] { m_features->imports->askForFile(false); });
    connect(&m_center->home(), &HomePage::tryClicked, f.help, &HelpFeature::beginTour);
    connect(&f.measuring->measuring(), &Measuring::promptChanged, this, &MainWindow::showHint);
    connect(&f.hands->hands(), &Hands::modeChanged, this, &MainWindow::showHint);
    m_selectionBar = f.selection->newBar(m_center);
    m_sculptBar = f.hands->hands().newSculptBar(m_center);
    m_center->addBar(*m_selectionBar, Center::Side::left);
    m_center->addBar(*m_sculptBar, Center::Side::right);
    m_availability.needPart({m_selectionBar->toggleViewAction(), m_sculptBar->toggleViewAction()});
}

/// One way to a place from all rows that are about one.
void MainWindow::showPlacesOfReports()
{
    auto* shown = new ShownPlace(m_document, *m_viewport);
    connect(m_features->imports, &ImportFeature::placeWanted, shown, &ShownPlace::show);
    connect(m_features->exports, &ExportFeature::placeWanted, shown, &ShownPlace::show);
    connect(m_features->comparison, &ComparisonFeature::placeWanted, shown, &ShownPlace::show);
    connect(m_features->measuring, &MeasuringFeature::placeWanted, shown, &ShownPlace::show);
}

void MainWindow::makeMenus()
{
    const MenuSources sources{*m_actions, *m_features, *m_display, *m_timeline};
    QMenu* panels = fillMenuBar(*this, sources);
    const Features& f = *m_features;
    f.help->setPlaces({*f.imports, *f.exports, f.hands->hands(), makeToolBar(*this, sources), *m_sculptBar, banner()});
    listPanels(*this, *panels, {m_selectionBar, m_sculptBar}, *m_actions);
}

/// After all panels, menus and actions are there.
void MainWindow::makeCommands()
{
    PreferencesFeature* preferences = m_features->preferences;
    preferences->takeKeys();
    m_palette = new CommandPalette(*this);
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
    connect(m_actions->quit, &QAction::triggered, this, &QWidget::close);
    connect(m_actions->newWindow, &QAction::triggered, this, &MainWindow::openAnother);
    connect(m_actions->firstPage, &QAction::toggled, this, &MainWindow::showFirstPage);
    connect(m_actions->cancel, &QAction::triggered, this, &MainWindow::cancel);
    m_availability.needPart({m_actions->firstPage});
    m_availability.whileSeen([this]() -> std::optional<QString> {
        if (m_actions->firstPage->isChecked())
            return tr("Go back to the part first: Esc.");
        return {};
    });
    for (const QuantityField* field : findChildren<QuantityField*>()) // the keys are the view's again
        connect(field, &QuantityField::finished, this, [this] {
            if (m_viewport->isVisible())
                m_viewport->setFocus();
        });
    connect(qApp, &QApplication::focusChanged, this, &MainWindow::showHint); // keys drive in the view only
    connect(m_modes, &Modes::changed, this, &MainWindow::showHint);
    connect(m_center, &Center::turned, this, &MainWindow::showHint);
    connect(m_timeline, &TimelinePanel::looked, m_features->deforming,
            &DeformFeature::leave); // before the past is shown
    connect(m_timeline, &TimelinePanel::looked, m_viewport, &ViewportWidget::lookBack);
    connect(m_timeline, &TimelinePanel::looked, this, [this](const FramePointer& past) {
        m_availability.update(); // some of it is for the present alone
        if (!past)
            m_notices->withdraw(ViewHand::notThePresent());
    });
}

void MainWindow::connectTasks()
{
    connect(&m_tasks, &TaskRunner::failed, this,
            [this](const QString&, const QString& sentence) { m_notices->problem(sentence); });
    connect(&m_tasks, &TaskRunner::cancelled, this,
            [this](const QString& title) { m_notices->note(tr("%1: cancelled, nothing has changed.").arg(title)); });
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
    m_status->readings().showUnits(now.lengthUnit + ", N, MPa");
    m_history->showAllowedMemory(now.historyMegabytes);
    projects().setKeepingInterval(now.keepingInterval);
    m_features->simulation->showThreads(now.threads);
    showHint();
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
    m_availability.update();
    if (m_document.isEmpty())
        return;
    for (const Document::Change what :
         {Document::Change::Frame, Document::Change::Selection, Document::Change::Fixtures, Document::Change::Moment})
        emit m_document.changed(what);
}

// --- what it tells of the document ----------------------------------------------------------------------------------------

void MainWindow::documentChanged(Document::Change what)
{
    if (what == Document::Change::Model)
        modelChanged();
    if (what == Document::Change::Selection)
        selectionChanged();
    if (what == Document::Change::Frame && m_document.selection().kind == Selection::Kind::Tool)
        showHint(); // it is placed, or it is driven
    m_availability.update();
}

void MainWindow::modelChanged()
{
    m_actions->firstPage->setChecked(false);
    if (m_document.history().isEmpty()) {
        showNothing();
        return;
    }
    const FilledModel& content = m_document.content();
    const bool isSimulated = !content.bodies.empty();
    m_center->showViews();
    m_features->views->showArrangement();
    m_modes->leave();
    m_features->simulation->showSurroundings();
    m_status->readings().setVisible(isSimulated);
    m_viewport->setFocus();
    m_viewport->fit();
    m_features->simulation->showFrame();
    m_features->imports->tellOfModel();
    m_features->simulation->showWalls(content.fineness);
    m_features->imports->showImport();
}

/// As before anything was opened.
void MainWindow::showNothing()
{
    m_modes->leave();
    m_features->simulation->showSurroundings();
    m_features->simulation->showFrame();
    m_features->imports->showNothing();
    m_status->readings().hide();
    m_center->showHome();
    m_center->home().setFocus();
    showHint();
}

void MainWindow::selectionChanged()
{
    m_properties->setCurrentIndex(static_cast<int>(m_document.selection().kind));
    showHint();
}

/// What the mouse and the keys do now.
QString MainWindow::hint() const
{
    if (!m_center->hasViews())
        return {}; // there is nothing to turn
    const PickTool& tool = m_features->measuring->measuring().tool();
    if (tool.isPicking())
        return tool.prompt();
    if (m_features->hands->actions().fixFaces->isChecked())
        return tr("Click faces to hold or free them   Esc: done");
    if (const QString ofHand = m_features->hands->hands().hint(); !ofHand.isEmpty())
        return ofHand;
    const NavigationPreset& navigation = m_viewport->navigation();
    const QString orbit = navigation.nameOf(NavigationMotion::orbit);
    const bool isTool = m_document.selection().kind == Selection::Kind::Tool;
    if (isTool && !m_viewport->hasFocus() && QApplication::focusWidget() != nullptr)
        return tr("Click into the view: arrows then drive the tool   %1: orbit").arg(orbit);
    if (isTool && !m_document.isPlaying())
        return tr("Arrows, PgUp, PgDn: place   Space: play, and it presses   %1: orbit").arg(orbit);
    if (isTool)
        return tr("Arrows, PgUp, PgDn: drive   Shift: slower   %1: orbit").arg(orbit);
    return tr("%1: orbit   %2: pan   Wheel: zoom").arg(orbit, navigation.nameOf(NavigationMotion::pan));
}

void MainWindow::showHint()
{
    m_status->showHint(hint());
}

/// A program of its own, as when it is started anew.
void MainWindow::openAnother()
{
    if (!QProcess::startDetached(QCoreApplication::applicationFilePath(), {}))
        m_notices->problem(tr("Another window could not be opened."));
}

/// What is open stays so, and time stands still meanwhile: nobody sees it.
void MainWindow::showFirstPage(bool on)
{
    if (m_document.isEmpty())
        return;
    if (on) {
        m_document.pause();
        m_center->showHome();
    } else {
        m_center->showViews();
        m_viewport->setFocus();
    }
    m_availability.update();
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

// --- what comes and goes --------------------------------------------------------------------------------------------------

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.empty() && std::all_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); })) {
        m_center->home().showDrop(true);
        event->acceptProposedAction();
    }
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent* event)
{
    m_center->home().showDrop(false);
    QMainWindow::dragLeaveEvent(event);
}

void MainWindow::dropEvent(QDropEvent* event)
{
    m_center->home().showDrop(false);
    activateWindow(); // the keys that follow are for this window, not for the one it comes from
    event->acceptProposedAction();
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        paths << url.toLocalFile();
    m_features->imports->openInstead(paths);
}

/// Enter presses the button that has the keyboard: Space, which does so elsewhere, starts and stops time.
void MainWindow::keyPressEvent(QKeyEvent* event)
{
    auto* button = qobject_cast<QAbstractButton*>(focusWidget());
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter && button != nullptr && button->isEnabled() && !event->isAutoRepeat())
        button->animateClick();
    else
        QMainWindow::keyPressEvent(event);
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
