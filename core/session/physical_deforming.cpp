#include "core/session/physical_deforming.h"

#include "core/deformation/number_words.h"
#include "core/message/message.h"

#include <algorithm>
#include <utility>

namespace knead {

namespace {

constexpr double longestRest = 3;   // after their way [s]
constexpr double wayShare = 0.9;    // of the progress
constexpr double stillSpeed = 1e-2; // spacings per second: nobody sees that

/// Between two frames.
bool isStill(const Snapshot& before, const Snapshot& now)
{
    for (std::size_t b = 0; b < now.bodies.size(); ++b) {
        const std::vector<Vec3>& places = now.bodies[b].positions;
        if (places.size() != before.bodies[b].positions.size())
            return false;
        const double most = stillSpeed * now.bodies[b].aggregate->lattice.spacing * (now.time - before.time);
        for (std::size_t i = 0; i < places.size(); ++i)
            if ((places[i] - before.bodies[b].positions[i]).norm() > most)
                return false;
    }
    return true;
}

/// With a name that no fixture has: "bend", "bend 2".
PhysicalDeformation withFreeName(PhysicalDeformation deformation, const Snapshot& now)
{
    const std::string stem =
        deformation.name.empty() ? std::string(wordsOf(deformation.numbers.kind).word) : deformation.name;
    const auto isTaken = [&](NumberEnd end) {
        return std::ranges::any_of(
            now.fixtures, [&](const Fixture& fixture) { return fixture.name == nameOfGrip(deformation, end); });
    };
    deformation.name = stem;
    for (int number = 2; isTaken(NumberEnd::first) || isTaken(NumberEnd::second); ++number)
        deformation.name = stem + " " + std::to_string(number);
    return deformation;
}

/// A simulation whose grips go their way.
class Deforming {
public:
    Deforming(Simulation simulation, const PhysicalDeformation& deformation, std::size_t filmMemory)
        : m_simulation(std::move(simulation))
        , m_deformation(deformation)
        , m_grips(deformation, m_simulation.time())
        , m_now(m_simulation.snapshot())
        , m_begin(m_simulation.time())
    {
        m_film.setMemory(filmMemory);
    }

    void hold(const std::vector<HeldEnds>& held)
    {
        if (m_now->pace == Pace::rough || m_now->pace == Pace::wide)
            m_simulation.post(SetPace{Pace::full});
        FixtureId id = m_now->nextFixture;
        for (Command& command : addedGrips(m_deformation, held)) {
            const bool isFirst =
                std::get<AddFixture>(command).fixture.name == nameOfGrip(m_deformation, NumberEnd::first);
            m_ids[isFirst ? 0 : 1].push_back(id++);
            m_simulation.post(std::move(command));
        }
    }

    void goTheWay(TaskControl& control)
    {
        for (; !m_grips.isOver(); step(control)) {
            const double step = m_simulation.timeStep();
            const EndGrips::Moves moves =
                m_grips.follow(m_simulation.time(), step, std::max(EndGrips::leastHorizon, step));
            for (std::size_t end = 0; end < moves.size(); ++end)
                for (const FixtureId id : m_ids[end])
                    if (moves[end])
                        m_simulation.post(MoveFixture{id, moves[end]->velocity, moves[end]->turn});
            if (m_grips.isOver())
                break;
        }
    }

    void letGo()
    {
        if (!m_deformation.letsGo)
            return;
        for (const FixtureId id : m_ids[freedEnd(m_deformation.numbers) == NumberEnd::first ? 0 : 1])
            m_simulation.post(RemoveFixture{id});
    }

    void rest(TaskControl& control)
    {
        const double end = m_simulation.time() + longestRest;
        for (SnapshotPointer before = m_now; m_simulation.time() < end;) {
            step(control);
            if (m_now == before)
                continue;
            if (isStill(*before, *m_now))
                return;
            before = m_now;
        }
    }

    DeformedByPhysics finished() &&
    {
        m_simulation.applyCommands();
        m_film.add(*m_simulation.snapshot());
        return {endGesture(m_simulation), std::move(m_film)};
    }

private:
    void step(TaskControl& control)
    {
        control.throwIfCancelled();
        m_simulation.step();
        if (!m_simulation.health().ok)
            throw Problem(m_simulation.health().message);
        if (m_simulation.time() < m_now->time + PlaybackCache::interval)
            return;
        m_now = m_simulation.snapshot();
        m_film.see(m_now);
        const double done = (m_simulation.time() - m_begin) / m_deformation.duration;
        control.report(wayShare * std::min(1.0, done), "moving the grips");
    }

    Simulation m_simulation;
    PhysicalDeformation m_deformation;
    EndGrips m_grips;
    std::array<std::vector<FixtureId>, 2> m_ids; ///< of the grips of each end
    SnapshotPointer m_now;                       ///< the last frame
    PlaybackCache m_film;
    double m_begin;
};

} // namespace

DeformedByPhysics deformByPhysics(Simulation simulation, const PhysicalDeformation& deformation,
                                  const std::vector<std::string>& names, const std::vector<bool>& which,
                                  std::size_t filmMemory, TaskControl& control)
{
    simulation.applyCommands();
    const SnapshotPointer now = simulation.snapshot();
    const std::vector<HeldEnds> held = heldEnds(deformation, *now, names, which);
    Deforming run(std::move(simulation), withFreeName(deformation, *now), filmMemory);
    run.hold(held);
    run.goTheWay(control);
    run.letGo();
    run.rest(control);
    return std::move(run).finished();
}

} // namespace knead
