#pragma once

#include "app/recipe_events.h"
#include "core/simulation/simulation.h"

#include <cstddef>
#include <functional>

namespace knead {

/// How far the events of a recipe were carried out in a simulation, each before the step at which it is due.
class RecipeProgress {
public:
    /// @param recipe and ready outlive this
    RecipeProgress(const Recipe& recipe, const RecipeScene& ready);

    /// Carries out what is due before the next step, in the order of the recipe.
    /// @param refused called after each command that makes no sense and changed nothing; the snapshot says why
    void carryOutDue(Simulation& simulation, const std::function<void()>& refused = {});

    /// The end counts from the last time that the run begins again.
    bool isDone(const Simulation& simulation) const;

    std::size_t nextEvent() const { return m_next; }

    /// Somebody else's command was carried out. After a Reset the recipe begins again; what it had added is there still.
    void noteOther(const Command& command);

    /// The simulation is at another moment.
    /// @param next the event that is next there; none: found by the time of the moment
    void goTo(const Moment& moment, std::optional<std::size_t> next);

private:
    bool isDue(const RecipeEvent& event, const Simulation& simulation) const;
    bool isThere(const RecipeAction& action, Simulation& simulation) const;
    void carryOut(Command command, Simulation& simulation, const std::function<void()>& refused);

    const Recipe& m_recipe;
    EventCommands m_events;
    std::size_t m_next = 0;
    std::size_t m_toDo = 0; ///< events before the end counts
    bool m_isRepeated = false;
};

/// Names and boxes are checked before the first step, not when the event is due.
/// @throws UnusableInput, in a sentence, when an event does not fit the parts
void checkEvents(const Recipe& recipe, const RecipeScene& ready);

} // namespace knead
