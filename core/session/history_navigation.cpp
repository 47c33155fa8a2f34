#include "core/session/history_navigation.h"

#include "core/session/sculpting.h"
#include "core/simulation/moment.h"
#include "core/simulation/replay.h"

#include <algorithm>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace knead {

namespace {

/// Takes away what a stroke of the entry put there and would have taken away again at its end, its fingers and the other hand: nobody
/// holds them where another branch begins. What a recipe would have taken away stays, as the recipe goes on.
/// @param begin of the entry
/// @param rest of its commands
void letGo(Simulation& simulation, const Snapshot& begin, std::span<const RecordedCommand> rest)
{
    const std::shared_ptr<const Snapshot> now = simulation.snapshot();
    const auto isHand = [](const auto& id, const auto& ids, const auto& before, const auto& named) {
        const auto found = std::ranges::find(ids, id);
        return found != ids.end() && std::ranges::find(before, id) == before.end() &&
               isNameOfStroke(named[static_cast<std::size_t>(found - ids.begin())].name);
    };
    const auto toolsOf = [](const Snapshot& snapshot) {
        std::vector<ToolId> tools;
        for (const ToolState& tool : snapshot.tools)
            tools.push_back(tool.id);
        return tools;
    };
    for (const RecordedCommand& recorded : rest) {
        if (std::holds_alternative<Reset>(recorded.command))
            break; // what comes after it is about others
        const auto* tool = std::get_if<RemoveManipulator>(&recorded.command);
        const auto* fixture = std::get_if<RemoveFixture>(&recorded.command);
        if ((tool != nullptr && isHand(tool->tool, toolsOf(*now), toolsOf(begin), now->tools)) ||
            (fixture != nullptr && isHand(fixture->fixture, now->fixtureIds, begin.fixtureIds, now->fixtures)))
            simulation.post(recorded.command);
    }
    simulation.applyCommands();
}

} // namespace

HistoryDestination HistoryNavigation::go(TaskControl& control) const
{
    HistoryDestination destination;
    destination.content = start.content;
    TaskPortion preparing(control, 0, 0.3);
    if (!destination.content)
        destination.content =
            std::make_shared<const FilledModel>(contentOf(model, start.choices, start.start, preparing));
    TaskPortion repeating(control, start.content ? 0 : 0.3, 1);
    const Scene& scene = start.start.scene;
    destination.moment = follow(way, scene, packing, repeating);
    if (!way.commands.empty())
        destination.found = std::make_shared<const Bytes>(momentToBytes(*destination.moment, packing));
    if (changesStart) {
        destination.simulation.emplace(scene);
        destination.simulation->goTo(destination.moment);
        destination.frame = prepareFrame(destination.content->bodies, destination.simulation->snapshot(), nullptr);
    }
    return destination;
}

Branch HistoryNavigation::branch(const std::vector<RecordedCommand>& commands, std::uint32_t run,
                                 std::uint64_t upToStep, TaskControl& control) const
{
    const Scene& scene = start.start.scene;
    TaskPortion going(control, 0, way.commands.empty() ? 0.05 : 0.5);
    Simulation simulation(scene);
    simulation.goTo(follow(way, scene, packing, going));
    const std::shared_ptr<const Snapshot> atBegin = simulation.snapshot();
    const std::vector<RecordedCommand> before = commandsBefore(commands, run, upToStep);
    const std::uint64_t begin = resetsIn(before) == 0 ? simulation.stepCount() : 0;
    TaskPortion repeating(control, way.commands.empty() ? 0.05 : 0.5, 1);
    simulation = replay(std::move(simulation), before, std::max(begin, upToStep), repeating);
    letGo(simulation, *atBegin, std::span(commands).subspan(before.size()));
    return {endGesture(simulation)};
}

} // namespace knead
