// Clay that is kneaded until its lattice is no good is filled anew, and goes on.
#include "support/thread_limit.h"

#include "core/aggregate/cell_shapes.h"
#include "core/document/moment_bytes.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "core/simulation/gesture.h"
#include "core/simulation/moment.h"
#include "core/skin/refilled.h"
#include "support/changed_moment.h"
#include "support/fuzz_random.h"
#include "support/kneaded_clay.h"
#include "support/scenes.h"

#include <QTest>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

using namespace knead;

namespace {

constexpr double spacing = 3e-3; // [m]
const Vec3 size(0.045, 0.036, 0.024);

Body lump(const Material& material = scenes::kneadedClay())
{
    const TriangleMesh mesh = shapes::box(size);
    Body body = scenes::body(mesh, spacing, material, "lump");
    body.surface = std::make_shared<const TriangleMesh>(mesh);
    return body;
}

/// A ball of half the thickness above a lump that is held below.
Scene dent(double speed = 0.1)
{
    Scene scene;
    scene.bodies.push_back(lump());
    scene.fixtures.push_back(
        {"foot", 0,
         objectsInBox(*scene.bodies[0].aggregate, Box(Vec3(-1, -1, -1), Vec3(1, 1, -0.5 * size.z() + 0.5 * spacing)))});
    scene.integrator = Integrator::implicitEuler;
    Manipulator ball{.name = "ball", .size = Vec3::Constant(0.5 * size.z())};
    ball.kind = ToolKind::ball;
    ball.speedLimit = speed;
    ball.pose.position = Vec3(0, 0, 0.75 * size.z() + 1e-4);
    scene.manipulators.push_back(ball);
    return scene;
}

const Vec3 barSize(0.048, 0.018, 0.018);
constexpr double rodHeight = 0.018; // [m] when it lies on the bar

/// A rod above one end of a bar that is held below.
Scene smearing()
{
    const TriangleMesh mesh = shapes::box(barSize);
    Scene scene;
    scene.bodies.push_back(scenes::body(mesh, spacing, scenes::kneadedClay(), "bar"));
    scene.bodies[0].surface = std::make_shared<const TriangleMesh>(mesh);
    scene.fixtures.push_back({"foot", 0,
                              objectsInBox(*scene.bodies[0].aggregate,
                                           Box(Vec3(-1, -1, -1), Vec3(1, 1, -0.5 * barSize.z() + 0.5 * spacing)))});
    scene.integrator = Integrator::implicitEuler;
    Manipulator rod{.name = "rod", .size = Vec3(0.018, 0.018, 0.04), .friction = 0.3};
    rod.kind = ToolKind::cylinder;
    rod.speedLimit = 0.05;
    rod.pose.position = Vec3(-0.018, 0, rodHeight + 1e-4);
    rod.pose.rotation = Quaternion(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX()));
    scene.manipulators.push_back(rod);
    return scene;
}

void drive(Simulation& simulation, const Vec3& place)
{
    Pose pose = simulation.snapshot()->tools[0].pose;
    pose.position = place;
    simulation.post(SetManipulatorMotion{0, GoTo{pose}});
    do
        simulation.step();
    while (simulation.health().ok && simulation.time() < 10 &&
           (simulation.snapshot()->tools[0].pose.position - place).norm() > 1e-9);
}

CellQuality cellsOf(const Snapshot& shot)
{
    const Snapshot::BodyState& body = shot.bodies[0];
    return CellShapes(*body.aggregate).quality([&](ObjectIndex object) { return body.positions[object]; });
}

/// Of the opened part's surface, where its material is now [m^3].
double volumeOf(const Snapshot& shot, const Vec3& opened = size)
{
    const SkinMap map(*shot.bodies[0].aggregate, shot.bodies[0].displacements());
    CarriedSurface surface = carriedSurface(shapes::box(opened), map, 0.5 * spacing);
    surface.mesh.vertices = std::move(surface.places);
    return massProperties(surface.mesh).volume;
}

double forceOn(Simulation& simulation)
{
    return simulation.snapshot()->tools[0].force.norm();
}

void steps(Simulation& simulation, int count)
{
    for (int n = 0; n < count; ++n)
        simulation.step();
}

/// Where only so much of the lump is left below the ball.
const Vec3 deep(0, 0, -0.5 * size.z() + 0.004 + 0.25 * size.z());

} // namespace

class RefillTest : public QObject {
    Q_OBJECT

private slots:
    void aCubeThatIsShearedStretchesAndOneThatIsCrushedInACornerIsInsideOut()
    {
        const Body cube = scenes::box({4, 4, 4}, spacing);
        const CellShapes cells(*cube.aggregate);
        QCOMPARE(cells.count(), std::size_t{64});
        const auto place = [&](ObjectIndex object) { return cube.aggregate->lattice.position(object); };
        QVERIFY(std::abs(cells.quality(place).leastCorner - 1) < 1e-12);
        QVERIFY(std::abs(cells.quality(place).largestStretch - 1) < 1e-12);
        const CellQuality sheared = cells.quality([&](ObjectIndex object) {
            const Vec3 at = place(object);
            return Vec3(at.x() + 3 * at.z(), at.y(), at.z());
        });
        QVERIFY(std::abs(sheared.leastCorner - 1) < 1e-9);
        QVERIFY(std::abs(sheared.largestStretch - std::sqrt(10.0)) < 1e-9);
        const CellQuality crushed = cells.quality([&](ObjectIndex object) {
            const Vec3 at = place(object);
            return at.minCoeff() > 1.5 * spacing ? Vec3(-0.4 * at) : at; // one corner of the cube
        });
        QCOMPARE(crushed.inverted, std::size_t{1});
        QVERIFY(crushed.leastCorner < 0);
    }

    void aDeepDentTurnsNoCellInsideOut()
    {
        Simulation simulation(dent());
        drive(simulation, deep);
        auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        QVERIFY(shot->refills >= 2);
        QCOMPARE(cellsOf(*shot).inverted, std::size_t{0});
        QVERIFY(std::abs(volumeOf(*shot) / size.prod() - 1) < 2e-3);
        QVERIFY2(shot->energy.imbalanceShare() < 0.02, qPrintable(QString::number(shot->energy.imbalanceShare())));
        drive(simulation, Vec3(0, 0, size.z()));
        shot = simulation.snapshot();
        QVERIFY(shot->tools[0].force.norm() < 1e-9);
        QVERIFY(std::abs(volumeOf(*shot) / size.prod() - 1) < 2e-3);
        // What it keeps of stress is no more than it bears.
        const Snapshot::BodyState& body = shot->bodies[0];
        const std::vector<Vec3> displacements = body.displacements();
        for (const ObjectStrain& strain : objectStrains(*body.aggregate, displacements, *body.relaxed))
            QVERIFY(vonMisesStress(strain.stress) < 1.2e4);
    }

    void withoutItCellsTurnInsideOut()
    {
        Scene scene = dent();
        scene.refilling = false;
        Simulation simulation(scene);
        drive(simulation, deep);
        const auto shot = simulation.snapshot();
        QCOMPARE(shot->refills, std::uint64_t{0});
        QVERIFY(!shot->health.ok || cellsOf(*shot).inverted > 10);
    }

    void aDraggedBallLeavesAGroove()
    {
        Simulation simulation(dent());
        drive(simulation, Vec3(-0.009, 0, 0.5 * size.z() + 0.25 * size.z() + 1e-4));
        drive(simulation, Vec3(-0.009, 0, 0.5 * size.z()));
        drive(simulation, Vec3(0.009, 0, 0.5 * size.z()));
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        QVERIFY(shot->refills >= 2);
        QCOMPARE(cellsOf(*shot).inverted, std::size_t{0});
        QVERIFY(std::abs(volumeOf(*shot) / size.prod() - 1) < 2e-3);
    }

    /// A rod that does not turn is drawn over a bar: what lay before it is drawn out to many times its length, which the objects that the
    /// bar had at first could not describe. Later fillings carry on.
    void aSkinThatIsDrawnOutFarStaysWhereItIs()
    {
        const Scene scene = smearing();
        Simulation simulation(scene);
        for (const double x : {-0.018, 0.015})
            drive(simulation, Vec3(x, 0, rodHeight - 0.005));
        const auto shot = simulation.snapshot();
        QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
        const auto& former = shot->bodies[0].aggregate->former;
        QVERIFY2(former && former->stages() > 1, qPrintable(QString("%1 fillings").arg(shot->refills)));
        QVERIFY(former->largestStretch() > FormerShape::mostStretch);
        QVERIFY(&firstFillingOf(*shot->bodies[0].aggregate) == scene.bodies[0].aggregate.get());
        QCOMPARE(cellsOf(*shot).inverted, std::size_t{0});
        QVERIFY(std::abs(volumeOf(*shot, barSize) / barSize.prod() - 1) < 2e-3);
        // One filling more leaves the surface where it is.
        std::vector<Vec3> points = refine(shapes::box(barSize), 0.5 * spacing).vertices;
        std::vector<Vec3> before(points.size());
        SkinMap(*shot->bodies[0].aggregate, shot->bodies[0].displacements()).evaluate(points, before);
        simulation.post(Refill{0, 0});
        simulation.applyCommands();
        const auto after = simulation.snapshot();
        std::vector<Vec3> now(points.size());
        SkinMap(*after->bodies[0].aggregate, after->bodies[0].displacements()).evaluate(points, now);
        double farthest = 0;
        for (std::size_t i = 0; i < now.size(); ++i)
            farthest = std::max(farthest, (now[i] - before[i]).norm());
        QVERIFY2(farthest < 0.3 * spacing, qPrintable(QString::number(farthest / spacing)));
        // And so do moments.
        const MomentPointer moment = simulation.keepMoment();
        const Bytes bytes = momentToBytes(*moment);
        const auto read = std::make_shared<const Moment>(momentFromBytes(bytes, scene.bodies));
        QVERIFY(momentToBytes(*read) == bytes);
        Simulation other(scene);
        other.goTo(read);
        steps(other, 3);
        steps(simulation, 3);
        QCOMPARE(other.stateHash(), simulation.stateHash());
    }

    /// Four times as long between its grips, or turned once around.
    void aLimbIsPulledAndTwisted()
    {
        for (const bool turns : {false, true}) {
            const Vec3 limb(0.06, 0.018, 0.018);
            const TriangleMesh mesh = shapes::box(limb);
            Scene scene;
            scene.bodies.push_back(scenes::body(mesh, spacing, scenes::kneadedClay(), "limb"));
            scene.bodies[0].surface = std::make_shared<const TriangleMesh>(mesh);
            const Aggregate& aggregate = *scene.bodies[0].aggregate;
            scene.fixtures.push_back({"foot", 0, objectsInBox(aggregate, Box(Vec3(-1, -1, -1), Vec3(-0.02, 1, 1)))});
            Fixture grip{"grip", 0, objectsInBox(aggregate, Box(Vec3(0.02, -1, -1), Vec3(1, 1, 1)))};
            if (turns)
                grip.turn = {
                    .center = Vec3(0.025, 0, 0), .angularVelocity = Vec3(4, 0, 0), .angle = 2 * std::acos(-1.0)};
            else
                grip.velocity = Vec3(0.06, 0, 0);
            scene.fixtures.push_back(grip);
            scene.integrator = Integrator::implicitEuler;
            Simulation simulation(scene);
            while (simulation.time() < 2 && simulation.health().ok)
                simulation.step();
            const auto shot = simulation.snapshot();
            QVERIFY2(shot->health.ok, shot->health.message.english().c_str());
            QVERIFY(shot->refills > 0);
            QCOMPARE(cellsOf(*shot).inverted, std::size_t{0});
            const double volume = volumeOf(*shot, limb) / limb.prod();
            QVERIFY2(std::abs(volume - 1) < 0.006, qPrintable(QString::number(volume)));
        }
    }

    /// Pressed between plates it bears the same in all its volume: another lattice changes nothing. The first one is cut by the
    /// surface, which flows at 5 % less.
    void evenStressGoesOver()
    {
        Scene scene;
        scene.bodies.push_back(lump());
        scene.bodies[0].material.friction = 0;
        scene.floorHeight = -0.5 * size.z();
        scene.floorFriction = 0;
        scene.integrator = Integrator::implicitEuler;
        Manipulator plate{.name = "plate", .size = Vec3(0.1, 0.1, 0.01), .friction = 0};
        plate.pose.position = Vec3(0, 0, 0.5 * size.z() + 0.005 + 1e-5);
        plate.speedLimit = 0.02;
        scene.manipulators.push_back(plate);
        Simulation simulation(scene);
        drive(simulation, plate.pose.position - Vec3(0, 0, 0.1 * size.z()));
        for (const double most : {0.06, 0.01, 0.01}) {
            steps(simulation, 20);
            const double before = forceOn(simulation);
            QVERIFY(before > 10);
            simulation.post(Refill{0, 0});
            steps(simulation, 1);
            QVERIFY2(simulation.snapshot()->notice.empty(), simulation.snapshot()->notice.english().c_str());
            QVERIFY2(std::abs(forceOn(simulation) / before - 1) < most,
                     qPrintable(QString("%1 of %2").arg(forceOn(simulation)).arg(before)));
        }
        QCOMPARE(simulation.snapshot()->refills, std::uint64_t{3});
    }

    void motionGoesOver()
    {
        Scene scene;
        scene.bodies.push_back(lump());
        scene.bodies[0].velocity = Vec3(0.3, -0.2, 0.1);
        scene.bodies[0].angularVelocity = Vec3(1, 2, -1);
        scene.integrator = Integrator::implicitEuler;
        Simulation simulation(scene);
        steps(simulation, 30);
        const auto before = simulation.snapshot();
        simulation.post(Refill{0, 0});
        simulation.applyCommands();
        const auto after = simulation.snapshot();
        QVERIFY(after->bodies[0].aggregate != before->bodies[0].aggregate);
        QVERIFY((after->momentum - before->momentum).norm() < 1e-3 * before->momentum.norm());
        QVERIFY((after->angularMomentum - before->angularMomentum).norm() < 1e-2 * before->angularMomentum.norm());
        QVERIFY(std::abs(after->energy.kinetic / before->energy.kinetic - 1) < 1e-2);
        QVERIFY(std::abs(after->energy.imbalance - before->energy.imbalance) < 1e-9 * before->energy.turnover);
    }

    void whatIsHeldAndMadeOfSomethingElseStaysSo()
    {
        Scene scene = dent();
        Material stiff = scenes::kneadedClay();
        stiff.yieldStress = 5e4;
        const std::vector<ObjectIndex> left =
            objectsInBox(*scene.bodies[0].aggregate, Box(Vec3(-1, -1, -1), Vec3(-0.2 * size.x(), 1, 1)));
        scene.bodies[0].regions.push_back({"left", left, stiff});
        Simulation simulation(scene);
        const auto first = simulation.snapshot();
        simulation.post(Refill{0, 2e-3});
        simulation.applyCommands();
        const auto shot = simulation.snapshot();
        const Aggregate& filled = *shot->bodies[0].aggregate;
        QCOMPARE(filled.lattice.spacing, 2e-3);
        QVERIFY(objectsInFilling(filled, first->fixtures[0].objects) == shot->fixtures[0].objects);
        for (const ObjectIndex object : shot->fixtures[0].objects)
            QVERIFY(filled.lattice.position(object).z() < -0.5 * size.z() + spacing);
        QVERIFY(shot->fixtures[0].objects.size() > first->fixtures[0].objects.size());
        const MaterialMap& materials = shot->bodies[0].relaxed->materials;
        for (ObjectIndex object = 0; object < filled.size(); ++object)
            if (const double x = filled.lattice.position(object).x() + 0.2 * size.x(); std::abs(x) > spacing)
                QCOMPARE(materials.of(object).yieldStress, x < 0 ? 5e4 : 1e4);
        simulation.post(Reset{});
        simulation.applyCommands();
        const auto reset = simulation.snapshot();
        QVERIFY(reset->bodies[0].aggregate == first->bodies[0].aggregate);
        QVERIFY(reset->bodies[0].positions == first->bodies[0].positions);
        QVERIFY(reset->fixtures[0].objects == first->fixtures[0].objects);
        QVERIFY(reset->bodies[0].relaxed->materials == first->bodies[0].relaxed->materials);
    }

    void whatCannotBeFilledAnewSaysWhy()
    {
        const auto noticeOf = [](Simulation& simulation, const Refill& refill) {
            simulation.post(refill);
            simulation.applyCommands();
            return QString::fromStdString(simulation.snapshot()->notice.english());
        };
        Scene scene;
        scene.bodies.push_back(lump(Material{}));
        scene.bodies.push_back(lump());
        scene.bodies[1].surface = nullptr;
        Simulation simulation(scene);
        QVERIFY(noticeOf(simulation, {0, 0}).contains("is elastic"));
        QVERIFY(noticeOf(simulation, {1, 0}).contains("no surface"));
        QVERIFY(noticeOf(simulation, {2, 0}).contains("no body number 2"));
        QVERIFY(noticeOf(simulation, {1, -1}).contains("more than 0"));
        Scene cracked;
        cracked.bodies.push_back(lump());
        Simulation torn(cracked);
        scenes::cut(torn, 0, 0, 0);
        QVERIFY(noticeOf(torn, {0, 0}).contains("cracks"));
        QCOMPARE(torn.snapshot()->refills, std::uint64_t{0});
    }

    void momentsKeepTheFilling()
    {
        const Scene scene = dent();
        Simulation simulation(scene);
        drive(simulation, 0.5 * (deep + scene.manipulators[0].pose.position));
        QVERIFY(simulation.snapshot()->refills > 0);
        const MomentPointer moment = simulation.keepMoment();
        const Bytes bytes = momentToBytes(*moment);
        drive(simulation, deep);
        const std::uint64_t end = simulation.stateHash();
        Simulation other(scene);
        other.goTo(moment);
        drive(other, deep);
        QCOMPARE(other.stateHash(), end);
        const auto read = std::make_shared<const Moment>(momentFromBytes(bytes, scene.bodies));
        QVERIFY(momentToBytes(*read) == bytes);
        Simulation third(scene);
        third.goTo(read);
        drive(third, deep);
        QCOMPARE(third.stateHash(), end);
        QVERIFY(std::abs(volumeOf(*third.snapshot()) - volumeOf(*simulation.snapshot())) < 1e-15);
        third.goTo(Simulation(scene).keepMoment()); // and back before it
        QVERIFY(third.snapshot()->bodies[0].aggregate == scene.bodies[0].aggregate);
    }

    /// Between the points of a skin that touched it, the rim of a tool reaches into the surface. New points there keep how deep they are, and
    /// the filling stores next to nothing in their springs.
    void aFillingUnderASharpRimIsNoBlow()
    {
        Scene scene = dent();
        Manipulator& rod = scene.manipulators[0];
        rod.kind = ToolKind::cylinder;
        rod.size = Vec3(0.0104, 0.0104, 0.02);
        rod.pose.position = Vec3(-0.006, 0.012, 0.5 * size.z() + 0.0103);
        Simulation simulation(scene);
        Pose goal = rod.pose;
        goal.position += Vec3(0.006, -0.010, -0.012);
        simulation.post(SetManipulatorMotion{0, GoTo{goal}});
        double flowed = 0;
        while (simulation.time() < 0.25) {
            simulation.step();
            const SnapshotPointer now = simulation.snapshot();
            QVERIFY2(now->health.ok, now->health.message.english().c_str());
            QVERIFY2(now->energy.plastic >= flowed - 0.05 * now->energy.toolWork,
                     qPrintable(QString("filling %1: %2 of %3 J")
                                    .arg(now->refills)
                                    .arg(flowed - now->energy.plastic)
                                    .arg(now->energy.toolWork)));
            flowed = now->energy.plastic;
        }
        QVERIFY(simulation.snapshot()->refills >= 2);
        QVERIFY(simulation.snapshot()->energy.imbalanceShare() < 0.01);
        // What it keeps is nothing to wait for.
        const std::uint64_t refills = simulation.snapshot()->refills;
        for (const double finer : {0.95, 1.0}) {
            simulation.post(Refill{0, finer * spacing});
            simulation.applyCommands();
        }
        QVERIFY2(simulation.snapshot()->refills == refills + 2, simulation.snapshot()->notice.english().c_str());
    }

    /// An object of the surface that something squashed does not say how the material around it is strained.
    void aSquashedObjectDoesNotStrainTheNextFilling()
    {
        const Scene scene = dent();
        Simulation simulation(scene);
        steps(simulation, 2);
        Moment moment = *simulation.keepMoment();
        const Aggregate& aggregate = *scene.bodies[0].aggregate;
        const Vec3 top(0, 0, 0.5 * size.z());
        ObjectIndex squashed = 0;
        for (ObjectIndex i = 0; i < aggregate.size(); ++i)
            if ((aggregate.lattice.position(i) - top).norm() < (aggregate.lattice.position(squashed) - top).norm())
                squashed = i;
        moment.bodies[0].position.set(squashed, moment.bodies[0].position.at(squashed) - Vec3(0, 0, 0.7 * spacing));
        simulation.goTo(std::make_shared<const Moment>(moment));
        const double before = simulation.snapshot()->energy.elastic;
        simulation.post(Refill{0, 0});
        simulation.applyCommands();
        QCOMPARE(simulation.snapshot()->refills, std::uint64_t{1});
        const double after = simulation.snapshot()->energy.elastic;
        QVERIFY2(after < 0.5 * before, qPrintable(QString("%1 J from %2 J").arg(after).arg(before)));
    }

    /// They say nothing of what carries a former shape, which is the first filling.
    void momentsOfEarlierVersionsAreRead_data()
    {
        QTest::addColumn<int>("version");
        QTest::newRow("8: one former shape") << 8;
        QTest::newRow("9: none in pieces") << 9;
        QTest::newRow("10: no tools that roll") << 10;
        QTest::newRow("11: nothing of kept volume") << 11;
    }
    void momentsOfEarlierVersionsAreRead()
    {
        QFETCH(int, version);
        const Scene scene = dent();
        Simulation simulation(scene);
        drive(simulation, 0.5 * (deep + scene.manipulators[0].pose.position));
        const MomentPointer moment = simulation.keepMoment();
        QCOMPARE(moment->bodies[0].refilled->former->stages(), 1);
        constexpr std::size_t header = 36; // mark, version, two sizes, checksum
        // Other moments, whose bytes differ first where that is said which there was not.
        const auto firstOther = [&](const std::function<void(Aggregate&, ToolRun&, double& keptVolume)>& change) {
            Moment other = *moment;
            Aggregate filling = *moment->bodies[0].refilled;
            change(filling, *other.tools[0], other.bodies[0].changes.keptVolume);
            other.bodies[0].refilled = std::make_shared<const Aggregate>(std::move(filling));
            const Bytes is = momentToBytes(*moment);
            const Bytes would = momentToBytes(other);
            return std::mismatch(is.begin() + header, is.end(), would.begin() + header).first - is.begin();
        };
        const auto isLater = firstOther([&](Aggregate& filling, ToolRun&, double&) {
            filling.former = std::make_shared<const FormerShape>(moment->bodies[0].refilled,
                                                                 std::vector<Vec3>(filling.size(), Vec3::Zero()));
        });
        const auto parted = firstOther([&](Aggregate& filling, ToolRun&, double&) {
            filling.former =
                std::make_shared<const FormerShape>(filling.former->carriers(), filling.former->displacements(),
                                                    std::vector<BrokenConnection>{{{0, 0}, 0}});
        });
        // From the last to the first, so that places stay.
        std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> missing{
            {firstOther([](Aggregate&, ToolRun&, double& volume) {
                 volume = std::bit_cast<double>(~std::bit_cast<std::uint64_t>(volume)); // all bytes differ
             }),
             8}};
        if (version < 11) {
            missing.emplace_back(firstOther([](Aggregate&, ToolRun& tool, double&) { tool.start.rollsFreely = true; }),
                                 1);
            missing.emplace_back(
                firstOther([](Aggregate&, ToolRun& tool, double&) { tool.manipulator.rollsFreely = true; }), 1);
        }
        if (version < 10)
            missing.emplace_back(parted, sizeof(std::uint32_t));
        if (version < 9)
            missing.emplace_back(isLater, 1);
        std::ranges::sort(missing, std::greater{});
        Bytes old = momentToBytes(*moment);
        for (const auto& [place, count] : missing)
            old.erase(old.begin() + place, old.begin() + place + count);
        const auto put = [&](std::size_t place, std::uint64_t number, std::size_t size) {
            for (std::size_t i = 0; i < size; ++i)
                old[place + i] = static_cast<std::byte>(number >> (8 * i));
        };
        put(8, static_cast<std::uint64_t>(version), 4);
        put(12, old.size() - header, 8);
        put(20, old.size() - header, 8);
        put(28, momentSum(static_cast<std::uint32_t>(version), std::span(old).subspan(header)), 8);
        const Moment read = momentFromBytes(old, scene.bodies);
        Moment wanted = *moment;
        wanted.bodies[0].changes.keptVolume = 0; // which begins anew
        QVERIFY(momentToBytes(read) == momentToBytes(wanted));
    }

    /// Wherever a byte of a filling is another one, the moment is refused, or what it holds can be simulated.
    void damagedFillingsAreRefusedOrCanBeSimulated()
    {
        constexpr std::size_t header = 36; // mark, version, two sizes, checksum
        const Scene scene = dent();
        Simulation simulation(scene);
        drive(simulation, 0.5 * (deep + scene.manipulators[0].pose.position));
        const MomentPointer moment = simulation.keepMoment();
        const Bytes whole = momentToBytes(*moment);
        Moment without = *moment;
        without.bodies[0].refilled = nullptr;
        const std::size_t filling = whole.size() - momentToBytes(without).size();
        fuzz::Random random(7);
        int refused = 0;
        int simulated = 0;
        for (int i = 0; i < 300; ++i) {
            Bytes bytes = whole;
            // Half of them among its first numbers: lattice, sizes, indices.
            const std::size_t range = random.chance(50) ? std::min<std::size_t>(filling, 2000) : filling;
            const std::size_t place = header + 5 + random.below(range);
            bytes[place] ^= static_cast<std::byte>(1U << random.below(8));
            const std::uint64_t sum = momentSum(static_cast<std::uint32_t>(bytes[8]), std::span(bytes).subspan(header));
            for (std::size_t k = 0; k < 8; ++k)
                bytes[header - 8 + k] = static_cast<std::byte>(sum >> (8 * k));
            try {
                auto read = std::make_shared<const Moment>(momentFromBytes(bytes, scene.bodies));
                simulation.goTo(std::move(read));
                simulation.step();
                simulation.snapshot();
                ++simulated;
            } catch (const std::runtime_error&) {
                ++refused;
            }
        }
        QCOMPARE(refused + simulated, 300);
        QVERIFY2(refused > 20 && simulated > 20, qPrintable(QString("%1 refused").arg(refused)));
    }

    void theBitsDoNotDependOnTheThreads()
    {
        const auto hashAtTheEnd = [] {
            Simulation simulation(dent());
            drive(simulation, 0.5 * (deep + Vec3(0, 0, 0.75 * size.z())));
            return std::pair(simulation.stateHash(), simulation.snapshot()->refills);
        };
        const auto one = onThreads(1, hashAtTheEnd);
        QVERIFY(onThreads(4, hashAtTheEnd) == one);
        QVERIFY(one.second > 0);
    }

    /// Forty fillings are as exact as four: the surface stays where it is. How far the farthest place of it goes depends on where the dent
    /// lies between the objects, by four times; so there are three dents.
    void fillingAgainAndAgainChangesNothing()
    {
        double sum = 0;
        const double offsets[] = {-0.3, 0, 0.3}; // [spacings]
        for (const double offset : offsets) {
            Scene scene = dent();
            const Vec3 aside = offset * spacing * Vec3(1, 0.6, 0);
            const Vec3 above = scene.manipulators[0].pose.position + aside;
            scene.manipulators[0].pose.position = above;
            Simulation simulation(scene);
            drive(simulation, 0.5 * (deep + aside + above));
            drive(simulation, above);
            steps(simulation, 10);
            const auto surfaceNow = [&] {
                const auto shot = simulation.snapshot();
                const SkinMap map(*shot->bodies[0].aggregate, shot->bodies[0].displacements());
                return carriedSurface(shapes::box(size), map, 0.5 * spacing);
            };
            const CarriedSurface before = surfaceNow();
            const double volume = volumeOf(*simulation.snapshot());
            for (int n = 0; n < 40; ++n) {
                simulation.post(Refill{0, 0});
                simulation.applyCommands();
            }
            QVERIFY(simulation.snapshot()->refills >= 40);
            const auto shot = simulation.snapshot();
            const SkinMap map(*shot->bodies[0].aggregate, shot->bodies[0].displacements());
            std::vector<Vec3> places(before.places.size());
            map.evaluate(before.mesh.vertices, places);
            double farthest = 0;
            for (std::size_t i = 0; i < places.size(); ++i)
                farthest = std::max(farthest, (places[i] - before.places[i]).norm());
            sum += farthest;
            QVERIFY2(farthest < 0.15 * spacing, qPrintable(QString::number(farthest / spacing)));
            QVERIFY2(std::abs(volumeOf(*shot) / volume - 1) < 5e-4,
                     qPrintable(QString::number(volumeOf(*shot) / volume - 1)));
        }
        const double mean = sum / static_cast<double>(std::size(offsets));
        QVERIFY2(mean < 0.1 * spacing, qPrintable(QString::number(mean / spacing)));
    }
};

QTEST_MAIN(RefillTest)
#include "refill_test.moc"
