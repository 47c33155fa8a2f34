#include "core/simulation/simulation_state.h"

#include <cmath>
#include <stdexcept>

namespace knead {

namespace {

/// Carries out one command on the state; a command that makes no sense throws with a sentence and changes nothing.
class Executor {
public:
    explicit Executor(Simulation::State& state)
        : m_state(state)
    {
    }

    void operator()(const SetMaterial& command) const
    {
        BodyRun& run = body(command.body);
        if (const auto problems = materialProblems(command.material); !problems.empty())
            throw Problem(problems.front());
        MaterialMap changed = run.materials;
        if (command.objects.empty())
            changed.setOwn(command.material);
        else
            changed.set(command.objects, command.material);
        m_state.requireDamping(changed, m_state.scheme.inUse);
        keepingAccounts([&] {
            if (command.objects.empty()) {
                run.materials.setOwn(command.material);
                m_state.bodies[command.body].material = command.material;
            } else {
                run.materials.set(command.objects, command.material);
            }
            run.connections.updateMaterials();
            run.rigid.reset(); // its mass is another; it goes on with the velocities of its objects
            m_state.setMasses();
            m_state.updateTimeStep();
            m_state.chooseIntegrator();
        });
    }
    void operator()(const SetBodyKind& command) const
    {
        const BodyRun& run = body(command.body);
        if (command.kind == BodyKind::rigid && run.kind != BodyKind::rigid)
            requireWhole(command.body);
        keepingAccounts([&] { m_state.setKind(command.body, command.kind); });
    }
    void operator()(const Renormalize& command) const
    {
        BodyRun& run = body(command.body);
        if (!run.deforms())
            throw Problem(Message("Material", "A rigid body has no stress to lose. Make it deformable first."));
        if (!(command.duration >= 0 && command.duration <= 3600))
            throw Problem(Message("Material", "Re-normalization takes 0 to 3600 s."));
        for (const ObjectIndex object : command.objects)
            if (object >= run.state.size())
                throw Problem(Message("Material", "There is no object number %1.").with(object));
        std::vector<std::uint8_t> marks = marksOf(command.objects, run.state.size());
        if (command.duration > 0)
            m_state.annealings.push_back({.body = command.body,
                                          .marks = std::move(marks),
                                          .rate = relaxationsPerAnnealing / command.duration,
                                          .end = m_state.steps.time + command.duration});
        else
            m_state.accounts.energy.plastic += run.connections.renormalize(run.state, marks, 1);
    }
    void operator()(const SetGravity& command) const
    {
        if (!(command.gravity.norm() <= 1e4))
            throw Problem(Message("Scene", "Gravity must not be stronger than 10000 m/s^2."));
        keepingAccounts([&] { m_state.around.gravity = command.gravity; });
    }
    void operator()(const SetFloor& command) const
    {
        if (command.height && !(std::abs(*command.height) <= 1e4))
            throw Problem(Message("Scene", "The height of the floor must lie between -10 and 10 km."));
        if (!(command.friction >= 0 && command.friction <= 2))
            throw Problem(Message("Scene", "The friction of the floor must lie between 0 and 2."));
        if (!(command.adhesion >= 0 && command.adhesion <= 1e9))
            throw Problem(Message("Scene", "The adhesion of the floor must lie between 0 and 1e9 Pa."));
        m_state.around.floorHeight = command.height;
        m_state.around.floorFriction = command.friction;
        m_state.around.floorAdhesion = command.adhesion;
        m_state.contacts->invalidate();
    }
    void operator()(const AddManipulator& command) const
    {
        check(command.manipulator);
        m_state.tools.emplace_back(command.manipulator);
        m_state.contacts->invalidate();
    }
    void operator()(const RemoveManipulator& command) const
    {
        tool(command.tool);
        m_state.tools[command.tool].reset();
        m_state.contacts->invalidate();
    }
    void operator()(const SetManipulatorMotion& command) const
    {
        change(command.tool, [&](Manipulator& manipulator) { manipulator.motion = command.motion; });
    }
    void operator()(const ReshapeManipulator& command) const
    {
        const auto reshape = [&](Manipulator& manipulator) {
            manipulator.kind = command.kind;
            manipulator.part = command.part;
            manipulator.size = command.size;
            manipulator.friction = command.friction;
            manipulator.speedLimit = command.speedLimit;
            manipulator.forceLimit = command.forceLimit;
            manipulator.adhesion = command.adhesion;
            manipulator.rollsFreely = command.rollsFreely;
        };
        change(command.tool, reshape);
        reshape(tool(command.tool).start);
    }
    void operator()(const PlaceManipulator& command) const
    {
        change(command.tool, [&](Manipulator& manipulator) {
            manipulator.pose = command.pose;
            manipulator.motion = HoldStill{};
        });
        if (m_state.steps.count == 0)
            tool(command.tool).start = tool(command.tool).manipulator;
    }
    void operator()(const AddFixture& command) const
    {
        if (command.fixture.body >= m_state.bodies.size())
            throw Problem(
                Message("Fixture", "Fixture \"%1\" names a body that does not exist.").with(command.fixture.name));
        requireGrip(command.fixture);
        keepingAccounts([&] {
            m_state.grips.fixtures.emplace_back(command.fixture);
            m_state.grips.progress.resize(m_state.grips.fixtures.size());
            m_state.holdFixtures();
        });
    }
    void operator()(const RemoveFixture& command) const
    {
        fixture(command.fixture).reset();
        m_state.holdFixtures();
    }
    void operator()(const MoveFixture& command) const
    {
        Fixture moved = *fixture(command.fixture);
        moved.velocity = command.velocity;
        moved.turn = command.turn;
        requireGrip(moved);
        keepingAccounts([&] {
            fixture(command.fixture) = std::move(moved);
            m_state.grips.progress[command.fixture] = {};
            m_state.holdFixtures();
        });
    }

    void operator()(const SetIntegrator& command) const
    {
        if (command.integrator == Integrator::forwardEuler)
            for (const auto& run : m_state.runs)
                m_state.requireDamping(run->materials, command.integrator);
        keepingAccounts([&] { m_state.setIntegrator(command.integrator); });
    }
    void operator()(const SetPace& command) const
    {
        m_state.scheme.pace = command.pace;
        if (m_state.isImplicit())
            m_state.steps.length = m_state.frameStep();
    }
    void operator()(const Reset&) const
    {
        m_state.placeAtStart();
        ++m_state.commands.resets;
    }
    void operator()(const KeepMoment&) const { m_state.keepMoment(); }
    void operator()(const FindBalance& command) const
    {
        const StaticReport report = m_state.settle(command.duration, TaskControl::none());
        if (report.converged)
            return;
        m_state.commands.recording.push_back({m_state.steps.count, KeepMoment{}}); // which it began with
        throw Problem(report.message);
    }
    void operator()(const Refill& command) const
    {
        body(command.body);
        if (!(command.spacing >= 0 && std::isfinite(command.spacing)))
            throw Problem(Message("Filling", "The spacing of another filling must be more than 0."));
        if (const Message why = m_state.whyNotRefilled(command.body); !why.empty())
            throw Problem(why);
        m_state.refill(command.body, command.spacing);
    }
    void operator()(const Cut& command) const
    {
        const BodyRun& run = body(command.body);
        if (!(command.point.allFinite() && command.normal.allFinite() && command.normal.norm() > 0))
            throw Problem(Message("Cut", "A cut needs a plane: a point, and a normal that is not zero."));
        if (!run.deforms())
            throw Problem(Message("Cut", "\"%1\" is rigid, and is not cut. Make it deformable first.")
                              .with(m_state.bodies[command.body].name));
        if (m_state.cutAlong(command.body, command.point, command.normal.normalized()) == 0)
            throw Problem(Message("Cut", "The plane meets nothing of \"%1\" that could be cut.")
                              .with(m_state.bodies[command.body].name));
    }
    void operator()(const SetPartLook&) const {}
    void operator()(const RenameManipulator& command) const
    {
        tool(command.tool).manipulator.name = command.name;
        tool(command.tool).start.name = command.name;
    }
    void operator()(const RenameFixture& command) const { fixture(command.fixture)->name = command.name; }
    void operator()(const AddLoad& command) const
    {
        if (command.load.body >= m_state.bodies.size())
            throw Problem(Message("Load", "Load \"%1\" names a body that does not exist.").with(command.load.name));
        const Aggregate& aggregate = *m_state.bodies[command.load.body].aggregate;
        if (const Message problem = loadProblem(command.load, aggregate.size()); !problem.empty())
            throw Problem(problem);
        m_state.loads.add({.load = command.load, .from = {}, .begin = m_state.steps.time}, aggregate);
    }
    void operator()(const RemoveLoad& command) const
    {
        requireLoad(command.load);
        m_state.loads.remove(command.load);
    }
    void operator()(const SetLoad& command) const
    {
        requireLoad(command.load);
        if (const Message problem = amountProblem(command.amount, command.ramp); !problem.empty())
            throw Problem(problem);
        m_state.loads.change(command, m_state.steps.time);
    }

private:
    // An annealing takes this many times its relaxation time, so that little is left to do at once at its end.
    static constexpr double relaxationsPerAnnealing = 5;

    BodyRun& body(BodyId id) const
    {
        if (id >= m_state.bodies.size())
            throw Problem(Message("Scene", "There is no body number %1.").with(id));
        return *m_state.runs[id];
    }
    std::optional<Fixture>& fixture(FixtureId id) const
    {
        std::vector<std::optional<Fixture>>& all = m_state.grips.fixtures;
        if (id >= all.size() || !all[id])
            throw Problem(Message("Fixture", "There is no fixture number %1.").with(id));
        return all[id];
    }
    /// Pieces that came off move on their own, and a rigid body has one motion.
    void requireWhole(BodyId id) const
    {
        const std::size_t pieces = m_state.piecesOf(id).count;
        if (pieces > findPieces(*m_state.bodies[id].aggregate).count)
            throw Problem(Message("Run", "\"%1\" broke into %2 pieces, and a rigid body would weld them together where "
                                         "they are. Keep it deformable, or reset before it becomes rigid.")
                              .with(m_state.bodies[id].name, pieces));
    }
    /// What a person changes by hand is neither won nor lost in the ledger.
    template <typename Change>
    void keepingAccounts(Change apply) const
    {
        const double before = m_state.storedEnergy().imbalance;
        apply();
        m_state.accounts.atStart += m_state.storedEnergy().imbalance - before;
    }
    static void requireGrip(const Fixture& fixture)
    {
        if (const Message problem = gripProblem(fixture); !problem.empty())
            throw Problem(problem);
    }
    void requireLoad(LoadId load) const
    {
        if (!m_state.loads.isThere(load))
            throw Problem(Message("Load", "There is no load number %1.").with(load));
    }
    static void check(const Manipulator& manipulator)
    {
        if (const auto problems = manipulatorProblems(manipulator); !problems.empty())
            throw Problem(problems.front());
    }
    ToolRun& tool(ToolId id) const
    {
        if (id >= m_state.tools.size() || !m_state.tools[id])
            throw Problem(Message("Tool", "There is no tool number %1.").with(id));
        return *m_state.tools[id];
    }
    template <typename Change>
    void change(ToolId id, Change apply) const
    {
        Manipulator changed = tool(id).manipulator;
        apply(changed);
        check(changed);
        tool(id).manipulator = changed;
        m_state.contacts->invalidate();
    }

    Simulation::State& m_state;
};

template <typename... Kinds>
bool isOneOf(const Command& command)
{
    return (std::holds_alternative<Kinds>(command) || ...);
}

/// Objects, what they are made of and which of them are held stay what they are, so that the implicit scheme goes on with its
/// system and its factor: what a hand does sixty times a second must not cost a factor each time.
bool leavesBodies(const Command& command)
{
    return isOneOf<SetPartLook, RenameManipulator, RenameFixture, SetGravity, SetFloor, AddManipulator,
                   RemoveManipulator, SetManipulatorMotion, ReshapeManipulator, PlaceManipulator, MoveFixture, SetLoad,
                   SetPace>(command);
}

/// At once and without pushing, be there material or not.
bool placesTool(const Command& command)
{
    return isOneOf<AddManipulator, PlaceManipulator, ReshapeManipulator, SetFloor, Reset>(command);
}

/// Of which body a command names objects by their numbers.
std::optional<BodyId> bodyOfNumbers(const Command& command)
{
    if (const auto* change = std::get_if<SetMaterial>(&command); change != nullptr && !change->objects.empty())
        return change->body;
    if (const auto* wanted = std::get_if<Renormalize>(&command); wanted != nullptr && !wanted->objects.empty())
        return wanted->body;
    if (const auto* add = std::get_if<AddFixture>(&command))
        return add->fixture.body;
    return std::nullopt;
}

} // namespace

void Simulation::State::setKind(BodyId body, BodyKind kind)
{
    BodyRun& run = *runs[body];
    if (run.kind == kind)
        return;
    bodies[body].kind = kind;
    run.kind = kind;
    run.rigid.reset();
    std::erase_if(annealings, [&](const Annealing& annealing) { return annealing.body == body; });
    setMasses();
    contacts->setKind(body, kind);
    updateTimeStep();
    chooseIntegrator();
}

void Simulation::State::carryOut(const Command& command)
{
    const std::uint64_t before = steps.count;
    rest.disturb();
    std::visit(Executor(*this), command);
    if (!leavesBodies(command))
        implicit.reset();
    const std::optional<BodyId> body = bodyOfNumbers(command);
    const bool isLater = body && !isFirstFilling(*body);
    commands.recording.push_back(
        {before, command, isLater ? static_cast<std::uint32_t>(bodies[*body].aggregate->size()) : 0});
}

void Simulation::State::applyCommands()
{
    while (!commands.pending.empty()) {
        const Command command = std::move(commands.pending.front());
        commands.pending.pop_front();
        try {
            carryOut(command);
            if (!std::holds_alternative<KeepMoment>(command)) // what was wrong before has not been read yet
                out.notice = {};
            if (placesTool(command))
                noteToolsInside();
        } catch (const std::runtime_error& error) {
            out.notice = messageOf(error);
        }
    }
}

} // namespace knead
