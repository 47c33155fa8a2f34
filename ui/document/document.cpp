#include "ui/document/document.h"

#include "core/session/export_jobs.h"
#include "ui/document/face_memory.h"

#include "core/mechanics/blade.h"
#include "core/model/part_tree.h"
#include "core/simulation/moment.h"
#include "ui/document/tool_kinds.h"
#include "ui/round_number.h"
#include "ui/selection/selection_model.h"
#include "ui/tasks/task_runner.h"
#include "ui/units.h"

#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <utility>

namespace knead {

namespace {

constexpr double fastestDisplay = 0.016; // [s]
constexpr double slowestDisplay = 0.1;   // [s]
constexpr double blockShare = 0.25;      // size of a new block, in sizes of the part
constexpr double crossingTime = 1.5;     // a tool crosses the part in this time [s]
// A new tool stalls at this strain of the stiffest material under its face: enough to bend and dent, not to crush.
constexpr double stallStrain = 0.25;
// And a new knife by this times what its whole edge takes in the toughest material.
constexpr double cutsInLimit = 4;
constexpr double placeShare = 1.0 / 200;          // of the part: new tools stand at places no finer than this
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
    beginFixtures(prepared);
    m_history.begin({startOf(*content, std::move(prepared.scene)), content, std::move(prepared.script)},
                    std::move(prepared.first),
                    prepared.name.empty() ? tr("Import %1").arg(file) : QString::fromStdString(prepared.name));
    m_start = 0;
    m_notes->remember({});
    m_appearance = {};
    showStart();
}

void Document::refill(PreparedModel prepared, const QString& name)
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
    m_fixtures.follow(*content, held);
    const QString spacing = formatQuantity(content->spacing, Quantity::Length);
    m_history.expectStart({startOf(*content, std::move(prepared.scene)), content}, std::move(prepared.first),
                          name.isEmpty() ? tr("Refill %1").arg(spacing) : name);
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

Project Document::project() const
{
    Project project;
    if (m_history.isEmpty())
        return project;
    project.model = m_content->model;
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

void Document::addTool(ToolKind kind)
{
    addTool(lookOf(kind));
}

/// @param look of those there are, which stay
void Document::addTool(const ToolKindLook& look)
{
    if (isEmpty() || later([this, &look] { addTool(look); }))
        return;
    Manipulator tool;
    tool.name = look.name + std::string(" ") + std::to_string(numberOfNewTool(look));
    tool.kind = look.kind;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        tool.size[axis] = typedNumber(size() * blockShare * look.proportions[axis]);
    tool.rollsFreely = look.rollsFreely;
    const bool lies = tool.rolls() || (look.kind == ToolKind::cylinder && bladeOf(tool.shape()));
    if (lies) // across, and goes down
        tool.pose.rotation = Quaternion(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()));
    tool.pose.position = placeAbove(lies ? tool.size.reverse().eval() : tool.size);
    tool.speedLimit = typedNumber(size() / crossingTime);
    double stiffest = 0;
    for (const Material& material : m_frame->snapshot->materials)
        stiffest = std::max(stiffest, material.youngsModulus);
    tool.forceLimit = stallStrain * stiffest * tool.size.x() * tool.size.y();
    if (const auto blade = bladeOf(tool.shape())) // which needs more than what would stall so small a block
        for (const Material& material : m_frame->snapshot->materials)
            tool.forceLimit = std::max(tool.forceLimit, cutsInLimit * material.toughness * blade->length());
    tool.forceLimit = typedNumber(tool.forceLimit);
    m_toolToSelect = tool.name;
    post(AddManipulator{std::move(tool)});
}

/// Above those of the tools that are there and of those that were just added.
int Document::numberOfNewTool(const ToolKindLook& look)
{
    int& count = m_toolCount[look.name];
    const QString begin = QString(look.name) + ' ';
    for (const ToolState& tool : m_frame->snapshot->tools)
        if (const QString name = QString::fromStdString(tool.name); name.startsWith(begin))
            count = std::max(count, name.mid(begin.size()).toInt());
    return ++count;
}

void Document::renormalize()
{
    if (later([this] { renormalize(); }))
        return;
    if (m_selection.kind == Selection::Kind::Region) {
        renormalizeRegion(m_selected->region());
        return;
    }
    for (BodyId body = 0; body < m_content->bodies.size(); ++body) {
        const bool isMeant = m_selection.kind != Selection::Kind::Body || m_selection.id == body;
        if (isMeant && m_frame->snapshot->bodies[body].kind == BodyKind::deformable)
            post(Renormalize{.body = body});
    }
}

void Document::refillNow()
{
    if (later([this] { refillNow(); }))
        return;
    bool isAny = false;
    for (BodyId body = 0; body < m_content->bodies.size(); ++body) {
        const bool isSelected = m_selection.kind == Selection::Kind::Body && m_selection.id == body;
        const bool isMeant =
            isSelected || (m_selection.kind != Selection::Kind::Body && m_frame->snapshot->materials[body].yields());
        if (isMeant)
            post(Refill{.body = body});
        isAny = isAny || isMeant;
    }
    if (!isAny)
        emit notice(
            tr("No body is of material that yields: elastic ones keep their shape at rest, and are not filled anew."));
}

void Document::cutAlong(const Vec3& point, const Vec3& normal)
{
    if (later([this, point, normal] { cutAlong(point, normal); }))
        return;
    for (BodyId body = 0; body < m_content->bodies.size(); ++body) {
        const bool isSelected = m_selection.kind == Selection::Kind::Body && m_selection.id == body;
        const bool isMeant =
            m_selection.kind != Selection::Kind::Body && m_frame->snapshot->bodies[body].kind == BodyKind::deformable;
        if (isSelected || isMeant)
            post(Cut{.body = body, .point = point, .normal = normal});
    }
}

/// Just above what lies under the middle of the bodies, other tools included.
Vec3 Document::placeAbove(const Vec3& toolSize) const
{
    Box box;
    for (const auto& body : m_frame->bodies)
        for (const Vec3& place : body->places)
            box.extend(place);
    const Vec3 center = box.center();
    double top = std::numeric_limits<double>::lowest();
    const auto raise = [&](const Vec3& place, const Vec3& margin) {
        const Vec3 reach = toolSize / 2 + margin;
        if (std::abs(place.x() - center.x()) <= reach.x() && std::abs(place.y() - center.y()) <= reach.y())
            top = std::max(top, place.z() + margin.z());
    };
    for (const auto& body : m_frame->bodies)
        for (const Vec3& place : body->places)
            raise(place, Vec3::Zero());
    for (const ToolState& tool : m_frame->snapshot->tools)
        raise(tool.pose.position, tool.size / 2);
    if (top < box.min().z()) // nothing there, as in a ring
        top = box.max().z();
    const double grid = placeShare * size();
    const auto nearest = [](double steps) { return std::round(steps); };
    const auto above = [](double steps) { return std::ceil(steps * (1 - 1e-12)); }; // what rounding left is no step
    return {onGrid(center.x(), grid, nearest), onGrid(center.y(), grid, nearest),
            onGrid(top + m_content->spacing + toolSize.z() / 2, grid, above)};
}

void Document::selectNewTool()
{
    if (m_toolToSelect.empty())
        return;
    for (const ToolState& tool : m_frame->snapshot->tools)
        if (tool.name == m_toolToSelect) {
            m_toolToSelect.clear();
            select({Selection::Kind::Tool, tool.id});
            return;
        }
}

void Document::dropLostSelection()
{
    if (m_selection.kind == Selection::Kind::Tool && tool(m_selection.id) == nullptr)
        select({});
}

const ToolState* Document::tool(ToolId id) const
{
    if (!m_frame)
        return nullptr;
    const auto& tools = m_frame->snapshot->tools;
    const auto found = std::find_if(tools.begin(), tools.end(), [id](const ToolState& tool) { return tool.id == id; });
    return found == tools.end() ? nullptr : &*found;
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
