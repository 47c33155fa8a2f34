#include "core/document/moment_check.h"

#include "core/simulation/scene_limits.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace knead {

namespace {

constexpr double farthest = 1e9;      // [m], [m/s]: beyond what any run comes to
constexpr double longestTimeStep = 1; // [s]

bool isWithin(double value, double low, double high)
{
    return value >= low && value <= high;
}

bool isPositive(double value)
{
    return std::isfinite(value) && value > 0;
}

bool isAmount(double value)
{
    return std::isfinite(value) && value >= 0;
}

bool isNear(const Vec3& vector)
{
    return vector.norm() <= farthest;
}

bool areNear(const VectorArray& vectors)
{
    for (std::size_t i = 0; i < vectors.size(); ++i)
        if (!isNear(vectors.at(i)))
            return false;
    return true;
}

template <typename List, typename Holds>
bool all(const List& list, Holds holds)
{
    return std::all_of(std::begin(list), std::end(list), holds);
}

/// Looks at one moment; each function says whether a part of it is as it must be.
class MomentCheck {
public:
    MomentCheck(const Moment& moment, std::span<const Body> bodies)
        : m_moment(moment)
        , m_bodies(bodies)
    {
    }

    Message problem() const
    {
        if (m_moment.bodies.size() != m_bodies.size())
            return Message("History", "it has another number of bodies than the scene");
        for (std::size_t b = 0; b < m_bodies.size(); ++b)
            if (Message found = bodyProblem(m_moment.bodies[b], fillingOf(b)); !found.empty())
                return found;
        if (!all(m_moment.tools, [this](const auto& tool) { return !tool || isTool(*tool); }))
            return Message("History", "a tool cannot be simulated");
        if (!all(m_moment.fixtures, [this](const auto& fixture) { return !fixture || isFixture(*fixture); }) ||
            m_moment.fixtureForces.size() > m_moment.fixtures.size() ||
            !all(m_moment.fixtureForces, [](const Vec3& force) { return force.allFinite(); }))
            return Message("History", "a fixture cannot be simulated");
        if (!all(m_moment.loads, [this](const auto& load) { return !load || isLoad(*load); }))
            return Message("History", "a load cannot be simulated");
        if (!all(m_moment.annealings, [this](const Annealing& annealing) { return isAnnealing(annealing); }))
            return Message("History", "a re-normalization under way is out of range");
        if (!areContacts(m_moment.contacts))
            return Message("History", "a contact or joint is out of range");
        return areNumbers() ? Message() : Message("History", "a number is out of range");
    }

private:
    const Aggregate& fillingOf(std::size_t body) const
    {
        return m_moment.bodies[body].refilled ? *m_moment.bodies[body].refilled : *m_bodies[body].aggregate;
    }

    static Message bodyProblem(const Moment::BodyMoment& body, const Aggregate& aggregate)
    {
        const std::size_t objects = aggregate.size();
        const MaterialMap& map = body.materials;
        if (map.materials().empty() || map.indices().size() != objects ||
            !all(map.indices(), [&](MaterialMap::Index index) { return index < map.materials().size(); }) ||
            !all(map.materials(), [](const Material& material) { return materialProblems(material).empty(); }))
            return Message("History", "a material is out of range");
        if (body.rigid ? !isRigidMotion(body, objects) : !isState(body, objects))
            return Message("History", "objects are not where they can be");
        if (!(body.mass.empty() || (body.mass.size() == objects && all(body.mass, isPositive))))
            return Message("History", "a mass is out of range");
        const std::size_t mode = body.fastestMode.size();
        return areChanges(body.changes, aggregate) && (mode == 0 || mode == 3 * objects)
                   ? Message()
                   : Message("History", "connections are not as they can be");
    }

    static bool isState(const Moment::BodyMoment& body, std::size_t objects)
    {
        return body.position.size() == objects && body.velocity.size() == objects && areNear(body.position) &&
               areNear(body.velocity);
    }

    static bool isRigidMotion(const Moment::BodyMoment& body, std::size_t objects)
    {
        const RigidMotion::Memory& motion = *body.rigid;
        return body.kind == BodyKind::rigid && motion.arms.size() == objects && areNear(motion.arms) &&
               isNear(motion.center) && isNear(motion.velocity) && isNear(motion.angularVelocity) &&
               motion.angularMomentum.allFinite() && std::abs(motion.rotation.norm() - 1) < 1e-6;
    }

    /// C of every object is positive, with its determinant near enough to 1.
    static bool areMetrics(const PlasticState& plastic, std::size_t objects)
    {
        for (const LaneVector<double>& component : plastic.metric)
            if (component.size() != plastic.metric[0].size() ||
                !all(component, [](double entry) { return std::isfinite(entry); }))
                return false;
        if (plastic.metric[0].empty())
            return plastic.equivalentStrain.empty() && plastic.damage.empty();
        const auto isMetric = [&](std::size_t i) {
            const auto& c = plastic.metric;
            const double minor = c[0][i] * c[1][i] - c[3][i] * c[3][i];
            const double determinant = c[2][i] * minor - c[5][i] * (c[0][i] * c[5][i] - c[3][i] * c[4][i]) +
                                       c[4][i] * (c[3][i] * c[5][i] - c[1][i] * c[4][i]);
            return c[0][i] > 0 && minor > 0 && std::abs(determinant - 1) < 0.01;
        };
        for (std::size_t i = 0; i < plastic.metric[0].size(); ++i)
            if (!isMetric(i))
                return false;
        return plastic.metric[0].size() == objects && plastic.equivalentStrain.size() == objects &&
               plastic.damage.size() == objects && all(plastic.equivalentStrain, isAmount) &&
               all(plastic.damage, isAmount);
    }

    static bool areChanges(const StructuralConnections::Changes& changes, const Aggregate& aggregate)
    {
        for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
            const LaneVector<double>& lengths = changes.plastic.nominalLength[d];
            const bool fits = lengths.empty() || lengths.size() == aggregate.weight[d].size();
            if (!fits || !all(lengths, isPositive))
                return false;
        }
        if (!areMetrics(changes.plastic, aggregate.size()))
            return false;
        std::set<ConnectionId> seen;
        const auto canBreak = [&](const BrokenConnection& connection) {
            return connection.cutAt >= 0 && connection.cutAt < 1 && connection.direction < Lattice::directionCount &&
                   connection.lower < aggregate.weight[connection.direction].size() &&
                   aggregate.weight[connection.direction][connection.lower] > 0 && seen.insert(connection).second;
        };
        return (changes.restDilatation.empty() || changes.restDilatation.size() == aggregate.size()) &&
               all(changes.restDilatation, [](double theta) { return std::isfinite(theta); }) &&
               (changes.keptVolume == 0 || std::abs(std::log(changes.keptVolume / aggregate.filledVolume)) < 20) &&
               all(changes.broken, canBreak);
    }

    static bool isTool(const ToolRun& tool)
    {
        return manipulatorProblems(tool.manipulator).empty() && manipulatorProblems(tool.start).empty() &&
               tool.force.allFinite() && tool.meanForce.allFinite() && tool.meanTorque.allFinite() &&
               isAmount(tool.peakForce);
    }

    bool isObject(const ObjectRef& object) const
    {
        return object.body < m_bodies.size() && object.object < fillingOf(object.body).size();
    }

    bool isFixture(const Fixture& fixture) const
    {
        return fixture.body < m_bodies.size() && gripProblem(fixture).empty();
    }

    bool isLoad(const LoadRun& run) const
    {
        return run.load.body < m_bodies.size() && loadProblem(run.load, fillingOf(run.load.body).size()).empty() &&
               amountProblem(run.from, 0).empty() && std::isfinite(run.begin);
    }

    bool isAnnealing(const Annealing& annealing) const
    {
        return annealing.body < m_bodies.size() && m_moment.bodies[annealing.body].kind == BodyKind::deformable &&
               (annealing.marks.empty() || annealing.marks.size() == fillingOf(annealing.body).size()) &&
               isAmount(annealing.rate) && isAmount(annealing.end);
    }

    bool isJoint(const Joint& joint) const
    {
        const auto isNumber = [](double value) { return value >= 0; }; // may be infinite
        return isObject(joint.first) && isObject(joint.second) && joint.first < joint.second &&
               isAmount(joint.nominalLength) && isAmount(joint.stiffness) && isAmount(joint.damping) &&
               isAmount(joint.friction) && isNumber(joint.tolerance) && isNumber(joint.yieldStrain) &&
               isAmount(joint.flowTime) && isNumber(joint.ductility) && isAmount(joint.plasticStrain);
    }

    bool areContacts(const Contacts::Memory& memory) const
    {
        const auto isPair = [this](const Contacts::Memory::Pair& pair) {
            return isObject(pair.first) && isObject(pair.second) && isAmount(pair.value);
        };
        const auto isOutOfOrder = [](const Joint& a, const Joint& b) {
            return std::pair(a.first, a.second) >= std::pair(b.first, b.second);
        };
        const auto isFriction = [](const FrictionMemory& friction) {
            return friction.hold.allFinite() && std::isfinite(friction.pressure) &&
                   (friction.pressure >= 0 || friction.sticks);
        };
        const auto isHeld = [&](const Contacts::Memory::Held& held) {
            return isObject(held.first) && isObject(held.second) && isFriction(held.friction);
        };
        const auto isTouch = [&](const SurfaceContacts::Touch& touch) {
            return touch.body < m_bodies.size() && touch.point < SurfaceContacts::pointCount(fillingOf(touch.body)) &&
                   isFriction(touch.friction) && std::abs(touch.side) <= 1 && isAmount(touch.kept) &&
                   isAmount(touch.pressed);
        };
        const auto isHold = [&](const CuttingEdges::Hold& hold) {
            return hold.surface < m_moment.tools.size() && hold.force.allFinite();
        };
        const auto& joints = memory.joints;
        return all(memory.keptLengths, isPair) && all(memory.pressedTimes, isPair) && all(memory.holds, isHeld) &&
               all(memory.touches, isTouch) && all(memory.edges, isHold) &&
               all(memory.facingSlit, [this](const ObjectRef& object) { return isObject(object); }) &&
               all(joints, [this](const Joint& joint) { return isJoint(joint); }) &&
               std::ranges::adjacent_find(joints, isOutOfOrder) == joints.end() && isAmount(memory.frequency);
    }

    bool areNumbers() const
    {
        const Moment& m = m_moment;
        const EnergyLedger& energy = m.accounts.energy;
        const Surroundings& around = m.around;
        const double ledger[] = {m.contactEnergy, m.addedMass,      m.accounts.atStart, m.accounts.unknown,
                                 energy.viscous,  energy.friction,  energy.plastic,     energy.fracture,
                                 energy.toolWork, energy.numerical, energy.turnover,    m.accounts.placed};
        return all(ledger, [](double value) { return std::isfinite(value); }) &&
               around.gravity.norm() <= strongestGravity &&
               (!around.floorHeight || std::abs(*around.floorHeight) <= farthestFloor) &&
               isWithin(around.floorFriction, 0, 2) && isWithin(around.floorAdhesion, 0, 1e9) &&
               isAmount(m.steps.time) && isPositive(m.steps.length) && m.steps.length <= longestTimeStep &&
               isWithin(m.steps.last, 0, longestTimeStep) && isPositive(m.steps.stable) && isPositive(m.steps.crowding);
    }

    const Moment& m_moment;
    std::span<const Body> m_bodies;
};

} // namespace

Message momentProblem(const Moment& moment, std::span<const Body> bodies)
{
    return MomentCheck(moment, bodies).problem();
}

} // namespace knead
