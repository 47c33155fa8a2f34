#include "ui/simulation/simulation_feature.h"

#include "ui/commands/availability.h"
#include "ui/document/run_remarks.h"
#include "ui/frame/docks.h"
#include "ui/frame/notices.h"
#include "ui/importing/import_feature.h"
#include "ui/language/retranslation.h"
#include "ui/language/said.h"
#include "ui/panels/panel_area.h"
#include "ui/panels/performance_panel.h"
#include "ui/panels/press_button.h"
#include "ui/panels/simulation_panel.h"
#include "ui/panels/status_readings.h"
#include "ui/viewport/view_grid.h"
#include "ui/viewport/viewport_widget.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStatusBar>

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr int outcomeTime = 10'000;    // of what came out [ms]
constexpr double slower = 0.5;         // speed limit of a tool by its old one
constexpr double finer = 0.75;         // spacing by the old one
constexpr double leastDamping = 0.1;   // damping ratio that is offered
constexpr double largestDamping = 0.3; // that a material may have

void slowToolsDown(Document& document)
{
    document.beginGesture();
    for (const ToolState& tool : document.frame()->snapshot->tools)
        document.post(ReshapeManipulator{tool.id, tool.size, tool.friction, slower * tool.speedLimit, tool.forceLimit,
                                         tool.kind, tool.part, tool.adhesion, tool.rollsFreely},
                      Message("SimulationFeature", "Slower tools"));
    document.endGesture();
    document.reset();
}

void dampMore(Document& document)
{
    document.beginGesture();
    const std::vector<Material> materials = document.frame()->snapshot->materials;
    for (BodyId body = 0; body < materials.size(); ++body) {
        Material material = materials[body];
        material.dampingRatio = std::clamp(2 * material.dampingRatio, leastDamping, largestDamping);
        document.post(SetMaterial{body, material}, Message("SimulationFeature", "More damping"));
    }
    document.endGesture();
    document.reset();
}

} // namespace

SimulationFeature::SimulationFeature(const Workbench& bench, StatusReadings& readings, ImportFeature& imports)
    : QObject(&bench.window)
    , m_bench(bench)
    , m_actions(bench.window)
    , m_readings(readings)
    , m_imports(imports)
    , m_panel(new SimulationPanel(bench.document, m_actions.keepUp, bench.services.limitThreads != nullptr))
    , m_performance(new PerformancePanel(&bench.window))
{
    bench.docks.add("simulationDock", tr("Simulation"), scrolled(m_panel));
    bench.docks.add("performanceDock", tr("Performance"), m_performance);
    connect(m_panel, &SimulationPanel::speedChanged, this, [this](double speed) {
        m_readings.setSpeed(speed);
        if (const FramePointer& frame = m_bench.document.frame())
            m_readings.show(*frame->snapshot);
    });
    connect(m_panel, &SimulationPanel::threadsChosen, this, &SimulationFeature::threadsChosen);
    new PressButton(m_actions.pressIt, &bench.views);
    connect(&bench.document, &Document::changed, m_performance, [this](Document::Change what) {
        if (what == Document::Change::Model)
            m_performance->clear();
    });
    auto* remarks = new RunRemarks(bench.document, this);
    connect(remarks, &RunRemarks::said, &bench.notices, &Notices::remark);
    connect(remarks, &RunRemarks::noted, &bench.notices, &Notices::warn);
    connect(remarks, &RunRemarks::passed, &bench.notices, &Notices::withdraw);
    connect(&bench.notices, &Notices::otherClicked, &bench.document, &Document::reset);
    connect(&bench.document, &Document::changed, this, &SimulationFeature::documentChanged);
    connect(&bench.document, &Document::stopping, this, [this] {
        showSteppable(false);
        m_bench.availability.update();
    });
    connect(&bench.document, &Document::recipeEnded, &bench.notices, &Notices::note);
    connect(&bench.document, &Document::balanced, this, &SimulationFeature::showBalance);
    connect(&bench.document, &Document::notBalanced, this, [this](const QString& sentence) {
        m_shownImbalance = sentence;
        m_bench.notices.problem(sentence);
    });
    connect(&bench.document, &Document::notice, this,
            [this](const QString& sentence) { m_bench.notices.problem(sentence); });
    connectActions();
    sayWhyNot();
}

void SimulationFeature::connectActions()
{
    const SimulationActions& a = m_actions;
    Document* document = &m_bench.document;
    connect(a.undo, &QAction::triggered, document, &Document::undo);
    connect(a.redo, &QAction::triggered, document, &Document::redo);
    connect(a.play, &QAction::triggered, document, &Document::togglePlay);
    connect(a.step, &QAction::triggered, document, &Document::stepOnce);
    connect(a.findBalance, &QAction::triggered, document, &Document::findBalance);
    connect(a.reset, &QAction::triggered, document, &Document::reset);
    connect(a.pressIt, &QAction::triggered, document, &Document::pressIt);
    connect(a.gravity, &QAction::toggled, this, &SimulationFeature::setGravity);
    connect(a.keepUp, &QAction::toggled, document, &Document::keepUp);
    connect(a.floor, &QAction::toggled, this, &SimulationFeature::setFloor);
    connect(a.renormalize, &QAction::triggered, document, &Document::renormalize);
    connect(a.refillNow, &QAction::triggered, document, &Document::refillNow);
    connect(a.cutHere, &QAction::triggered, this, [this] {
        if (const std::optional<CutPlane>& plane = m_bench.viewport.options().section.plane)
            m_bench.document.cutAlong(plane->offset * plane->normal, plane->normal);
        else
            m_bench.notices.remark(tr("Turn the section plane on (Shift+S) and put it where the cut shall be."));
    });
}

void SimulationFeature::sayWhyNot()
{
    using Why = std::optional<QString>;
    Availability& when = m_bench.availability;
    const SimulationActions& a = m_actions;
    when.add({a.undo}, [this] { return m_undoes ? Why() : tr("There is nothing to undo."); });
    when.add({a.redo}, [this] { return m_redoes ? Why() : tr("There is nothing to redo."); });
    when.needBodies(
        {a.play, a.findBalance, a.reset, a.gravity, a.floor, a.keepUp, a.renormalize, a.refillNow, a.cutHere});
    when.needBodies({a.step}, [this] { return m_isSteppable ? Why() : tr("Pause first."); });
    when.needBodies({a.pressIt}, [this]() -> Why {
        if (m_bench.viewport.isLookingBack())
            return tr("Come back to the present first: Esc.");
        return m_bench.document.canPressIt() ? Why()
                                             : tr("Only a part to which nothing was done yet is pressed like this.");
    });
}

void SimulationFeature::documentChanged(Document::Change what)
{
    if (what == Document::Change::Frame)
        showFrame();
    if (what == Document::Change::Moment)
        showSurroundings();
    if (what == Document::Change::Moment || what == Document::Change::History)
        showHistory();
}

/// Menu and buttons say what they would undo and redo.
void SimulationFeature::showHistory()
{
    m_undoes = m_bench.document.undoName();
    m_redoes = m_bench.document.redoName();
    const auto show = [](QAction* action, const QString& verb, const std::optional<QString>& name) {
        action->setText(name ? tr("%1 \"%2\"").arg(verb, *name) : verb);
    };
    show(m_actions.undo, tr("Undo"), m_undoes);
    show(m_actions.redo, tr("Redo"), m_redoes);
}

QList<QMenu*> SimulationFeature::newMenus() const
{
    const QList<QMenu*> menus = m_panel->newMenus(&m_bench.window);
    for (const QMenu* menu : menus)
        m_bench.availability.needBodies(menu->actions());
    return menus;
}

void SimulationFeature::showThreads(int threads)
{
    m_panel->showThreads(threads);
}

/// What was not carried out, or what should be known of it.
void SimulationFeature::showNotice(const Message& notice)
{
    if (std::exchange(m_shownNotice, notice) != notice && !notice.empty())
        m_bench.notices.remark(said(notice));
}

/// Too few cells across them, with a filling that has enough.
void SimulationFeature::showWalls(const SpacingAssessment& fineness)
{
    const bool isFine = fineness.warning.empty() || m_bench.document.content().bodies.empty();
    const QString before = std::exchange(m_shownWalls, isFine ? QString() : said(fineness.warning));
    if (isFine)
        return m_bench.notices.withdraw(before);
    m_bench.notices.advise(m_shownWalls, tr("Fill finer"),
                           [this, spacing = fineness.advisedSpacing] { m_imports.refill(spacing); });
}

void SimulationFeature::showBalance(const QString& sentence)
{
    m_bench.notices.withdraw(m_shownImbalance);
    m_bench.notices.note(sentence);
    m_bench.window.statusBar()->showMessage(sentence, outcomeTime);
}

/// What the simulation advises, as a button; and back to the start as it is.
void SimulationFeature::showHealth(const Health& health)
{
    if (health.message == m_shownHealth)
        return;
    m_shownHealth = health.message;
    m_bench.notices.setGrave(!health.message.empty());
    const QString sentence = said(health.message);
    const auto reset = [this] { m_bench.document.reset(); };
    if (health.message.empty())
        return m_bench.notices.hide();
    if (health.ok)
        return m_bench.notices.problem(sentence);
    const bool hasTools = !m_bench.document.frame()->snapshot->tools.empty();
    if (health.trouble == Trouble::squashed)
        m_bench.notices.trouble(
            sentence, tr("Fill finer"), [this] { m_imports.refill(finer * m_bench.document.content().spacing); },
            tr("Reset"));
    else if (health.trouble == Trouble::none || health.trouble == Trouble::longStep ||
             health.trouble == Trouble::failed)
        m_bench.notices.problem(sentence, tr("Reset"), reset);
    else if (hasTools)
        m_bench.notices.trouble(
            sentence, tr("Slower tools"), [this] { slowToolsDown(m_bench.document); }, tr("Reset"));
    else
        m_bench.notices.trouble(
            sentence, tr("More damping"), [this] { dampMore(m_bench.document); }, tr("Reset"));
}

/// The switches say what the simulation has.
void SimulationFeature::showSurroundings()
{
    const Snapshot& snapshot = *m_bench.document.frame()->snapshot;
    const QSignalBlocker gravityBlocker(m_actions.gravity);
    const QSignalBlocker floorBlocker(m_actions.floor);
    m_actions.gravity->setChecked(!snapshot.gravity.isZero());
    m_actions.floor->setChecked(snapshot.floorHeight.has_value());
}

/// Before a frame shows it: who pauses and steps at once does not wait for one.
void SimulationFeature::showSteppable(bool isPlaying)
{
    m_isSteppable = !isPlaying;
}

void SimulationFeature::showFrame()
{
    const Snapshot& snapshot = *m_bench.document.frame()->snapshot;
    const std::pair surroundings(!snapshot.gravity.isZero(), snapshot.floorHeight.has_value());
    if (std::exchange(m_surroundings, surroundings) != surroundings) // by a recipe, for one
        showSurroundings();
    m_readings.show(snapshot);
    m_performance->show(snapshot);
    m_actions.setPlaying(snapshot.playing);
    showSteppable(m_bench.document.isPlaying());
    showHealth(snapshot.health);
    showNotice(snapshot.notice);
}

void SimulationFeature::setGravity(bool on)
{
    m_bench.document.post(SetGravity{on ? m_panel->wantedGravity() : Vec3(Vec3::Zero())});
}

void SimulationFeature::setFloor(bool on)
{
    const Snapshot& now = *m_bench.document.frame()->snapshot;
    SetFloor command{{}, now.floorFriction, now.floorAdhesion};
    if (on)
        command.height = m_bench.document.content().box.min().z();
    m_bench.document.post(command);
}

} // namespace knead
