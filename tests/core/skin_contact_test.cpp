// Bodies on floors and between plates touch with their real skin: nothing goes in, creeps, or is pushed aside.
#include "core/aggregate/fill.h"
#include "core/aggregate/skin_points.h"
#include "core/simulation/simulation.h"
#include "support/scenes.h"
#include "support/shapes.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace knead;

namespace {

Material elastic(double modulus, double friction)
{
    return {.density = 1000, .youngsModulus = modulus, .poissonRatio = 0.3, .dampingRatio = 0.05, .friction = friction};
}

Body filled(const TriangleMesh& mesh, double spacing, const Material& material)
{
    return {.name = "body",
            .aggregate = std::make_shared<const Aggregate>(fill(mesh, {.spacing = spacing})),
            .material = material};
}

Vec3 middleOf(Simulation& simulation)
{
    const auto shot = simulation.snapshot();
    Vec3 sum = Vec3::Zero();
    for (const Vec3& place : shot->bodies[0].positions)
        sum += place;
    return sum / static_cast<double>(shot->bodies[0].positions.size());
}

void runUntil(Simulation& simulation, double time)
{
    while (simulation.health().ok && simulation.time() < time * (1 - 1e-9))
        simulation.step();
    QVERIFY2(simulation.health().ok, simulation.health().message.english().c_str());
}

/// A body on the floor of a slope that goes down along x.
Scene onSlope(const Body& body, double height, double angle, double friction, Integrator integrator)
{
    Scene scene;
    scene.bodies.push_back(body);
    scene.gravity = 9.81 * Vec3(std::sin(angle), 0, -std::cos(angle));
    scene.floorHeight = -height / 2;
    scene.floorFriction = friction;
    scene.integrator = integrator;
    return scene;
}

} // namespace

class SkinContactTest : public QObject {
    Q_OBJECT

    static void addIntegrators()
    {
        QTest::addColumn<bool>("isImplicit");
        QTest::newRow("explicit") << false;
        QTest::newRow("implicit") << true;
    }
    static Integrator integrator(bool isImplicit)
    {
        return isImplicit ? Integrator::implicitEuler : Integrator::semiImplicitEuler;
    }

private slots:
    void pointsOfASkinAreOnItAndStandForAllOfIt()
    {
        const TriangleMesh ball = shapes::sphere(0.01, 64);
        const Aggregate aggregate = fill(ball, {.spacing = 0.0023});
        double area = 0;
        for (const SkinPoint& point : aggregate.skin) {
            QVERIFY(std::abs(point.place.norm() - 0.01) < 1e-4);
            area += point.area;
        }
        QVERIFY(std::abs(area / (4 * std::numbers::pi * 1e-4) - 1) < 0.01);
        const Aggregate box = fill(shapes::box({0.01, 0.02, 0.03}), {.spacing = 0.0023});
        Box reach;
        for (const SkinPoint& point : box.skin)
            reach.extend(point.place);
        QVERIFY((reach.sizes() - Vec3(0.01, 0.02, 0.03)).norm() < 1e-12); // corners are among them
    }

    /// By 80 %, at pressures of many times the modulus. (At nu = 1/4 and below springs alone bear it, which collapse.)
    void whatIsCrushedStaysBetweenItsPlates()
    {
        constexpr double width = 0.012;
        constexpr double thickness = 0.004;
        double before = 0;
        for (const double cells : {4.0, 6.0}) {
            Scene scene;
            scene.bodies.push_back(filled(shapes::box(Vec3::Constant(width)), width / cells, elastic(1e6, 0)));
            scene.integrator = Integrator::implicitEuler;
            for (const double side : {-1.0, 1.0}) {
                Manipulator plate{.name = "plate", .size = {4 * width, 4 * width, thickness}};
                plate.kind = ToolKind::plate;
                plate.friction = 0;
                plate.speedLimit = 10;
                const auto at = [&](double down) {
                    return Pose{Vec3(0, 0, side * (width / 2 + thickness / 2 - down)), Quaternion::Identity()};
                };
                plate.pose = at(0);
                plate.motion = FollowKeyFrames{{{0, at(0)}, {0.4, at(0.4 * width)}, {1, at(0.4 * width)}}};
                scene.manipulators.push_back(plate);
            }
            Simulation simulation(scene);
            runUntil(simulation, 0.5);
            simulation.snapshot();
            runUntil(simulation, 0.55);
            const auto shot = simulation.snapshot();
            double highest = 0;
            for (const Vec3& place : shot->bodies[0].positions)
                highest = std::max(highest, std::abs(place.z()));
            const double depth = (highest - 0.1 * width) / (width / cells);
            QVERIFY2(depth < 0.1, qPrintable(QString("%1 spacings").arg(depth)));
            const Vec3& force = shot->tools[1].force;
            QVERIFY2(std::hypot(force.x(), force.y()) < 0.01 * force.z(), qPrintable(QString::number(force.x())));
            qInfo("%g cells: %.1f N, %.3f spacings", cells, force.z(), depth);
            if (before > 0)
                QVERIFY2(std::abs(force.z() / before - 1) < 0.1, qPrintable(QString::number(force.z() / before)));
            before = force.z();
        }
    }

    void aBlockStaysOnASlope_data() { addIntegrators(); }
    void aBlockStaysOnASlope()
    {
        QFETCH(const bool, isImplicit);
        const Body block = filled(shapes::box({0.03, 0.03, 0.015}), 0.015 / 4, elastic(1e7, 0.4));
        Simulation simulation(onSlope(block, 0.015, std::atan(0.9 * 0.4), 0.4, integrator(isImplicit)));
        const Vec3 start = middleOf(simulation);
        runUntil(simulation, 0.1);
        const Vec3 settled = middleOf(simulation);
        QVERIFY2((settled - start).norm() < 1e-5, qPrintable(QString::number((settled - start).norm())));
        runUntil(simulation, isImplicit ? 10 : 0.2);
        const double creep = (middleOf(simulation) - settled).norm();
        QVERIFY2(creep < 1e-8, qPrintable(QString::number(creep)));
    }

    void aBlockSlidesWhereItIsTooSteep_data()
    {
        QTest::addColumn<bool>("isImplicit");
        QTest::addColumn<double>("cells");
        QTest::newRow("implicit") << true << 3.0;
        // It rattles, and more so the finer it is.
        for (const double cells : {2.5, 3.0, 6.0})
            QTest::addRow("explicit, %g cells high", cells) << false << cells;
    }
    void aBlockSlidesWhereItIsTooSteep()
    {
        QFETCH(const bool, isImplicit);
        QFETCH(const double, cells);
        const double angle = std::atan(1.3 * 0.4);
        const Body block = filled(shapes::box({0.03, 0.03, 0.015}), 0.015 / cells, elastic(1e7, 0.4));
        Simulation simulation(onSlope(block, 0.015, angle, 0.4, integrator(isImplicit)));
        // Implicit friction takes a few frames to let go; from then on it gathers speed as it should.
        const auto momentum = [&] { return simulation.snapshot()->momentum.x(); };
        runUntil(simulation, 0.1);
        const double before = momentum();
        const double start = simulation.time();
        runUntil(simulation, 0.2);
        const double mass = 1000 * 0.03 * 0.03 * 0.015;
        const double gathered = (momentum() - before) / (mass * (simulation.time() - start));
        const double expected = 9.81 * (std::sin(angle) - 0.4 * std::cos(angle));
        QVERIFY2(std::abs(gathered / expected - 1) < 0.05, qPrintable(QString::number(gathered / expected)));
    }

    /// g sin a t^2 / 3, from rest on its line of contact.
    void aCylinderRolls_data() { addIntegrators(); }
    void aCylinderRolls()
    {
        QFETCH(const bool, isImplicit);
        const double angle = 10 * std::numbers::pi / 180;
        const TriangleMesh mesh =
            shapes::moved(shapes::cylinder(0.01, 0.02, 64),
                          {Vec3::Zero(), Quaternion(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()))});
        Body cylinder = filled(mesh, 0.02 / 8, elastic(1e7, 0.4));
        cylinder.kind = BodyKind::rigid;
        Simulation simulation(onSlope(cylinder, 0.02, angle, 0.4, integrator(isImplicit)));
        const double start = middleOf(simulation).x();
        runUntil(simulation, 0.4);
        const double time = simulation.time();
        const double ratio = (middleOf(simulation).x() - start) / (9.81 * std::sin(angle) * time * time / 3);
        QVERIFY2(std::abs(ratio - 1) < 0.05, qPrintable(QString::number(ratio)));
    }
};

QTEST_APPLESS_MAIN(SkinContactTest)
#include "skin_contact_test.moc"
