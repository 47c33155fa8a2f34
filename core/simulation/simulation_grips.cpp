// Grips that turn, and what grips feel.
#include "core/simulation/scene_limits.h"
#include "core/simulation/simulation_state.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double fastestTurn = 1e4; // [rad/s]

Mat3 rotation(const Vec3& angularVelocity, double angle)
{
    return Eigen::AngleAxisd(angle, angularVelocity.normalized()).toRotationMatrix();
}

} // namespace

Message gripProblem(const Fixture& fixture)
{
    if (!(fixture.velocity.norm() <= fastestFixture))
        return Message("Fixture", "A fixture must not move faster than 100 m/s.");
    if (!(fixture.turn.angularVelocity.norm() <= fastestTurn) || !fixture.turn.center.allFinite() ||
        !(fixture.turn.angle > 0))
        return Message("Fixture",
                       "Fixture \"%1\" must turn about a place, by more than 0, and no faster than 10000 rad/s.")
            .with(fixture.name);
    return {};
}

/// Of two grips on one object the later one moves it.
bool Simulation::State::isMovedBy(FixtureId fixture, ObjectIndex object) const
{
    return runs[grips.fixtures[fixture]->body]->gripOf[object] == fixture;
}

double Grips::turnInStep(FixtureId id, double duration) const
{
    const GripTurn& turn = fixtures[id]->turn;
    return std::clamp(turn.angle - progress[id].angle, 0.0, turn.angularVelocity.norm() * duration);
}

/// Objects go along chords whose ends lie on circles: v = V + (R r - r) / h.
void Simulation::State::turnGrips()
{
    for (FixtureId id = 0; id < grips.fixtures.size(); ++id) {
        if (!grips.turns(id))
            continue;
        const Fixture& fixture = *grips.fixtures[id];
        BodyRun& run = *runs[fixture.body];
        if (!run.deforms())
            continue;
        const Mat3 turned = rotation(fixture.turn.angularVelocity, grips.turnInStep(id, steps.length));
        const Vec3 center = fixture.turn.center + grips.progress[id].way;
        for (const ObjectIndex object : fixture.objects) {
            if (object >= run.state.size() || !isMovedBy(id, object))
                continue;
            const Vec3 arm = run.state.position.at(object) - center;
            const Vec3 velocity = fixture.velocity + (turned * arm - arm) / steps.length;
            if (grips.progress[id].angle == 0) // the grip sets it going
                accounts.energy.toolWork += 0.5 * run.state.mass[object] *
                                            (velocity.squaredNorm() - run.state.velocity.at(object).squaredNorm());
            run.state.velocity.set(object, velocity);
        }
    }
}

void Grips::endTurns(double duration)
{
    for (FixtureId id = 0; id < fixtures.size(); ++id) {
        if (!turns(id))
            continue;
        progress[id].angle += turnInStep(id, duration);
        progress[id].way += duration * fixtures[id]->velocity;
    }
}

/// The next step finds the velocities of what turns anew; a moment has those that going to it makes.
void Simulation::State::forgetTurns(Moment& moment) const
{
    for (FixtureId id = 0; id < grips.fixtures.size(); ++id) {
        if (!grips.turns(id))
            continue;
        VectorArray& velocity = moment.bodies[grips.fixtures[id]->body].velocity;
        for (const ObjectIndex object : grips.fixtures[id]->objects)
            if (object < velocity.size() && isMovedBy(id, object))
                velocity.set(object, grips.fixtures[id]->velocity);
    }
}

/// Acceleration of an object that goes around evenly, from chord to chord: (R - 2 + R^-1) r / h^2, r at the start of the step.
Vec3 Simulation::State::centripetal(FixtureId fixture, const Vec3& place) const
{
    const GripTurn& turn = grips.fixtures[fixture]->turn;
    if (!turn.turns() || !runs[grips.fixtures[fixture]->body]->deforms())
        return Vec3::Zero();
    const double angle = grips.turnInStep(fixture, steps.length);
    if (angle < turn.angularVelocity.norm() * steps.length)
        return Vec3::Zero(); // the last step
    const Mat3 turned = rotation(turn.angularVelocity, angle);
    Vec3 arm = place - turn.center - grips.progress[fixture].way;
    if (isImplicit()) // the place is the one at the end
        arm = turned.transpose() * (arm - steps.length * grips.fixtures[fixture]->velocity);
    return (turned * arm - 2 * arm + turned.transpose() * arm) / (steps.length * steps.length);
}

void Grips::findCenters(const std::vector<Body>& bodies)
{
    centers.assign(fixtures.size(), Vec3::Zero());
    for (FixtureId id = 0; id < fixtures.size(); ++id) {
        if (!fixtures[id])
            continue;
        const Lattice& lattice = bodies[fixtures[id]->body].aggregate->lattice;
        std::size_t count = 0;
        for (const ObjectIndex object : fixtures[id]->objects)
            if (object < lattice.size()) {
                centers[id] += lattice.position(object);
                ++count;
            }
        centers[id] /= static_cast<double>(std::max<std::size_t>(1, count));
    }
}

} // namespace knead
