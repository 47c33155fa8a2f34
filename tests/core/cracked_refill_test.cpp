// Bodies with cracks are filled anew, too, and the cracks stay; clay that is kneaded does not get tired.
#include "support/thread_limit.h"

#include "core/aggregate/cell_shapes.h"
#include "core/aggregate/pieces.h"
#include "core/geometry/mass_properties.h"
#include "core/simulation/moment.h"
#include "core/skin/carried_cracks.h"
#include "core/skin/refilled.h"
#include "support/changed_moment.h"
#include "support/kneaded_clay.h"
#include "support/random_strokes.h"
#include "support/scenes.h"

#include <QTest>

#include <cmath>

using namespace knead;

namespace {

constexpr double spacing = 3e-3; // [m]
const Vec3 size(0.045, 0.036, 0.024);

Body lump(const Material& material, double fineness = spacing)
{
    const TriangleMesh mesh = shapes::box(size);
    Body body = scenes::body(mesh, fineness, material, "lump");
    body.surface = std::make_shared<const TriangleMesh>(mesh);
    return body;
}

/// Connections across the plane x = place where y is above `from`.
std::vector<BrokenConnection> crack(const Aggregate& aggregate, double place, double from, bool isCut)
{
    std::vector<BrokenConnection> broken;
    const Lattice& lattice = aggregate.lattice;
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : lattice.segments[d])
            for (ObjectIndex lower = segment.begin; lower < segment.end; ++lower) {
                if (!(aggregate.weight[d][lower] > 0))
                    continue;
                const Vec3 begin = lattice.position(lower);
                const Vec3 end = lattice.position(lower + static_cast<ObjectIndex>(segment.offset));
                const double at = (place - begin.x()) / (end.x() - begin.x());
                if (at > 0 && at < 1 && (begin + at * (end - begin)).y() > from)
                    broken.push_back({{d, lower}, isCut ? at : 0});
            }
    return broken;
}

double volumeOf(const Snapshot& shot)
{
    const SkinMap map(*shot.bodies[0].aggregate, shot.bodies[0].displacements());
    CarriedSurface surface = carriedSurface(shapes::box(size), map, 0.5 * spacing);
    surface.mesh.vertices = std::move(surface.places);
    return massProperties(surface.mesh).volume;
}

Manipulator ballOver(double x)
{
    Manipulator ball{.name = "ball", .size = Vec3::Constant(0.5 * size.z())};
    ball.kind = ToolKind::ball;
    ball.speedLimit = 0.1;
    ball.pose.position = Vec3(x, 0, 0.75 * size.z() + 1e-4);
    return ball;
}

void run(Simulation& simulation, double duration)
{
    const double end = simulation.time() + duration;
    while (simulation.time() < end && simulation.health().ok)
        simulation.step();
}

/// The ball goes down until 5 mm are left, and up again.
void dentAt(Simulation& simulation, double x)
{
    Pose pose;
    for (const double z : {0.75 * size.z(), -0.5 * size.z() + 0.005 + 0.25 * size.z(), 0.75 * size.z()}) {
        pose.position = Vec3(x, 0, z);
        simulation.post(SetManipulatorMotion{0, GoTo{pose}});
        run(simulation, 0.3);
    }
}

std::vector<BrokenConnection> brokenOf(const Snapshot::BodyState& body)
{
    return body.broken ? *body.broken : std::vector<BrokenConnection>();
}

std::size_t piecesIn(const Snapshot& shot)
{
    return findPieces(*shot.bodies[0].aggregate, brokenOf(shot.bodies[0])).count;
}

auto placesIn(const Snapshot& shot)
{
    return [&shot](ObjectIndex object) { return shot.bodies[0].positions[object]; };
}

/// Those that no crack goes through.
CellShapes cellsOf(const Snapshot::BodyState& body)
{
    return CellShapes(*withoutBroken(body.aggregate, brokenOf(body)));
}

std::size_t brokenIn(const Snapshot& shot)
{
    return shot.bodies[0].broken ? shot.bodies[0].broken->size() : 0;
}

} // namespace

class CrackedRefillTest : public QObject {
    Q_OBJECT

private slots:
    void aCrackIsCarriedToAnyLattice_data()
    {
        QTest::addColumn<double>("fineness");
        QTest::newRow("the same") << 1.0;
        QTest::newRow("finer") << 0.8;
        QTest::newRow("coarser") << 1.3;
    }
    void aCrackIsCarriedToAnyLattice()
    {
        QFETCH(double, fineness);
        const Body whole = lump(scenes::kneadedClay());
        const Aggregate& before = *whole.aggregate;
        // Another lattice: of a surface that was moved by part of a spacing.
        TriangleMesh moved = shapes::box(size);
        for (Vec3& vertex : moved.vertices)
            vertex += Vec3(0.4, 0.3, 0.2) * spacing;
        const Aggregate after = fill(moved, {.spacing = fineness * spacing});
        for (const bool isWhole : {true, false}) {
            const double from = isWhole ? -1 : 0.3 * size.y();
            const auto broken = crack(before, 0.1e-3, from, true);
            const VectorArray nodes = nodesOf(before);
            const auto carried = carriedCracks({before, nodes, broken}, after, nodesOf(after));
            QCOMPARE(findPieces(after, carried).count, std::size_t{isWhole ? 2U : 1U});
            // As many per area.
            const double per =
                static_cast<double>(carried.size()) * fineness * fineness / static_cast<double>(broken.size());
            // Of the part of a width there are few columns.
            QVERIFY2(per > 0.7 && per < (isWhole ? 1.3 : 1.8), qPrintable(QString::number(per)));
            for (const BrokenConnection& connection : carried) {
                const Vec3 begin = after.lattice.position(connection.lower);
                const Vec3 way = after.lattice.direction(static_cast<int>(connection.direction));
                const Vec3 at = begin + connection.cutAt * way;
                QVERIFY(connection.isCut());
                QVERIFY2(std::abs(at.x() - 0.1e-3) < 0.3 * spacing, qPrintable(QString::number(at.x() / spacing)));
            }
        }
    }

    void whatHealedIsOneAgain()
    {
        const Body whole = lump(scenes::kneadedClay());
        const Aggregate& body = *whole.aggregate;
        const auto broken = crack(body, 0.1e-3, -1, false);
        std::vector<GrownTogether> healed;
        for (const BrokenConnection& connection : broken) {
            const Lattice::Node& o = Lattice::directions[connection.direction];
            const Lattice::Node& n = body.lattice.nodes[connection.lower];
            healed.emplace_back(connection.lower, body.lattice.find({n[0] + o[0], n[1] + o[1], n[2] + o[2]}));
        }
        std::sort(healed.begin(), healed.end());
        const VectorArray nodes = nodesOf(body);
        QVERIFY(carriedCracks({body, nodes, broken, healed}, body, nodes).empty());
        QCOMPARE(carriedCracks({body, nodes, broken}, body, nodes).size(), broken.size());
    }

    /// A lump with a slit is dented beside it, until it has been filled anew: the slit is still there.
    void aLumpWithASlitIsKneadedOn()
    {
        Scene scene;
        Material late = scenes::kneadedClay();
        late.healingTime = 1000; // it would heal, but not now
        scene.bodies.push_back(lump(late));
        scene.integrator = Integrator::implicitEuler;
        scene.fixtures.push_back({"foot", 0,
                                  objectsInBox(*scene.bodies[0].aggregate,
                                               Box(Vec3(-1, -1, -1), Vec3(1, 1, -0.5 * size.z() + 0.5 * spacing)))});
        Manipulator ball{.name = "ball", .size = Vec3::Constant(0.5 * size.z())};
        ball.kind = ToolKind::ball;
        ball.speedLimit = 0.1;
        ball.pose.position = Vec3(0.3 * size.x(), 0, 0.75 * size.z() + 1e-4);
        scene.manipulators.push_back(ball);
        Simulation simulation(scene);
        const std::size_t slit = crack(*scene.bodies[0].aggregate, 0.1e-3, 0.25 * size.y(), false).size();
        scenes::changeState(simulation, [&](Moment& moment) {
            moment.bodies[0].changes.broken = crack(*scene.bodies[0].aggregate, 0.1e-3, 0.25 * size.y(), false);
        });
        Pose deep = ball.pose;
        deep.position.z() = -0.5 * size.z() + 0.006 + 0.25 * size.z();
        simulation.post(SetManipulatorMotion{0, GoTo{deep}});
        while (simulation.time() < 0.2 && simulation.health().ok)
            simulation.step();
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        QVERIFY(shot->refills > 0);
        const auto& body = shot->bodies[0];
        const CellQuality cells = cellsOf(body).quality([&](ObjectIndex object) { return body.positions[object]; });
        QCOMPARE(cells.inverted, std::size_t{0});
        QVERIFY(std::abs(volumeOf(*shot) / size.prod() - 1) < 3e-3);
        const double kept = static_cast<double>(brokenIn(*shot)) / static_cast<double>(slit);
        QVERIFY2(kept > 0.6 && kept < 1.5, qPrintable(QString::number(kept)));
        QCOMPARE(findPieces(*body.aggregate, *body.broken).count, std::size_t{1});
        QVERIFY(shot->energy.imbalanceShare() < 0.03);
    }

    /// A lump that was cut in two and lies together is one again as soon as it has healed and been filled.
    void whatWasCutAndHealedIsKneadedOnAsOne()
    {
        Scene scene;
        scene.bodies.push_back(lump(scenes::modelingClay()));
        scene.gravity = Vec3(0, 0, -9.81);
        scene.floorHeight = -0.5 * size.z();
        scene.floorFriction = 1;
        scene.floorAdhesion = 2e4;
        scene.integrator = Integrator::implicitEuler;
        scene.manipulators.push_back(ballOver(0.25 * size.x()));
        Simulation simulation(scene);
        simulation.post(Cut{0, Vec3(0.5e-3, 0, 0), Vec3(1, 0, 0.2)});
        simulation.step();
        QCOMPARE(piecesIn(*simulation.snapshot()), std::size_t{2});
        for (const double x : {0.25, -0.25})
            dentAt(simulation, x * size.x());
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        QVERIFY(
            !std::ranges::equal(shot->bodies[0].aggregate->lattice.nodes, scene.bodies[0].aggregate->lattice.nodes));
        QCOMPARE(cellsOf(shot->bodies[0]).quality(placesIn(*shot)).inverted, std::size_t{0});
        QCOMPARE(piecesIn(*shot), std::size_t{1});
        QVERIFY2(std::abs(volumeOf(*shot) / size.prod() - 1) < 5e-3,
                 qPrintable(QString::number(volumeOf(*shot) / size.prod() - 1)));
    }

    /// Pulled and pressed together again, and sheared to and fro: what heals is as it was, other material is tired.
    void clayIsNotTiredByBeingKneadedToAndFro()
    {
        for (const bool heals : {true, false}) {
            Material material = scenes::kneadedClay();
            material.elongationAtBreak = 0.5;
            material.tensileStrength = 1e6;
            material.healingTime = heals ? 1 : 0;
            Scene scene;
            scene.refilling = false;
            const Vec3 cube = Vec3::Constant(4 * spacing);
            scene.bodies.push_back(scenes::body(shapes::box(cube), spacing, material, "cube"));
            scene.integrator = Integrator::implicitEuler;
            const Aggregate& aggregate = *scene.bodies[0].aggregate;
            const double edge = 0.5 * cube.z() - 0.75 * spacing;
            scene.fixtures.push_back({"below", 0, objectsInBox(aggregate, Box(Vec3(-1, -1, -1), Vec3(1, 1, -edge)))});
            scene.fixtures.push_back({"above", 0, objectsInBox(aggregate, Box(Vec3(-1, -1, edge), Vec3(1, 1, 1)))});
            Simulation simulation(scene);
            for (int n = 0; n < 10; ++n) {
                simulation.post(MoveFixture{1, Vec3(n % 2 == 0 ? 0.03 : -0.03, 0, 0)});
                const double end = simulation.time() + 0.1;
                while (simulation.time() < end && simulation.health().ok)
                    simulation.step();
            }
            QVERIFY(simulation.health().ok);
            const bool isTorn = brokenIn(*simulation.snapshot()) > 0;
            QCOMPARE(isTorn, !heals);
        }
    }

    /// The hand goes on and on.
    void aLumpIsKneadedAtRandom()
    {
        constexpr double coarse = 4e-3;
        Scene scene;
        scene.bodies.push_back(lump(scenes::modelingClay(), coarse));
        scene.gravity = Vec3(0, 0, -9.81);
        scene.floorHeight = -0.5 * size.z();
        scene.floorFriction = 1;
        scene.floorAdhesion = 2e4;
        scene.integrator = Integrator::implicitEuler;
        Simulation simulation(scene);
        scenes::RandomStrokes hand(simulation, 5);
        for (int n = 0; n < 10; ++n)
            QVERIFY2(hand.stroke(), simulation.health().message.english().c_str());
        const auto shot = simulation.snapshot();
        QVERIFY(shot->refills > 3);
        const auto& body = shot->bodies[0];
        const CellQuality cells = cellsOf(body).quality([&](ObjectIndex object) { return body.positions[object]; });
        QCOMPARE(cells.inverted, std::size_t{0});
        QVERIFY2(std::abs(volumeOf(*shot) / size.prod() - 1) < 3e-3,
                 qPrintable(QString::number(volumeOf(*shot) / size.prod() - 1)));
    }
};

QTEST_MAIN(CrackedRefillTest)
#include "cracked_refill_test.moc"
