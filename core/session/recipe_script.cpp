#include "core/session/recipe_script.h"

#include "core/session/recipe_progress.h"
#include "core/simulation/moment.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

namespace knead {

namespace {

/// How far a recipe is.
struct PlaceInRecipe {
    RecipeProgress::Mark mark;
    bool hasEnded = false;
};

/// What tells moments apart. A rigid body that nothing touches has the same hash at every step; runs before and after a Reset
/// differ in how many tools and fixtures there have been.
using MomentKey = std::tuple<std::uint64_t, std::uint64_t, std::size_t, std::size_t>;

MomentKey keyOf(const Moment& moment, std::uint64_t hash)
{
    return {hash, moment.steps.count, moment.tools.size(), moment.fixtures.size()};
}

/// How far it was where gestures ended. Any thread.
class Places {
public:
    void keep(const MomentKey& moment, const PlaceInRecipe& place)
    {
        const std::lock_guard lock(m_mutex);
        m_places[moment] = place;
    }

    std::optional<PlaceInRecipe> at(const MomentKey& moment) const
    {
        const std::lock_guard lock(m_mutex);
        const auto found = m_places.find(moment);
        return found == m_places.end() ? std::nullopt : std::optional(found->second);
    }

private:
    mutable std::mutex m_mutex;
    std::map<MomentKey, PlaceInRecipe> m_places;
};

class RecipeScript final : public ScriptedEvents {
public:
    RecipeScript(std::shared_ptr<const ReadyRecipe> ready, std::shared_ptr<Places> places)
        : m_ready(std::move(ready))
        , m_places(std::move(places))
        , m_progress(m_ready->recipe, m_ready->scene)
    {
    }

    bool carryOutDue(Simulation& simulation) override
    {
        simulation.applyCommands();
        noteOthers(simulation.recording());
        m_progress.carryOutDue(simulation);
        m_known = simulation.recording().size();
        return !m_hasEnded && (m_hasEnded = m_progress.isDone(simulation));
    }

    void ended(const Gesture& gesture) override
    {
        noteOthers(gesture.commands);
        m_known = 0;
        m_places->keep(keyOf(*gesture.moment, gesture.hash), {m_progress.mark(), m_hasEnded});
    }

    void wentTo(const Moment& moment, std::uint64_t hash) override
    {
        const std::optional<PlaceInRecipe> place = m_places->at(keyOf(moment, hash));
        m_progress.goTo(moment, place ? std::optional(place->mark) : std::nullopt);
        m_hasEnded = place && place->hasEnded;
        m_known = 0;
    }

private:
    /// What a person did since the last look.
    void noteOthers(std::span<const RecordedCommand> recording)
    {
        for (; m_known < recording.size(); ++m_known) {
            m_progress.noteOther(recording[m_known].command);
            m_hasEnded = m_hasEnded && !std::holds_alternative<Reset>(recording[m_known].command);
        }
    }

    std::shared_ptr<const ReadyRecipe> m_ready;
    std::shared_ptr<Places> m_places;
    RecipeProgress m_progress;
    bool m_hasEnded = false;
    std::size_t m_known = 0; ///< of the recording
};

} // namespace

ScriptedEventsMaker scriptOf(std::shared_ptr<const ReadyRecipe> ready)
{
    return [ready = std::move(ready), places = std::make_shared<Places>()] {
        return std::make_unique<RecipeScript>(ready, places);
    };
}

} // namespace knead
