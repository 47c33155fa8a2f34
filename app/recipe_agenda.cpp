#include "app/recipe_agenda.h"

#include "app/recipe_progress.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

namespace knead {

namespace {

/// How far a recipe is.
struct Place {
    std::size_t nextEvent = 0;
    bool hasEnded = false;
};

/// How far it was where gestures ended, by the hash of the state there. Any thread.
class Places {
public:
    void keep(std::uint64_t hash, const Place& place)
    {
        const std::lock_guard lock(m_mutex);
        m_places[hash] = place;
    }

    std::optional<Place> at(std::uint64_t hash) const
    {
        const std::lock_guard lock(m_mutex);
        const auto found = m_places.find(hash);
        return found == m_places.end() ? std::nullopt : std::optional(found->second);
    }

private:
    mutable std::mutex m_mutex;
    std::map<std::uint64_t, Place> m_places;
};

class RecipeAgenda final : public Agenda {
public:
    RecipeAgenda(std::shared_ptr<const ReadyRecipe> ready, std::shared_ptr<Places> places)
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
        m_places->keep(gesture.hash, {m_progress.nextEvent(), m_hasEnded});
    }

    void wentTo(const Moment& moment, std::uint64_t hash) override
    {
        const std::optional<Place> place = m_places->at(hash);
        m_progress.goTo(moment, place ? std::optional(place->nextEvent) : std::nullopt);
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

AgendaMaker agendaOf(std::shared_ptr<const ReadyRecipe> ready)
{
    return [ready = std::move(ready), places = std::make_shared<Places>()] {
        return std::make_unique<RecipeAgenda>(ready, places);
    };
}

} // namespace knead
