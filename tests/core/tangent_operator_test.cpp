#include "core/mechanics/tangent_kernels.h"
#include "core/mechanics/tangent_operator.h"
#include "support/scenes.h"
#include "support/thread_limit.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <random>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;
constexpr double step = 1.0 / 60;

struct Lump {
    explicit Lump(double poisson, const Eigen::Vector3i& cells = {6, 4, 5})
        : aggregate(std::make_shared<const Aggregate>(
              fill(shapes::box(spacing * cells.cast<double>()), {.spacing = spacing})))
        , materials(Material{.poissonRatio = poisson, .dampingRatio = 0.1}, aggregate->size())
        , connections(aggregate, materials)
        , state(objectsAtRest(*aggregate))
        , tangent(connections)
    {
    }

    VectorArray random(double size, unsigned seed) const
    {
        std::mt19937 generator(seed);
        std::uniform_real_distribution<double> value(-size, size);
        VectorArray vectors;
        vectors.resize(state.size());
        for (std::size_t i = 0; i < state.size(); ++i)
            vectors.set(i, {value(generator), value(generator), value(generator)});
        return vectors;
    }

    void deform(const Mat3& gradient)
    {
        for (std::size_t i = 0; i < state.size(); ++i)
            state.position.set(i, gradient * state.position.at(i));
    }

    VectorArray product(const VectorArray& u)
    {
        VectorArray result;
        result.resize(u.size());
        tangent.addProduct(kernels::from(u, 0), kernels::into(result, 0));
        return result;
    }

    /// h times the change of the forces when velocities change by u, and places by h u: what the product must be.
    VectorArray changeOfForces(const VectorArray& u)
    {
        const double small = 1e-6;
        VectorArray change;
        change.resize(u.size());
        for (const double way : {1.0, -1.0}) {
            ObjectState moved = state;
            for (std::size_t i = 0; i < u.size(); ++i) {
                moved.position.add(i, way * small * step * u.at(i));
                moved.velocity.set(i, way * small * u.at(i));
            }
            connections.computeForces(moved);
            for (std::size_t i = 0; i < u.size(); ++i)
                change.add(i, -way * step / (2 * small) * (moved.force.at(i) + moved.damping.at(i)));
        }
        return change;
    }

    std::shared_ptr<const Aggregate> aggregate;
    MaterialMap materials;
    StructuralConnections connections;
    ObjectState state;
    TangentOperator tangent;
};

double norm(const VectorArray& v)
{
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
        sum += v.at(i).squaredNorm();
    return std::sqrt(sum);
}
double dot(const VectorArray& a, const VectorArray& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a.at(i).dot(b.at(i));
    return sum;
}
double difference(const VectorArray& a, const VectorArray& b)
{
    VectorArray left = a;
    for (std::size_t i = 0; i < a.size(); ++i)
        left.add(i, -b.at(i));
    return norm(left) / norm(b);
}

} // namespace

class TangentOperatorTest : public QObject {
    Q_OBJECT

private slots:
    void productIsTheChangeOfTheForcesOfUnstressedMaterial()
    {
        for (const double poisson : {0.25, 0.3, 0.45, 0.49}) {
            Lump lump(poisson);
            lump.tangent.update(lump.state.position, step);
            const VectorArray u = lump.random(0.01, 3);
            QVERIFY2(difference(lump.product(u), lump.changeOfForces(u)) < 1e-6,
                     qPrintable(QString::number(difference(lump.product(u), lump.changeOfForces(u)))));
        }
    }

    void productIsTheChangeOfTheForcesOfTurnedAndStretchedMaterial()
    {
        // All connections are longer than their nominal lengths, so that nothing is left out of what they answer.
        Lump lump(0.25);
        lump.deform(1.2 * shapes::tilt(0.7).rotation.toRotationMatrix() * Vec3(1.1, 1, 0.95).asDiagonal());
        lump.tangent.update(lump.state.position, step);
        const VectorArray u = lump.random(0.01, 3);
        QVERIFY(difference(lump.product(u), lump.changeOfForces(u)) < 1e-6);
    }

    void productIsSymmetricAndPositiveInAnyShape()
    {
        for (const double poisson : {0.0, 0.25, 0.45}) {
            Lump lump(poisson);
            lump.deform(Vec3(0.6, 1.1, 0.8).asDiagonal());
            const VectorArray shake = lump.random(0.3 * spacing, 5);
            for (std::size_t i = 0; i < shake.size(); ++i)
                lump.state.position.add(i, shake.at(i));
            lump.tangent.update(lump.state.position, step);
            const VectorArray u = lump.random(1, 1);
            const VectorArray v = lump.random(1, 2);
            const VectorArray Au = lump.product(u);
            const VectorArray Av = lump.product(v);
            QVERIFY(std::abs(dot(v, Au) - dot(u, Av)) < 1e-12 * norm(u) * norm(Av));
            QVERIFY(dot(u, Au) > 0);
            Vec3 total = Vec3::Zero();
            for (std::size_t i = 0; i < Au.size(); ++i)
                total += Au.at(i);
            QVERIFY(total.norm() < 1e-12 * norm(Au));
        }
    }

    void diagonalBlocksAndSlopesAreThoseOfTheProduct()
    {
        Lump lump(0.45);
        lump.deform(Vec3(0.9, 1.1, 0.8).asDiagonal());
        lump.tangent.update(lump.state.position, step);
        std::array<std::vector<double>, 6> blocks;
        std::array<double*, 6> pointers{};
        for (std::size_t c = 0; c < 6; ++c) {
            blocks[c].assign(lump.state.size(), 0);
            pointers[c] = blocks[c].data();
        }
        lump.tangent.addBlocks(pointers);
        const auto zero = [&] {
            VectorArray none;
            none.resize(lump.state.size());
            return none;
        };
        for (const std::size_t object : {std::size_t{0}, std::size_t{37}, lump.state.size() - 1}) {
            const std::array<std::array<std::size_t, 2>, 6> places{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
            for (std::size_t c = 0; c < 6; ++c) {
                VectorArray unit = zero();
                Vec3 direction = Vec3::Zero();
                direction[static_cast<Eigen::Index>(places[c][0])] = 1;
                unit.set(object, direction);
                const double entry = lump.product(unit).at(object)[static_cast<Eigen::Index>(places[c][1])];
                QVERIFY(std::abs(blocks[c][object] - entry) < 1e-9 * (blocks[0][object] + std::abs(entry)));
            }
        }
        // u A u from connections and slopes one by one.
        const VectorArray u = lump.random(1, 4);
        double sum = 0;
        lump.tangent.forEachConnection([&](ObjectIndex i, ObjectIndex j, const Vec3& root, double across) {
            const Vec3 between = u.at(j) - u.at(i);
            sum += std::pow(root.dot(between), 2) + across * between.squaredNorm();
        });
        for (ObjectIndex i = 0; i < u.size(); ++i) {
            double rate = 0;
            for (const auto& slope : lump.tangent.slopesOf(i))
                rate += slope.gradient.dot(u.at(slope.object));
            sum += lump.tangent.weightOf(i) * rate * rate;
        }
        QVERIFY(std::abs(sum / dot(u, lump.product(u)) - 1) < 1e-9);
    }

    void sameBitsForAnyNumberOfThreads()
    {
        const auto product = [](int threads) {
            return onThreads(threads, [] {
                Lump lump(0.4, {60, 16, 16});
                lump.tangent.update(lump.state.position, step);
                const VectorArray all = lump.product(lump.random(1, 6));
                return std::vector<double>(all.component(0), all.component(0) + all.size());
            });
        };
        const std::vector<double> one = product(1);
        const std::vector<double> two = product(2);
        QVERIFY(std::memcmp(one.data(), two.data(), one.size() * sizeof(double)) == 0);
    }

    void everyInstructionSetGivesTheSameBits()
    {
        constexpr std::size_t count = 1003; // the remainder of every vector width is met
        const auto run = [&](const kernels::TangentKernels& set) {
            std::mt19937 random(5);
            std::uniform_real_distribution<double> value(0.5, 1.5);
            std::vector<std::vector<double>> in(40, std::vector<double>(count));
            for (auto& column : in)
                for (double& entry : column)
                    entry = value(random);
            const auto vectors = [&](std::size_t c) {
                return kernels::ConstVectors{in[c].data(), in[c + 1].data(), in[c + 2].data()};
            };
            std::vector<std::vector<double>> out(40, std::vector<double>(count, 0.25));
            const auto into = [&](std::size_t c) {
                return kernels::Vectors{out[c].data(), out[c + 1].data(), out[c + 2].data()};
            };
            set.connectionTangent(count, vectors(0), vectors(3), in[6].data(), in[7].data(), in[8].data(), 0.1, into(0),
                                  out[3].data());
            set.connectionPull(count, vectors(0), vectors(3), vectors(9), in[12].data(), into(4));
            const double* columns[15];
            for (std::size_t c = 0; c < 15; ++c)
                columns[c] = in[13 + c].data();
            double* blocks[9];
            for (std::size_t c = 0; c < 9; ++c)
                blocks[c] = out[7 + c].data();
            set.addConnectionBlocks(count, vectors(9), in[12].data(), blocks);
            double* gradient[9];
            for (std::size_t c = 0; c < 9; ++c)
                gradient[c] = out[16 + c].data();
            set.dilatationGradient(count, {columns, columns + 9, in[30].data(), 1e-3, 0.1, gradient, out[25].data()});
            const double steps[3] = {1, 0, -1};
            set.combineColumns(count, columns, steps, into(26));
            set.addDilatationRate(count, vectors(0), vectors(3), in[6].data(), vectors(9), out[29].data());
            set.addPressurePull(count, in[6].data(), {in[7].data(), in[8].data()}, {vectors(0), vectors(3)}, into(30));
            set.dot(count, in[0].data(), in[1].data(), out[33].data());
            set.descend(count, 0.3, in[0].data(), in[1].data(), out[34].data(), out[35].data());
            set.turn(count, 0.3, in[0].data(), out[36].data());
            set.multiplyBlocks(count, columns, vectors(0), into(37));
            return out;
        };
        const auto expected = run(kernels::availableTangents().front());
        for (const kernels::TangentKernels& set : kernels::availableTangents()) {
            const auto other = run(set);
            for (std::size_t c = 0; c < expected.size(); ++c)
                QVERIFY2(std::memcmp(other[c].data(), expected[c].data(), count * sizeof(double)) == 0, set.name);
        }
    }
};

QTEST_GUILESS_MAIN(TangentOperatorTest)
#include "tangent_operator_test.moc"
