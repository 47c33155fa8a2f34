#include "core/kernels/kernels.h"
#include "core/mechanics/tangent_operator.h"
#include "support/scenes.h"
#include "support/thread_limit.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <random>
#include <tuple>

using namespace knead;

namespace {

constexpr double spacing = 2e-3;
constexpr double step = 1.0 / 60;
constexpr double singlePrecision = 2e-6;

struct Lump {
    explicit Lump(double poisson, const Eigen::Vector3i& cells = {6, 4, 5})
        : aggregate(std::make_shared<const Aggregate>(
              fill(shapes::box(spacing * cells.cast<double>()), {.spacing = spacing})))
        , materials(Material{.poissonRatio = poisson, .dampingRatio = 0.1}, aggregate->size())
        , connections(aggregate, materials)
        , state(objectsAtRest(*aggregate))
        , tangent(connections, state.mass)
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

    /// Less that of the masses.
    VectorArray product(const VectorArray& u)
    {
        FloatArray own(tangent.places().size());
        FloatArray product(tangent.places().size());
        for (std::size_t i = 0; i < u.size(); ++i)
            own.set(tangent.places().of(static_cast<ObjectIndex>(i)), u.at(i));
        energy = tangent.multiply(own.data(), product.data(), own.stride());
        VectorArray result(u.size());
        for (std::size_t i = 0; i < u.size(); ++i)
            result.set(i, product.at(tangent.places().of(static_cast<ObjectIndex>(i))) - state.mass[i] * u.at(i));
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
    double energy = 0; ///< u A u of the last product, with the masses
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
            QVERIFY2(difference(lump.product(u), lump.changeOfForces(u)) < singlePrecision,
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
        QVERIFY(difference(lump.product(u), lump.changeOfForces(u)) < singlePrecision);
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
            QVERIFY(std::abs(dot(v, Au) - dot(u, Av)) < singlePrecision * norm(u) * norm(Av));
            QVERIFY(dot(u, Au) > 0);
            double kinetic = 0;
            for (std::size_t i = 0; i < v.size(); ++i)
                kinetic += lump.state.mass[i] * v.at(i).squaredNorm();
            QVERIFY(std::abs(lump.energy / (dot(v, Av) + kinetic) - 1) < singlePrecision);
            Vec3 total = Vec3::Zero();
            for (std::size_t i = 0; i < Au.size(); ++i)
                total += Au.at(i);
            QVERIFY(total.norm() < singlePrecision * norm(Au));
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
            blocks[c].assign(lump.tangent.places().size(), 0);
            pointers[c] = blocks[c].data();
        }
        lump.tangent.findDiagonal(pointers);
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
                const std::size_t slot = lump.tangent.places().of(static_cast<ObjectIndex>(object));
                const double mass = c < 3 ? lump.state.mass[object] : 0;
                QVERIFY(std::abs(blocks[c][slot] - mass - entry) < singlePrecision * blocks[0][slot]);
            }
        }
        // u A u from connections and slopes one by one.
        const VectorArray u = lump.random(1, 4);
        double sum = 0;
        lump.tangent.forEachConnection([&](ObjectIndex i, ObjectIndex j, const Vec3& root, double across) {
            const Vec3 between = u.at(j) - u.at(i);
            sum += std::pow(root.dot(between), 2) + across * between.squaredNorm();
        });
        std::vector<TangentOperator::Slope> slopes;
        for (ObjectIndex i = 0; i < u.size(); ++i) {
            double rate = 0;
            lump.tangent.slopesOf(i, slopes);
            for (const auto& slope : slopes)
                rate += slope.gradient.dot(u.at(slope.object));
            sum += rate * rate;
        }
        QVERIFY(std::abs(sum / dot(u, lump.product(u)) - 1) < singlePrecision);
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
        const auto run = [&](const kernels::Kernels& set) {
            std::mt19937 random(5);
            std::uniform_real_distribution<double> value(0.5, 1.5);
            std::vector<LaneVector<double>> in(40, LaneVector<double>(count));
            for (auto& column : in)
                for (double& entry : column)
                    entry = value(random);
            const auto vectors = [&](std::size_t c) {
                return kernels::ConstVectors{in[c].data(), in[c + 1].data(), in[c + 2].data()};
            };
            std::vector<LaneVector<double>> out(8, LaneVector<double>(count, 0.25));
            std::vector<LaneVector<float>> single(40, LaneVector<float>(count, 0.25F));
            set.connectionTangent(count, vectors(0), vectors(3), in[6].data(), in[7].data(), in[8].data(), 0.1,
                                  {single[0].data(), single[1].data(), single[2].data()}, single[3].data());
            const double* columns[15];
            for (std::size_t c = 0; c < 15; ++c)
                columns[c] = in[13 + c].data();
            float* gradient[9];
            float* inverse[6];
            for (std::size_t c = 0; c < 9; ++c)
                gradient[c] = single[4 + c].data();
            for (std::size_t c = 0; c < 6; ++c)
                inverse[c] = single[13 + c].data();
            set.dilatationGradient(count, {columns, columns + 9, in[30].data(), 1e-3, 0.1, gradient});
            set.invertBlocks(count, columns, inverse);
            set.addShape(count, vectors(0), vectors(3), in[6].data(), -1,
                         {out[0].data(), out[1].data(), out[2].data()});
            set.dot(count, in[0].data(), in[1].data(), out[3].data());
            set.descend(count, 0.3F, single[0].data(), single[1].data(), single[19].data(), single[20].data());
            set.turn(count, 0.3F, single[0].data(), single[21].data());
            return std::pair(out, single);
        };
        const auto expected = run(kernels::available().front());
        for (const kernels::Kernels& set : kernels::available()) {
            const auto other = run(set);
            for (std::size_t c = 0; c < expected.first.size(); ++c)
                QVERIFY2(std::memcmp(other.first[c].data(), expected.first[c].data(), count * sizeof(double)) == 0,
                         set.name);
            for (std::size_t c = 0; c < expected.second.size(); ++c)
                QVERIFY2(std::memcmp(other.second[c].data(), expected.second[c].data(), count * sizeof(float)) == 0,
                         set.name);
        }
    }

    void everyInstructionSetGivesTheSameBitsBySlots()
    {
        // Six blocks in two rows side by side, with empty slotCount around them.
        constexpr std::size_t slotCount = 80;
        std::vector<SlotBlock> blocks;
        for (const std::uint32_t first : {8U, 16U, 24U, 40U, 48U, 56U}) {
            SlotBlock block{first, {}};
            for (std::int32_t& offset : block.offset)
                offset = 72 - static_cast<std::int32_t>(first);
            block.offset[4] = 0;
            block.offset[first < 32 ? 7 : 1] = first < 32 ? 32 : -32;
            blocks.push_back(block);
        }
        const auto run = [&](const kernels::Kernels& set) {
            std::mt19937 random(7);
            std::uniform_real_distribution<float> value(0.5F, 1.5F);
            // 13 directions of 5 arrays, 9 of gradients, mass, 3 of u and of arms.
            std::vector<float> in(slotCount * (65 + 16) + 64, 0);
            for (std::size_t array = 0; array < 81; ++array)
                for (const SlotBlock& block : blocks)
                    for (std::size_t lane = 0; lane < 8; ++lane)
                        in[array * slotCount + block.first + lane] = value(random);
            std::vector<float> out(slotCount * 30 + 64, 0);
            std::vector<double> diagonal(6 * slotCount, 0);
            kernels::SlotTangent tangent{};
            tangent.stride = tangent.vectorStride = slotCount;
            for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
                tangent.root[d] = &in[5 * d * slotCount];
                tangent.across[d] = &in[(5 * d + 3) * slotCount];
                tangent.stiffness[d] = &in[(5 * d + 4) * slotCount];
            }
            tangent.gradient = &in[65 * slotCount];
            tangent.pressure = &out[0];
            tangent.mass = &in[74 * slotCount];
            const float* u = &in[75 * slotCount];
            const float* arm = &in[78 * slotCount];
            set.slotPressures(blocks.size(), blocks.data(), tangent, u);
            const double energy = set.slotProduct(blocks.size(), blocks.data(), tangent, u, &out[9 * slotCount]);
            double* own[6];
            for (std::size_t c = 0; c < 6; ++c)
                own[c] = &diagonal[c * slotCount];
            set.slotDiagonal(blocks.size(), blocks.data(), tangent, own);
            const float* columns[6];
            for (std::size_t c = 0; c < 6; ++c)
                columns[c] = &in[c * slotCount];
            set.multiplyBlocks(slotCount, columns, u, &out[12 * slotCount], slotCount);
            const double dot = set.floatDot(slotCount, u, arm);
            const std::uint32_t fours[] = {8, 20, 44};
            set.restrictFours(3, fours, u, arm, slotCount, &out[15 * slotCount]);
            const std::int32_t motion[] = {-1, -1, 0, 1, -1, 0};
            set.prolongFours(6, motion, &in[8], arm, &out[16 * slotCount], slotCount);
            const std::uint32_t begin[] = {0, 1, 3, 4};
            const std::uint32_t behind[] = {0, 2, 4};
            const std::uint32_t matrixColumns[] = {1, 0, 2, 1};
            const kernels::BlockRows rows{3, begin, behind, matrixColumns, &in[16], &in[5 * slotCount]};
            set.sweepAhead(rows, &in[8], &out[19 * slotCount]);
            set.leftAfterSweep(rows, &out[19 * slotCount], &out[20 * slotCount]);
            set.sweepBack(rows, &in[8], &out[19 * slotCount]);
            return std::tuple(out, diagonal, energy, dot);
        };
        const auto expected = run(kernels::available().front());
        QVERIFY(std::get<2>(expected) > 0);
        for (const kernels::Kernels& set : kernels::available())
            QVERIFY2(run(set) == expected, set.name);
    }
};

QTEST_GUILESS_MAIN(TangentOperatorTest)
#include "tangent_operator_test.moc"
