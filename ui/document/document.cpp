#include "ui/document/document.h"

#include "core/model/part_tree.h"

#include "ui/document/tool_kinds.h"

#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace knead {

namespace {

constexpr double fastestDisplay = 0.016; // [s]
constexpr double slowestDisplay = 0.1;   // [s]
constexpr double blockShare = 0.25;      // size of a new block, in sizes of the part
constexpr double crossingTime = 1.5;     // a tool crosses the part in this time [s]
// A new tool stalls at this strain of the stiffest material under its face: enough to bend and dent, not to crush.
constexpr double stallStrain = 0.25;

} // namespace

Document::Document(QObject* parent)
    : QObject(parent)
    , m_timer(new QTimer(this))
{
    setDisplayInterval(fastestDisplay);
    m_timer->setTimerType(Qt::PreciseTimer);
    connect(m_timer, &QTimer::timeout, this, &Document::poll);
}

Document::~Document() = default;

void Document::open(PreparedContent prepared)
{
    m_fixtures.clear();
    start(std::move(prepared));
    m_toolCount.clear();
    m_selection = m_content.bodies.empty() ? Selection{} : Selection{Selection::Kind::Body, 0};
    emit changed(Change::Content);
    emit changed(Change::Selection);
}

void Document::refill(PreparedContent prepared)
{
    m_fixtures.refilled();
    start(std::move(prepared));
    if (m_selection.kind == Selection::Kind::Tool) // tools are numbered anew
        m_selection = m_content.bodies.empty() ? Selection{} : Selection{Selection::Kind::Body, 0};
    emit changed(Change::Content);
    emit changed(Change::Selection);
}

void Document::start(PreparedContent prepared)
{
    retire();
    m_content = std::move(prepared.content);
    m_frame = std::move(prepared.frame);
    m_simulation = std::make_unique<SimulationThread>(std::move(prepared.simulation));
    m_seen = m_simulation->latest();
    m_toolToSelect.clear();
    const std::uint64_t generation = ++m_generation;
    m_preparer = std::make_unique<FramePreparer>(m_content.bodies, [this, generation](const FramePointer& frame) {
        QMetaObject::invokeMethod(
            this, [this, frame, generation] { accept(frame, generation); }, Qt::QueuedConnection);
    });
    m_preparer->prepare(m_seen);
    m_timer->start();
}

/// Lets go of the simulation without waiting for the step it is in.
void Document::retire()
{
    std::erase_if(m_retiring, [](const std::future<void>& one) {
        return one.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    if (m_simulation)
        m_retiring.push_back(std::async(
            std::launch::async, [simulation = std::move(m_simulation), preparer = std::move(m_preparer)]() mutable {
                preparer.reset();
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
    if (generation != m_generation)
        return;
    m_frame = frame;
    postFixtures();
    selectNewTool();
    dropLostSelection();
    emit changed(Change::Frame);
}

void Document::setDisplayInterval(double seconds)
{
    const int interval = static_cast<int>(1000 * std::clamp(seconds, fastestDisplay, slowestDisplay));
    if (interval != m_timer->interval())
        m_timer->setInterval(interval);
}

void Document::play()
{
    if (m_simulation)
        m_simulation->play();
}

void Document::pause()
{
    if (m_simulation)
        m_simulation->pause();
}

void Document::togglePlay()
{
    if (m_simulation && m_simulation->latest()->playing)
        pause();
    else
        play();
}

void Document::stepOnce()
{
    if (m_simulation)
        m_simulation->stepOnce();
}

void Document::reset()
{
    if (m_simulation)
        m_simulation->reset();
}

void Document::post(Command command)
{
    if (m_simulation)
        m_simulation->post(std::move(command));
}

void Document::select(const Selection& selection)
{
    if (selection == m_selection)
        return;
    m_selection = selection;
    emit changed(Change::Selection);
}

void Document::removeSelected()
{
    if (m_selection.kind == Selection::Kind::Tool) {
        post(RemoveManipulator{m_selection.id});
    } else if (m_selection.kind == Selection::Kind::Fixture) {
        m_fixtures.remove(m_selection.id);
        select({});
        postFixtures();
        emit changed(Change::Fixtures);
    }
}

void Document::addTool(ToolKind kind)
{
    if (isEmpty())
        return;
    const ToolKindLook& look = lookOf(kind);
    Manipulator tool;
    tool.name = look.name + std::string(" ") + std::to_string(++m_toolCount[kind]);
    tool.kind = kind;
    tool.size = size() * blockShare * look.proportions;
    tool.pose.position = placeAbove(tool.size);
    tool.speedLimit = size() / crossingTime;
    double stiffest = 0;
    for (const Material& material : m_frame->snapshot->materials)
        stiffest = std::max(stiffest, material.youngsModulus);
    tool.forceLimit = stallStrain * stiffest * tool.size.x() * tool.size.y();
    m_toolToSelect = tool.name;
    post(AddManipulator{std::move(tool)});
}

void Document::renormalize()
{
    for (BodyId body = 0; body < m_content.bodies.size(); ++body) {
        const bool isMeant = m_selection.kind != Selection::Kind::Body || m_selection.id == body;
        if (isMeant && m_frame->snapshot->bodies[body].kind == BodyKind::deformable)
            post(Renormalize{.body = body});
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
    return {center.x(), center.y(), top + m_content.spacing + toolSize.z() / 2};
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
    return isEmpty() ? 0 : m_content.box.sizes().maxCoeff();
}

ExportJob Document::exportJob(const std::vector<bool>& keep) const
{
    const Model& model = *m_content.model;
    ExportJob job;
    job.tree = prunedTree(model.tree, keep);
    job.options.unit = canBeWrittenIn(model.unit) ? model.unit : std::string();
    const Snapshot& snapshot = *m_frame->snapshot;
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        if (!keep[p])
            continue;
        PartToExport& part = job.parts.emplace_back(PartToExport{.part = model.parts[p]});
        for (std::size_t b = 0; b < m_content.bodies.size(); ++b)
            if (m_content.bodies[b]->part == p) {
                part.aggregate = m_content.bodies[b]->aggregate;
                part.displacements = snapshot.bodies[b].displacements();
                part.broken = snapshot.bodies[b].broken;
                part.relaxed = snapshot.bodies[b].relaxed;
                part.density = snapshot.materials[b].density;
            }
    }
    return job;
}

void Document::toggleFace(BodyId body, std::uint32_t face)
{
    if (m_content.model->parts[m_content.bodies[body]->part].faces.empty()) {
        emit notice(tr("\"%1\" is a mesh without CAD faces: open it as STEP, IGES or BREP to fix faces.")
                        .arg(QString::fromStdString(m_content.bodies[body]->name)));
        return;
    }
    const std::uint32_t active = m_selection.kind == Selection::Kind::Fixture ? m_selection.id : 0;
    const std::uint32_t key = m_fixtures.toggle(body, face, active);
    if (key != 0)
        select({Selection::Kind::Fixture, key});
    else if (m_fixtures.find(active) == nullptr)
        select({});
    noticeEmptyFixtures();
    postFixtures();
    emit changed(Change::Fixtures);
}

void Document::noticeEmptyFixtures()
{
    const std::vector<Fixture>& wanted = m_fixtures.wanted(m_content);
    for (const FaceFixture& fixture : m_fixtures.list())
        if (std::none_of(wanted.begin(), wanted.end(), [&](const Fixture& f) { return f.name == fixture.name; }))
            emit notice(
                tr("%1 holds no objects: its faces are smaller than the spacing. Choose a finer spacing and refill.")
                    .arg(QString::fromStdString(fixture.name)));
}

void Document::postFixtures()
{
    for (Command& command : m_fixtures.changes(*m_frame->snapshot, m_content))
        post(std::move(command));
}

} // namespace knead
