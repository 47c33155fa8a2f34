// What came off a body moves on its own.
#include "core/simulation/pieces_of_body.h"
#include "support/changed_moment.h"
#include "support/scenes.h"

#include <QTest>

#include <cmath>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;
const Vec3 earth(0, 0, -9.81);

Material damped()
{
    Material material;
    material.youngsModulus = 1e6;
    material.shapeDamping = 200;
    return material;
}

/// Mean over the objects of a body beyond a place along x at rest.
struct Part {
    Vec3 place = Vec3::Zero();
    Vec3 displacement = Vec3::Zero();
};

Part beyond(const Snapshot& shot, double x)
{
    Part part;
    double count = 0;
    for (ObjectIndex i = 0; i < shot.bodies[0].positions.size(); ++i)
        if (shot.bodies[0].aggregate->lattice.position(i).x() > x) {
            part.place += shot.bodies[0].positions[i];
            part.displacement += shot.bodies[0].displacement(i);
            count += 1;
        }
    part.place /= count;
    part.displacement /= count;
    return part;
}

void addIntegrators()
{
    QTest::addColumn<Integrator>("integrator");
    QTest::newRow("explicit") << Integrator::semiImplicitEuler;
    QTest::newRow("implicit") << Integrator::implicitEuler;
}

/// With steps of one length, which a parabola can be compared with.
void use(Integrator integrator, Scene& scene)
{
    scene.integrator = integrator;
    if (integrator == Integrator::implicitEuler)
        scene.timeStep = 1e-3;
}

/// Two boxes side by side along x that are one body.
TriangleMesh twins()
{
    const Vec3 size = spacing * Vec3(4, 4, 4);
    return shapes::together(shapes::moved(shapes::box(size), {Vec3(-8 * spacing, 0, 0), Quaternion::Identity()}),
                            shapes::moved(shapes::box(size), {Vec3(8 * spacing, 0, 0), Quaternion::Identity()}));
}

} // namespace

class PiecesMotionTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsCutOffAHeldBodyFallsFreely_data() { addIntegrators(); }
    void whatIsCutOffAHeldBodyFallsFreely()
    {
        QFETCH(Integrator, integrator);
        // Down is along the bar, so that what falls does not rub on what is held.
        Scene scene = scenes::cantilever({16, 3, 3}, spacing, damped(), Vec3(9.81, 0, 0));
        use(integrator, scene);
        Simulation simulation(scene);
        scenes::cut(simulation, 0, 0, 1e-4);
        QCOMPARE(simulation.components(), std::size_t{2});
        while (simulation.time() < 0.05)
            simulation.step();
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        const double t = shot->time;
        const double h = t / static_cast<double>(shot->step);
        const double fall = 0.5 * 9.81 * t * t;
        // Both schemes are ahead of the parabola by g t h / 2.
        const double ahead = 0.5 * 9.81 * t * h;
        const double fallen = beyond(*shot, 1e-4).displacement.x();
        QVERIFY2(std::abs(fallen - fall) < 1.1 * ahead + 1e-3 * std::abs(fall),
                 qPrintable(QString::number(fallen / fall)));
        // What is still held comes to rest there.
        QVERIFY(shot->bodies[0].displacement(0).norm() < 1e-3 * fall);
    }

    void aPieceFallsPastAnotherThatLies_data() { addIntegrators(); }
    void aPieceFallsPastAnotherThatLies()
    {
        QFETCH(Integrator, integrator);
        Scene scene;
        scene.bodies.push_back(scenes::body(twins(), spacing, damped()));
        scene.gravity = earth;
        use(integrator, scene);
        Manipulator table{.name = "table", .size = {8 * spacing, 8 * spacing, 4 * spacing}};
        table.pose.position = Vec3(-8 * spacing, 0, -4 * spacing);
        scene.manipulators.push_back(table);
        Simulation simulation(scene);
        while (simulation.time() < 0.05)
            simulation.step();
        const auto shot = simulation.snapshot();
        const double t = shot->time;
        const double fall = -0.5 * 9.81 * t * t;
        const double ahead = 0.5 * 9.81 * t * t / static_cast<double>(shot->step);
        const double fallen = beyond(*shot, 0).displacement.z();
        QVERIFY2(std::abs(fallen - fall) < 1.1 * ahead + 1e-3 * std::abs(fall),
                 qPrintable(QString::number(fallen / fall)));
        QVERIFY(beyond(*shot, 0).place.z() < -4 * spacing);
    }

    /// Backward Euler takes from the spin of each; what gives it back must not move their centers.
    void freePiecesKeepMomentaOfTheirOwn()
    {
        Scene scene;
        Material material = damped();
        material.shapeDamping = 0;
        scene.bodies.push_back(scenes::body(twins(), spacing, material));
        scene.bodies[0].angularVelocity = Vec3(0, 30, 0);
        scene.integrator = Integrator::implicitEuler;
        scene.timeStep = 1e-3;
        Simulation simulation(scene);
        const Vec3 start = beyond(*simulation.snapshot(), 0).place;
        const Vec3 velocity = Vec3(0, 30, 0).cross(start);
        for (int step = 0; step < 60; ++step)
            simulation.step();
        const auto shot = simulation.snapshot();
        QVERIFY(shot->health.ok);
        const Vec3 expected = start + shot->time * velocity;
        const Vec3 found = beyond(*shot, 0).place;
        QVERIFY2((found - expected).norm() < 1e-6 * shot->time * velocity.norm(),
                 qPrintable(QString::number((found - expected).norm() / (shot->time * velocity.norm()))));
        // And each still turns as it did, about the axis it had: 30 rad/s for 60 ms.
        const auto& body = shot->bodies[0];
        const Aggregate& aggregate = *body.aggregate;
        const ObjectIndex last = static_cast<ObjectIndex>(aggregate.size() - 1);
        const Vec3 before = aggregate.lattice.position(last) - start;
        const Vec3 after = body.positions[last] - found;
        const double angle = std::atan2(before.z() * after.x() - before.x() * after.z(),
                                        before.x() * after.x() + before.z() * after.z());
        QVERIFY2(std::abs(angle - 30 * shot->time) < 0.05, qPrintable(QString::number(angle)));
    }

    void aSingleObjectThatCameOffKeepsItsVelocity()
    {
        Scene scene;
        scene.bodies.push_back(scenes::box({4, 4, 4}, spacing, damped()));
        Simulation simulation(scene);
        scenes::changeState(simulation, [&](Moment& moment) {
            const Aggregate& aggregate = *scene.bodies[0].aggregate;
            const ObjectIndex last = static_cast<ObjectIndex>(aggregate.size() - 1);
            for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
                for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
                    for (ObjectIndex lower = segment.begin; lower < segment.end; ++lower)
                        if (aggregate.weight[d][lower] > 0 && lower + static_cast<ObjectIndex>(segment.offset) == last)
                            moment.bodies[0].changes.broken.push_back({d, lower});
            const Vec3 thrown(1, 2, 3);
            moment.bodies[0].velocity.set(last, thrown);
            const double mass = scene.bodies[0].material.density * aggregate.volume[last];
            moment.accounts.atStart += 0.5 * mass * thrown.squaredNorm(); // or it would come from nowhere
        });
        QCOMPARE(simulation.components(), std::size_t{2});
        const ObjectIndex last = static_cast<ObjectIndex>(scene.bodies[0].aggregate->size() - 1);
        for (int step = 0; step < 640; ++step)
            simulation.step();
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        const Vec3 way = shot->bodies[0].displacement(last);
        QVERIFY2((way - shot->time * Vec3(1, 2, 3)).norm() < 1e-9 * way.norm(),
                 qPrintable(QString::number(way.norm())));
    }

    void piecesAreFoundOnlyWhenSomethingBreaks()
    {
        Scene scene = scenes::cantilever({8, 2, 2}, spacing, damped(), earth);
        const auto aggregate = scene.bodies[0].aggregate;
        const MaterialMap materials(scene.bodies[0].material, aggregate->size());
        StructuralConnections connections(aggregate, materials);
        const Joints none;
        PiecesOfBody pieces;
        for (int look = 0; look < 10; ++look)
            QCOMPARE(pieces.find(connections, 0, none).count, std::size_t{1});
        QCOMPARE(pieces.searches(), std::size_t{1});

        Joints joints; // of another body, and sticking: neither makes one of two pieces
        joints.add({{.first = {1, 0}, .second = {1, 5}, .healed = true}});
        joints.add({{.first = {0, 0}, .second = {0, 7}}});
        pieces.find(connections, 0, joints);
        QCOMPARE(pieces.searches(), std::size_t{1});

        StructuralConnections::Changes changes;
        const double middle = 1e-4;
        for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
            for (const Lattice::Segment& segment : aggregate->lattice.segments[d])
                for (ObjectIndex lower = segment.begin; lower < segment.end; ++lower) {
                    const ObjectIndex upper = lower + static_cast<ObjectIndex>(segment.offset);
                    if (aggregate->weight[d][lower] > 0 && (aggregate->lattice.position(lower).x() > middle) !=
                                                               (aggregate->lattice.position(upper).x() > middle))
                        changes.broken.push_back({d, lower});
                }
        connections.restore(changes);
        const Pieces expected = findPieces(*aggregate, changes.broken);
        QCOMPARE(expected.count, std::size_t{2});
        QVERIFY(pieces.find(connections, 0, joints).ofObject == expected.ofObject);
        QCOMPARE(pieces.searches(), std::size_t{2});

        joints.add({{.first = {0, 0}, .second = {0, static_cast<ObjectIndex>(aggregate->size() - 1)}, .healed = true}});
        QCOMPARE(pieces.find(connections, 0, joints).count, std::size_t{1});
        QCOMPARE(pieces.find(connections, 0, joints).count, std::size_t{1});
        QCOMPARE(pieces.searches(), std::size_t{3});
    }

    void aBrokenBodyIsNotWeldedByBecomingRigid()
    {
        Scene scene;
        scene.bodies.push_back(scenes::box({8, 3, 3}, spacing, damped()));
        Simulation simulation(scene);
        simulation.post(SetBodyKind{0, BodyKind::rigid});
        simulation.post(SetBodyKind{0, BodyKind::deformable});
        simulation.applyCommands();
        QVERIFY(simulation.snapshot()->notice.empty());
        scenes::cut(simulation, 0, 0, 1e-4);
        const std::uint64_t hash = simulation.stateHash();
        simulation.post(SetBodyKind{0, BodyKind::rigid});
        simulation.applyCommands();
        const auto shot = simulation.snapshot();
        QCOMPARE(shot->bodies[0].kind, BodyKind::deformable);
        QVERIFY2(shot->notice.english().find("broke into 2 pieces") != std::string::npos,
                 shot->notice.english().c_str());
        QVERIFY(simulation.recording().empty());
        QCOMPARE(simulation.stateHash(), hash);
        simulation.post(Reset{});
        simulation.post(SetBodyKind{0, BodyKind::rigid});
        simulation.applyCommands();
        QCOMPARE(simulation.snapshot()->bodies[0].kind, BodyKind::rigid);
    }

    /// As it was filled, a body may be of several pieces, and is meant to be one.
    void aBodyOfSeveralSolidsMayBeRigid()
    {
        Scene scene;
        scene.bodies.push_back(scenes::body(twins(), spacing, damped()));
        Simulation simulation(scene);
        simulation.post(SetBodyKind{0, BodyKind::rigid});
        simulation.applyCommands();
        QCOMPARE(simulation.snapshot()->bodies[0].kind, BodyKind::rigid);
    }
};

QTEST_GUILESS_MAIN(PiecesMotionTest)
#include "pieces_motion_test.moc"
