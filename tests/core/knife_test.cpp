// Knives, wires and planes cut material, at the force that its toughness gives.
#include "support/thread_limit.h"

#include "core/aggregate/pieces.h"
#include "core/document/moment_bytes.h"
#include "core/geometry/mass_properties.h"
#include "core/mechanics/blade.h"
#include "core/simulation/moment.h"
#include "core/skin/fragments.h"
#include "core/skin/torn_surface.h"
#include "support/scenes.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace knead;

namespace {

constexpr double spacing = 2.5e-3; // [m]
const Vec3 size(0.04, 0.015, 0.015);
constexpr double speed = 0.05; // [m/s]

Material gel(double toughness)
{
    Material material{.density = 1000, .youngsModulus = 2e5, .poissonRatio = 0.4, .dampingRatio = 0.1};
    material.shapeDamping = 20;
    material.friction = 0.5;
    material.toughness = toughness;
    return material;
}

Material clay(double toughness)
{
    Material material{.density = 1700, .youngsModulus = 5e5, .poissonRatio = 0.45, .dampingRatio = 0.2};
    material.shapeDamping = 20;
    material.friction = 0.5;
    material.yieldStress = 1e4;
    material.relaxationTime = 0.002;
    material.toughness = toughness;
    return material;
}

/// A bar on a floor, and a knife or a wire above it that goes down through it without friction.
/// @param turn of the edge about the vertical; 90 degrees cuts straight across
Scene cutting(const Material& material, double turn = 90, bool isWire = false, double offset = 0.4e-3)
{
    Scene scene;
    scene.bodies.push_back(scenes::body(shapes::box(size), spacing, material, "bar"));
    scene.floorHeight = -0.5 * size.z();
    scene.floorFriction = 1;
    scene.integrator = Integrator::implicitEuler;
    Manipulator knife{.name = "knife", .size = Vec3(0.05, 1e-3, 0.02)};
    knife.kind = ToolKind::wedge;
    knife.pose.rotation = Quaternion(Eigen::AngleAxisd(turn * std::numbers::pi / 180, Vec3::UnitZ()));
    double edge = 0.5 * knife.size.z();
    if (isWire) {
        knife.kind = ToolKind::cylinder;
        knife.size = Vec3(0.5e-3, 0.5e-3, 0.05);
        knife.pose.rotation =
            knife.pose.rotation * Quaternion(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()));
        edge = 0;
    }
    knife.friction = 0;
    knife.speedLimit = speed;
    knife.pose.position = Vec3(offset, 0, 0.5 * size.z() + edge + 1e-3);
    Pose end = knife.pose;
    end.position.z() = -0.5 * size.z() + edge - 4e-4;
    knife.motion = GoTo{end};
    scene.manipulators.push_back(knife);
    return scene;
}

double depthOf(const Snapshot& shot)
{
    const ToolState& tool = shot.tools[0];
    const double edge = tool.kind == ToolKind::wedge ? 0.5 * tool.size.z() : 0;
    return 0.5 * size.z() - (tool.pose.position.z() - edge);
}

/// Mean force on the tool while its edge goes through the middle half of the bar [N].
double meanForce(Simulation& simulation)
{
    double sum = 0;
    int count = 0;
    while (simulation.health().ok && simulation.time() < 2 && depthOf(*simulation.snapshot()) < size.z() + 3.9e-4) {
        simulation.step();
        const SnapshotPointer shot = simulation.snapshot();
        if (const double depth = depthOf(*shot); depth > 0.25 * size.z() && depth < 0.75 * size.z()) {
            sum += shot->tools[0].force.z();
            ++count;
        }
    }
    return sum / count;
}

std::vector<std::size_t> sizesOfPieces(const Snapshot& shot)
{
    const Snapshot::BodyState& body = shot.bodies[0];
    const Pieces pieces =
        findPieces(*body.aggregate, body.broken ? std::span(*body.broken) : std::span<const BrokenConnection>());
    std::vector<std::size_t> sizes(pieces.count, 0);
    for (const std::uint32_t piece : pieces.ofObject)
        ++sizes[piece];
    return sizes;
}

} // namespace

class KnifeTest : public QObject {
    Q_OBJECT

private slots:
    void edgesBelowFortyFiveDegreesAndThinCylindersCut()
    {
        const auto wedge = [](double back, double height) {
            return ToolShape{.kind = ToolKind::wedge, .size = Vec3(0.04, back, height), .part = nullptr};
        };
        const double tangent = 2 * std::tan(std::numbers::pi / 8); // of a wedge of 45 degrees: back by height
        QVERIFY(bladeOf(wedge(0.99 * tangent * 0.03, 0.03)));
        QVERIFY(!bladeOf(wedge(1.01 * tangent * 0.03, 0.03)));
        const auto blade = bladeOf(wedge(0.002, 0.03));
        QCOMPARE(blade->length(), 0.04);
        QCOMPARE(blade->from.z(), -0.015);
        QCOMPARE(blade->height, 0.03);
        QVERIFY(!blade->isWire());
        const auto wire = bladeOf({.kind = ToolKind::cylinder, .size = Vec3(0.001, 0.001, 0.05), .part = nullptr});
        QVERIFY(wire && wire->isWire());
        QCOMPARE(wire->length(), 0.05);
        QVERIFY(!bladeOf({.kind = ToolKind::cylinder, .size = Vec3(0.01, 0.01, 0.05), .part = nullptr}));
        QVERIFY(!bladeOf({.kind = ToolKind::plate, .size = Vec3(0.05, 0.05, 0.001), .part = nullptr}));
    }

    void flanksAreSeenFromTheirSideAlone()
    {
        const ToolShape wedge{.kind = ToolKind::wedge, .size = Vec3(0.04, 0.002, 0.03), .part = nullptr};
        const auto right = flankOf(wedge, 1, Vec3(0, 0.001, 0.015));
        QVERIFY(right && !right->isAhead && std::abs(right->plane.distance) < 1e-12);
        const auto left = flankOf(wedge, -1, Vec3(0, 0.001, 0.015));
        QVERIFY(left && left->plane.distance < -0.0019);
        QVERIFY(flankOf(wedge, 1, Vec3(0, 0.001, -0.016))->isAhead);
        QVERIFY(!flankOf(wedge, 1, Vec3(0.021, 0, 0)));
        QVERIFY(!flankOf(wedge, 1, Vec3(0, 0, 0.016)));
    }

    void aBarIsCutInTwoAtTheForceOfItsToughness_data()
    {
        QTest::addColumn<bool>("yields");
        QTest::addColumn<double>("turn");
        QTest::addColumn<bool>("isWire");
        QTest::addColumn<bool>("isImplicit");
        QTest::addColumn<double>("offset");
        QTest::newRow("gel, across") << false << 90.0 << false << true << 0.4e-3;
        QTest::newRow("gel, across, explicit") << false << 90.0 << false << false << 0.4e-3;
        QTest::newRow("gel, between objects") << false << 90.0 << false << true << 1.25e-3;
        QTest::newRow("gel, through a layer of objects") << false << 90.0 << false << true << 0.0;
        QTest::newRow("gel, 60 degrees") << false << 60.0 << false << true << 0.4e-3;
        QTest::newRow("gel, 45 degrees") << false << 45.0 << false << true << 0.4e-3;
        QTest::newRow("gel, wire") << false << 90.0 << true << true << 0.4e-3;
        QTest::newRow("gel, wire, 60 degrees") << false << 60.0 << true << true << 0.4e-3;
        QTest::newRow("clay, across") << true << 90.0 << false << true << 0.4e-3;
        QTest::newRow("clay, 60 degrees") << true << 60.0 << false << true << 0.4e-3;
    }
    void aBarIsCutInTwoAtTheForceOfItsToughness()
    {
        QFETCH(bool, yields);
        QFETCH(double, turn);
        QFETCH(bool, isWire);
        QFETCH(bool, isImplicit);
        QFETCH(double, offset);
        constexpr double toughness = 50;
        Scene scene = cutting(yields ? clay(toughness) : gel(toughness), turn, isWire, offset);
        if (!isImplicit)
            scene.integrator = Integrator::semiImplicitEuler;
        Simulation simulation(scene);
        const double force = meanForce(simulation);
        QVERIFY2(simulation.health().ok, simulation.health().message.english().c_str());
        const SnapshotPointer shot = simulation.snapshot();
        const double width = size.y() / std::sin(turn * std::numbers::pi / 180);
        const double expected = toughness * width;
        QVERIFY2(std::abs(force / expected - 1) < 0.2, qPrintable(QString::number(force / expected)));
        const std::vector<std::size_t> sizes = sizesOfPieces(*shot);
        QCOMPARE(sizes.size(), std::size_t{2});
        QVERIFY(sizes[0] > 100 && sizes[1] > 100);
        QCOMPARE(simulation.components(), std::size_t{2});
        const EnergyLedger& energy = shot->energy;
        QVERIFY2(std::abs(energy.imbalance) < 5e-3 * energy.toolWork,
                 qPrintable(QString::number(energy.imbalance / energy.toolWork)));
        QVERIFY(energy.fracture > 0.7 * expected * size.z());
        QVERIFY(energy.fracture < 1.2 * energy.toolWork);
    }

    void aToolThatMayNotPushAsHardStandsStill()
    {
        Scene scene = cutting(gel(50));
        scene.manipulators[0].forceLimit = 0.5 * 50 * size.y();
        Simulation simulation(scene);
        while (simulation.time() < 0.6)
            simulation.step();
        QVERIFY(depthOf(*simulation.snapshot()) < 0.3 * size.z());
        QCOMPARE(simulation.components(), std::size_t{1});
    }

    void aKnifeThatGoesSlowlyInShortStepsCutsToo()
    {
        for (const bool isWire : {false, true}) {
            Scene scene = cutting(gel(50), 90, isWire);
            scene.integrator = Integrator::semiImplicitEuler;
            scene.manipulators[0].speedLimit = 2e-3;
            scene.manipulators[0].pose.position.z() -= 0.9e-3;
            Simulation simulation(scene);
            while (simulation.health().ok && depthOf(*simulation.snapshot()) < 0.5e-3)
                for (int n = 0; n < 100; ++n)
                    simulation.step();
            QVERIFY(simulation.timeStep() * 2e-3 < 1e-4 * spacing);
            QVERIFY(simulation.snapshot()->broken > 3);
        }
    }

    void materialWithoutToughnessIsNotCut()
    {
        Simulation simulation(cutting(gel(0)));
        while (simulation.time() < 0.2)
            simulation.step();
        QCOMPARE(simulation.snapshot()->broken, std::size_t{0});
    }

    void whatIsCutDoesNotHoldAgain()
    {
        Scene scene = cutting(gel(50));
        Simulation simulation(scene);
        const double first = meanForce(simulation);
        const Pose down = simulation.snapshot()->tools[0].pose;
        Pose up = down;
        up.position.z() += size.z() + 2e-3;
        simulation.post(SetManipulatorMotion{0, GoTo{up}});
        while (depthOf(*simulation.snapshot()) > -1e-3)
            simulation.step();
        simulation.post(SetManipulatorMotion{0, GoTo{down}});
        simulation.step();
        const double second = meanForce(simulation);
        QVERIFY2(second < 0.25 * first, qPrintable(QString::number(second / first)));
        QCOMPARE(simulation.components(), std::size_t{2});
    }

    void aCutIsRepeatedAndGoneBackToToTheBit()
    {
        const Scene scene = cutting(clay(50));
        const auto half = [](Simulation& simulation) {
            while (depthOf(*simulation.snapshot()) < 0.5 * size.z())
                simulation.step();
        };
        Simulation once(scene);
        half(once);
        const MomentPointer moment = once.keepMoment();
        QVERIFY(!moment->contacts.edges.empty());
        QVERIFY(std::ranges::any_of(moment->bodies[0].changes.broken, &BrokenConnection::isCut));
        const Moment read = momentFromBytes(momentToBytes(*moment), scene.bodies);
        meanForce(once);
        Simulation again(scene);
        again.goTo(std::make_shared<const Moment>(read));
        meanForce(again);
        QCOMPARE(again.stateHash(), once.stateHash());
        const auto hash = onThreads(1, [&] {
            Simulation alone(scene);
            half(alone);
            alone.keepMoment();
            meanForce(alone);
            return alone.stateHash();
        });
        QCOMPARE(hash, once.stateHash());
    }

    void sidesOfACutDoNotHealOverTheKnife()
    {
        Material material = clay(50);
        material.healingTime = 0.05;
        material.adhesion = 500;
        Simulation simulation(cutting(material));
        meanForce(simulation);
        for (int n = 0; n < 30; ++n)
            simulation.step();
        QCOMPARE(simulation.snapshot()->joints, std::size_t{0});
        QCOMPARE(simulation.components(), std::size_t{2});
    }

    void aPlaneCutsWithoutForce()
    {
        Scene scene;
        scene.bodies.push_back(scenes::body(shapes::box(size), spacing, gel(0), "bar"));
        Simulation simulation(scene);
        const Vec3 normal(1, 0.3, 0.2);
        simulation.post(Cut{.body = 0, .point = Vec3(0.003, 0, 0), .normal = normal});
        simulation.step();
        QVERIFY2(simulation.snapshot()->notice.empty(), simulation.snapshot()->notice.english().c_str());
        QCOMPARE(simulation.components(), std::size_t{2});
        const SnapshotPointer shot = simulation.snapshot();
        for (const BrokenConnection& cut : *shot->bodies[0].broken)
            QVERIFY(cut.isCut());
        // Surfaces of the pieces: closed, and flat where they were cut.
        const TriangleMesh skin = shapes::box(size);
        const std::vector<Fragment> fragments = fragmentsOf(*shot->bodies[0].aggregate, skin, *shot->bodies[0].broken);
        QCOMPARE(fragments.size(), std::size_t{2});
        double volume = 0;
        for (const Fragment& fragment : fragments) {
            QVERIFY(isWatertight(fragment.mesh));
            volume += fragment.volume;
            for (std::size_t t = 0; t < fragment.mesh.triangles.size(); ++t)
                if (fragment.mesh.faceOfTriangle[t] == Fragment::crackFace)
                    for (const std::uint32_t corner : fragment.mesh.triangles[t]) {
                        const double off =
                            (fragment.mesh.vertices[corner] - Vec3(0.003, 0, 0)).dot(normal.normalized());
                        QVERIFY2(std::abs(off) < 0.05 * spacing, qPrintable(QString::number(off / spacing)));
                    }
        }
        QVERIFY(std::abs(volume / size.prod() - 1) < 1e-9);
        const double expected = size.prod() / 2; // as the plane goes through the middle of the section at 3 mm
        QVERIFY(std::abs(fragments[0].volume + 0.003 * size.y() * size.z() - expected) < 0.01 * expected ||
                std::abs(fragments[1].volume + 0.003 * size.y() * size.z() - expected) < 0.01 * expected);
        // And as the view shows them: carried by their own objects alone.
        const auto torn = tornSurface(*shot->bodies[0].aggregate, skin, *shot->bodies[0].broken);
        QVERIFY(torn);
        std::vector<Vec3> apart(shot->bodies[0].aggregate->size(), Vec3::Zero());
        const Pieces pieces = findPieces(*shot->bodies[0].aggregate, *shot->bodies[0].broken);
        for (std::size_t i = 0; i < apart.size(); ++i)
            apart[i].x() = pieces.ofObject[i] == 0 ? -0.05 : 0.05;
        TriangleMesh moved = torn->mesh;
        torn->skin.evaluate(apart, moved.vertices);
        QVERIFY(std::abs(massProperties(moved).volume / size.prod() - 1) < 1e-6);
        for (std::size_t v = 0; v < moved.vertices.size(); ++v)
            QVERIFY(std::abs(std::abs(moved.vertices[v].x() - torn->mesh.vertices[v].x()) - 0.05) < 1e-6);
    }

    void cutsThatMakeNoSenseAreRefused()
    {
        Scene scene;
        scene.bodies.push_back(scenes::body(shapes::box(size), spacing, gel(0), "bar"));
        Simulation simulation(scene);
        const auto refusal = [&](const Cut& cut) {
            simulation.post(cut);
            simulation.applyCommands();
            return simulation.snapshot()->notice.english();
        };
        QVERIFY(refusal({.body = 0, .point = Vec3::Zero(), .normal = Vec3::Zero()}).find("plane") != std::string::npos);
        QVERIFY(refusal({.body = 0, .point = Vec3(1, 0, 0), .normal = Vec3::UnitX()}).find("nothing") !=
                std::string::npos);
        QVERIFY(refusal({.body = 7, .point = Vec3::Zero(), .normal = Vec3::UnitX()}).find("no body") !=
                std::string::npos);
        simulation.post(SetBodyKind{0, BodyKind::rigid});
        QVERIFY(refusal({.body = 0, .point = Vec3::Zero(), .normal = Vec3::UnitX()}).find("rigid") !=
                std::string::npos);
        QCOMPARE(simulation.snapshot()->broken, std::size_t{0});
        QVERIFY(simulation.recording().size() == 1);
    }
};

QTEST_MAIN(KnifeTest)
#include "knife_test.moc"
