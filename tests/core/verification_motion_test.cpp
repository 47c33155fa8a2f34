// Motion against closed forms and against the theory of the schemes: V1 to V4, V8, V9 and V20 of the verification suite.
#include "core/integration/forward_euler.h"
#include "core/integration/semi_implicit_euler.h"
#include "core/integration/time_step.h"
#include "core/mechanics/structural_connections.h"
#include "support/scenes.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>

using namespace knead;

namespace {

constexpr double pi = std::numbers::pi;

/// Objects and connections alone, without tools, contacts or commands.
struct Specimen {
    Specimen(std::shared_ptr<const Aggregate> lump, const Material& material)
        : aggregate(std::move(lump))
        , materials(material, aggregate->size())
        , connections(aggregate, materials)
        , state(objectsAtRest(*aggregate))
    {
        for (std::size_t i = 0; i < state.size(); ++i) {
            state.mass[i] = material.density * aggregate->volume[i];
            state.inverseMass[i] = 1 / state.mass[i];
        }
    }

    StepReport step(double dt)
    {
        connections.computeForces(state);
        return semiImplicitEuler(state, Vec3::Zero(), dt);
    }

    double stableStep()
    {
        return stableTimeStep(connections.largestFrequency(state, std::vector<double>(state.size())),
                              connections.dampingTime());
    }

    double kinetic() const
    {
        double sum = 0;
        for (std::size_t i = 0; i < state.size(); ++i)
            sum += 0.5 * state.mass[i] * state.velocity.at(i).squaredNorm();
        return sum;
    }

    std::shared_ptr<const Aggregate> aggregate;
    MaterialMap materials;
    StructuralConnections connections;
    ObjectState state;
};

std::shared_ptr<const Aggregate> boxOfCells(const Eigen::Vector3i& cells, double spacing)
{
    return std::make_shared<const Aggregate>(fill(shapes::box(spacing * cells.cast<double>()), {.spacing = spacing}));
}

/// Two objects a millimeter apart along x, 1 g each, joined by one connection; and their angular frequency.
struct Pair {
    explicit Pair(double dampingRatio)
        : specimen(twoObjects(), material(dampingRatio))
    {
        specimen.state.mass = {1e-3, 1e-3};
        specimen.state.inverseMass = {1e3, 1e3};
        const double stiffness = specimen.connections.stiffness()[2][0];
        frequency = std::sqrt(stiffness / 0.5e-3);
    }

    static std::shared_ptr<const Aggregate> twoObjects()
    {
        Aggregate pair;
        pair.lattice.spacing = 1e-3;
        pair.lattice.axes.col(2) = Vec3::UnitX();
        pair.lattice.axes.col(0) = Vec3::UnitY();
        pair.lattice.axes.col(1) = Vec3::UnitZ();
        pair.lattice.nodes = {{0, 0, 0}, {0, 0, 1}};
        findSegments(pair.lattice);
        for (std::size_t d = 0; d < Lattice::isotropicCount; ++d)
            pair.weight[d] = {d == 2 ? 1.0 : 0.0, 0.0};
        pair.volume = {0.5e-9, 0.5e-9};
        pair.depth = {0, 0};
        pair.face = {0, 0};
        return std::make_shared<const Aggregate>(pair);
    }

    /// Damped so that its own mode has the damping ratio, whatever its mass.
    static Material material(double dampingRatio)
    {
        // b / k = 2 zeta sqrt(rho a^2 / (2 mu)); of the pair 2 zeta / omega with omega^2 = mu a / (0.5 g).
        Material m;
        m.youngsModulus = 1e5;
        m.density = 1100;
        const double mu = m.shearModulus();
        const double latticeTime = std::sqrt(m.density * 1e-6 / (2 * mu));
        m.dampingRatio = dampingRatio * std::sqrt(0.5e-3 / (mu * 1e-3)) / latticeTime;
        return m;
    }

    double stretch() const { return (specimen.state.position.at(1) - specimen.state.position.at(0)).norm() - 1e-3; }

    Specimen specimen;
    double frequency;
};

/// Times of upward zero crossings, by linear interpolation.
std::vector<double> crossings(int count, double dt, const std::function<double()>& stepAndRead, double start)
{
    std::vector<double> times;
    double before = start;
    for (long step = 1; static_cast<int>(times.size()) < count; ++step) {
        const double now = stepAndRead();
        if (before < 0 && now >= 0)
            times.push_back((static_cast<double>(step) - now / (now - before)) * dt);
        before = now;
        if (step > 50'000'000)
            break;
    }
    return times;
}

} // namespace

class VerificationMotionTest : public QObject {
    Q_OBJECT

private slots:
    void twoObjectsSwingWithThePeriodOfTheScheme_data()
    {
        QTest::addColumn<double>("phase");
        for (const double phase : {0.5, 0.1, 0.02})
            QTest::addRow("omega h = %.2f", phase) << phase;
    }
    void twoObjectsSwingWithThePeriodOfTheScheme() // V1
    {
        QFETCH(double, phase);
        Pair pair(0);
        const double dt = phase / pair.frequency;
        pair.specimen.state.position.add(1, Vec3(1e-5, 0, 0));
        const int periods = 2000;
        const auto times = crossings(
            periods + 1, dt,
            [&] {
                pair.specimen.step(dt);
                return pair.stretch();
            },
            1e-5);
        const double period = (times.back() - times.front()) / periods;
        const double error = period * pair.frequency / (2 * pi) - 1;
        const double theory = phase / 2 / std::asin(phase / 2) - 1;
        QVERIFY2(std::abs(error / theory - 1) < 0.01, qPrintable(QString("%1 %2").arg(error).arg(theory)));
    }

    void dampedSwingDecaysAsTheoryHasIt_data()
    {
        QTest::addColumn<double>("zeta");
        for (const double zeta : {0.05, 0.2, 0.5})
            QTest::addRow("zeta %.2f", zeta) << zeta;
    }
    void dampedSwingDecaysAsTheoryHasIt() // V2
    {
        QFETCH(double, zeta);
        Pair pair(zeta);
        const double dt = 2e-3 / pair.frequency;
        pair.specimen.state.position.add(1, Vec3(1e-5, 0, 0));
        double best = 0;
        std::vector<double> peaks;
        double last = 1e-5;
        bool rising = false;
        while (peaks.size() < 2) {
            pair.specimen.step(dt);
            const double now = pair.stretch();
            if (rising && now < last)
                peaks.push_back(last);
            rising = now > last;
            last = now;
            best = std::max(best, now);
        }
        const double decay = peaks[1] / peaks[0];
        const double theory = std::exp(-zeta * 2 * pi / std::sqrt(1 - zeta * zeta));
        QVERIFY2(std::abs(decay / theory - 1) < 0.015, qPrintable(QString("%1 %2").arg(decay).arg(theory)));
    }

    void freeBodyKeepsMomentumToRounding() // V3
    {
        Material material;
        material.youngsModulus = 1e6;
        Specimen specimen(boxOfCells({7, 4, 4}, 2e-3), material);
        for (std::size_t i = 0; i < specimen.state.size(); ++i)
            specimen.state.velocity.set(i,
                                        Vec3(0.3, 0.1, -0.2) + Vec3(20, 30, 50).cross(specimen.state.position.at(i)));
        const auto momenta = [&] {
            std::pair<Vec3, Vec3> sum{Vec3::Zero(), Vec3::Zero()};
            for (std::size_t i = 0; i < specimen.state.size(); ++i) {
                const Vec3 p = specimen.state.mass[i] * specimen.state.velocity.at(i);
                sum.first += p;
                sum.second += specimen.state.position.at(i).cross(p);
            }
            return sum;
        };
        const auto before = momenta();
        const double dt = 0.8 * specimen.stableStep();
        for (int step = 0; step < 20'000; ++step)
            specimen.step(dt);
        const auto after = momenta();
        QVERIFY((after.first - before.first).norm() < 1e-12 * before.first.norm());
        QVERIFY((after.second - before.second).norm() < 1e-12 * before.second.norm());
    }

    void undampedEnergyStaysWithoutDriftWhereForwardEulerExplodes() // V4
    {
        Material material;
        material.dampingRatio = 0;
        const auto lump = boxOfCells({6, 4, 4}, 2e-3);
        Specimen specimen(lump, material);
        Specimen published(lump, material);
        for (std::size_t i = 0; i < specimen.state.size(); ++i) { // a stretched start
            const Vec3 x = specimen.state.position.at(i);
            specimen.state.position.set(i, x + 0.02 * Vec3(x.x(), 0, 0));
            published.state.position.set(i, x + 0.02 * Vec3(x.x(), 0, 0));
        }
        const double dt = 0.33 * specimen.stableStep();
        const double start = specimen.connections.energy(specimen.state);
        double sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
        const int steps = 20'000;
        double lowest = start;
        double highest = start;
        for (int step = 0; step < steps; ++step) {
            specimen.step(dt);
            if (step % 10 != 0)
                continue;
            const double energy = (specimen.connections.energy(specimen.state) + specimen.kinetic()) / start;
            lowest = std::min(lowest, energy * start);
            highest = std::max(highest, energy * start);
            const double x = step / 1000.0;
            sumX += x;
            sumY += energy;
            sumXX += x * x;
            sumXY += x * energy;
        }
        const double n = steps / 10;
        const double slope = (n * sumXY - sumX * sumY) / (n * sumXX - sumX * sumX);
        QVERIFY2(std::abs(slope) < 1e-4, qPrintable(QString::number(slope)));
        QVERIFY(lowest > 0.9 * start && highest < 1.15 * start);

        int step = 0;
        double energy = start;
        for (; step < 3000 && energy < 10 * start; ++step) {
            published.connections.computeForces(published.state);
            forwardEuler(published.state, Vec3::Zero(), dt);
            energy = published.connections.energy(published.state) + published.kinetic();
        }
        QVERIFY(step < 1000);
    }

    void wavesRunAtTheSpeedOfABar() // V8
    {
        // The slowest mode along a free bar has the frequency c / (2 L).
        Material material;
        material.dampingRatio = 0;
        Specimen specimen(boxOfCells({80, 3, 3}, 2e-3), material);
        const double length = 0.16;
        for (std::size_t i = 0; i < specimen.state.size(); ++i)
            specimen.state.position.add(i, {1e-6 * std::sin(pi * specimen.state.position.at(i).x() / length), 0, 0});
        const double dt = 0.5 * specimen.stableStep();
        const auto elongation = [&] {
            double sum = 0;
            for (std::size_t i = 0; i < specimen.state.size(); ++i) {
                const double rest = specimen.aggregate->lattice.position(static_cast<ObjectIndex>(i)).x();
                sum += (specimen.state.position.at(i).x() - rest) * std::sin(pi * rest / length);
            }
            return sum;
        };
        const auto times = crossings(
            9, dt,
            [&] {
                specimen.step(dt);
                return elongation();
            },
            elongation());
        const double speed = 2 * length * 8 / (times.back() - times.front());
        QVERIFY2(std::abs(speed / material.soundSpeed() - 1) < 0.02,
                 qPrintable(QString::number(speed / material.soundSpeed())));
    }

    void errorFallsWithTheOrderOfTheScheme() // V9
    {
        Material material;
        material.dampingRatio = 0;
        const auto lump = boxOfCells({4, 3, 3}, 2e-3);
        const double whole = 20 * 0.4 * Specimen(lump, material).stableStep();
        // Where the objects are after the whole time, begun with velocities at time 0 or half a step later.
        const auto run = [&](int steps, bool shifted) {
            Specimen specimen(lump, material);
            const double dt = whole / steps;
            for (std::size_t i = 0; i < specimen.state.size(); ++i) {
                const Vec3 x = specimen.state.position.at(i);
                specimen.state.position.set(i, x + 0.05 * Vec3(x.x(), -x.y(), 0.5 * x.z()));
            }
            if (shifted) { // back by half a kick, so that the first kick ends half a step ahead
                specimen.connections.computeForces(specimen.state);
                for (std::size_t i = 0; i < specimen.state.size(); ++i)
                    specimen.state.velocity.add(i,
                                                -0.5 * dt * specimen.state.inverseMass[i] * specimen.state.force.at(i));
            }
            for (int step = 0; step < steps; ++step)
                specimen.step(dt);
            return specimen.state.position;
        };
        const VectorArray exact = run(20 * 256, true);
        for (const bool shifted : {false, true}) {
            std::vector<double> errors;
            for (const int steps : {80, 160, 320}) {
                const VectorArray places = run(steps, shifted);
                double sum = 0;
                for (std::size_t i = 0; i < places.size(); ++i)
                    sum += (places.at(i) - exact.at(i)).squaredNorm();
                errors.push_back(std::sqrt(sum));
            }
            for (std::size_t i = 0; i < 2; ++i) {
                const double order = std::log2(errors[i] / errors[i + 1]);
                QVERIFY2(shifted ? order > 1.9 : std::abs(order - 1) < 0.1, qPrintable(QString::number(order)));
            }
        }
    }

    void cantileverSwingsAtItsFirstFrequency() // V20
    {
        // 0.5596 sqrt(E I / (rho A L^4)); shear and rotary inertia take 1 % at this slenderness.
        Material material;
        material.dampingRatio = 0;
        const int width = 5;
        const int length = 80;
        const double a = 2e-3;
        Specimen specimen(boxOfCells({length, width, width}, a), material);
        const double L = length * a;
        std::vector<double> shape(specimen.state.size());
        for (std::size_t i = 0; i < shape.size(); ++i) {
            const double x = (specimen.state.position.at(i).x() + L / 2) / L;
            const double k = 1.875104;
            const double sigma = 0.734096;
            shape[i] = std::cosh(k * x) - std::cos(k * x) - sigma * (std::sinh(k * x) - std::sin(k * x));
            specimen.state.velocity.set(i, {0, 0, -1e-3 * shape[i]});
            if (x < 1e-9)
                specimen.state.inverseMass[i] = 0;
        }
        const double dt = 0.8 * specimen.stableStep();
        const auto deflection = [&] {
            double sum = 0;
            for (std::size_t i = 0; i < shape.size(); ++i) {
                const double rest = specimen.aggregate->lattice.position(static_cast<ObjectIndex>(i)).z();
                sum += specimen.state.mass[i] * shape[i] * (specimen.state.position.at(i).z() - rest);
            }
            return sum;
        };
        const auto times = crossings(
            3, dt,
            [&] {
                specimen.step(dt);
                return deflection();
            },
            -1e-30);
        const double frequency = 2 / (times.back() - times.front());
        const double h = width * a;
        const double theory = 0.5596 * material.soundSpeed() * h / std::sqrt(12.0) / (L * L);
        qInfo("%.4f of theory", frequency / theory);
        QVERIFY2(std::abs(frequency / theory - 1) < 0.02, qPrintable(QString::number(frequency / theory)));
    }
};

QTEST_GUILESS_MAIN(VerificationMotionTest)
#include "verification_motion_test.moc"
