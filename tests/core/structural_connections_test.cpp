#include "core/integration/semi_implicit_euler.h"
#include "core/integration/time_step.h"
#include "core/mechanics/structural_connections.h"
#include "support/scenes.h"

#include <Eigen/Eigenvalues>
#include <QTest>

#include <cmath>
#include <random>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;

struct Lump {
    explicit Lump(const Material& chosen = {}, const TriangleMesh& mesh = shapes::box(spacing * Vec3(7, 4, 5)))
        : material(chosen)
        , aggregate(std::make_shared<const Aggregate>(fill(mesh, {.spacing = spacing})))
        , materials(material, aggregate->size())
        , connections(aggregate, materials)
        , state(objectsAtRest(*aggregate))
    {
        for (std::size_t i = 0; i < state.size(); ++i) {
            state.mass[i] = material.density * aggregate->volume[i];
            state.inverseMass[i] = 1 / state.mass[i];
        }
    }

    void shake(double positions, double velocities)
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> value(-1, 1);
        const auto vector = [&] { return Vec3(value(random), value(random), value(random)); };
        for (std::size_t i = 0; i < state.size(); ++i) {
            state.position.add(i, positions * vector());
            state.velocity.add(i, velocities * vector());
        }
    }

    void deform(const Mat3& gradient)
    {
        for (std::size_t i = 0; i < state.size(); ++i)
            state.position.set(i, gradient * state.position.at(i));
    }

    Material material;
    /// With room for one contact on every object, as in a simulation.
    double largestFrequency()
    {
        std::vector<double> added(state.size());
        for (ObjectIndex i = 0; i < added.size(); ++i)
            added[i] = connections.contactStiffness(i);
        return connections.largestFrequency(state, added);
    }

    std::shared_ptr<const Aggregate> aggregate;
    MaterialMap materials;
    StructuralConnections connections;
    ObjectState state;
};

Material withPoisson(double ratio)
{
    Material material;
    material.poissonRatio = ratio;
    return material;
}

TriangleMesh tiltedCylinder()
{
    return shapes::moved(shapes::cylinder(5 * spacing, 14 * spacing, 48), shapes::tilt(0.7));
}

} // namespace

class StructuralConnectionsTest : public QObject {
    Q_OBJECT

private slots:
    void noForceAtRest()
    {
        for (const double ratio : {0.0, 0.25, 0.45}) {
            Lump f(withPoisson(ratio), tiltedCylinder());
            f.connections.computeForces(f.state);
            const double scale = f.material.youngsModulus * spacing * spacing;
            for (std::size_t i = 0; i < f.state.size(); ++i)
                QVERIFY(f.state.force.at(i).norm() < 1e-10 * scale);
            QVERIFY(f.connections.energy(f.state) < 1e-18);
        }
    }

    void forceIsTheGradientOfTheEnergy()
    {
        for (const double ratio : {0.1, 0.25, 0.45}) {
            Lump f(withPoisson(ratio), tiltedCylinder());
            f.shake(0.15 * spacing, 0);
            f.connections.computeForces(f.state);
            const ObjectState before = f.state;
            const double step = 1e-6 * spacing;
            for (std::size_t i = 0; i < f.state.size(); i += 37) {
                Vec3 gradient;
                for (Eigen::Index axis = 0; axis < 3; ++axis) {
                    Vec3 nudge = Vec3::Zero();
                    nudge[axis] = step;
                    f.state.position.set(i, before.position.at(i) + nudge);
                    const double ahead = f.connections.energy(f.state);
                    f.state.position.set(i, before.position.at(i) - nudge);
                    const double behind = f.connections.energy(f.state);
                    f.state.position.set(i, before.position.at(i));
                    gradient[axis] = (ahead - behind) / (2 * step);
                }
                QVERIFY((before.force.at(i) + gradient).norm() < 1e-4 * (before.force.at(i).norm() + 1e-3));
            }
        }
    }

    void internalForcesKeepLinearAndAngularMomentum()
    {
        Lump f(withPoisson(0.45), tiltedCylinder());
        f.shake(0.2 * spacing, 1);
        f.connections.computeForces(f.state);
        Vec3 force = Vec3::Zero();
        Vec3 torque = Vec3::Zero();
        double size = 0;
        for (std::size_t i = 0; i < f.state.size(); ++i) {
            const Vec3 total = f.state.force.at(i) + f.state.damping.at(i);
            force += total;
            torque += f.state.position.at(i).cross(total);
            size += total.norm();
        }
        QVERIFY(force.norm() < 1e-13 * size);
        QVERIFY(torque.norm() < 1e-13 * size);
    }

    void rotationCostsNoEnergy()
    {
        Lump f(withPoisson(0.4));
        f.deform(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix());
        QVERIFY(f.connections.energy(f.state) < 1e-20);
    }

    void smallStrainEnergyIsThatOfTheIsotropicSolid_data()
    {
        QTest::addColumn<double>("ratio");
        for (const double ratio : {0.0, 0.1, 0.25, 0.35, 0.45, 0.49})
            QTest::addRow("Poisson %.2f", ratio) << ratio;
    }
    void smallStrainEnergyIsThatOfTheIsotropicSolid()
    {
        // 1/2 lambda tr(e)^2 + mu e:e, for several strains, axis-aligned and sheared.
        QFETCH(double, ratio);
        const Material material = withPoisson(ratio);
        const Mat3 strains[] = {Vec3(1, 0, 0).asDiagonal(), Vec3(1, 1, 1).asDiagonal(), Vec3(1, -1, 0).asDiagonal(),
                                (Mat3() << 0, 1, 0, 1, 0, 0, 0, 0, 0).finished(),
                                (Mat3() << 1, .3, -.2, .3, -.5, .7, -.2, .7, .1).finished()};
        for (const Mat3& direction : strains) {
            Lump f(material);
            const Mat3 strain = 1e-5 * direction;
            f.deform(Mat3::Identity() + strain);
            const double expected =
                f.aggregate->filledVolume * (0.5 * material.lameLambda() * strain.trace() * strain.trace() +
                                             material.shearModulus() * strain.squaredNorm());
            const double energy = f.connections.energy(f.state);
            QVERIFY2(std::abs(energy / expected - 1) < 1e-4, qPrintable(QString::number(energy / expected)));
        }
    }

    void energyIsBoundedAtTheStableStepAndGrowsBeyondIt()
    {
        for (const double ratio : {0.25, 0.45}) {
            Material material = withPoisson(ratio);
            material.dampingRatio = 0;
            for (const double share : {0.95, 1.5}) {
                Lump f(material, tiltedCylinder());
                const double dt = share * stableTimeStep(f.largestFrequency(), 0);
                f.shake(1e-4 * spacing, 0);
                const double start = f.connections.energy(f.state);
                double largest = 0;
                for (int step = 0; step < 400; ++step) {
                    f.connections.computeForces(f.state);
                    semiImplicitEuler(f.state, Vec3::Zero(), dt);
                    largest = std::max(largest, f.connections.energy(f.state));
                    if (largest > 1e3 * start)
                        break;
                }
                if (share < 1)
                    QVERIFY2(largest < 5 * start, qPrintable(QString::number(largest / start)));
                else
                    QVERIFY(largest > 1e3 * start);
            }
        }
    }

    /// By its definition, one connection after the other: of more objects than a block has, so that some cross from one to the
    /// next, and of two in one place.
    void boundsAreThoseOfTheStiffnessAroundEachObject()
    {
        Lump f(withPoisson(0.25), shapes::moved(shapes::box(spacing * Vec3(60, 19, 17)), shapes::tilt(0.4)));
        QVERIFY(f.state.size() > 12000);
        f.shake(0.2 * spacing, 0);
        ObjectIndex together = 0;
        f.connections.forEachConnection(ObjectIndex{5000},
                                        [&](ObjectIndex object, const ConnectionId&) { together = object; });
        f.state.position.set(5000, f.state.position.at(together));
        const std::vector<double> bounds =
            f.connections.stiffnessBounds(f.state, std::vector<double>(f.state.size(), 3.0));
        for (ObjectIndex i = 0; i < f.state.size(); ++i) {
            Mat3 sum = Mat3::Zero();
            f.connections.forEachConnection(i, [&](ObjectIndex neighbor, const ConnectionId& connection) {
                const Vec3 across = f.state.position.at(neighbor) - f.state.position.at(i);
                const double k = f.connections.stiffness()[connection.direction][connection.lower];
                const double length = across.norm();
                const double sideways =
                    length > 0 ? std::max(0.0, 1 - f.connections.nominalLength(connection) / length) : 1;
                const Vec3 n = across.stableNormalized();
                sum += k * ((1 - sideways) * n * n.transpose() + sideways * Mat3::Identity());
            });
            const double expected = 2 * sum.selfadjointView<Eigen::Lower>().eigenvalues()[2] + 3;
            QVERIFY2(std::abs(bounds[i] / expected - 1) < 1e-9, qPrintable(QString::number(bounds[i] / expected)));
        }
    }

    void dampersOpposeRelativeMotionAndNothingElse()
    {
        Lump f;
        f.shake(0, 1);
        f.connections.computeForces(f.state);
        double power = 0;
        for (std::size_t i = 0; i < f.state.size(); ++i)
            power += f.state.damping.at(i).dot(f.state.velocity.at(i));
        QVERIFY(power < 0);

        Lump spinning;
        for (std::size_t i = 0; i < spinning.state.size(); ++i)
            spinning.state.velocity.set(i, Vec3(1, 2, 3) + Vec3(30, -20, 10).cross(spinning.state.position.at(i)));
        spinning.connections.computeForces(spinning.state);
        for (std::size_t i = 0; i < spinning.state.size(); ++i)
            QVERIFY(spinning.state.damping.at(i).norm() < 1e-12);
    }
};

QTEST_GUILESS_MAIN(StructuralConnectionsTest)
#include "structural_connections_test.moc"
