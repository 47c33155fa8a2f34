#include "app/recipe_progress.h"

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
        return *event.step < moment.step;
    return moment.step > 0 && moment.time - 0.5 * moment.timeStep >= event.time;
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
    return m_next >= m_toDo && (m_recipe.durationSteps ? simulation.stepCount() >= *m_recipe.durationSteps
                                                       : isAt(simulation, m_recipe.duration));
}

void RecipeProgress::carryOutDue(Simulation& simulation, const std::function<void()>& refused)
{
    for (; m_next < m_recipe.events.size() && isDue(m_recipe.events[m_next], simulation); ++m_next) {
        if (m_isRepeated && isThere(m_recipe.events[m_next].action, simulation))
            continue;
        for (Command& command : m_events.commandsOf(m_next, simulation.bodies()))
            carryOut(std::move(command), simulation, refused);
    }
}

void RecipeProgress::carryOut(Command command, Simulation& simulation, const std::function<void()>& refused)
{
    const std::size_t before = simulation.recording().size();
    simulation.post(std::move(command));
    simulation.applyCommands();
    const std::vector<RecordedCommand>& recording = simulation.recording();
    if (recording.size() > before)
        m_events.carriedOut(recording.back().command);
    else if (refused)
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
    return false;
}

void RecipeProgress::noteOther(const Command& command)
{
    m_events.carriedOutByOthers(command);
    if (!std::holds_alternative<Reset>(command))
        return;
    m_next = 0;
    m_isRepeated = true;
}

void RecipeProgress::goTo(const Moment& moment, std::optional<std::size_t> next)
{
    m_events.goTo(moment);
    m_next = 0;
    while (m_next < m_recipe.events.size() && wasDue(m_recipe.events[m_next], moment))
        ++m_next;
    m_next = next.value_or(m_next);
}

void checkEvents(const Recipe& recipe, const RecipeScene& ready)
{
    const EventCommands events(recipe, ready);
    for (std::size_t i = 0; i < recipe.events.size(); ++i)
        events.commandsOf(i, ready.scene.bodies);
}

} // namespace knead
