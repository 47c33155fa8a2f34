#include "support/material_scenes.h"
#include "support/static_solver.h"
#include "support/thread_limit.h"

#include <QTest>

#include <chrono>
#include <cmath>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;
constexpr double frame = 1.0 / 60;

Material rubber(double poisson = 0.25)
{
    return {.density = 1100, .youngsModulus = 1e6, .poissonRatio = poisson, .dampingRatio = 0.05};
}
Material steel(double poisson = 0.25)
{
    return {.density = 7850, .youngsModulus = 2e11, .poissonRatio = poisson, .dampingRatio = 0.05};
}

Scene implicit(Scene scene)
{
    scene.integrator = Integrator::implicitEuler;
    return scene;
}

/// Deflection of the tip under gravity, from the statics of small displacements.
double staticDeflection(const Scene& scene)
{
    StaticBody body(scene.bodies[0].aggregate, scene.bodies[0].material);
    for (const ObjectIndex held : scene.fixtures[0].objects)
        body.prescribe(held, Vec3::Zero());
    for (std::size_t i = 0; i < body.size(); ++i)
        body.loads.push_back(scene.bodies[0].material.density * body.aggregate().volume[i] * scene.gravity);
    body.solve(1e-9);
    return body.displacement(body.size() - 1).z();
}

} // namespace

class ImplicitEulerTest : public QObject {
    Q_OBJECT

private slots:
    void experiment()
    {
        using Clock = std::chrono::steady_clock;
        for (const Eigen::Vector3i& cells : {Eigen::Vector3i(16, 4, 4), Eigen::Vector3i(33, 9, 9)})
        for (const double poisson : {0.0, 0.25, 0.3, 0.45})
            for (const Material& material : {rubber(poisson), steel(poisson)}) {
                // Gravity such that deflections are small.
                Scene scene = implicit(scenes::cantilever(cells, spacing, material, Vec3(0, 0, -1e-3 * material.youngsModulus / 1e6)));
                if (scene.gravity.norm() > 9e3) scene.gravity = Vec3(0, 0, -200);
                const double expected = staticDeflection(scene);
                Simulation simulation(scene);
                const std::size_t tip = scene.bodies[0].aggregate->size() - 1;
                for (int step = 0; step < 60; ++step) {
                    const auto t0 = Clock::now();
                    simulation.step();
                    const double ms = std::chrono::duration<double>(Clock::now() - t0).count() * 1e3;
                    const auto shot = simulation.snapshot();
                    if (step < 6 || step == 59)
                        qInfo("%zu nu %.2f E %.0e step %d h %.4f: %.6f of static; its %d, %.2f ms, num %.3g, imbalance %.3g of %.3g %s", tip + 1, poisson, material.youngsModulus, step, simulation.timeStep(),
                              shot->bodies[0].displacements[tip].z() / expected, shot->solverIterations, ms, shot->energy.numerical, shot->energy.imbalance, shot->energy.elastic, shot->health.message.c_str());
                }
            }
    }
};

QTEST_GUILESS_MAIN(ImplicitEulerTest)
#include "implicit_euler_test.moc"
