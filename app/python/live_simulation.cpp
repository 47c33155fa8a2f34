#include "app/python/live_simulation.h"

#include "app/recipe_exports.h"
#include "core/mechanics/stress_law.h"
#include "core/model/joined_model.h"
#include "core/session/export_jobs.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <utility>

namespace knead::python {

namespace {

/// That there is no problem.
void require(const Message& problem)
{
    if (!problem.empty())
        throw Problem(problem);
}

void requireTool(const Manipulator& tool)
{
    if (const std::vector<Message> problems = manipulatorProblems(tool); !problems.empty())
        throw Problem(problems.front());
}

} // namespace

SeenState::SeenState(SnapshotPointer snapshot)
    : m_snapshot(std::move(snapshot))
    , m_bodies(m_snapshot->bodies.size())
{
}

const std::vector<Vec3>& SeenState::displacements(BodyId body) const
{
    const std::lock_guard lock(m_mutex);
    OfBody& known = m_bodies.at(body);
    if (!known.displacements)
        known.displacements = m_snapshot->bodies[body].displacements();
    return *known.displacements;
}

const std::vector<ObjectStrain>& SeenState::strains(BodyId body) const
{
    const std::lock_guard lock(m_mutex);
    OfBody& known = m_bodies.at(body);
    if (!known.strains) {
        const Snapshot::BodyState& state = m_snapshot->bodies[body];
        const std::vector<BrokenConnection> none;
        known.strains =
            objectStrains(*state.aggregate, displacements(body), *state.relaxed, state.broken ? *state.broken : none);
    }
    return *known.strains;
}

const std::vector<double>& SeenState::vonMises(BodyId body) const
{
    const std::lock_guard lock(m_mutex);
    OfBody& known = m_bodies.at(body);
    if (!known.vonMises) {
        known.vonMises.emplace();
        for (const ObjectStrain& object : strains(body))
            known.vonMises->push_back(vonMisesStress(object.stress));
    }
    return *known.vonMises;
}

class LiveSimulation::Turn {
public:
    explicit Turn(LiveSimulation& simulation)
        : m_simulation(simulation)
    {
        if (simulation.m_owner == std::this_thread::get_id())
            throw Problem(
                Message("Python", "This simulation is in the midst of computing; ask for it when that is done."));
        ++simulation.m_waiting;
        simulation.m_mutex.lock();
        --simulation.m_waiting;
        simulation.m_owner = std::this_thread::get_id();
    }
    ~Turn()
    {
        m_simulation.m_owner = std::thread::id();
        m_simulation.m_mutex.unlock();
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

private:
    LiveSimulation& m_simulation;
};

LiveSimulation::LiveSimulation(std::vector<std::shared_ptr<FilledPart>> bodies, Scene world)
    : m_filled(std::move(bodies))
    , m_scene(std::move(world))
{
    if (m_filled.empty() || std::ranges::count(m_filled, nullptr) > 0)
        throw Problem(Message("Python", "A simulation needs a body; make one of a part with knead.fill()."));
    std::vector<Part> parts;
    for (const std::shared_ptr<FilledPart>& filled : m_filled) {
        parts.push_back(filled->source.part());
        m_scene.bodies.push_back(filled->body);
    }
    m_model = std::make_shared<const Model>(withParts(*m_filled.front()->source.model, std::move(parts)));
}

FixtureId LiveSimulation::fix(BodyId body, const std::optional<Box>& box, const std::vector<std::uint32_t>& faces,
                              Fixture how)
{
    const Turn turn(*this);
    const Body& held = m_simulation ? m_simulation->bodies().at(body) : m_scene.bodies.at(body);
    const Part& part = m_filled.at(body)->source.part();
    how.body = body;
    const auto hold = [&how](const std::vector<ObjectIndex>& objects) {
        const std::vector<ObjectIndex> before = std::exchange(how.objects, {});
        std::ranges::set_union(before, objects, std::back_inserter(how.objects));
    };
    if (box)
        hold(objectsInBox(*held.aggregate, *box));
    if (!faces.empty()) {
        for (const std::uint32_t face : faces)
            if (face >= part.faces.size())
                throw Problem(
                    Message("Python", "\"%1\" has no face %2; it has %3.").with(part.name, face, part.faces.size()));
        hold(objectsAtFaces(*held.aggregate, part.mesh, faces));
    }
    if (how.objects.empty())
        throw Problem(Message("Python", "The fixture of \"%1\" holds nothing: no object lies there.").with(part.name));
    if (how.objects.back() >= held.aggregate->size())
        throw Problem(Message("Python", "\"%1\" has no object %2; it has %3.")
                          .with(part.name, how.objects.back(), held.aggregate->size()));
    require(gripProblem(how));
    return add(std::move(how));
}

FixtureId LiveSimulation::add(Fixture fixture)
{
    if (m_simulation) {
        const FixtureId id = seen()->snapshot().nextFixture;
        apply(AddFixture{std::move(fixture)});
        return id;
    }
    m_scene.fixtures.push_back(std::move(fixture));
    return static_cast<FixtureId>(m_scene.fixtures.size() - 1);
}

ToolId LiveSimulation::addTool(const Manipulator& tool)
{
    requireTool(tool);
    const Turn turn(*this);
    if (m_simulation) {
        const ToolId id = seen()->snapshot().nextTool;
        apply(AddManipulator{tool});
        return id;
    }
    m_scene.manipulators.push_back(tool);
    return static_cast<ToolId>(m_scene.manipulators.size() - 1);
}

std::optional<std::uint32_t> LiveSimulation::carryOut(Command command)
{
    const Turn turn(*this);
    if (!m_simulation)
        if (const std::optional<std::uint32_t> number = addToStart(command))
            return number;
    std::optional<std::uint32_t> number;
    if (std::holds_alternative<AddManipulator>(command))
        number = seen()->snapshot().nextTool;
    if (std::holds_alternative<AddFixture>(command))
        number = seen()->snapshot().nextFixture;
    apply(std::move(command));
    return number;
}

std::optional<std::uint32_t> LiveSimulation::addToStart(const Command& command)
{
    const auto place = [](auto& all, const auto& one) {
        all.push_back(one);
        return static_cast<std::uint32_t>(all.size() - 1);
    };
    if (const auto* tool = std::get_if<AddManipulator>(&command)) {
        requireTool(tool->manipulator);
        return place(m_scene.manipulators, tool->manipulator);
    }
    if (const auto* add = std::get_if<AddFixture>(&command)) {
        const Fixture& fixture = add->fixture;
        bodyAtStart(fixture.body,
                    Message("Fixture", "Fixture \"%1\" names a body that does not exist.").with(fixture.name));
        require(gripProblem(fixture));
        return place(m_scene.fixtures, fixture);
    }
    if (const auto* add = std::get_if<AddLoad>(&command)) {
        const Load& load = add->load;
        const Body& body =
            bodyAtStart(load.body, Message("Load", "Load \"%1\" names a body that does not exist.").with(load.name));
        require(loadProblem(load, body.aggregate->size()));
        return place(m_scene.loads, load);
    }
    return std::nullopt;
}

const Body& LiveSimulation::bodyAtStart(BodyId body, const Message& problem) const
{
    return body < m_scene.bodies.size() ? m_scene.bodies[body] : throw Problem(problem);
}

void LiveSimulation::apply(Command command)
{
    Simulation& simulation = running();
    const std::size_t before = simulation.recording().size();
    const std::size_t kind = command.index();
    simulation.post(std::move(command));
    simulation.applyCommands();
    m_seen.reset();
    const std::vector<RecordedCommand>& recording = simulation.recording();
    if (recording.size() == before || recording.back().command.index() != kind)
        throw Problem(seen()->snapshot().notice);
}

void LiveSimulation::stepOnce()
{
    Simulation& simulation = running();
    m_seen.reset();
    simulation.step();
    if (const Health& health = simulation.health(); !health.ok)
        throw Problem(health.message);
}

void LiveSimulation::giveWay(const TaskControl& control) const
{
    control.throwIfCancelled();
    while (m_waiting > 0) {
        std::this_thread::yield();
        control.throwIfCancelled();
    }
}

void LiveSimulation::step(std::uint64_t steps, TaskControl& control)
{
    for (std::uint64_t i = 0; i < steps; ++i) {
        {
            const Turn turn(*this);
            stepOnce();
        }
        giveWay(control);
    }
}

bool LiveSimulation::stepTowards(double time)
{
    const Turn turn(*this);
    const Simulation& simulation = running();
    if (simulation.time() + 0.5 * simulation.timeStep() >= time)
        return false;
    stepOnce();
    return true;
}

void LiveSimulation::advanceTo(double time, TaskControl& control)
{
    while (stepTowards(time))
        giveWay(control);
}

bool LiveSimulation::stepTowards(std::uint64_t step)
{
    const Turn turn(*this);
    const std::uint64_t reached = running().stepCount();
    if (reached == step)
        return false;
    if (reached > step || !running().health().ok)
        throw Problem(
            Message("Python", "Step %1 cannot be gone on to: the simulation is at step %2.").with(step, reached));
    m_seen.reset();
    running().step();
    return true;
}

void LiveSimulation::stepTo(std::uint64_t step, TaskControl& control)
{
    while (stepTowards(step))
        giveWay(control);
}

StaticReport LiveSimulation::settle(double duration, TaskControl& control)
{
    const Turn turn(*this);
    StaticReport report = running().settle({.duration = duration}, control);
    m_seen.reset();
    if (!report.converged)
        throw Problem(report.message);
    return report;
}

MomentPointer LiveSimulation::keepMoment()
{
    const Turn turn(*this);
    m_seen.reset(); // rounding may change
    return running().keepMoment();
}

void LiveSimulation::goTo(const MomentPointer& moment)
{
    const Turn turn(*this);
    running().goTo(moment);
    m_seen.reset();
    if (const Message& notice = seen()->snapshot().notice; !notice.empty())
        throw Problem(notice);
}

double LiveSimulation::time()
{
    const Turn turn(*this);
    return running().time();
}

double LiveSimulation::timeStep()
{
    const Turn turn(*this);
    return running().timeStep();
}

std::uint64_t LiveSimulation::stepCount()
{
    const Turn turn(*this);
    return running().stepCount();
}

std::uint64_t LiveSimulation::stateHash()
{
    const Turn turn(*this);
    return running().stateHash();
}

std::vector<Reaction> LiveSimulation::reactions()
{
    const Turn turn(*this);
    return running().reactions();
}

SeenStatePointer LiveSimulation::state()
{
    const Turn turn(*this);
    return seen();
}

WrittenExports LiveSimulation::write(const std::string& path, const ExportOptions& options, TaskControl& control)
{
    const Turn turn(*this);
    Simulation& simulation = running();
    simulation.showPressing(true); // stress needs to know where
    const SnapshotPointer snapshot = simulation.snapshot();
    simulation.showPressing(false);
    std::vector<std::size_t> partOfBody(m_filled.size());
    std::iota(partOfBody.begin(), partOfBody.end(), std::size_t{0});
    ExportJob job = exportJobOf(*m_model, partOfBody, *snapshot);
    RecipeExport wanted{.file = std::filesystem::path(path).filename(), .options = options};
    if (options.unit.empty())
        wanted.options.unit = job.options.unit;
    const std::vector<RecipeExport> wishes{std::move(wanted)};
    const std::string folder = std::filesystem::absolute(path).parent_path();
    prepareFolders(wishes, folder);
    return writeExports(wishes, folder, std::move(job), *snapshot, control);
}

Simulation& LiveSimulation::running()
{
    if (!m_simulation)
        m_simulation.emplace(m_scene);
    return *m_simulation;
}

const SeenStatePointer& LiveSimulation::seen()
{
    if (!m_seen)
        m_seen = std::make_shared<const SeenState>(running().snapshot());
    return m_seen;
}

} // namespace knead::python
