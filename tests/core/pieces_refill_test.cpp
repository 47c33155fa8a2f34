// Clay that was cut is kneaded on: each piece is filled anew by itself, and what has grown together is one again.
#include "support/thread_limit.h"

#include "core/aggregate/cell_shapes.h"
#include "core/aggregate/fill.h"
#include "core/aggregate/pieces.h"
#include "core/document/moment_bytes.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/simulation/moment.h"
#include "core/skin/former_shape.h"
#include "core/skin/new_filling.h"
#include "core/skin/regrown.h"
#include "core/skin/torn_surface.h"
#include "support/kneaded_clay.h"
#include "support/random_strokes.h"
#include "support/scenes.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace knead;

namespace {

constexpr double spacing = 3e-3; // [m]
const Vec3 size(0.045, 0.036, 0.024);
const Cut cutInTwo{0, Vec3(0.5e-3, 0, 0), Vec3(1, 0, 0.2)};

/// A lump of clay on a table, with a ball over its right half.
/// @param healingTime [s]
Scene lumpOnTable(double healingTime)
{
    Material clay = scenes::modelingClay();
    clay.healingTime = healingTime;
    const TriangleMesh mesh = shapes::box(size);
    Scene scene;
    scene.bodies.push_back(scenes::body(mesh, spacing, clay, "lump"));
    scene.bodies[0].surface = std::make_shared<const TriangleMesh>(mesh);
    scene.gravity = Vec3(0, 0, -9.81);
    scene.floorHeight = -0.5 * size.z();
    scene.floorFriction = 1;
    scene.floorAdhesion = 2e4;
    scene.integrator = Integrator::implicitEuler;
    Manipulator ball{.name = "ball", .size = Vec3::Constant(0.5 * size.z())};
    ball.kind = ToolKind::ball;
    ball.speedLimit = 0.1;
    ball.pose.position = Vec3(0.25 * size.x(), 0, 0.75 * size.z() + 1e-4);
    scene.manipulators.push_back(ball);
    return scene;
}

void run(Simulation& simulation, double duration)
{
    const double end = simulation.time() + duration;
    while (simulation.time() < end && simulation.health().ok)
        simulation.step();
}

void cut(Simulation& simulation)
{
    simulation.post(cutInTwo);
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

std::size_t piecesOf(const Snapshot::BodyState& body)
{
    return findPieces(*body.aggregate, brokenOf(body)).count;
}

CellQuality cellsOf(const Snapshot::BodyState& body)
{
    return CellShapes(*withoutBroken(body.aggregate, brokenOf(body))).quality([&](ObjectIndex object) {
        return body.positions[object];
    });
}

/// The surface as the view shows it, all pieces in one.
TriangleMesh skinOf(const Snapshot::BodyState& body)
{
    const TriangleMesh opened = refine(shapes::box(size), 1e-3, 100'000);
    auto torn = tornSurface(*body.aggregate, opened, brokenOf(body));
    if (!torn)
        return {};
    TriangleMesh mesh = std::move(torn->mesh);
    torn->skin.evaluate(body.displacements(), mesh.vertices);
    return mesh;
}

} // namespace

class PiecesRefillTest : public QObject {
    Q_OBJECT

private slots:
    void eachPieceIsKneadedByItself()
    {
        Simulation simulation(lumpOnTable(1000));
        cut(simulation);
        QCOMPARE(piecesOf(simulation.snapshot()->bodies[0]), std::size_t{2});
        for (const double x : {0.25, -0.25})
            dentAt(simulation, x * size.x());
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        QVERIFY2(shot->notice.empty(), shot->notice.english().c_str());
        QVERIFY(shot->refills >= 4);
        const Snapshot::BodyState& body = shot->bodies[0];
        QVERIFY(body.aggregate->former->isInPieces());
        QCOMPARE(piecesOf(body), std::size_t{2});
        QCOMPARE(cellsOf(body).inverted, std::size_t{0});
        QVERIFY(cellsOf(body).largestStretch < 3);
        const TriangleMesh skin = skinOf(body);
        QVERIFY(isWatertight(skin));
        const double grown = massProperties(skin).volume / size.prod() - 1;
        QVERIFY2(std::abs(grown) < 2e-3, qPrintable(QString::number(grown)));
        QVERIFY2(shot->energy.imbalanceShare() < 0.02, qPrintable(QString::number(shot->energy.imbalanceShare())));
    }

    /// Nothing is seen of it: places, forces and energies stay as they are.
    void fillingPiecesThatRestMovesNothing()
    {
        Simulation simulation(lumpOnTable(1000));
        cut(simulation);
        run(simulation, 0.2);
        const TriangleMesh before = skinOf(simulation.snapshot()->bodies[0]);
        for (int n = 0; n < 3; ++n) {
            simulation.post(Refill{0, n == 1 ? 0.8 * spacing : 0});
            run(simulation, 0.1);
        }
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        QCOMPARE(shot->refills, std::uint64_t{3});
        QCOMPARE(piecesOf(shot->bodies[0]), std::size_t{2});
        QVERIFY(cellsOf(shot->bodies[0]).largestStretch < 1.05);
        const TriangleMesh after = skinOf(shot->bodies[0]);
        QVERIFY(std::abs(massProperties(after).volume / massProperties(before).volume - 1) < 2e-4);
        const Box from = massProperties(before).box;
        const Box to = massProperties(after).box;
        QVERIFY((from.min() - to.min()).norm() < 0.02 * spacing);
        QVERIFY((from.max() - to.max()).norm() < 0.02 * spacing);
    }

    /// One piece flies, the other rests: each keeps its momenta.
    void eachPieceKeepsItsMomenta()
    {
        Scene scene = lumpOnTable(1000);
        scene.gravity = Vec3::Zero();
        scene.floorHeight.reset();
        scene.manipulators.clear();
        Simulation simulation(scene);
        cut(simulation);
        const Snapshot::BodyState& parted = simulation.snapshot()->bodies[0];
        const Pieces pieces = findPieces(*parted.aggregate, *parted.broken);
        const Vec3 speed(0.05, 0, 0);
        {
            Moment moment = *simulation.keepMoment();
            for (ObjectIndex i = 0; i < pieces.ofObject.size(); ++i)
                moment.bodies[0].velocity.set(i, pieces.ofObject[i] == 0 ? Vec3(-speed) : Vec3::Zero());
            simulation.goTo(std::make_shared<const Moment>(std::move(moment)));
        }
        simulation.post(Refill{0, 0});
        simulation.applyCommands();
        const Moment moment = *simulation.keepMoment();
        const Aggregate& filled = *moment.bodies[0].refilled;
        const Pieces now = findPieces(filled);
        QCOMPARE(now.count, std::size_t{2});
        for (ObjectIndex i = 0; i < filled.size(); ++i) {
            const Vec3 wanted = now.ofObject[i] == 0 ? Vec3(-speed) : Vec3::Zero();
            QVERIFY((moment.bodies[0].velocity.at(i) - wanted).norm() < 1e-6);
        }
    }

    void whatHasGrownTogetherWhereItWasCutIsOneAgain()
    {
        Simulation simulation(lumpOnTable(0.5));
        cut(simulation);
        simulation.post(Refill{0, 0});
        simulation.step();
        QVERIFY(simulation.snapshot()->bodies[0].aggregate->former->isInPieces());
        run(simulation, 1.5);
        QCOMPARE(simulation.components(), std::size_t{1});
        simulation.post(Refill{0, 0});
        simulation.step();
        auto shot = simulation.snapshot();
        QVERIFY2(shot->notice.empty(), shot->notice.english().c_str());
        QVERIFY(!shot->bodies[0].aggregate->former->isInPieces());
        QCOMPARE(piecesOf(shot->bodies[0]), std::size_t{1});
        QCOMPARE(shot->joints, std::size_t{0}); // connections have taken their place
        dentAt(simulation, 0);
        shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        QCOMPARE(cellsOf(shot->bodies[0]).inverted, std::size_t{0});
        const Snapshot::BodyState& whole = shot->bodies[0];
        const SkinMap map(*whole.aggregate, whole.displacements());
        const double grown =
            massProperties(carriedMesh(shapes::box(size), map, 1e-3, 100'000)).volume / size.prod() - 1;
        QVERIFY2(std::abs(grown) < 2e-3, qPrintable(QString::number(grown)));
    }

    /// A piece that was filled anew is cut again.
    void aPieceIsCutAgain()
    {
        Simulation simulation(lumpOnTable(1000));
        cut(simulation);
        dentAt(simulation, 0.25 * size.x());
        QVERIFY(simulation.snapshot()->bodies[0].aggregate->former->isInPieces());
        simulation.post(Cut{0, Vec3(-0.25 * size.x(), 0, 0), Vec3(1, 0, 0)});
        simulation.step();
        QVERIFY2(simulation.snapshot()->notice.empty(), simulation.snapshot()->notice.english().c_str());
        QCOMPARE(piecesOf(simulation.snapshot()->bodies[0]), std::size_t{3});
        const TriangleMesh before = skinOf(simulation.snapshot()->bodies[0]);
        QVERIFY(isWatertight(before));
        simulation.post(Refill{0, 0});
        simulation.step();
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->notice.empty(), shot->notice.english().c_str());
        QCOMPARE(findPieces(*shot->bodies[0].aggregate).count, std::size_t{3});
        const TriangleMesh after = skinOf(shot->bodies[0]);
        QVERIFY(isWatertight(after));
        for (const TriangleMesh* mesh : {&before, &after}) {
            const double grown = massProperties(*mesh).volume / size.prod() - 1;
            QVERIFY2(std::abs(grown) < 2e-3, qPrintable(QString::number(grown)));
        }
    }

    /// Only what has grown together where it was parted, and most of it, makes pieces one again.
    void piecesThatHoldOnToEachOtherStayPieces()
    {
        const Body lump = scenes::body(shapes::box(size), spacing, scenes::modelingClay(), "lump");
        const Aggregate& aggregate = *lump.aggregate;
        const auto isRight = [&](ObjectIndex object) { return aggregate.lattice.position(object).x() > 0.1e-3; };
        std::vector<BrokenConnection> broken;
        std::vector<GrownTogether> pairs;
        std::vector<GrownTogether> within;
        for (std::uint32_t d = 0; d < Lattice::directionCount; ++d)
            for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
                for (ObjectIndex lower = segment.begin; lower < segment.end; ++lower) {
                    const ObjectIndex upper = lower + static_cast<ObjectIndex>(segment.offset);
                    if (!(aggregate.weight[d][lower] > 0))
                        continue;
                    if (isRight(lower) == isRight(upper)) {
                        within.emplace_back(lower, upper);
                        continue;
                    }
                    broken.push_back({{d, lower}, 0.5});
                    pairs.emplace_back(lower, upper);
                }
        QCOMPARE(findPieces(aggregate, broken).count, std::size_t{2});
        std::vector<Vec3> displacements(aggregate.size(), Vec3::Zero());
        const auto kept = [&](const std::vector<GrownTogether>& some) {
            return regrown(aggregate, displacements, broken, some).size();
        };
        QCOMPARE(kept(pairs), pairs.size());
        const std::vector<GrownTogether> few(pairs.begin(),
                                             pairs.begin() + static_cast<std::ptrdiff_t>(pairs.size() / 10));
        QCOMPARE(kept(few), std::size_t{0});
        QCOMPARE(kept(within), within.size());
        for (ObjectIndex i = 0; i < displacements.size(); ++i)
            if (isRight(i))
                displacements[i].y() = 5 * spacing; // as if it had been moved along the cut
        QCOMPARE(kept(pairs), std::size_t{0});
        QCOMPARE(kept(within), within.size());
    }

    /// The hand cuts and kneads what there is, whatever comes of it.
    void aLumpIsCutAndKneadedAtRandom()
    {
        constexpr double coarse = 4e-3;
        Scene scene = lumpOnTable(1);
        scene.manipulators.clear();
        scene.bodies[0].aggregate = std::make_shared<const Aggregate>(fill(shapes::box(size), {.spacing = coarse}));
        Simulation simulation(scene);
        scenes::RandomStrokes hand(simulation, 7);
        fuzz::Random random(8);
        const auto within = [&](double low, double high) {
            return low + (high - low) * static_cast<double>(random.below(1 << 20)) / (1 << 20);
        };
        for (int n = 0; n < 6; ++n) {
            if (n % 3 == 0) {
                const auto shot = simulation.snapshot();
                Box box;
                for (const Vec3& place : shot->bodies[0].positions)
                    box.extend(place);
                const Vec3 at = box.center() + Vec3(within(-0.2, 0.2), within(-0.2, 0.2), 0).cwiseProduct(box.sizes());
                simulation.post(Cut{0, at, Vec3(within(-1, 1), within(-1, 1), within(-0.5, 0.5))});
                simulation.step();
            }
            QVERIFY2(hand.stroke(), simulation.health().message.english().c_str());
        }
        const auto shot = simulation.snapshot();
        QVERIFY(shot->refills > 3);
        const Snapshot::BodyState& body = shot->bodies[0];
        QVERIFY(findPieces(*body.aggregate).count > 1);
        QCOMPARE(cellsOf(body).inverted, std::size_t{0});
        QVERIFY2(std::abs(body.aggregate->filledVolume / size.prod() - 1) < 5e-3,
                 qPrintable(QString::number(body.aggregate->filledVolume / size.prod() - 1)));
    }

    void momentsKeepThePiecesAndGoOnToTheSameBits()
    {
        const Scene scene = lumpOnTable(1000);
        Simulation simulation(scene);
        cut(simulation);
        simulation.post(Refill{0, 0});
        run(simulation, 0.1);
        const Bytes bytes = momentToBytes(*simulation.keepMoment());
        Simulation other(scene);
        other.goTo(std::make_shared<const Moment>(momentFromBytes(bytes, scene.bodies)));
        QVERIFY(other.snapshot()->bodies[0].aggregate->former->isInPieces());
        QVERIFY(momentToBytes(*other.keepMoment()) == bytes);
        simulation.goTo(simulation.keepMoment()); // both without what is found out again
        for (Simulation* each : {&simulation, &other}) {
            each->post(Refill{0, 0});
            run(*each, 0.1);
        }
        QVERIFY(momentToBytes(*simulation.keepMoment()) == momentToBytes(*other.keepMoment()));
    }

    void anyNumberOfThreadsGivesTheSameBits()
    {
        const auto after = [](int threads) {
            return onThreads(threads, [] {
                Simulation simulation(lumpOnTable(1000));
                cut(simulation);
                for (int n = 0; n < 2; ++n) {
                    simulation.post(Refill{0, 0});
                    simulation.step();
                }
                return momentToBytes(*simulation.keepMoment());
            });
        };
        QVERIFY(after(1) == after(2));
    }
};

QTEST_MAIN(PiecesRefillTest)
#include "pieces_refill_test.moc"
