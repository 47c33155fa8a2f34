#pragma once

#include "core/simulation/simulation.h"
#include "verify/book.h"

#include <ctime>
#include <functional>

namespace knead::book {

/// A simulation of the book while it runs: keeps the time and the account of energy.
class Experiment {
public:
    explicit Experiment(Scene scene)
        : m_start(std::clock())
        , m_simulation(std::move(scene))
    {
    }

    Simulation& simulation() { return m_simulation; }
    double time() const { return m_simulation.time(); }

    /// Steps until a simulated time [s]. @throws Problem with the sentence of the simulation when it stops
    void runUntil(double time);

    /// Until hardly anything moves and stored energy stays from look to look, or a simulated time [s].
    /// @param look time between two looks: slow motion that is damped away needs some [s]
    void settle(double latest, double look);

    /// Mean force of the material on each tool over a while [s], in order.
    std::vector<Vec3> meanToolForces(double duration);

    /// Counts, time and energy of the run, and the shape of its first body.
    Outcome outcome(std::vector<double> values, const TriangleMesh& mesh);

private:
    void notice(const Snapshot& shot);

    std::clock_t m_start;
    Simulation m_simulation;
    double m_imbalance = 0; ///< largest so far [J]
};

/// Runs a case of any kind and turns an error into Outcome::trouble.
Outcome guarded(std::size_t quantities, const std::function<Outcome()>& run);

/// A tool that goes a way between two times, gently at both ends.
Motion gentleWay(const Pose& from, const Vec3& way, double begin, double end);

/// 0 to 1, with slopes of 0 at both ends.
inline double gentle(double t)
{
    return t <= 0 ? 0 : t >= 1 ? 1 : t * t * (3 - 2 * t);
}

} // namespace knead::book
