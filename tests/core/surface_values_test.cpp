#include "core/aggregate/fill.h"
#include "core/geometry/refine.h"
#include "core/simulation/simulation.h"
#include "core/skin/surface_values.h"
#include "support/scenes.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>
#include <functional>

using namespace knead;

namespace {

constexpr double E = 2e6;
constexpr double nu = 0.3;

Material rubber()
{
    Material material;
    material.youngsModulus = E;
    material.poissonRatio = nu;
    return material;
}

/// A bar, its surface, and the displacements that a map gives it.
struct Bar {
    TriangleMesh mesh = shapes::box({0.04, 0.012, 0.012});
    Aggregate aggregate = fill(mesh, {.spacing = 0.002});
    Skin skin{aggregate, mesh.vertices};
    RelaxedState relaxed{.materials = MaterialMap(rubber(), aggregate.size())};
    std::vector<Vec3> displacements;
    std::vector<Vec3> places;

    explicit Bar(const std::function<Vec3(const Vec3&)>& map)
    {
        for (ObjectIndex i = 0; i < aggregate.size(); ++i)
            displacements.push_back(map(aggregate.lattice.position(i)) - aggregate.lattice.position(i));
        places.resize(mesh.vertices.size());
        skin.evaluate(displacements, places);
    }

    SurfaceState state() const
    {
        return {.aggregate = aggregate,
                .skin = skin,
                .displacements = displacements,
                .relaxed = &relaxed,
                .places = places};
    }

    std::vector<float> values(SurfaceQuantity quantity) const { return surfaceValues(quantity, state()); }
};

Bar stretched(double stretch)
{
    return Bar([stretch](const Vec3& X) { return Vec3(stretch * X.x(), X.y(), X.z()); });
}

bool areNear(const std::vector<float>& values, double wanted, double share)
{
    return !values.empty() && std::all_of(values.begin(), values.end(), [&](float value) {
        return std::abs(static_cast<double>(value) - wanted) <= share * std::abs(wanted) + 1e-12;
    });
}

} // namespace

class SurfaceValuesTest : public QObject {
    Q_OBJECT

private slots:
    void displacementGrowsAlongAStretchedBar()
    {
        const Bar bar = stretched(1.25);
        const std::vector<float> values = bar.values(SurfaceQuantity::displacement);
        QCOMPARE(values.size(), bar.mesh.vertices.size());
        for (std::size_t v = 0; v < values.size(); ++v)
            QVERIFY(std::abs(static_cast<double>(values[v]) - 0.25 * std::abs(bar.mesh.vertices[v].x())) < 1e-8);
    }

    /// Uniaxial strain e = ln s: its deviator is e (2/3, -1/3, -1/3), the equivalent strain 2/3 e.
    void strainOfAnEvenStretchIsItsLogarithm()
    {
        QVERIFY(areNear(stretched(1.25).values(SurfaceQuantity::strain), 2.0 / 3 * std::log(1.25), 1e-5));
        QVERIFY(areNear(stretched(0.9).values(SurfaceQuantity::strain), -2.0 / 3 * std::log(0.9), 1e-5));
    }

    /// By the stretch of the volume, what the connections along the bar bear and those across faces with it, less what two of
    /// those bear across; the volumetric term is the same all around. For small strain it is 2 mu e.
    void stressOfAnEvenStretchIsThatOfTheConnections()
    {
        const double mu = E / (2 * (1 + nu));
        const auto byHand = [&](double s) {
            const double diagonal = 1 - std::sqrt(2 / (s * s + 1));
            return mu * (s * (s - 1) + 4 * s * s * diagonal - 2 * diagonal) / s;
        };
        QVERIFY(areNear(stretched(1.25).values(SurfaceQuantity::vonMisesStress), byHand(1.25), 1e-4));
        QVERIFY(areNear(stretched(1.001).values(SurfaceQuantity::vonMisesStress), 2 * mu * 1e-3, 3e-3));
    }

    void stressComesWithItsError()
    {
        const Bar bar = stretched(1.1);
        const SkinStresses stresses = surfaceStresses(bar.state());
        QCOMPARE(stresses.vonMises, bar.values(SurfaceQuantity::vonMisesStress));
        QCOMPARE(stresses.error.size(), stresses.vonMises.size());
        QVERIFY(stresses.errorShare < 1e-5); // even stress is read as well at any resolution
    }

    void whatHasNotFlowedHasNoPlasticStrain()
    {
        QVERIFY(areNear(stretched(1.25).values(SurfaceQuantity::plasticStrain), 0, 0));
    }

    /// A bar that was drawn to so much of its length, at constant volume: the strain is the logarithm.
    void plasticStrainIsThatOfTheRelaxedMetric()
    {
        Bar bar = stretched(1);
        const double s = 1.5;
        const Vec3 flow = bar.aggregate.lattice.axes.transpose() * Vec3(s, 1 / std::sqrt(s), 1 / std::sqrt(s));
        for (std::size_t n = 0; n < 6; ++n) {
            const double stretch = n < 3 ? flow[static_cast<Eigen::Index>(n)] : 0;
            bar.relaxed.metric[n].assign(bar.aggregate.size(), static_cast<float>(stretch * stretch));
        }
        QVERIFY(areNear(bar.values(SurfaceQuantity::plasticStrain), std::log(s), 1e-3));
    }

    /// Moved as a whole by less than its height: the top leaves the original by that, the bottom goes in by that.
    void distanceIsSignedAndExact()
    {
        Bar bar([](const Vec3& X) { return Vec3(X + Vec3(0, 0, 0.001)); });
        // Corners are nearest to edges; the middle of faces is nearest to faces.
        bar.mesh = refine(bar.mesh, 0.004);
        bar.skin = Skin(bar.aggregate, bar.mesh.vertices);
        bar.places.resize(bar.mesh.vertices.size());
        bar.skin.evaluate(bar.displacements, bar.places);
        const TriangleMesh original = shapes::box({0.04, 0.012, 0.012});
        const SurfaceDistance distance(original);
        SurfaceState state = bar.state();
        QVERIFY(!isKnown(SurfaceQuantity::distance, state));
        state.original = &distance;
        QVERIFY(isKnown(SurfaceQuantity::distance, state));
        const std::vector<float> values = surfaceValues(SurfaceQuantity::distance, state);
        int above = 0;
        int below = 0;
        for (std::size_t v = 0; v < values.size(); ++v) {
            const Vec3& X = bar.mesh.vertices[v];
            const bool isInner = std::abs(X.x()) < 0.018 && std::abs(X.y()) < 0.004;
            if (!isInner || std::abs(std::abs(X.z()) - 0.006) > 1e-9)
                continue;
            QVERIFY(std::abs(static_cast<double>(values[v]) - std::copysign(0.001, X.z())) < 1e-7);
            (X.z() > 0 ? above : below) += 1;
        }
        QVERIFY(above > 5 && below > 5);
    }

    void whatIsNotKeptIsNotKnown()
    {
        const Bar bar = stretched(1.1);
        SurfaceState state = bar.state();
        state.relaxed = nullptr;
        QVERIFY(isKnown(SurfaceQuantity::displacement, state) && isKnown(SurfaceQuantity::strain, state));
        QVERIFY(!isKnown(SurfaceQuantity::vonMisesStress, state) && !isKnown(SurfaceQuantity::plasticStrain, state));
        QVERIFY(!isKnown(SurfaceQuantity::contactForce, state));
        QVERIFY(areNear(surfaceValues(SurfaceQuantity::strain, state), 2.0 / 3 * std::log(1.1), 1e-5));
    }

    void contactForceIsCarriedByTheSkin()
    {
        const Bar bar = stretched(1);
        const std::vector<Vec3> pressing(bar.aggregate.size(), Vec3(0, 0.3, -0.4));
        SurfaceState state = bar.state();
        state.pressing = &pressing;
        QVERIFY(areNear(surfaceValues(SurfaceQuantity::contactForce, state), 0.5, 1e-5));
    }

    /// A block at rest on the floor is pressed by its weight, and one pressed by a tool by what the tool feels.
    void pressingForcesCarryTheWeight()
    {
        Material material = rubber();
        material.shapeDamping = 100;
        material.dampingRatio = 0.3;
        constexpr double spacing = 2e-3;
        Scene scene;
        scene.bodies.push_back(scenes::box({6, 6, 4}, spacing, material));
        scene.gravity = Vec3(0, 0, -9.81);
        scene.floorHeight = -2 * spacing;
        Simulation simulation(scene);
        simulation.showPressing(true);
        const double weight = 9.81 * material.density * std::pow(spacing, 3) * 6 * 6 * 4;
        // The mean over some time: it may still swing a little.
        Vec3 mean = Vec3::Zero();
        int count = 0;
        while (simulation.health().ok && simulation.time() < 0.5) {
            simulation.step();
            if (simulation.time() < 0.3 || simulation.stepCount() % 50 != 0)
                continue;
            const auto shot = simulation.snapshot();
            QVERIFY(shot->bodies[0].pressing);
            for (const ObjectIndex object : loadedObjects(*shot, 0))
                QVERIFY((*shot->bodies[0].pressing)[object].norm() > 0);
            QVERIFY(loadedObjects(*shot, 0).size() >= 4);
            for (const Vec3& force : *shot->bodies[0].pressing)
                mean += force;
            ++count;
        }
        mean /= count;
        qInfo("weight %.4g N, pressed by %.4g N", weight, mean.z());
        QVERIFY(std::abs(mean.z() / weight - 1) < 0.03);
        QVERIFY(mean.head<2>().norm() < 0.01 * weight);
    }

    /// Asking for it changes no bit, and after going to a moment it is as before.
    void askingForPressingChangesNothing()
    {
        Scene scene;
        scene.bodies.push_back(scenes::box({6, 6, 4}, 2e-3, rubber()));
        scene.gravity = Vec3(0, 0, -9.81);
        scene.floorHeight = -2 * 2e-3;
        scene.manipulators.push_back({.name = "block",
                                      .size = Vec3(0.01, 0.01, 0.01),
                                      .pose = {Vec3(0, 0, 0.0085), Quaternion::Identity()},
                                      .motion = HoldStill{}});
        Simulation one(scene);
        Simulation other(scene);
        other.showPressing(true);
        for (int i = 0; i < 400; ++i) {
            one.step();
            other.step();
            if (i % 20 == 0)
                other.snapshot();
        }
        QCOMPARE(one.stateHash(), other.stateHash());
        QVERIFY(!one.snapshot()->bodies[0].pressing);
        const auto before = other.snapshot();
        other.keepMoment();
        const auto after = other.snapshot();
        double all = 0;
        double difference = 0;
        for (ObjectIndex i = 0; i < before->bodies[0].pressing->size(); ++i) {
            all += (*before->bodies[0].pressing)[i].norm();
            difference += ((*before->bodies[0].pressing)[i] - (*after->bodies[0].pressing)[i]).norm();
        }
        QVERIFY(all > 0);
        QVERIFY(difference < 1e-6 * all);
    }
};

QTEST_APPLESS_MAIN(SurfaceValuesTest)
#include "surface_values_test.moc"
