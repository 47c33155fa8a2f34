// Materials and how time runs in the main window: the simulation dock, and what is offered when a simulation had to stop.
#include "ui/main_window.h"

#include "ui/document/run_remarks.h"
#include "ui/language/words_of_files.h"
#include "ui/materials/material_store.h"
#include "ui/panels/banner.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/panel_area.h"
#include "ui/panels/simulation_panel.h"
#include "ui/panels/status_readings.h"

#include <QDockWidget>
#include <QScrollArea>
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
                      MainWindow::tr("Slower tools"));
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
        document.post(SetMaterial{body, material}, MainWindow::tr("More damping"));
    }
    document.endGesture();
    document.reset();
}

} // namespace

void MainWindow::makeMaterials()
{
    m_materials = new MaterialStore(m_services, this);
    connect(m_materials, &MaterialStore::failed, this, [this](const QString& sentence) { showProblem(sentence); });
    if (!m_materials->damage().isEmpty()) // when there is a banner to show it
        QMetaObject::invokeMethod(
            this, [this] { showProblem(m_materials->damage()); }, Qt::QueuedConnection);
}

void MainWindow::makeSimulation()
{
    auto* panel = new SimulationPanel(m_document, m_actions->keepUp, m_services.limitThreads != nullptr);
    auto* dock = new QDockWidget(tr("Simulation"), this);
    dock->setObjectName("simulationDock");
    dock->setWidget(scrolled(panel));
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    addDockWidget(Qt::LeftDockWidgetArea, dock);
    auto* model = findChild<QDockWidget*>("modelDock");
    tabifyDockWidget(findChild<QDockWidget*>("historyDock"), dock);
    model->raise();
    m_simulation = panel;
    connect(panel, &SimulationPanel::speedChanged, this, [this](double speed) {
        m_readings->setSpeed(speed);
        if (const FramePointer& frame = m_document.frame())
            m_readings->show(*frame->snapshot);
    });
    connect(panel, &SimulationPanel::threadsChosen, this, &MainWindow::chooseThreads);
    auto* remarks = new RunRemarks(m_document, this);
    connect(remarks, &RunRemarks::said, this, &MainWindow::showRemark);
    connect(m_banner, &Banner::otherClicked, this, [this] { m_document.reset(); });
}

/// What was not carried out, or what should be known of it.
void MainWindow::showNotice(const std::string& notice)
{
    if (std::exchange(m_shownNotice, notice) != notice && !notice.empty())
        showRemark(inWords(notice));
}

/// On the banner, too, unless that has something worse to say, or a remedy.
void MainWindow::showRemark(const QString& sentence)
{
    m_log->add(sentence, LogPanel::Kind::Warning);
    const bool hasRemedy = !m_banner->isHidden() && m_remedy != nullptr;
    if (!m_shownHealth.empty() || hasRemedy)
        return;
    m_remedy = nullptr;
    m_banner->show(sentence);
}

/// Too few cells across them, with a filling that has enough.
void MainWindow::showWalls(const SpacingAssessment& fineness)
{
    const bool isSaid = !m_shownWalls.isEmpty() && m_banner->sentence() == m_shownWalls;
    const bool isFine = fineness.warning.empty() || m_document.content().bodies.empty();
    m_shownWalls = isFine ? QString() : inWords(fineness.warning);
    if (isFine && isSaid)
        m_banner->hide();
    if (isFine)
        return;
    m_remedy = [this, spacing = fineness.advisedSpacing] { refill(spacing); };
    m_banner->show(m_shownWalls, tr("Fill finer"));
}

void MainWindow::showBalance(const QString& sentence)
{
    if (!m_shownImbalance.isEmpty() && m_banner->sentence() == m_shownImbalance)
        m_banner->hide(); // what it says is no longer so
    m_log->add(sentence);
    statusBar()->showMessage(sentence, outcomeTime);
}

/// What the simulation advises, as a button; and back to the start as it is.
void MainWindow::showHealth(const Health& health)
{
    if (health.message == m_shownHealth)
        return;
    m_shownHealth = health.message;
    const QString sentence = inWords(health.message);
    const auto reset = [this] { m_document.reset(); };
    if (health.message.empty())
        return m_banner->hide();
    if (health.ok)
        return showProblem(sentence);
    const bool hasTools = !m_document.frame()->snapshot->tools.empty();
    if (health.trouble == Trouble::squashed)
        showTrouble(sentence, tr("Fill finer"), [this] { refill(finer * m_document.content().spacing); });
    else if (health.trouble == Trouble::none || health.trouble == Trouble::longStep ||
             health.trouble == Trouble::failed)
        showProblem(sentence, tr("Reset"), reset);
    else if (hasTools)
        showTrouble(sentence, tr("Slower tools"), [this] { slowToolsDown(m_document); });
    else
        showTrouble(sentence, tr("More damping"), [this] { dampMore(m_document); });
}

void MainWindow::showTrouble(const QString& sentence, const QString& remedyText, std::function<void()> remedy)
{
    showProblem(sentence, remedyText, std::move(remedy));
    m_banner->show(sentence, remedyText, tr("Reset"));
}

} // namespace knead
