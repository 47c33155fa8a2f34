#include "core/simulation/simulation.h"
#include "support/scenes.h"

#include <QtTest>

using namespace knead;

class PartLookTest : public QObject {
    Q_OBJECT
private slots:
    void nameAndColorOfAPartChangeNoBitOfARun_data()
    {
        QTest::addColumn<int>("integrator");
        QTest::newRow("semi-implicit") << static_cast<int>(Integrator::semiImplicitEuler);
        QTest::newRow("implicit") << static_cast<int>(Integrator::implicitEuler);
    }

    void nameAndColorOfAPartChangeNoBitOfARun()
    {
        QFETCH(int, integrator);
        Scene scene = scenes::cantilever({6, 3, 3}, 0.01, {.youngsModulus = 1e5}, Vec3(0, 0, -9.81));
        scene.integrator = static_cast<Integrator>(integrator);
        const auto run = [&](bool isLooked) {
            Simulation simulation(scene);
            for (int step = 0; step < 40; ++step) {
                if (isLooked && step % 10 == 3)
                    simulation.post(SetPartLook{0, "lever", "#ff8800"});
                simulation.step();
            }
            return simulation.stateHash();
        };
        QCOMPARE(run(true), run(false));
    }
};

QTEST_APPLESS_MAIN(PartLookTest)
#include "part_look_test.moc"
