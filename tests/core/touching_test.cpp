#include "support/scenes.h"

#include <QtTest>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;
constexpr double height = 6 * spacing;

Material rubber()
{
    Material material;
    material.dampingRatio = 0.3;
    material.shapeDamping = 60; // so that what hangs comes to rest soon
    return material;
}

Body block(const Vec3& low, const Vec3& high, double a = spacing)
{
    Body body =
        scenes::body(shapes::moved(shapes::box(high - low), {(low + high) / 2, Quaternion::Identity()}), a, rubber());
    return body;
}

/// A bar along x from 0 to `length`, of pieces that end at `cuts`, held at its low end.
Scene bar(double length, std::vector<double> cuts)
{
    Scene scene;
    cuts.push_back(length);
    double begin = 0;
    for (const double end : cuts) {
        scene.bodies.push_back(block({begin, 0, 0}, {end, height, height}));
        begin = end;
    }
    scene.fixtures.push_back(
        {"clamp", 0, objectsInBox(*scene.bodies[0].aggregate, Box(Vec3(-1, -1, -1), Vec3(spacing / 2, 1, 1)))});
    return scene;
}

/// Mean displacement of the last layer of objects [m].
Vec3 tipDisplacement(Simulation& simulation, const Scene& scene)
{
    const auto shot = simulation.snapshot();
    const Aggregate& last = *scene.bodies.back().aggregate;
    double end = -1;
    for (ObjectIndex i = 0; i < last.size(); ++i)
        end = std::max(end, last.lattice.position(i).x());
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (ObjectIndex i = 0; i < last.size(); ++i)
        if (last.lattice.position(i).x() > end - spacing / 2) {
            sum += shot->bodies.back().positions[i] - last.lattice.position(i);
            ++count;
        }
    return sum / count;
}

void runFor(Simulation& simulation, double time)
{
    while (simulation.time() < time && simulation.health().ok)
        simulation.step();
}

/// At rest: implicit steps damp what swings.
Vec3 hangingTip(Scene scene, const Vec3& gravity)
{
    scene.gravity = gravity;
    scene.touching = Touching::glued;
    scene.integrator = Integrator::implicitEuler;
    Simulation simulation(scene);
    runFor(simulation, 1);
    return tipDisplacement(simulation, scene);
}

} // namespace

class TouchingTest : public QObject {
    Q_OBJECT

private slots:
    void gluedPiecesBendAsOneBar_data()
    {
        QTest::addColumn<double>("length"); // [spacings]
        QTest::addColumn<QList<double>>("cuts");
        QTest::newRow("nodes meet") << 24.0 << QList<double>{12};
        QTest::newRow("nodes do not meet") << 24.4 << QList<double>{12};
        QTest::newRow("three pieces") << 24.0 << QList<double>{8, 16};
    }
    void gluedPiecesBendAsOneBar()
    {
        QFETCH(double, length);
        QFETCH(QList<double>, cuts);
        std::vector<double> places;
        for (const double cut : cuts)
            places.push_back(cut * spacing);
        // A lattice that does not fit sticks out at the clamp too, so the bar to compare with is one that does.
        const double whole = hangingTip(bar(24 * spacing, {}), Vec3(0, 0, -1)).z() * std::pow(length / 24, 4);
        const double glued = hangingTip(bar(length * spacing, places), Vec3(0, 0, -1)).z();
        QVERIFY(whole < -1e-5);
        QVERIFY2(std::abs(glued / whole - 1) < 0.04, qPrintable(QString::number(glued / whole)));
    }

    void gluedHalvesStretchAsOneBar()
    {
        const Vec3 pull(9.81, 0, 0);
        const double whole = hangingTip(bar(24 * spacing, {}), pull).x();
        const double glued = hangingTip(bar(24 * spacing, {12 * spacing}), pull).x();
        QVERIFY2(std::abs(glued / whole - 1) < 0.03, qPrintable(QString::number(glued / whole)));
    }

    void separateHalvesComeApart()
    {
        Scene halves = bar(24 * spacing, {12 * spacing});
        halves.gravity = Vec3(9.81, 0, 0);
        Simulation simulation(halves);
        runFor(simulation, 0.05);
        const double fallen = 0.5 * 9.81 * 0.05 * 0.05;
        QVERIFY(std::abs(tipDisplacement(simulation, halves).x() / fallen - 1) < 0.02);
    }

    void theSeamIsAsStrongAsTheWeakerMaterial()
    {
        // The second half pulls at the seam with its weight, which grows.
        const double length = 12 * spacing;
        Scene halves = bar(2 * length, {length});
        halves.touching = Touching::glued;
        halves.bodies[0].material.tensileStrength = 1e6;
        halves.bodies[1].material.tensileStrength = 1e4;
        const double tearing = 1e4 / (rubber().density * length); // [m/s^2]
        for (const auto& [share, holds] : {std::pair{0.85, true}, std::pair{1.25, false}}) {
            Simulation simulation(halves);
            const std::size_t joints = simulation.snapshot()->joints;
            constexpr double growth = 0.05; // [s]; waves take 1 ms
            for (int part = 1; part <= 50; ++part) {
                simulation.post(SetGravity{Vec3(share * tearing * part / 50, 0, 0)});
                runFor(simulation, growth * part / 50);
            }
            runFor(simulation, 1.3 * growth);
            const auto shot = simulation.snapshot();
            QVERIFY(shot->health.ok);
            QVERIFY(joints > 0);
            QCOMPARE(shot->components == 1, holds);
            if (holds)
                QCOMPARE(shot->joints, joints);
        }
    }

    void onlyWhatTouchesIsGlued()
    {
        for (const auto& [gap, isGlued] : {std::pair{0.3, true}, std::pair{0.9, false}}) {
            Scene scene;
            scene.bodies.push_back(block({0, 0, 0}, {height, height, height}));
            scene.bodies.push_back(block({height + gap * spacing, 0, 0}, {2 * height + gap * spacing, height, height}));
            scene.touching = Touching::glued;
            Simulation simulation(scene);
            QCOMPARE(simulation.snapshot()->joints > 0, isGlued);
        }
    }

    void solidsInContactRest_data()
    {
        QTest::addColumn<Vec3>("shift");
        QTest::addColumn<Vec3>("size");
        QTest::newRow("a face") << Vec3(height, 0, 0) << Vec3(height, height, height);
        QTest::newRow("part of a face") << Vec3(height, 0.0017, 0.0031) << Vec3(height, height, height);
        QTest::newRow("lattices that do not fit") << Vec3(height, 0.0007, 0) << Vec3(0.0113, 0.0097, 0.0151);
        QTest::newRow("a slight overlap") << Vec3(height - 0.0003, 0, 0) << Vec3(height, height, height);
        QTest::newRow("an edge") << Vec3(height, height, 0) << Vec3(height, height, height);
    }
    void solidsInContactRest()
    {
        QFETCH(Vec3, shift);
        QFETCH(Vec3, size);
        for (const Touching touching : {Touching::separate, Touching::glued}) {
            Scene scene;
            scene.bodies.push_back(block({0, 0, 0}, {height, height, height}));
            scene.bodies.push_back(block(shift, shift + size));
            scene.touching = touching;
            Simulation simulation(scene);
            for (int step = 0; step < 500; ++step)
                simulation.step();
            const auto shot = simulation.snapshot();
            QVERIFY(shot->health.ok);
            QVERIFY(shot->energy.kinetic < 1e-18);
            for (const auto& body : shot->bodies)
                for (const Vec3& displacement : body.displacements())
                    QVERIFY(displacement.norm() < 1e-7 * spacing);
        }
    }

    void gluingIsTheSameAfterAReset()
    {
        Scene scene = bar(24 * spacing, {12 * spacing});
        scene.touching = Touching::glued;
        Simulation simulation(scene);
        const std::size_t joints = simulation.snapshot()->joints;
        runFor(simulation, 0.001);
        simulation.post(Reset{});
        simulation.applyCommands();
        QCOMPARE(simulation.snapshot()->joints, joints);
    }
};

QTEST_GUILESS_MAIN(TouchingTest)
#include "touching_test.moc"
