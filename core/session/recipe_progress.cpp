#include "core/session/recipe_progress.h"

#include "core/simulation/moment.h"

#include <algorithm>
#include <variant>

namespace knead {

namespace {

/// Whether the step nearest to a time [s] has been reached.
bool isAt(const Simulation& simulation, double time)
{
    return simulation.time() + 0.5 * simulation.timeStep() >= time;
}

/// Whether an event took place before an earlier step than that of a moment.
bool wasDue(const RecipeEvent& event, const Moment& moment)
{
    if (event.step)
        return *event.step < moment.steps.count;
    return moment.steps.count > 0 && moment.steps.time - 0.5 * moment.steps.length >= event.time;
}

/// Whether it is of objects that there are only when the event is due.
bool namesLaterFilling(const RecipeAction& action)
{
    const auto isLater = [](const std::optional<RecipeObjects>& objects) { return objects && objects->isFilledAnew; };
    if (const auto* change = std::get_if<ChangeMaterial>(&action))
        return isLater(change->objects);
    if (const auto* wanted = std::get_if<RenormalizeBodies>(&action))
        return isLater(wanted->objects);
    const auto* add = std::get_if<AddRecipeFixture>(&action);
    return add != nullptr && isLater(add->fixture.objects);
}

} // namespace

RecipeProgress::RecipeProgress(const Recipe& recipe, const RecipeScene& ready)
    : m_recipe(recipe)
    , m_events(recipe, ready)
{
    for (std::size_t i = 0; i < recipe.events.size(); ++i)
        if (std::holds_alternative<StartAgain>(recipe.events[i].action))
            m_toDo = i + 1;
}

bool RecipeProgress::isDue(const RecipeEvent& event, const Simulation& simulation) const
{
    return event.step ? simulation.stepCount() >= *event.step : isAt(simulation, event.time);
}

bool RecipeProgress::isDone(const Simulation& simulation) const
{
    return m_mark.nextEvent >= m_toDo && (m_recipe.durationSteps ? simulation.stepCount() >= *m_recipe.durationSteps
                                                                 : isAt(simulation, m_recipe.duration));
}

void RecipeProgress::carryOutDue(Simulation& simulation, const std::function<void()>& refused)
{
    std::size_t& next = m_mark.nextEvent;
    for (; next < m_recipe.events.size() && isDue(m_recipe.events[next], simulation); ++next) {
        const bool isThereAlready = m_mark.isRepeated && isThere(m_recipe.events[next].action, simulation);
        if (std::holds_alternative<DeformByPhysics>(m_recipe.events[next].action))
            begin(next, simulation, isThereAlready ? nullptr : &refused);
        else if (!isThereAlready)
            for (Command& command : m_events.commandsOf(next, simulation.bodies()))
                carryOut(std::move(command), simulation, refused);
    }
    moveGrips(simulation, refused);
}

/// @param refused null: its grips are there already
void RecipeProgress::begin(std::size_t event, Simulation& simulation, const std::function<void()>* refused)
{
    if (refused != nullptr)
        for (Command& command : m_events.gripsOf(event, *simulation.snapshot()))
            carryOut(std::move(command), simulation, *refused);
    m_mark.onTheWay.emplace_back(
        event, EndGrips(std::get<DeformByPhysics>(m_recipe.events[event].action).what, simulation.time()));
}

void RecipeProgress::moveGrips(Simulation& simulation, const std::function<void()>& refused)
{
    const bool isStatic = m_recipe.analysis == Analysis::equilibrium;
    const double step = isStatic ? m_recipe.duration / m_recipe.loadSteps : simulation.timeStep();
    for (auto& [event, grips] : m_mark.onTheWay) {
        const PhysicalDeformation& what = std::get<DeformByPhysics>(m_recipe.events[event].action).what;
        const EndGrips::Moves moves =
            grips.follow(simulation.time(), step, isStatic ? step : std::max(EndGrips::leastHorizon, step));
        for (Command& command : m_events.movesOf(what, moves))
            carryOut(std::move(command), simulation, refused);
        if (grips.isOver() && what.letsGo)
            for (Command& command : m_events.releaseOf(what))
                carryOut(std::move(command), simulation, refused);
    }
    std::erase_if(m_mark.onTheWay, [](const auto& each) { return each.second.isOver(); });
}

bool RecipeProgress::isOnTheWay(const Simulation& simulation) const
{
    const double time = simulation.time() + 0.5 * simulation.timeStep();
    return std::ranges::any_of(m_mark.onTheWay, [time](const auto& each) { return each.second.shareAt(time) < 1; });
}

void RecipeProgress::carryOut(Command command, Simulation& simulation, const std::function<void()>& refused)
{
    const std::size_t before = simulation.recording().size();
    const std::size_t kind = command.index();
    simulation.post(std::move(command));
    simulation.applyCommands();
    const std::vector<RecordedCommand>& recording = simulation.recording();
    if (recording.size() > before && recording.back().command.index() == kind) {
        m_events.carriedOut(recording.back().command);
        if (std::holds_alternative<Reset>(recording.back().command))
            m_mark.onTheWay.clear();
    } else if (refused)
        refused();
}

/// What an event adds has been there since it was carried out for the first time.
bool RecipeProgress::isThere(const RecipeAction& action, Simulation& simulation) const
{
    const auto isNamed = [](const std::string& name) { return [&name](const auto& one) { return one.name == name; }; };
    if (const auto* tool = std::get_if<AddRecipeManipulator>(&action)) {
        const auto now = simulation.snapshot();
        return std::any_of(now->tools.begin(), now->tools.end(), isNamed(tool->manipulator.name));
    }
    if (const auto* fixture = std::get_if<AddRecipeFixture>(&action)) {
        const auto now = simulation.snapshot();
        return std::any_of(now->fixtures.begin(), now->fixtures.end(), isNamed(fixture->fixture.name));
    }
    if (const auto* deform = std::get_if<DeformByPhysics>(&action)) {
        const auto now = simulation.snapshot();
        return std::ranges::any_of(now->fixtures, isNamed(nameOfGrip(deform->what, NumberEnd::second)));
    }
    if (const auto* load = std::get_if<AddRecipeLoad>(&action)) {
        const std::vector<Reaction> now = simulation.reactions();
        return std::any_of(now.begin(), now.end(), [&](const Reaction& reaction) {
            return reaction.kind == Reaction::Kind::load && reaction.name == load->load.name;
        });
    }
    return false;
}

void RecipeProgress::noteOther(const Command& command)
{
    m_events.carriedOutByOthers(command);
    if (!std::holds_alternative<Reset>(command))
        return;
    m_mark = {.nextEvent = 0, .isRepeated = true};
}

void RecipeProgress::goTo(const Moment& moment, const std::optional<Mark>& mark)
{
    m_events.goTo(moment);
    const auto isNext = [&](const RecipeEvent& event) { return !wasDue(event, moment); };
    const auto next = std::find_if(m_recipe.events.begin(), m_recipe.events.end(), isNext);
    if (mark) {
        m_mark = *mark;
        return;
    }
    m_mark = {.nextEvent = static_cast<std::size_t>(next - m_recipe.events.begin())};
    for (std::size_t event = 0; event < m_mark.nextEvent; ++event)
        if (const auto* deform = std::get_if<DeformByPhysics>(&m_recipe.events[event].action)) {
            const double begin = m_recipe.events[event].time;
            if (moment.steps.time < begin + deform->what.duration)
                m_mark.onTheWay.emplace_back(event, EndGrips(deform->what, begin, moment.steps.time));
        }
}

void checkEvents(const Recipe& recipe, const RecipeScene& ready)
{
    const EventCommands events(recipe, ready);
    for (std::size_t i = 0; i < recipe.events.size(); ++i)
        if (!namesLaterFilling(recipe.events[i].action))
            events.commandsOf(i, ready.scene.bodies);
}

} // namespace knead
