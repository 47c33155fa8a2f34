// Contacts that are worked out eight at a time are those that the law says one by one.
#include "core/mechanics/contact_batch.h"
#include "core/mechanics/surface_contacts.h"
#include "support/scenes.h"
#include "support/shapes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <vector>

using namespace knead;

namespace {

constexpr double spacing = 1e-3;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A box whose objects fly about, and what is done to them.
struct Lump {
    std::shared_ptr<const Aggregate> aggregate = scenes::box({6, 6, 6}, spacing).aggregate;
    MaterialMap materials{Material{}, aggregate->size()};
    ObjectState state = objectsAtRest(*aggregate);
    StructuralConnections connections{aggregate, materials};
    SurfaceLoad load;
    ContactReport report;
    double crowding = 0;
    std::vector<FrictionMemory> memory;

    Lump()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> value(-1, 1);
        for (std::size_t i = 0; i < state.size(); ++i) {
            state.position.add(i, 0.1 * spacing * Vec3(value(random), value(random), value(random)));
            state.velocity.set(i, Vec3(value(random), value(random), value(random)));
        }
    }
    std::vector<ContactBody> bodies()
    {
        return {{.state = &state, .connections = &connections, .materials = &materials}};
    }
};

/// Points of its skin, some just outside of their cells, and objects themselves; of all kinds of springs.
std::vector<PointSpread> spreadsIn(const Aggregate& aggregate)
{
    std::vector<PointSpread> spreads;
    for (const SkinPoint& point : aggregate.skin)
        for (const double out : {0.0, 0.2})
            if (const auto spread = spreadOf(aggregate.lattice, point.place + out * spacing * point.place.normalized()))
                spreads.push_back(*spread);
    std::stable_sort(spreads.begin(), spreads.end(),
                     [](const PointSpread& a, const PointSpread& b) { return a.objects < b.objects; });
    for (ObjectIndex i = 0; i < aggregate.size(); i += 3)
        spreads.push_back(spreadOf(i));
    return spreads;
}

std::vector<ContactBatch::Point> pointsOf(const std::vector<PointSpread>& spreads, std::vector<FrictionMemory>& memory)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(0, 1);
    memory.resize(spreads.size());
    std::vector<ContactBatch::Point> points;
    for (std::size_t p = 0; p < spreads.size(); ++p) {
        const bool remembers = p % 3 != 0;
        if (remembers)
            memory[p] = {.hold = Vec3(value(random), -value(random), value(random)), .pressure = value(random)};
        points.push_back({.body = 0,
                          .spread = &spreads[p],
                          .reach = 0.2 * spacing * value(random),
                          .parameters = {.stiffness = 1e4 * (1 + value(random)),
                                         .damping = 3 * value(random),
                                         .friction = p % 5 == 0 ? 0 : 0.5 * value(random),
                                         .stiffening = p % 7 == 0 ? infinite : 0.05 * spacing,
                                         .steepest = 0.15 * spacing,
                                         .frictionDelay = p % 4 == 0 ? 0 : 1e-4,
                                         .mass = p % 6 == 0 ? 0 : 1e-6 * value(random),
                                         .largestOverlap = p % 8 == 0 ? 0.1 * spacing : infinite},
                          .friction = &memory[p]});
    }
    return points;
}

/// One after the other, by the law.
void pressAlone(Lump& lump, const std::vector<ContactBatch::Point>& points, const RigidSurface& surface,
                const ContactStep& step)
{
    ContactCrowd crowd;
    const std::vector<ContactBody> bodies = lump.bodies();
    for (const ContactBatch::Point& point : points) {
        const Vec3 place = point.spread->at(lump.state.position);
        const Vec3 rubbed = surface.velocityAt(place);
        const SurfacePoint nearest = surface.nearest(place);
        const Quaternion& turned = surface.isFloor ? Quaternion::Identity() : surface.pose.rotation;
        const ContactResult result = contactForce({.overlap = point.reach - nearest.distance,
                                                   .normal = nearest.normal,
                                                   .relativeVelocity = point.spread->at(lump.state.velocity) - rubbed,
                                                   .memory = {turned * point.friction->hold, point.friction->pressure}},
                                                  point.parameters, step);
        *point.friction = {turned.inverse() * result.memory.hold, result.memory.pressure};
        point.spread->add(result.spring, lump.state.force);
        point.spread->add(result.damping, lump.state.damping);
        const Vec3 force = result.force();
        lump.load.force -= force;
        lump.load.torque -= (place - surface.pose.position).cross(force);
        lump.load.power += force.dot(rubbed);
        lump.report.energy += result.energy;
        lump.report.brakingPower -= result.damping.dot(rubbed);
        lump.report.count += result.energy > 0 ? 1 : 0;
        lump.report.steepness = std::max(lump.report.steepness, result.steepness);
        lump.report.frictions.push_back(
            {.object = {0, 0}, .spread = point.spread, .force = result.friction, .velocity = rubbed});
        if (result.slope > 0)
            crowd.add(bodies[0], 0, *point.spread, result.slope);
    }
    lump.crowding = crowd.take(bodies);
}

double rubbingPower(const Lump& lump)
{
    double power = 0;
    for (const ContactFriction& friction : lump.report.frictions) {
        const Vec3 velocity = friction.spread != nullptr ? friction.spread->at(lump.state.velocity)
                                                         : lump.state.velocity.at(friction.object.object);
        power += friction.force.dot(velocity - friction.velocity);
    }
    return power;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) <= 1e-11 * std::max(std::abs(a), std::abs(b));
}
bool isNear(const Vec3& a, const Vec3& b)
{
    return (a - b).norm() <= 1e-11 * std::max(a.norm(), b.norm());
}

RigidSurface surfaceLike(const QString& form)
{
    RigidSurface surface;
    surface.friction = 0.5;
    surface.velocity = Vec3(0.1, -0.2, 0.3);
    surface.angularVelocity = Vec3(20, -30, 40);
    surface.shape.size = Vec3(4, 4, 5) * spacing;
    surface.pose = {Vec3(0.3, -0.2, 3.5) * spacing, Quaternion(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()))};
    if (form == "floor") {
        surface = RigidSurface{.isFloor = true, .friction = 0.5};
        surface.pose.position.z() = -2 * spacing;
    } else if (form == "ball") {
        surface.shape.kind = ToolKind::ball;
    } else if (form == "cylinder") {
        surface.shape.kind = ToolKind::cylinder;
    } else if (form == "wedge") {
        surface.shape.kind = ToolKind::wedge;
    } else if (form == "plate") {
        surface.shape.kind = ToolKind::plate;
    } else if (form == "part") {
        surface.shape.kind = ToolKind::part;
        surface.shape.part = std::make_shared<const ToolPart>(shapes::sphere(2 * spacing, 16));
    }
    return surface;
}

bool sameBits(const Lump& a, const Lump& b)
{
    const auto sameMemory = [](const FrictionMemory& one, const FrictionMemory& other) {
        return std::memcmp(one.hold.data(), other.hold.data(), sizeof(Vec3)) == 0 && one.pressure == other.pressure;
    };
    return a.state.force.hasSameBits(b.state.force) && a.state.damping.hasSameBits(b.state.damping) &&
           a.load.force == b.load.force && a.load.torque == b.load.torque && a.load.power == b.load.power &&
           a.report.energy == b.report.energy && a.report.brakingPower == b.report.brakingPower &&
           a.report.count == b.report.count && a.report.steepness == b.report.steepness && a.crowding == b.crowding &&
           std::equal(a.memory.begin(), a.memory.end(), b.memory.begin(), b.memory.end(), sameMemory);
}

/// For some steps. @param keeps which points are listed
template <typename Keeps>
Lump pressed(const RigidSurface& surface, const kernels::Kernels& run, const Keeps& keeps)
{
    Lump lump;
    const std::vector<PointSpread> spreads = spreadsIn(*lump.aggregate);
    const std::vector<ContactBatch::Point> all = pointsOf(spreads, lump.memory);
    std::vector<ContactBatch::Point> listed;
    for (const ContactBatch::Point& point : all)
        if (keeps(point, lump))
            listed.push_back(point);
    const std::vector<ContactBody> bodies = lump.bodies();
    ContactBatch batch(bodies, listed, run);
    ContactCrowd crowd;
    const PlacedSurface placed(surface);
    for (const double duration : {1e-5, 1e-5, 2e-5})
        batch.press(bodies, placed, {.duration = duration}, crowd, lump.load, lump.report);
    batch.writeBack();
    lump.crowding = crowd.take(bodies);
    return lump;
}

} // namespace

class ContactBatchTest : public QObject {
    Q_OBJECT

    static void addForms()
    {
        QTest::addColumn<QString>("form");
        for (const char* form : {"floor", "box", "plate", "ball", "cylinder", "wedge", "part"})
            QTest::newRow(form) << form;
    }

private slots:
    void whatComesOutIsTheLawOfEachPoint_data() { addForms(); }
    void whatComesOutIsTheLawOfEachPoint()
    {
        QFETCH(const QString, form);
        const RigidSurface surface = surfaceLike(form);
        Lump together;
        Lump alone;
        const std::vector<PointSpread> spreads = spreadsIn(*together.aggregate);
        QVERIFY(spreads.size() > 600); // several blocks, the last of them not whole
        const std::vector<ContactBatch::Point> points = pointsOf(spreads, together.memory);
        const std::vector<ContactBatch::Point> same = pointsOf(spreads, alone.memory);
        const std::vector<ContactBody> bodies = together.bodies();
        ContactBatch batch(bodies, points);
        ContactCrowd crowd;
        for (const double duration : {1e-5, 1e-5, 2e-5}) {
            const ContactStep step{.duration = duration};
            batch.press(bodies, PlacedSurface(surface), step, crowd, together.load, together.report);
            pressAlone(alone, same, surface, step);
        }
        batch.writeBack();

        QVERIFY(alone.report.count > 100 && alone.report.count < 3 * points.size());
        QCOMPARE(together.report.count, alone.report.count);
        double largest = 0;
        for (std::size_t i = 0; i < alone.state.size(); ++i)
            largest = std::max({largest, alone.state.force.at(i).norm(), alone.state.damping.at(i).norm()});
        for (std::size_t i = 0; i < alone.state.size(); ++i) {
            QVERIFY((together.state.force.at(i) - alone.state.force.at(i)).norm() < 1e-11 * largest);
            QVERIFY((together.state.damping.at(i) - alone.state.damping.at(i)).norm() < 1e-11 * largest);
        }
        QVERIFY(isNear(together.load.force, alone.load.force));
        QVERIFY(isNear(together.load.torque, alone.load.torque));
        QVERIFY(isNear(together.load.power, alone.load.power));
        QVERIFY(isNear(together.report.energy, alone.report.energy));
        QVERIFY(isNear(together.report.brakingPower, alone.report.brakingPower));
        QVERIFY(isNear(together.report.steepness, alone.report.steepness));
        QVERIFY(isNear(rubbingPower(together), rubbingPower(alone)));
        QVERIFY(std::abs(rubbingPower(alone)) > 0);
        for (std::size_t p = 0; p < points.size(); ++p) {
            QVERIFY(std::abs(together.memory[p].pressure - alone.memory[p].pressure) < 1e-11 * largest);
            QVERIFY((together.memory[p].hold - alone.memory[p].hold).norm() < 1e-11 * largest);
        }
    }

    void crowdsAreThoseOfEachPoint()
    {
        const RigidSurface surface = surfaceLike("ball");
        Lump together;
        Lump alone;
        const std::vector<PointSpread> spreads = spreadsIn(*together.aggregate);
        const std::vector<ContactBatch::Point> points = pointsOf(spreads, together.memory);
        const std::vector<ContactBatch::Point> same = pointsOf(spreads, alone.memory);
        const std::vector<ContactBody> bodies = together.bodies();
        ContactCrowd crowd;
        ContactBatch(bodies, points)
            .press(bodies, PlacedSurface(surface), {.duration = 1e-5}, crowd, together.load, together.report);
        pressAlone(alone, same, surface, {.duration = 1e-5});
        QVERIFY(alone.crowding > 0);
        QVERIFY(isNear(crowd.take(bodies), alone.crowding));
    }

    void noInstructionSetChangesBits_data() { addForms(); }
    void noInstructionSetChangesBits()
    {
        QFETCH(const QString, form);
        const RigidSurface surface = surfaceLike(form);
        const auto all = [](const ContactBatch::Point&, const Lump&) { return true; };
        const Lump first = pressed(surface, kernels::available().front(), all);
        for (const kernels::Kernels& run : kernels::available())
            QVERIFY2(sameBits(first, pressed(surface, run, all)), run.name);
    }

    /// So that a run that goes on from a moment, whose lists are other ones, stays the same.
    void whatElseIsListedChangesNoBits()
    {
        const RigidSurface surface = surfaceLike("ball");
        const auto all = [](const ContactBatch::Point&, const Lump&) { return true; };
        const auto touches = [&](const ContactBatch::Point& point, const Lump& lump) {
            const Vec3 place = point.spread->at(lump.state.position);
            return point.reach - surface.nearest(place).distance > 0 || point.friction->pressure > 0;
        };
        QVERIFY(sameBits(pressed(surface, kernels::best(), all), pressed(surface, kernels::best(), touches)));
    }

    /// Also of many points that one object carries, and of what adds up to nothing.
    void oppositeWeightsTouchToo()
    {
        Lump lump;
        lump.state = objectsAtRest(*lump.aggregate);
        std::vector<PointSpread> spreads(300, spreadOf(0));
        for (std::size_t p = 0; p < spreads.size(); ++p) {
            spreads[p].objects[1] = 1;
            spreads[p].count = 2;
            spreads[p].weights[1] = p % 2 == 0 ? 0.25 : -0.25;
            spreads[p].weights[0] = 1 - spreads[p].weights[1];
        }
        std::vector<FrictionMemory> memory(spreads.size());
        std::vector<ContactBatch::Point> points;
        for (std::size_t p = 0; p < spreads.size(); ++p)
            points.push_back({.body = 0,
                              .spread = &spreads[p],
                              .parameters = {.stiffness = 1, .damping = 1},
                              .friction = &memory[p]});
        RigidSurface floor{.isFloor = true};
        floor.pose.position.z() = lump.state.position.at(0).z() + spacing;
        lump.state.velocity.set(1, Vec3(0, 0, -1));
        const std::vector<ContactBody> bodies = lump.bodies();
        ContactBatch batch(bodies, points);
        ContactCrowd crowd;
        batch.press(bodies, PlacedSurface(floor), {.duration = 1e-5}, crowd, lump.load, lump.report);
        const Vec3 force = lump.state.force.at(1) + lump.state.damping.at(1);
        QVERIFY(lump.state.force.at(1).norm() < 1e-12 && force.norm() > 0);
        // What one step leaves is not there in the next.
        lump.state.force.setZero();
        lump.state.damping.setZero();
        batch.press(bodies, PlacedSurface(floor), {.duration = 1e-5}, crowd, lump.load, lump.report);
        QVERIFY(isNear(lump.state.force.at(1) + lump.state.damping.at(1), force));
    }

    /// Lists that are made anew in every step, and another friction in between, change nothing of it.
    void whatFrictionRemembersOutlivesLists()
    {
        struct Slide {
            Lump lump;
            SurfaceContacts contacts;
            RigidSurface floor{.isFloor = true, .friction = 0.5};

            Slide()
                : contacts(lump.bodies())
            {
                lump.state = objectsAtRest(*lump.aggregate);
                lump.state.mass.assign(lump.state.size(), 1e-6);
                contacts.updateParameters(lump.bodies(), 1e4, false);
                floor.pose.position.z() = -2.98 * spacing;
                list();
            }
            void list() { contacts.list(lump.bodies(), std::span(&floor, 1), 0.5 * spacing); }
            void step()
            {
                lump.state.force.setZero();
                lump.state.damping.setZero();
                for (std::size_t i = 0; i < lump.state.size(); ++i) {
                    lump.state.velocity.set(i, Vec3(0.1, 0.05, 0));
                    lump.state.position.add(i, Vec3(1e-6, 0.5e-6, 0));
                }
                ContactCrowd crowd;
                ContactReport report;
                report.loads.resize(1);
                contacts.computeForces(lump.bodies(), std::span(&floor, 1), {.duration = 1e-5}, crowd, report);
            }
        };
        Slide once;
        Slide often;
        Vec3 last = Vec3::Zero();
        for (int n = 0; n < 12; ++n) {
            for (Slide* slide : {&once, &often}) {
                slide->floor.friction = n < 6 ? 0.5 : 0.4;
                slide->step();
            }
            often.list();
            QVERIFY(once.lump.state.damping.hasSameBits(often.lump.state.damping));
            Vec3 sum = Vec3::Zero();
            for (std::size_t i = 0; i < once.lump.state.size(); ++i)
                sum += once.lump.state.damping.at(i);
            QVERIFY2(n == 0 || sum.norm() > 1.01 * last.norm(), qPrintable(QString::number(n))); // it holds ever more
            last = sum;
        }
        const auto remembered = once.contacts.memory();
        QVERIFY(remembered.size() > 20);
        QVERIFY(std::all_of(remembered.begin(), remembered.end(),
                            [](const SurfaceContacts::Touch& touch) { return !touch.friction.isEmpty(); }));
    }
};

QTEST_APPLESS_MAIN(ContactBatchTest)
#include "contact_batch_test.moc"
