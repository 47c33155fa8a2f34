#include "ui/document/document.h"

#include "core/model/part_tree.h"
#include "core/session/export_jobs.h"
#include "core/simulation/moment.h"
#include "ui/document/face_memory.h"
#include "ui/selection/selection_model.h"
#include "ui/tasks/task_runner.h"
#include "ui/units.h"

#include <QTimer>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

namespace knead {

namespace {

constexpr double fastestDisplay = 0.016;          // [s]
constexpr double slowestDisplay = 0.1;            // [s]
constexpr const char* fixturesPanel = "fixtures"; // in Project::panels
constexpr const char* notesPanel = "notes";

/// A project tells only those that lead to what is shown. The others have other spacings.
ImportChoices choicesFor(const ProjectStart& start, const ImportChoices& ofAnother)
{
    ImportChoices choices = ofAnother;
    if (!start.scene.bodies.empty())
        choices.spacing =
            SpacingChoice{SpacingChoice::Kind::Length, start.scene.bodies.front().aggregate->lattice.spacing};
    return choices;
}

} // namespace

Document::Document(QObject* parent)
    : QObject(parent)
    , m_content(std::make_shared<const FilledModel>())
    , m_notes(new ModelNotes(this))
    , m_selected(new SelectionModel(*this))
    , m_ending(new QTimer(this))
    , m_timer(new QTimer(this))
{
    setDisplayInterval(fastestDisplay);
    m_timer->setTimerType(Qt::PreciseTimer);
    m_ending->setSingleShot(true);
    connect(m_timer, &QTimer::timeout, this, &Document::poll);
    connect(m_ending, &QTimer::timeout, this, &Document::finishGesture);
    connect(&m_history, &DocumentHistory::appended, this, [this](Entry entry) {
        m_shown = entry;
        const HistoryRecord& record = m_history.tree().record(entry);
        if (record.start != m_history.tree().record(record.parent).start)
            m_playback.dropUnderWay();
        m_playback.append(entry, record.step, resetsIn(record.commands));
        followAppearance(record.commands);
    });
    connect(&m_history, &DocumentHistory::settled, this, &Document::tellSettled);
    connect(m_notes, &ModelNotes::edited, &m_history, &DocumentHistory::noteEdit);
    connect(&m_history, &DocumentHistory::changed, this, [this] { emit changed(Change::History); });
}

Document::~Document()
{
    cancelBalancing();
}

void Document::setTasks(TaskRunner* tasks)
{
    m_tasks = tasks;
    const auto tripEnded = [this](const QString& title) {
        if (m_navigation == NavigationState::looking && title == m_longTitle)
            giveUp({});
    };
    connect(tasks, &TaskRunner::cancelled, this, tripEnded);
    connect(tasks, &TaskRunner::failed, this, tripEnded);
}

void Document::open(PreparedModel prepared)
{
    const auto content = std::make_shared<const FilledModel>(std::move(prepared.content));
    const QString file = QString::fromStdString(std::filesystem::path(content->model->file).filename().string());
    start(std::move(prepared.simulation), content, std::move(prepared.frame),
          prepared.script ? prepared.script() : nullptr);
    forgetGoing();
    m_whenSettled.clear();
    m_playback.forget();
    m_opened = content->model;
    ++m_opening;
    beginFixtures(prepared);
    m_history.begin({startOf(*content, std::move(prepared.scene)), content, std::move(prepared.script)},
                    std::move(prepared.first),
                    prepared.name.empty() ? Message("Document", "Import %1").with(file.toStdString()) : prepared.name);
    m_start = 0;
    m_notes->remember({});
    m_appearance = {};
    showStart();
}

void Document::refill(PreparedModel prepared, const Message& name)
{
    showInstead(std::move(prepared), name, {});
}

void Document::deform(PreparedDeformation done, const Message& name)
{
    m_carried = &done.carried;
    showInstead(std::move(done.prepared), name, std::move(done.said));
    m_carried = nullptr;
}

void Document::showInstead(PreparedModel prepared, const Message& name, std::vector<RecipeDeformation> said)
{
    const auto content = std::make_shared<const FilledModel>(std::move(prepared.content));
    if (!isGoing())
        finishGesture();
    if (m_hasScript)
        emit recipeEnded(
            tr("The recipe belongs to the filling before and does not go on in this one. Undo goes back to it."));
    const std::vector<Fixture>& fixtures = prepared.scene.fixtures;
    const std::vector<std::optional<Fixture>> held(fixtures.begin(), fixtures.end());
    start(std::move(prepared.simulation), content, std::move(prepared.frame));
    forgetGoing();
    for (const FaceFixture& fixture : prepared.fixtures)
        m_fixtures.keepInMind(fixture);
    m_fixtures.follow(*content, held);
    const QString spacing = formatQuantity(content->spacing, Quantity::Length);
    ProjectStart next = startOf(*content, std::move(prepared.scene));
    if (content->model != m_opened) {
        next.model = content->model;
        next.deformations = deformationsUntil(m_history.starts()[m_start].start, next.model, std::move(said));
    }
    m_history.expectStart({std::move(next), content}, std::move(prepared.first),
                          name.empty() ? Message("Document", "Refill %1").with(spacing.toStdString()) : name);
    m_start = static_cast<std::uint32_t>(m_history.starts().size() - 1);
    showStart();
}

void Document::open(PreparedProject prepared)
{
    Project& project = prepared.project;
    HistoryDestination& destination = prepared.destination;
    std::vector<DocumentHistory::Start> starts;
    for (ProjectStart& start : project.starts) {
        ImportChoices choices = choicesFor(start, project.import);
        starts.push_back({.start = std::move(start), .content = nullptr, .choices = std::move(choices)});
    }
    m_history.begin(std::move(starts), std::move(project.entries), project.current);
    m_opened = project.model;
    ++m_opening;
    m_start = m_history.tree().record(project.current).start;
    m_history.setModel(m_start, destination.content);
    start(std::move(*destination.simulation), destination.content, std::move(destination.frame));
    forgetGoing();
    m_whenSettled.clear();
    m_playback.forget();
    m_shown = project.current;
    m_fixtures.clear();
    for (const FaceFixture& known : facesRemembered(project.panels[fixturesPanel]))
        m_fixtures.keepInMind(known);
    m_notes->remember(project.panels[notesPanel]);
    m_appearance = PartAppearance::at(m_history.tree(), project.current);
    follow(*destination.moment);
    showStart();
}

/// What is left is a model without parts, which lies where the last one did: views need a place to look at.
void Document::close()
{
    if (isEmpty())
        return;
    emit stopping();
    retire();
    m_timer->stop();
    m_ending->stop();
    m_selected->forget();
    auto nothing = std::make_shared<FilledModel>();
    nothing->model = std::make_shared<const Model>();
    nothing->box = m_content->box;
    m_content = std::move(nothing);
    m_opened = nullptr;
    ++m_opening;
    m_frame = std::make_shared<const Frame>(Frame{.snapshot = std::make_shared<const Snapshot>()});
    m_seen = nullptr;
    ++m_generation;
    ++m_edits;
    m_isPlaying = m_hasScript = false;
    m_scriptEnds = m_fixtureRequest = m_editRequest = m_arrivals = 0;
    m_whenKnown.clear();
    m_whenSettled.clear();
    m_toolRequests.forget();
    m_gesture = {};
    forgetGoing();
    m_playback.forget();
    m_fixtures.clear();
    m_notes->remember({});
    m_appearance = {};
    m_history.end();
    showStart();
}

Project Document::project() const
{
    Project project;
    if (m_history.isEmpty())
        return project;
    project.model = m_opened;
    project.import = m_content->request;
    for (const DocumentHistory::Start& start : m_history.starts())
        project.starts.push_back(start.start);
    project.entries = m_history.tree().records();
    project.current = m_history.tree().current();
    project.panels = panels();
    return project;
}

std::map<std::string, std::string> Document::panels() const
{
    return {{fixturesPanel, faceMemory(m_fixtures.known())}, {notesPanel, m_notes->memory()}};
}

void Document::showStart()
{
    m_toolCount.clear();
    m_toolToSelect.clear();
    if (m_selection.kind != Selection::Kind::Fixture ||
        m_fixtures.find(m_selection.id) == nullptr) // tools have other numbers
        m_selection = m_content->bodies.empty() ? Selection{} : Selection{Selection::Kind::Body, 0};
    emit changed(Change::Model);
    emit changed(Change::Selection);
}

void Document::start(Simulation simulation, std::shared_ptr<const FilledModel> content, FramePointer frame,
                     std::unique_ptr<ScriptedEvents> script)
{
    retire();
    m_selected->forget();
    m_content = std::move(content);
    m_frame = std::move(frame);
    if (m_frame->filled != m_content->bodies) {
        auto filled = std::make_shared<FilledModel>(*m_content);
        filled->bodies = m_frame->filled;
        m_content = std::move(filled);
    }
    m_hasScript = script != nullptr;
    m_simulation = std::make_unique<SimulationThread>(std::move(simulation), std::move(script));
    if (m_showsPressing)
        m_simulation->showPressing(true);
    m_simulation->setSpeed(m_speed);
    m_simulation->keepUp(m_keepsUp);
    m_seen = m_simulation->latest();
    m_arrivals = 0;
    ++m_edits;
    m_scriptEnds = m_fixtureRequest = m_editRequest = 0;
    m_whenKnown.clear();
    m_toolRequests.forget();
    m_isPlaying = false;
    m_ending->stop();
    m_gesture = {.begin = m_frame->snapshot->time};
    const std::uint64_t generation = ++m_generation;
    m_preparer = std::make_unique<FramePreparer>(m_content->bodies, [this, generation](const FramePointer& newest) {
        QMetaObject::invokeMethod(
            this, [this, newest, generation] { accept(newest, generation); }, Qt::QueuedConnection);
    });
    m_preparer->prepare(m_seen);
    m_timer->start();
    keepFilm();
}

/// Lets go of the simulation without waiting for the step it is in. The gesture that was ended last is still told.
void Document::retire()
{
    std::erase_if(m_retiring, [](const std::future<void>& one) {
        return one.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    cancelBalancing();
    if (m_simulation)
        m_retiring.push_back(std::async(
            std::launch::async, [simulation = std::move(m_simulation), preparer = std::move(m_preparer)]() mutable {
                preparer.reset();
                simulation->pause();
                std::promise<void> toldAll;
                simulation->lookAtGesture([&](const auto&, auto) { toldAll.set_value(); });
                toldAll.get_future().wait();
                simulation.reset();
            }));
}

void Document::poll()
{
    SnapshotPointer newest = m_simulation->latest();
    if (newest == m_seen)
        return;
    m_seen = newest;
    m_preparer->prepare(std::move(newest));
}

void Document::accept(const FramePointer& frame, std::uint64_t generation)
{
    if (generation != m_generation || frame->snapshot->arrivals < m_arrivals)
        return;
    m_frame = frame;
    followFillings();
    m_toolRequests.seen(*frame->snapshot);
    noticeStop();
    noticeRecipeEnd();
    selectNewTool();
    dropLostSelection();
    followScript();
    emit changed(Change::Frame);
    if (m_navigation == NavigationState::arriving)
        endNavigation();
}

/// Bodies have other objects than they had, and whoever looks at objects begins again; or a cut has opened their surface further.
void Document::followFillings()
{
    if (m_frame->filled == m_content->bodies)
        return;
    auto content = std::make_shared<FilledModel>(*m_content);
    content->bodies = m_frame->filled;
    m_content = std::move(content);
    emit changed(Change::Filling);
}

void Document::setSpeed(double ratio)
{
    m_speed = ratio;
    if (m_simulation)
        m_simulation->setSpeed(ratio);
}

void Document::keepUp(bool on)
{
    m_keepsUp = on;
    if (m_simulation)
        m_simulation->keepUp(on);
}

void Document::setDisplayInterval(double seconds)
{
    const int interval = static_cast<int>(1000 * std::clamp(seconds, fastestDisplay, slowestDisplay));
    if (interval != m_timer->interval())
        m_timer->setInterval(interval);
}

void Document::showPressing(bool on)
{
    if (std::exchange(m_showsPressing, on) != on && m_simulation)
        m_simulation->showPressing(on);
}

void Document::select(const Selection& selection)
{
    if (selection == m_selection)
        return;
    m_selection = selection;
    emit changed(Change::Selection);
}

void Document::dropLostSelection()
{
    if (m_selection.kind == Selection::Kind::Tool && tool(m_selection.id) == nullptr)
        select({});
}

double Document::size() const
{
    return isEmpty() ? 0 : m_content->box.sizes().maxCoeff();
}

ExportJob Document::exportJob(const std::vector<bool>& keep) const
{
    const Model& model = *m_content->model;
    std::vector<std::size_t> partOfBody;
    for (const auto& body : m_content->bodies)
        partOfBody.push_back(body->part);
    ExportJob job = exportJobOf(model, partOfBody, *m_frame->snapshot, keep);
    job.tree = prunedTree(m_appearance.dressed(model.tree), keep);
    std::size_t kept = 0;
    for (std::size_t p = 0; p < model.parts.size(); ++p)
        if (keep[p])
            m_appearance.dress(job.parts[kept++].part, p);
    return job;
}

} // namespace knead
