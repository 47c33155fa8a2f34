#pragma once

#include "core/session/recipe_events.h"
#include "core/simulation/simulation.h"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace knead {

/// How far the events of a recipe were carried out in a simulation, each before the step at which it is due.
class RecipeProgress {
public:
    /// Where it is in the recipe.
    struct Mark {
        std::size_t nextEvent = 0;
        bool isRepeated = false; ///< somebody else's Reset came before: what events add may be there already
        std::vector<std::pair<std::size_t, EndGrips>> onTheWay = {}; ///< of deformations by physics, by their events
    };

    /// @param recipe and ready outlive this
    RecipeProgress(const Recipe& recipe, const RecipeScene& ready);

    /// Carries out what is due before the next step, in the order of the recipe.
    /// @param refused called after each command that makes no sense and changed nothing; the snapshot says why
    void carryOutDue(Simulation& simulation, const std::function<void()>& refused = {});

    /// The end counts from the last time that the run begins again.
    bool isDone(const Simulation& simulation) const;

    const Mark& mark() const { return m_mark; }
    /// Grips have not yet come to the end of their way.
    bool isOnTheWay(const Simulation& simulation) const;

    /// Somebody else's command was carried out. After a Reset the recipe begins again; what it had added is there still.
    void noteOther(const Command& command);

    /// The simulation is at another moment.
    /// @param mark what mark() was there; none: the next event is found by the time of the moment
    void goTo(const Moment& moment, const std::optional<Mark>& mark);

private:
    bool isDue(const RecipeEvent& event, const Simulation& simulation) const;
    bool isThere(const RecipeAction& action, Simulation& simulation) const;
    void begin(std::size_t event, Simulation& simulation, const std::function<void()>* refused);
    void moveGrips(Simulation& simulation, const std::function<void()>& refused);
    void carryOut(Command command, Simulation& simulation, const std::function<void()>& refused);

    const Recipe& m_recipe;
    EventCommands m_events;
    Mark m_mark;
    std::size_t m_toDo = 0; ///< events before the end counts
};

/// Names and boxes are checked before the first step, not when the event is due.
/// @throws UnusableInput, in a sentence, when an event does not fit the parts
void checkEvents(const Recipe& recipe, const RecipeScene& ready);

} // namespace knead
