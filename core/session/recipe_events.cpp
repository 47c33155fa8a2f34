#include "core/session/recipe_events.h"

#include "core/message/message.h"
#include "core/simulation/moment.h"
#include "core/skin/refilled.h"

#include <filesystem>

namespace knead {

namespace {

using Tools = std::map<std::string, ToolId>;
using Fixtures = std::map<std::string, std::vector<FixtureId>>;
using Loads = std::map<std::string, LoadId>;

/// One event, by what it says.
struct CommandMaker {
    const Recipe& recipe;
    const RecipeScene& ready;
    const Tools& tools;
    const Fixtures& fixtures;
    const Loads& loads;
    const std::vector<Body>& bodies;
    std::size_t event;
    std::vector<Command> made = {};

    Message place() const
    {
        return Message::verbatim(std::filesystem::path(recipe.file).filename().string() + ": events[" +
                                 std::to_string(recipe.events[event].item) + "]");
    }

    /// What could not be added has no number, and nothing happens to it.
    template <class Make>
    void withTool(const std::string& name, Make make)
    {
        if (const auto found = tools.find(name); found != tools.end())
            made.push_back(make(found->second));
    }
    template <class Make>
    void withFixtures(const std::string& name, Make make)
    {
        if (const auto found = fixtures.find(name); found != fixtures.end())
            for (const FixtureId id : found->second)
                made.push_back(make(id));
    }

    template <class Make>
    void withLoad(const std::string& name, Make make)
    {
        if (const auto found = loads.find(name); found != loads.end())
            made.push_back(make(found->second));
    }

    void operator()(const AddRecipeLoad& add)
    {
        Load load = loadOf(recipe, add.load, ready);
        const Aggregate& aggregate = *bodies[load.body].aggregate;
        if (aggregate.former) // of a box nothing is left, which the simulation refuses
            load.patch = load.faces.empty()
                             ? LoadPatch{}
                             : loadPatch(aggregate, surfaceWhenFilled(ready.parts()[load.body].mesh, aggregate),
                                         load.faces, std::nullopt);
        made.push_back(AddLoad{std::move(load)});
    }
    void operator()(const ChangeRecipeLoad& change)
    {
        withLoad(change.load, [&](LoadId id) { return SetLoad{id, change.amount, change.ramp}; });
    }
    void operator()(const TakeLoadAway& away)
    {
        withLoad(away.load, [](LoadId id) { return RemoveLoad{id}; });
    }
    void operator()(const ChangeMaterial& change)
    {
        for (BodyObjects& at : objectsWithin(ready, change.body, change.box, change.objects, place()))
            made.push_back(SetMaterial{at.body, change.material.on(ready.scene.bodies[at.body].material),
                                       present(at.body, at.objects, change.objects)});
    }
    /// What was chosen in the first filling of a body, in the one that it has by now.
    /// @throws Problem where numbers are those of another filling
    std::vector<ObjectIndex> present(BodyId body, const std::vector<ObjectIndex>& objects,
                                     const std::optional<RecipeObjects>& numbers) const
    {
        const Aggregate& aggregate = *bodies[body].aggregate;
        if (!numbers || !numbers->isFilledAnew)
            return objectsInFilling(aggregate, objects);
        if (!aggregate.former || aggregate.size() != numbers->of)
            throw Problem(
                (aggregate.former
                     ? Message("Recipe",
                               "%1 names objects of a body that was filled anew with %2, and here it was filled anew "
                               "with %3. Name a box instead, or keep the spacing and what is done before.")
                     : Message("Recipe",
                               "%1 names objects of a body that was filled anew with %2, and here it is filled with "
                               "the first %3. Name a box instead, or keep the spacing and what is done before."))
                    .with(place(), numbers->of, aggregate.size()));
        return objects;
    }
    void operator()(const RenormalizeBodies& wanted)
    {
        for (BodyObjects& at : objectsWithin(ready, wanted.body, wanted.box, wanted.objects, place()))
            if (!wanted.body.empty() || bodies[at.body].kind == BodyKind::deformable)
                made.push_back(Renormalize{at.body, present(at.body, at.objects, wanted.objects), wanted.duration});
    }
    void operator()(const ChangeBodyKind& change)
    {
        for (const BodyId body : bodiesNamed(change.body, ready.parts(), place()))
            made.push_back(SetBodyKind{body, change.kind});
    }
    void operator()(const ChangeGravity& change) { made.push_back(SetGravity{change.gravity}); }
    void operator()(const ChangeFloor& change)
    {
        made.push_back(SetFloor{change.height, change.friction, change.adhesion});
    }
    void operator()(const ChangePace& change) { made.push_back(SetPace{change.pace}); }
    void operator()(const ChangeIntegrator& change) { made.push_back(SetIntegrator{change.integrator}); }
    void operator()(const AddRecipeFixture& add)
    {
        for (Fixture& fixture : fixturesOf(recipe, add.fixture, ready)) {
            fixture.objects = present(fixture.body, fixture.objects, add.fixture.objects);
            made.push_back(AddFixture{std::move(fixture)});
        }
    }
    void operator()(const MoveRecipeFixture& move)
    {
        withFixtures(move.fixture, [&](FixtureId id) { return MoveFixture{id, move.velocity, move.turn}; });
    }
    void operator()(const ReleaseFixture& release)
    {
        withFixtures(release.fixture, [](FixtureId id) { return RemoveFixture{id}; });
    }
    void operator()(const AddRecipeManipulator& add)
    {
        made.push_back(AddManipulator{manipulatorOf(add.manipulator, ready.eventParts[event])});
    }
    void operator()(const MoveRecipeManipulator& move)
    {
        withTool(move.manipulator, [&](ToolId id) { return SetManipulatorMotion{id, move.motion}; });
    }
    void operator()(const PlaceRecipeManipulator& place)
    {
        withTool(place.manipulator, [&](ToolId id) { return PlaceManipulator{id, place.pose}; });
    }
    void operator()(const ReshapeRecipeManipulator& reshape)
    {
        const Manipulator form = manipulatorOf(reshape.manipulator, ready.eventParts[event]);
        withTool(form.name, [&](ToolId id) {
            return ReshapeManipulator{.tool = id,
                                      .size = form.size,
                                      .friction = form.friction,
                                      .speedLimit = form.speedLimit,
                                      .forceLimit = form.forceLimit,
                                      .kind = form.kind,
                                      .part = form.part,
                                      .adhesion = form.adhesion,
                                      .rollsFreely = form.rollsFreely};
        });
    }
    void operator()(const TakeManipulatorAway& away)
    {
        withTool(away.manipulator, [](ToolId id) { return RemoveManipulator{id}; });
    }
    void operator()(const RefillBodies& wanted)
    {
        for (const BodyId body : bodiesNamed(wanted.body, ready.parts(), place()))
            if (!wanted.body.empty() || bodies[body].material.yields())
                made.push_back(Refill{body, wanted.spacing});
    }
    void operator()(const CutBodies& cut)
    {
        for (const BodyId body : bodiesNamed(cut.body, ready.parts(), place()))
            if (!cut.body.empty() || bodies[body].kind == BodyKind::deformable)
                made.push_back(Cut{body, cut.point, cut.normal});
    }
    /// Of bodies as they are filled, all deformable; a run finds them where and what they are by then.
    void operator()(const DeformByPhysics& deform) { made = gripsOf(deform, atRest(bodies)); }
    static Snapshot atRest(const std::vector<Body>& bodies)
    {
        Snapshot rest;
        for (const Body& body : bodies) {
            Snapshot::BodyState& state = rest.bodies.emplace_back(Snapshot::BodyState{.aggregate = body.aggregate});
            for (ObjectIndex i = 0; i < body.aggregate->size(); ++i)
                state.positions.push_back(body.aggregate->lattice.position(i));
        }
        return rest;
    }
    std::vector<Command> gripsOf(const DeformByPhysics& deform, const Snapshot& now) const
    {
        std::vector<std::string> names;
        for (const Part& part : ready.parts())
            names.push_back(part.name);
        std::vector<bool> which(names.size(), false);
        for (const BodyId body : bodiesNamed(deform.body, ready.parts(), place()))
            which[body] = !deform.body.empty() || now.bodies[body].kind == BodyKind::deformable;
        try {
            return addedGrips(deform.what, heldEnds(deform.what, now, names, which));
        } catch (const Problem& problem) {
            throw UnusableInput(Message::verbatim("%1: %2").with(place(), problem.message()));
        }
    }
    void operator()(const SettleScene& settle) { made.push_back(FindBalance{settle.duration}); }
    void operator()(const StartAgain&) { made.push_back(Reset{}); }
    void operator()(const MarkMoment&) { made.push_back(KeepMoment{}); }
};

} // namespace

EventCommands::EventCommands(const Recipe& recipe, const RecipeScene& ready)
    : m_recipe(recipe)
    , m_ready(ready)
    , m_nextTool(static_cast<ToolId>(ready.scene.manipulators.size()))
    , m_nextFixture(static_cast<FixtureId>(ready.scene.fixtures.size()))
    , m_nextLoad(static_cast<LoadId>(ready.scene.loads.size()))
{
    for (std::size_t i = 0; i < recipe.loads.size(); ++i)
        m_loads[recipe.loads[i].name] = static_cast<LoadId>(i);
    for (std::size_t i = 0; i < recipe.manipulators.size(); ++i)
        m_tools[recipe.manipulators[i].name] = static_cast<ToolId>(i);
    for (std::size_t i = 0; i < recipe.fixtures.size(); ++i)
        m_fixtures[recipe.fixtures[i].name] = ready.fixtureIds[i];
}

std::vector<Command> EventCommands::commandsOf(std::size_t event, const std::vector<Body>& bodies) const
{
    CommandMaker maker{m_recipe, m_ready, m_tools, m_fixtures, m_loads, bodies, event};
    std::visit([&](const auto& action) { maker(action); }, m_recipe.events[event].action);
    return std::move(maker.made);
}

std::vector<Command> EventCommands::gripsOf(std::size_t event, const Snapshot& now) const
{
    const CommandMaker maker{m_recipe, m_ready, m_tools, m_fixtures, m_loads, m_ready.scene.bodies, event};
    return maker.gripsOf(std::get<DeformByPhysics>(m_recipe.events[event].action), now);
}

std::vector<Command> EventCommands::movesOf(const PhysicalDeformation& deformation, const EndGrips::Moves& moves) const
{
    std::vector<Command> commands;
    for (const NumberEnd end : {NumberEnd::first, NumberEnd::second})
        if (const auto& move = moves[end == NumberEnd::first ? 0 : 1])
            if (const auto found = m_fixtures.find(nameOfGrip(deformation, end)); found != m_fixtures.end())
                for (const FixtureId id : found->second)
                    commands.emplace_back(MoveFixture{id, move->velocity, move->turn});
    return commands;
}

std::vector<Command> EventCommands::releaseOf(const PhysicalDeformation& deformation) const
{
    std::vector<Command> commands;
    if (const auto found = m_fixtures.find(nameOfGrip(deformation, freedEnd(deformation.numbers)));
        found != m_fixtures.end())
        for (const FixtureId id : found->second)
            commands.emplace_back(RemoveFixture{id});
    return commands;
}

void EventCommands::carriedOut(const Command& command)
{
    if (const auto* tool = std::get_if<AddManipulator>(&command))
        m_tools[tool->manipulator.name] = m_nextTool++;
    if (const auto* fixture = std::get_if<AddFixture>(&command))
        m_fixtures[fixture->fixture.name].push_back(m_nextFixture++);
    if (const auto* load = std::get_if<AddLoad>(&command))
        m_loads[load->load.name] = m_nextLoad++;
}

void EventCommands::carriedOutByOthers(const Command& command)
{
    m_nextTool += std::holds_alternative<AddManipulator>(command) ? 1 : 0;
    m_nextFixture += std::holds_alternative<AddFixture>(command) ? 1 : 0;
    m_nextLoad += std::holds_alternative<AddLoad>(command) ? 1 : 0;
}

void EventCommands::goTo(const Moment& moment)
{
    m_tools.clear();
    m_fixtures.clear();
    m_loads.clear();
    m_nextTool = static_cast<ToolId>(moment.tools.size());
    m_nextFixture = static_cast<FixtureId>(moment.fixtures.size());
    for (ToolId id = 0; id < m_nextTool; ++id)
        if (moment.tools[id])
            m_tools[moment.tools[id]->manipulator.name] = id;
    for (FixtureId id = 0; id < m_nextFixture; ++id)
        if (moment.fixtures[id])
            m_fixtures[moment.fixtures[id]->name].push_back(id);
    m_nextLoad = static_cast<LoadId>(moment.loads.size());
    for (LoadId id = 0; id < m_nextLoad; ++id)
        if (moment.loads[id])
            m_loads[moment.loads[id]->load.name] = id;
}

} // namespace knead
