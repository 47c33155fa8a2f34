// Whatever numbers come in: a sentence, or a run that stays in bounds.
#include "support/scenes.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

class Dice {
public:
    explicit Dice(unsigned seed)
        : m_random(seed)
    {
    }
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }
    bool oneIn(int n) { return std::uniform_int_distribution<int>(1, n)(m_random) == 1; }
    /// Evenly over the orders of magnitude.
    double over(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
    Vec3 vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
    Quaternion turn()
    {
        return Quaternion(Eigen::AngleAxisd(between(0, 3), (vector(1) + Vec3(0, 0, 1e-3)).normalized()));
    }

    Material material()
    {
        Material m;
        for (const MaterialField& field : materialFields()) {
            const double low = field.minimum > 0 ? field.minimum : field.maximum * 1e-9;
            m.*field.value = field.minimum == 0 && oneIn(3) ? 0
                             : field.maximum / low > 100    ? over(low, field.maximum)
                                                            : between(field.minimum, field.maximum);
        }
        return m;
    }

    Manipulator tool(double reach)
    {
        Manipulator tool;
        tool.kind = toolKinds[std::uniform_int_distribution<std::size_t>(0, std::size(toolKinds) - 2)(m_random)];
        tool.size = fittingSize(tool.kind, {over(1e-3, 0.02), over(1e-3, 0.02), over(1e-3, 0.02)});
        tool.pose = {vector(reach), turn()};
        tool.friction = between(0, 2);
        tool.speedLimit = over(1e-3, 100);
        if (oneIn(2))
            tool.forceLimit = over(1e-6, 1e6);
        if (oneIn(2))
            tool.motion = DriveAt{vector(over(1e-3, 100)), vector(over(1e-1, 1e3))};
        else
            tool.motion = GoTo{{vector(reach), turn()}};
        return tool;
    }

private:
    std::mt19937 m_random;
};

bool isFinite(const Snapshot& shot)
{
    for (const auto& body : shot.bodies)
        for (const Vec3& place : body.positions)
            if (!place.allFinite() || place.norm() > 1e3)
                return false;
    const EnergyLedger& e = shot.energy;
    for (const double energy :
         {e.kinetic, e.elastic, e.gravity, e.contact, e.toolWork, e.viscous, e.friction, e.plastic, e.fracture})
        if (!std::isfinite(energy))
            return false;
    return true;
}

} // namespace

class HostileTest : public QObject {
    Q_OBJECT

private slots:
    void aThousandRandomMaterialsAndMotionsStayInBounds()
    {
        const Body block = scenes::box({3, 3, 3}, spacing);
        int stopped = 0;
        for (unsigned seed = 1; seed <= 1000; ++seed) {
            Dice dice(seed);
            Scene scene;
            scene.bodies.push_back(block);
            scene.bodies[0].material = dice.material();
            scene.bodies[0].velocity = dice.vector(dice.oneIn(3) ? 10 : 0.1);
            if (dice.oneIn(4)) {
                scene.bodies.push_back(scenes::body(
                    shapes::moved(shapes::box(3 * spacing * Vec3::Ones()), {dice.vector(6 * spacing), dice.turn()}),
                    spacing, dice.material(), "second"));
                scene.bodies[1].kind = static_cast<BodyKind>(dice.oneIn(2) ? 0 : dice.oneIn(2) ? 1 : 2);
            }
            if (dice.oneIn(3))
                scene.bodies[0].regions.push_back({"corner", {0, 1, 2, 3, 4, 5, 6, 7}, dice.material()});
            if (dice.oneIn(2))
                scene.floorHeight = -2 * spacing;
            scene.gravity = dice.vector(20);
            for (int i = 0; i < 2; ++i)
                scene.manipulators.push_back(dice.tool(4 * spacing));
            Simulation simulation(scene);
            for (int step = 0; step < 300 && simulation.health().ok; ++step)
                simulation.step();
            const auto shot = simulation.snapshot();
            QVERIFY2(isFinite(*shot), qPrintable(QString("seed %1").arg(seed)));
            if (!simulation.health().ok) {
                ++stopped;
                qInfo("seed %u: %s", seed, simulation.health().message.english().c_str());
                QVERIFY(simulation.health().message.english().find("reset") != std::string::npos);
            }
        }
        qInfo("%d of 1000 runs were stopped", stopped);
        QVERIFY(stopped < 20);
    }

    void impossibleNumbersInAnyFieldGetASentence()
    {
        const Body block = scenes::box({2, 2, 2}, spacing);
        for (const double bad : {notANumber, infinite, -infinite, -1.0, 1e30, -1e30}) {
            for (const MaterialField& field : materialFields()) {
                Scene scene;
                scene.bodies.push_back(block);
                scene.bodies[0].material.*field.value = bad;
                QVERIFY_THROWS_EXCEPTION(std::runtime_error, Simulation{scene});
                scene.bodies[0] = block;
                Material material;
                material.*field.value = bad;
                scene.bodies[0].regions = {{"region", {0}, material}};
                QVERIFY_THROWS_EXCEPTION(std::runtime_error, Simulation{scene});
            }
            const auto refused = [&](auto change) {
                Scene scene;
                scene.bodies.push_back(block);
                scene.manipulators.push_back(Manipulator{.name = "tool"});
                change(scene);
                try {
                    const Simulation simulation(scene);
                } catch (const std::runtime_error& error) {
                    return std::string(error.what()).size() > 10;
                }
                return false;
            };
            QVERIFY(refused([&](Scene& s) { s.timeStep = bad; }));
            QVERIFY(refused([&](Scene& s) { s.massScalingTimeStep = bad; }));
            QVERIFY(refused([&](Scene& s) { s.floorFriction = bad; }));
            QVERIFY(refused([&](Scene& s) { s.bodies[0].structuralFriction = bad; }));
            QVERIFY(refused([&](Scene& s) { s.manipulators[0].friction = bad; }));
            QVERIFY(refused([&](Scene& s) { s.manipulators[0].speedLimit = bad; }));
            QVERIFY(refused([&](Scene& s) { s.manipulators[0].size.y() = bad; }));
            QVERIFY(refused([&](Scene& s) { s.bodies[0].velocity.x() = bad == -1 ? notANumber : bad; }));
            QVERIFY(refused([&](Scene& s) { s.bodies[0].angularVelocity.x() = bad == -1 ? notANumber : bad; }));
            QVERIFY(refused([&](Scene& s) { s.gravity.x() = bad == -1 ? notANumber : bad; }));
            QVERIFY(refused([&](Scene& s) { s.floorHeight = bad == -1 ? notANumber : bad; }));
            QVERIFY(refused([&](Scene& s) {
                s.fixtures.push_back({"grip", 0, {0}, Vec3(bad == -1 ? notANumber : bad, 0, 0)});
            }));
            QVERIFY(refused([&](Scene& s) { s.manipulators[0].pose.position.x() = bad == -1 ? notANumber : bad; }));
            QVERIFY(refused(
                [&](Scene& s) { s.manipulators[0].motion = DriveAt{Vec3(bad == -1 ? notANumber : bad, 0, 0)}; }));
        }
    }

    void aRunThatIsStoppedGoesBackToAGoodState()
    {
        // A block whose top is gripped and pushed down through its bottom.
        Scene scene;
        scene.bodies.push_back(scenes::box({6, 6, 6}, spacing));
        const Aggregate& aggregate = *scene.bodies[0].aggregate;
        const auto between = [&](double low, double high) {
            return objectsInBox(aggregate, Box(Vec3(-1, -1, low), Vec3(1, 1, high)));
        };
        scene.fixtures.push_back({"bottom", 0, between(-1, -2.9 * spacing)});
        scene.fixtures.push_back({"top", 0, between(2.9 * spacing, 1), Vec3(0, 0, -0.1)});
        Simulation simulation(scene);
        for (int step = 0; step < 20'000 && simulation.health().ok; ++step)
            simulation.step();
        QVERIFY(!simulation.health().ok);
        const auto shot = simulation.snapshot();
        QVERIFY(isFinite(*shot));
        QVERIFY(simulation.health().message.english().find("inside out") != std::string::npos);
        QVERIFY(shot->time > 0);
        qInfo("%s", simulation.health().message.english().c_str());
        simulation.post(Reset{});
        simulation.applyCommands();
        QVERIFY(simulation.health().ok);
        QCOMPARE(simulation.time(), 0.0);
        simulation.step();
        QVERIFY(simulation.health().ok);
    }

    /// Tools, gravity, or else what bodies and fixtures were given at the start.
    void theRemedyIsAboutWhatDrives()
    {
        const auto sentenceOf = [](const Vec3& gravity, bool hasTool) {
            Scene scene;
            scene.bodies.push_back(scenes::box({4, 4, 4}, spacing));
            scene.bodies[0].material.youngsModulus = 1e4;
            scene.bodies[0].material.density = 2000;
            scene.bodies[0].velocity = Vec3(900, 0, 0);
            scene.gravity = gravity;
            if (hasTool)
                scene.manipulators.push_back({.size = Vec3(1e-3, 1e-3, 1e-3), .pose = {Vec3(0, 0.1, 0)}});
            Simulation simulation(scene);
            simulation.step();
            return simulation.health().message.english();
        };
        QVERIFY(sentenceOf(Vec3::Zero(), false).find("Move bodies and fixtures slower or") != std::string::npos);
        QVERIFY(sentenceOf(Vec3(0, 0, -9.81), false).find("Lower gravity or") != std::string::npos);
        QVERIFY(sentenceOf(Vec3(0, 0, -9.81), true).find("Make the tools slower or") != std::string::npos);
    }
};

QTEST_GUILESS_MAIN(HostileTest)
#include "hostile_test.moc"
