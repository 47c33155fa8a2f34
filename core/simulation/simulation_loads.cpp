#include "core/simulation/simulation_loads.h"

#include "core/simulation/simulation_state.h"

#include <algorithm>

namespace knead {

LoadAmount LoadRun::at(double time) const
{
    if (time >= begin + load.ramp)
        return load.amount;
    return between(from, load.amount, std::max(0.0, (time - begin) / load.ramp));
}

void ActingLoads::add(LoadRun run, const Aggregate& aggregate)
{
    LoadForces forces(run.load.patch, aggregate);
    m_acting.emplace_back(Acting{std::move(run), std::move(forces), {}, {}});
}

void ActingLoads::remove(LoadId load)
{
    m_acting[load].reset();
}

void ActingLoads::change(const SetLoad& to, double time)
{
    LoadRun& run = m_acting[to.load]->run;
    run.from = run.at(time);
    run.begin = time;
    run.load.amount = to.amount;
    run.load.ramp = to.ramp;
}

void ActingLoads::begin()
{
    for (auto& acting : m_acting)
        if (acting) {
            acting->run.from = {};
            acting->run.begin = 0;
            acting->last.clear();
            acting->sum = {};
        }
    workAhead = 0;
}

void ActingLoads::restore(const std::vector<std::optional<LoadRun>>& runs, const std::vector<Body>& bodies)
{
    m_acting.clear();
    for (const std::optional<LoadRun>& run : runs) {
        if (run)
            add(*run, *bodies[run->load.body].aggregate);
        else
            m_acting.emplace_back();
    }
    workAhead = 0;
}

bool ActingLoads::empty() const
{
    return std::none_of(m_acting.begin(), m_acting.end(), [](const auto& acting) { return acting.has_value(); });
}

bool ActingLoads::isRising(double time) const
{
    return std::any_of(m_acting.begin(), m_acting.end(),
                       [&](const auto& acting) { return acting && time < acting->run.begin + acting->run.load.ramp; });
}

std::vector<std::optional<LoadRun>> ActingLoads::runs() const
{
    std::vector<std::optional<LoadRun>> runs;
    for (const auto& acting : m_acting)
        runs.push_back(acting ? std::optional(acting->run) : std::nullopt);
    return runs;
}

double ActingLoads::addForces(std::vector<std::unique_ptr<BodyRun>>& bodies, double time)
{
    for (auto& acting : m_acting) {
        if (!acting)
            continue;
        ObjectState& state = bodies[acting->run.load.body]->state;
        acting->last = acting->forces.at(state.position, acting->run.at(time));
        acting->sum = {};
        for (std::size_t i = 0; i < acting->last.size(); ++i) {
            const ObjectIndex object = acting->forces.objects()[i];
            state.force.add(object, acting->last[i]);
            acting->sum.force += acting->last[i];
            acting->sum.moment += (state.position.at(object) - acting->forces.center()).cross(acting->last[i]);
        }
    }
    return power(bodies);
}

double ActingLoads::power(const std::vector<std::unique_ptr<BodyRun>>& bodies) const
{
    double sum = 0;
    for (const auto& acting : m_acting)
        for (std::size_t i = 0; acting && i < acting->last.size(); ++i)
            sum += acting->last[i].dot(bodies[acting->run.load.body]->state.velocity.at(acting->forces.objects()[i]));
    return sum;
}

double Simulation::State::addLoads(double at)
{
    return loads.addForces(runs, at);
}

/// Of an explicit scheme. Work is the mean of the forces at both ends of the way that a step goes, which is what the product of
/// the velocities before and after belongs to: half of it is booked before the step, half after.
void Simulation::State::bookLoadsBefore()
{
    loads.workAhead = 0;
    if (loads.empty())
        return;
    accounts.energy.toolWork += 0.5 * steps.last * addLoads(steps.time);
}

void Simulation::State::bookLoadsAfter()
{
    if (loads.empty())
        return;
    const double share = isImplicit() ? 1 : 0.5;
    const double work = share * steps.length * loads.power(runs);
    accounts.energy.toolWork += work;
    loads.workAhead = isImplicit() ? 0 : work;
}

} // namespace knead
