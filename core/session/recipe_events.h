#pragma once

#include "core/session/end_grips.h"
#include "core/session/recipe.h"
#include "core/session/recipe_scene.h"
#include "core/simulation/command.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace knead {

struct Moment;

/// Makes commands of the events of a recipe, and knows the numbers that its names have in the simulation.
class EventCommands {
public:
    /// @param recipe and ready outlive this
    EventCommands(const Recipe& recipe, const RecipeScene& ready);

    /// What an event does now.
    /// @param bodies of the simulation, as they are now
    /// @throws UnusableInput, in a sentence, when the event does not fit the parts
    std::vector<Command> commandsOf(std::size_t event, const std::vector<Body>& bodies) const;

    /// The grips that a deformation by physics adds. @param now of the simulation
    /// @throws UnusableInput, in a sentence, where it makes no sense
    std::vector<Command> gripsOf(std::size_t event, const Snapshot& now) const;
    /// What they are told, by the names of both ends.
    std::vector<Command> movesOf(const PhysicalDeformation& deformation, const EndGrips::Moves& moves) const;
    /// That one of them lets go.
    std::vector<Command> releaseOf(const PhysicalDeformation& deformation) const;

    /// To be told of each command that was carried out: what it added has the next number.
    void carriedOut(const Command& command);
    /// The same for commands that are none of the recipe.
    void carriedOutByOthers(const Command& command);

    /// The simulation is at another moment: what has a name has the numbers it has there.
    void goTo(const Moment& moment);

private:
    const Recipe& m_recipe;
    const RecipeScene& m_ready;
    std::map<std::string, ToolId> m_tools;
    std::map<std::string, std::vector<FixtureId>> m_fixtures;
    std::map<std::string, LoadId> m_loads;
    ToolId m_nextTool = 0;
    FixtureId m_nextFixture = 0;
    LoadId m_nextLoad = 0;
};

} // namespace knead
