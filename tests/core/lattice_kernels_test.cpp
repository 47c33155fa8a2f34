#include "core/aggregate/lattice_directions.h"
#include "core/kernels/kernels.h"
#include "core/mechanics/vector_array.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

using namespace knead;
using namespace knead::kernels;

namespace {

using Column = std::vector<double>;

std::vector<Column> randomColumns(std::size_t columns, std::size_t count, double low, double high, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(low, high);
    std::vector<Column> all(columns, Column(count));
    for (Column& column : all)
        for (double& entry : column)
            entry = value(random);
    return all;
}

bool sameBits(const Column& a, const Column& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// An odd count, so that the remainder of every vector width is met too.
constexpr std::size_t count = 1003;

/// A run of objects in three directions, with room around it.
struct Run {
    /// @param alike whether all connections of a direction have the same length and damping time
    explicit Run(std::size_t first, std::size_t last, bool alike)
        : begin(first)
        , end(last)
        , areAlike(alike)
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> value(0.5, 1.5);
        const auto vectors = [&] {
            VectorArray all(size);
            for (std::size_t i = 0; i < size; ++i)
                all.set(i, {value(random), value(random), value(random)});
            return all;
        };
        const auto numbers = [&] {
            LaneVector<double> all(size);
            for (double& entry : all)
                entry = value(random);
            return all;
        };
        position = vectors();
        velocity = vectors();
        for (VectorArray& column : stress)
            column = vectors();
        for (std::size_t d = 0; d < 3; ++d) {
            stiffness[d] = numbers();
            length[d] = numbers();
            time[d] = numbers();
        }
    }

    std::vector<ForceDirection> directions() const
    {
        std::vector<ForceDirection> all;
        for (std::size_t d = 0; d < 3; ++d)
            all.push_back({.offset = std::array{1, 17, 60}[d],
                           .stiffness = stiffness[d].data(),
                           .nominalLength = areAlike || d == 1 ? nullptr : length[d].data(),
                           .dampingTime = areAlike || d == 2 ? nullptr : time[d].data(),
                           .uniformLength = 0.9,
                           .columns = 2,
                           .column = {stress[d].data(), stress[(d + 1) % 3].data(), nullptr},
                           .sign = {1, d == 0 ? 1.0 : -1.0, 0}});
        return all;
    }

    /// Six components of what the objects feel.
    std::vector<Column> forces(const Kernels& kernels, bool volumetric) const
    {
        VectorArray force(size);
        VectorArray damping(size);
        const ForceTarget target{force.data(), damping.data(), static_cast<std::ptrdiff_t>(force.stride())};
        const auto stride = static_cast<std::ptrdiff_t>(position.stride());
        const auto all = directions();
        kernels.addForces({.begin = begin,
                           .end = end,
                           .position = position.data(),
                           .velocity = velocity.data(),
                           .stride = stride,
                           .directions = all.data(),
                           .directionCount = all.size(),
                           .dampingTime = 0.25,
                           .stressStride = volumetric ? stride : 0,
                           .own = target,
                           .neighbors = target});
        std::vector<Column> out;
        for (const VectorArray* array : {&force, &damping})
            for (std::size_t c = 0; c < 3; ++c)
                out.emplace_back(array->component(c), array->component(c) + size);
        return out;
    }

    static constexpr std::size_t size = 400;
    std::size_t begin;
    std::size_t end;
    bool areAlike;
    VectorArray position, velocity;
    std::array<VectorArray, 3> stress;
    std::array<LaneVector<double>, 3> stiffness, length, time;
};

/// Stress of objects whose deformation gradient is diagonal (with K = 1 and a = 1, M is F).
std::vector<Column> diagonalStress(const Kernels& kernels, const Column& stretch)
{
    // Each object at the origin has one connection along each lattice axis; those along u are stretched.
    const std::size_t size = stretch.size();
    VectorArray position(4 * size);
    std::array<std::int32_t, 3> ahead{};
    const std::array<std::int32_t, 3> behind{};
    for (std::size_t d = 0; d < 3; ++d) {
        ahead[d] = static_cast<std::int32_t>((d + 1) * size);
        for (std::size_t i = 0; i < size; ++i)
            position.set((d + 1) * size + i, (d == 0 ? stretch[i] : 1) * Vec3::Unit(static_cast<Eigen::Index>(d)));
    }
    const std::vector<std::uint32_t> hasBehind(size + laneCount, 0);
    const LaneVector<double> zero(size, 0.0);
    const LaneVector<double> one(size, 1.0);
    const std::array<const double*, 3> stiffness{one.data(), one.data(), one.data()};
    std::array<const double*, 6> inverse;
    inverse.fill(zero.data());
    inverse[0] = inverse[1] = inverse[2] = one.data();
    std::vector<Column> out(10, Column(size));
    std::array<double*, 9> stress;
    for (std::size_t c = 0; c < 9; ++c)
        stress[c] = out[c].data();
    kernels.volumetricStress({.at = {.begin = 0,
                                     .end = size,
                                     .position = position.data(),
                                     .stride = static_cast<std::ptrdiff_t>(position.stride()),
                                     .forward = 7,
                                     .backward = 0,
                                     .ahead = ahead.data(),
                                     .behind = behind.data(),
                                     .hasBehind = hasBehind.data(),
                                     .stiffness = stiffness.data(),
                                     .inverseShape = inverse.data(),
                                     .restDilatation = zero.data(),
                                     .spacing = 1},
                              .bulk = one.data(),
                              .stress = stress.data(),
                              .theta = out[9].data()});
    return out;
}

/// All that a flow of objects in a full block writes: stress, dilatation, energy, plastic state.
/// @param shaken size of what is random in places and strains
/// @param share of the flow before; 1: there was none
std::vector<Column> flowingBlock(const Kernels& kernels, double shaken, double share)
{
    constexpr std::int32_t n[3] = {7, 5, 3};
    constexpr std::size_t size = 7 * 5 * 3;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> part(-shaken, shaken);
    VectorArray position(size);
    std::array<LaneVector<double>, latticeDirectionCount> stiffness, strain;
    std::vector<std::uint32_t> hasBehind(size + laneCount, 0);
    std::array<std::int32_t, latticeDirectionCount> offset{};
    for (std::size_t d = 0; d < latticeDirectionCount; ++d) {
        const auto& o = latticeDirections[d];
        offset[d] = (o[0] * n[1] + o[1]) * n[2] + o[2];
        stiffness[d].assign(size, 0);
        strain[d].assign(size, 0);
    }
    for (std::int32_t u = 0; u < n[0]; ++u)
        for (std::int32_t v = 0; v < n[1]; ++v)
            for (std::int32_t w = 0; w < n[2]; ++w) {
                const auto i = static_cast<std::size_t>((u * n[1] + v) * n[2] + w);
                position.set(i, Vec3(u + part(random), v + part(random), w + part(random)));
                for (std::size_t d = 0; d < 9; ++d) {
                    const auto& o = latticeDirections[d];
                    const std::int32_t to[3] = {u + o[0], v + o[1], w + o[2]};
                    if (to[0] < 0 || to[0] >= n[0] || to[1] < 0 || to[1] >= n[1] || to[2] < 0 || to[2] >= n[2])
                        continue;
                    stiffness[d][i] = 1;
                    strain[d][i] = part(random);
                    hasBehind[i + static_cast<std::size_t>(offset[d])] |= std::uint32_t{1} << d;
                }
            }
    std::array<LaneVector<double>, 6> inverse;
    for (auto& component : inverse)
        component.assign(size, 0);
    for (std::size_t i = 0; i < size; ++i) {
        Mat3 shape = Mat3::Zero();
        for (std::size_t d = 0; d < 9; ++d) {
            const Vec3 o(latticeDirections[d][0], latticeDirections[d][1], latticeDirections[d][2]);
            shape += (stiffness[d][i] + ((hasBehind[i] >> d & 1U) != 0 ? 1 : 0)) * o * o.transpose();
        }
        const Mat3 k = shape.inverse();
        const double entries[] = {k(0, 0), k(1, 1), k(2, 2), k(0, 1), k(0, 2), k(1, 2)};
        for (std::size_t c = 0; c < 6; ++c)
            inverse[c][i] = i == 50 ? 0 : entries[c]; // one whose surroundings are flat
    }
    const LaneVector<double> one(size, 1.0);
    const LaneVector<double> zero(size, 0.0);
    const LaneVector<double> yield(size, 0.1);
    std::vector<LaneVector<double>> out(9 + 1 + 1 + 6 + 1 + 1 + 1 + 13 + 13 + 1, LaneVector<double>(size, 0.0));
    out[19].assign(size, share);
    const auto pointers = [&](std::size_t first) {
        std::array<double*, latticeDirectionCount> to{};
        for (std::size_t c = 0; c < to.size() && first + c < out.size(); ++c)
            to[c] = out[first + c].data();
        return to;
    };
    std::array<const double*, latticeDirectionCount> k{}, natural{};
    std::array<const double*, 6> inverseShape{};
    for (std::size_t d = 0; d < latticeDirectionCount; ++d) {
        k[d] = stiffness[d].data();
        natural[d] = strain[d].data();
    }
    for (std::size_t c = 0; c < 6; ++c)
        inverseShape[c] = inverse[c].data();
    const auto stress = pointers(0), metric = pointers(11), affine = pointers(20), lengthening = pointers(33);
    const FlowResult flow{.duration = 1,
                          .connectionStrain = natural.data(),
                          .dilatation = zero.data(),
                          .metric = metric.data(),
                          .equivalentStrain = out[17].data(),
                          .damage = out[18].data(),
                          .share = out[19].data(),
                          .affine = affine.data(),
                          .lengthening = lengthening.data(),
                          .dissipated = out[46].data()};
    const kernels::Surroundings surroundings{.begin = 0,
                                             .end = size,
                                             .position = position.data(),
                                             .stride = static_cast<std::ptrdiff_t>(position.stride()),
                                             .forward = 511,
                                             .backward = 511,
                                             .ahead = offset.data(),
                                             .behind = offset.data(),
                                             .hasBehind = hasBehind.data(),
                                             .stiffness = k.data(),
                                             .inverseShape = inverseShape.data(),
                                             .restDilatation = zero.data(),
                                             .spacing = 1};
    const TensorLawNumbers numbers{.volume = one.data(),
                                   .shear = {.each = one.data()},
                                   .bulk = {.all = 1},
                                   .tensionShare = {.all = 1},
                                   .yieldStress = {.each = yield.data()},
                                   .hardening = {.all = 1},
                                   .flowTime = {.all = 1}};
    kernels.tensorLaw({.at = surroundings,
                       .numbers = numbers,
                       .plastic = {},
                       .flow = &flow,
                       .stress = stress.data(),
                       .theta = out[9].data(),
                       .energy = out[10].data()});
    // Every third object is rubberlike, the last ones all.
    LaneVector<double> isRubber(size, 0.0);
    for (std::size_t i = 0; i < size; ++i)
        isRubber[i] = i % 3 == 0 || i > size - 30 ? 1 : 0;
    kernels.hyperelasticLaw({.at = surroundings,
                             .numbers = numbers,
                             .isRubber = {.each = isRubber.data()},
                             .secondShare = {.each = yield.data()},
                             .inverseChain = {.all = 0.05},
                             .firstScale = {.all = 0.8},
                             .metric = nullptr,
                             .stress = stress.data(),
                             .theta = out[9].data(),
                             .energy = out[10].data()});
    std::vector<Column> columns;
    for (const auto& column : out)
        columns.emplace_back(column.begin(), column.end());
    return columns;
}

/// Force and damping on the first of two objects that a connection joins (k = 10, b / k = 0.5), then on the second.
std::array<Vec3, 4> forceBetween(const VectorArray& position, const VectorArray& velocity, double length)
{
    const LaneVector<double> stiffness(2, 10.0);
    const ForceDirection direction{.offset = 1, .stiffness = stiffness.data(), .uniformLength = length};
    VectorArray force(2);
    VectorArray damping(2);
    const ForceTarget target{force.data(), damping.data(), static_cast<std::ptrdiff_t>(force.stride())};
    best().addForces({.begin = 0,
                      .end = 1,
                      .position = position.data(),
                      .velocity = velocity.data(),
                      .stride = static_cast<std::ptrdiff_t>(position.stride()),
                      .directions = &direction,
                      .directionCount = 1,
                      .dampingTime = 0.5,
                      .own = target,
                      .neighbors = target});
    return {force.at(0), damping.at(0), force.at(1), damping.at(1)};
}

} // namespace

class LatticeKernelsTest : public QObject {
    Q_OBJECT

private slots:
    void everyInstructionSetGivesTheSameBits()
    {
        const auto stretch = randomColumns(1, count, 0.05, 20, 2)[0];
        const auto stress = diagonalStress(available().front(), stretch);
        for (const Kernels& kernels : available()) {
            const auto otherStress = diagonalStress(kernels, stretch);
            for (std::size_t c = 0; c < stress.size(); ++c)
                QVERIFY2(sameBits(stress[c], otherStress[c]), kernels.name);
        }
        for (const std::size_t begin : {0, 3, 8})
            for (const std::size_t end : {9, 40, 300}) // shorter and longer than what is worth aligning
                for (const int kind : {0, 1, 2, 3}) {
                    const bool volumetric = kind % 2 == 1;
                    const Run run(begin, end, kind < 2);
                    const auto forces = run.forces(available().front(), volumetric);
                    for (const Kernels& kernels : available()) {
                        const auto others = run.forces(kernels, volumetric);
                        for (std::size_t c = 0; c < forces.size(); ++c)
                            QVERIFY2(sameBits(forces[c], others[c]), kernels.name);
                    }
                }
    }

    void connectionForceFollowsThePaper()
    {
        VectorArray position(2);
        VectorArray velocity(2);
        position.set(1, {3, 4, 0});
        velocity.set(1, {1, 0, 0});
        const auto force = forceBetween(position, velocity, 4);
        // |d| = 5, stretch 1, v_n = 0.6: spring 10, damper 10 0.5 0.6 = 3, along (0.6, 0.8, 0)
        QVERIFY((force[0] - Vec3(6, 8, 0)).norm() < 1e-12);
        QVERIFY((force[1] - Vec3(1.8, 2.4, 0)).norm() < 1e-12);
        QCOMPARE(force[2], -force[0]);
        QCOMPARE(force[3], -force[1]);
    }

    /// Against a plain sum over connections, objects outside the run untouched.
    void forcesOfARunAreThoseOfItsConnections()
    {
        for (const int kind : {0, 1, 2, 3}) {
            const bool volumetric = kind % 2 == 1;
            const Run run(5, 331, kind < 2);
            const auto forces = run.forces(best(), volumetric);
            std::vector<Vec3> expected(2 * Run::size, Vec3::Zero());
            for (const ForceDirection& direction : run.directions())
                for (std::size_t i = run.begin; i < run.end; ++i) {
                    const std::size_t j = i + static_cast<std::size_t>(direction.offset);
                    const Vec3 d = run.position.at(j) - run.position.at(i);
                    const double k = direction.stiffness[i];
                    const double l = direction.nominalLength ? direction.nominalLength[i] : direction.uniformLength;
                    const double time = direction.dampingTime ? direction.dampingTime[i] : 0.25;
                    const Vec3 n = d.normalized();
                    Vec3 pull = k * (d.norm() - l) * n;
                    if (volumetric)
                        for (int c = 0; c < direction.columns; ++c)
                            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                                const double* component =
                                    direction.column[c] + axis * static_cast<std::ptrdiff_t>(run.stress[0].stride());
                                pull[axis] += k * direction.sign[c] * (component[i] + component[j]);
                            }
                    const Vec3 brake = k * time * (run.velocity.at(j) - run.velocity.at(i)).dot(n) * n;
                    expected[i] += pull;
                    expected[j] -= pull;
                    expected[Run::size + i] += brake;
                    expected[Run::size + j] -= brake;
                }
            for (std::size_t i = 0; i < 2 * Run::size; ++i)
                for (std::size_t c = 0; c < 3; ++c) {
                    const double value = forces[c + (i < Run::size ? 0 : 3)][i % Run::size];
                    const double wanted = expected[i][static_cast<Eigen::Index>(c)];
                    QVERIFY(std::abs(value - wanted) <= 1e-12 * (1 + std::abs(wanted)));
                }
        }
    }

    /// A block of 7 x 5 x 3 objects about a cube, flowing and hardly strained: every lane and every remainder is met.
    void theTensorLawGivesTheSameBitsOnEveryInstructionSet()
    {
        for (const double shaken : {0.2, 0.002})
            for (const double share : {0.5, 1.0}) {
                const auto first = flowingBlock(available().front(), shaken, share);
                for (const Kernels& kernels : available()) {
                    const auto other = flowingBlock(kernels, shaken, share);
                    for (std::size_t c = 0; c < first.size(); ++c)
                        QVERIFY2(sameBits(first[c], other[c]), kernels.name);
                }
            }
    }

    void nominalLengthsFollowTheFlowOfTheirEnds()
    {
        const auto v = randomColumns(10, count, 0.8, 1.2, 3);
        const Column share = randomColumns(1, count, 0, 1, 4)[0];
        const Column affine = randomColumns(1, count, -0.1, 0.1, 5)[0];
        const auto lengthened = [&](const Kernels& kernels, double& dissipated) {
            Column strain(count);
            Column after(count);
            Column lanes(sumLanes, 0.0);
            Column work(sumLanes, 0.0);
            const ConstVectors lower{v[0].data(), v[1].data(), v[2].data()};
            const Column far = randomColumns(1, count, 1.8, 2.4, 6)[0];
            const ConstVectors upper{far.data(), v[4].data(), v[5].data()};
            kernels.naturalStrain(count, lower, upper, v[6].data(), strain.data());
            kernels.lengthen(count, {.lower = lower,
                                     .upper = upper,
                                     .strain = strain.data(),
                                     .lowerShare = share.data(),
                                     .upperShare = v[9].data(),
                                     .lowerAffine = affine.data(),
                                     .upperAffine = affine.data(),
                                     .lowerLengthening = v[7].data(),
                                     .upperLengthening = v[8].data(),
                                     .stiffness = v[3].data(),
                                     .before = v[6].data(),
                                     .after = after.data(),
                                     .dissipated = lanes.data(),
                                     .work = work.data()});
            dissipated = 0;
            for (const double lane : lanes)
                dissipated += lane;
            double expected = 0;
            double expectedWork = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const double length = std::hypot(far[i] - v[0][i], v[4][i] - v[1][i], v[5][i] - v[2][i]);
                const double beyond = std::log(length / v[6][i]) - affine[i];
                const double wanted =
                    v[6][i] * std::pow(v[7][i] * v[8][i], 0.25) * std::exp(beyond * (1 - 0.5 * (share[i] + v[9][i])));
                if (std::abs(after[i] / wanted - 1) > 2e-3)
                    return Column();
                expected += 0.5 * v[3][i] * (std::pow(length - v[6][i], 2) - std::pow(length - after[i], 2));
                expectedWork += v[3][i] * (length - after[i]) * (after[i] - v[6][i]);
            }
            const bool isRight = std::abs(std::accumulate(work.begin(), work.end(), 0.0) / expectedWork - 1) < 1e-9 &&
                                 std::abs(dissipated / expected - 1) < 1e-9;
            return isRight ? after : Column();
        };
        double dissipated = 0;
        const Column first = lengthened(available().front(), dissipated);
        QVERIFY(!first.empty());
        for (const Kernels& kernels : available()) {
            double other = 0;
            QVERIFY2(sameBits(lengthened(kernels, other), first), kernels.name);
            QCOMPARE(other, dissipated);
        }
    }

    /// As steps have them, in rows of eight as in their remainder; where no end flows nothing changes.
    void smallFlowsLengthenExactly()
    {
        const auto v = randomColumns(4, count, 0.8, 1.2, 3);
        const auto small = randomColumns(4, count, -0.01, 0.01, 4);
        const Column &before = v[3], &stretch = small[0], &affine = small[1];
        std::array<Column, 2> share{Column(count, 1.0), Column(count, 1.0)};
        std::array<Column, 2> lengthening{Column(count, 1.0), Column(count, 1.0)};
        Column upper(count);
        for (std::size_t i = 0; i < count; ++i) {
            upper[i] = v[0][i] + before[i] * (1 + stretch[i]);
            for (std::size_t end = 0; end < 2; ++end)
                if (i / 16 % 3 == end ||
                    i % 80 == 0) { // sixteen of which one end flows, of which the other, of which none
                    share[end][i] = 0.9 + 10 * small[2 + end][i];
                    lengthening[end][i] = 1 + small[2 + end][i];
                }
        }
        for (const Kernels& kernels : available()) {
            const ConstVectors from{v[0].data(), v[1].data(), v[2].data()};
            const ConstVectors to{upper.data(), v[1].data(), v[2].data()};
            Column strain(count);
            Column after(count, 99.0);
            Column dissipated(sumLanes, 0.0);
            Column work(sumLanes, 0.0);
            kernels.naturalStrain(count, from, to, before.data(), strain.data());
            kernels.lengthen(count, {.lower = from,
                                     .upper = to,
                                     .strain = strain.data(),
                                     .lowerShare = share[0].data(),
                                     .upperShare = share[1].data(),
                                     .lowerAffine = affine.data(),
                                     .upperAffine = affine.data(),
                                     .lowerLengthening = lengthening[0].data(),
                                     .upperLengthening = lengthening[1].data(),
                                     .stiffness = v[1].data(),
                                     .before = before.data(),
                                     .after = after.data(),
                                     .dissipated = dissipated.data(),
                                     .work = work.data()});
            double expected = 0;
            for (std::size_t i = 0; i < count; ++i) {
                QVERIFY2(std::abs(strain[i] - std::log1p((upper[i] - v[0][i]) / before[i] - 1)) < 1e-15, kernels.name);
                const double shares = share[0][i] + share[1][i];
                const double wanted = before[i] * std::pow(lengthening[0][i] * lengthening[1][i], 0.25) *
                                      std::exp((strain[i] - affine[i]) * (1 - 0.5 * shares));
                QVERIFY2(std::abs(after[i] / wanted - 1) < 1e-12, kernels.name);
                if (shares == 2)
                    QVERIFY2(after[i] == before[i], kernels.name);
                const double length = upper[i] - v[0][i];
                expected += 0.5 * v[1][i] * (std::pow(length - before[i], 2) - std::pow(length - after[i], 2));
            }
            const double sum = std::accumulate(dissipated.begin(), dissipated.end(), 0.0);
            QVERIFY2(std::abs(sum / expected - 1) < 1e-9, kernels.name);
        }
    }

    /// What is no number stays none, and is not taken for a length.
    void noNumberStaysNone()
    {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        const Column zero(11, 0.0), one(11, 1.0), nothing(11, none);
        for (const Kernels& kernels : available()) {
            for (const bool ofShare : {false, true}) {
                Column after(11, 99.0);
                Column sums(2 * sumLanes, 0.0);
                const ConstVectors at{zero.data(), zero.data(), zero.data()};
                const ConstVectors to{one.data(), zero.data(), zero.data()};
                const Column half(11, 0.5);
                kernels.lengthen(11, {.lower = at,
                                      .upper = to,
                                      .strain = ofShare ? zero.data() : nothing.data(),
                                      .lowerShare = ofShare ? nothing.data() : half.data(),
                                      .upperShare = one.data(),
                                      .lowerAffine = zero.data(),
                                      .upperAffine = zero.data(),
                                      .lowerLengthening = one.data(),
                                      .upperLengthening = one.data(),
                                      .stiffness = one.data(),
                                      .before = one.data(),
                                      .after = after.data(),
                                      .dissipated = sums.data(),
                                      .work = sums.data() + sumLanes});
                for (const double length : after)
                    QVERIFY2(std::isnan(length), kernels.name);
            }
        }
    }

    /// Beside sums in plain loops; and on every set to the same bits.
    void fitsAreSumsOverTheNodesInTheSupport()
    {
        constexpr std::size_t nodes = 40;
        constexpr double support = 3;
        constexpr double coefficients[10] = {1, -2, 0.5, 3, 0.25, -1, 2, 0.75, -0.5, 1.5};
        const std::vector<Column> drawn = randomColumns(4, nodes, 0, 1, 3);
        std::array<std::vector<float>, 3> steps;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const double share : drawn[axis])
                steps[axis].push_back(static_cast<float>(std::lround(6 * share - 3)));
        constexpr double point[3] = {0.3, -0.2, 0.4};
        const Column& share = drawn[3];

        const auto weightOf = [&](double distance, double part) {
            const double r = std::min(1.0, distance / support);
            return part * std::pow(1 - r, 3) * (3 * r + 1);
        };
        std::vector<Column> first;
        for (const Kernels& kernels : available()) {
            std::vector<Column> place(3, Column(nodes));
            Column distance(nodes);
            const double nearest =
                kernels.lookAround(nodes, {steps[0].data(), steps[1].data(), steps[2].data()}, point,
                                   {place[0].data(), place[1].data(), place[2].data()}, distance.data());
            QCOMPARE(nearest, *std::ranges::min_element(distance));
            const FitNodes there{
                {place[0].data(), place[1].data(), place[2].data()}, distance.data(), share.data(), nodes};
            const FitContent content = kernels.content(there, support);
            const double further = 1e-6;
            const double slope =
                (kernels.content(there, support + further).count - kernels.content(there, support - further).count) /
                (2 * further);
            Column weight(nodes);
            Column values(nodes);
            double sums[FitMonomials::count];
            kernels.moments(there, support, weight.data(), sums);
            const double amplification = kernels.functions(there, support, weight.data(), coefficients, values.data());

            double count = 0;
            double absolute = 0;
            std::array<double, FitMonomials::count> wanted{};
            for (std::size_t i = 0; i < nodes; ++i) {
                const double x = steps[0][i] - point[0];
                const double y = steps[1][i] - point[1];
                const double z = steps[2][i] - point[2];
                const double one = weightOf(std::sqrt(x * x + y * y + z * z), share[i]);
                QVERIFY(std::abs(weight[i] - one) < 1e-15);
                count += one;
                for (std::size_t k = 0; k < FitMonomials::count; ++k)
                    wanted[k] += one * std::pow(x / support, fitMonomials.powers[k][0]) *
                                 std::pow(y / support, fitMonomials.powers[k][1]) *
                                 std::pow(z / support, fitMonomials.powers[k][2]);
                const std::array<double, 3> p{x / support, y / support, z / support};
                const std::array<double, 10> basis{1,           p[0],        p[1],        p[2],        p[0] * p[0],
                                                   p[1] * p[1], p[2] * p[2], p[0] * p[1], p[1] * p[2], p[2] * p[0]};
                const double value =
                    one * std::inner_product(basis.begin(), basis.end(), std::begin(coefficients), 0.0);
                QVERIFY(std::abs(values[i] - value) < 1e-14);
                absolute += std::abs(value);
            }
            QVERIFY(std::abs(content.count - count) < 1e-13);
            QVERIFY(std::abs(content.slope - slope) < 1e-7);
            QVERIFY(std::abs(amplification - absolute) < 1e-13);
            for (std::size_t k = 0; k < FitMonomials::count; ++k)
                QVERIFY(std::abs(sums[k] - wanted[k]) < 1e-14);

            place.insert(place.end(), {distance, weight, values, Column(std::begin(sums), std::end(sums)),
                                       Column{content.count, content.slope, amplification}});
            if (first.empty())
                first = place;
            for (std::size_t column = 0; column < place.size(); ++column)
                QVERIFY2(sameBits(place[column], first[column]), kernels.name);
        }
    }

    void squashedSurroundingsArePushedBackByTheGradientOfAnEnergy()
    {
        // theta goes on as its tangent below a tenth of the volume: theta(J) = ln 0.1 + J / 0.1 - 1, p = theta / 0.1.
        const Column ratios{0.05, 0.0, -0.5};
        const auto out = diagonalStress(best(), ratios);
        for (std::size_t i = 0; i < ratios.size(); ++i) {
            const double theta = std::log(0.1) + ratios[i] / 0.1 - 1;
            QVERIFY(std::abs(out[9][i] - theta) < 1e-13);
            QVERIFY(std::abs(out[0][i] - theta / 0.1) < 1e-12);
        }
        QVERIFY(std::abs(out[9][1] - flatDilatation) < 1e-12);
    }

    void aSingleLongConnectionIsFound()
    {
        const Column zero(count, 0.0);
        const Column one(count, 1.0);
        for (const Kernels& kernels : available())
            for (const std::size_t place : {std::size_t{0}, count / 2, count - 1}) {
                Column x(count, 1.2);
                const ConstVectors self{zero.data(), zero.data(), zero.data()};
                const ConstVectors neighbor{x.data(), zero.data(), zero.data()};
                QVERIFY(!kernels.anyLonger(count, self, neighbor, one.data(), one.data(), 1.21));
                x[place] = -1.22;
                QVERIFY2(kernels.anyLonger(count, self, neighbor, one.data(), one.data(), 1.21), kernels.name);
                Column stiffness = one;
                stiffness[place] = 0;
                QVERIFY(!kernels.anyLonger(count, self, neighbor, stiffness.data(), one.data(), 1.21));
            }
    }

    void coincidentObjectsGiveNoForce()
    {
        for (const Vec3& force : forceBetween(VectorArray(2), VectorArray(2), 1))
            QCOMPARE(force, Vec3(Vec3::Zero()));
    }

    void dilatationIsTheLogarithmOfTheVolumeRatio()
    {
        const Column stretch{0.1, 0.25, 0.5, 0.70710678118654752, 0.99, 1.0, 1.0000001, 1.41421356, 2.0, 7.5, 1e3};
        const auto out = diagonalStress(best(), stretch);
        for (std::size_t i = 0; i < stretch.size(); ++i) {
            const double expected = std::log(stretch[i]);
            QVERIFY2(std::abs(out[9][i] - expected) <= 4e-16 * std::max(1.0, std::abs(expected)),
                     qPrintable(QString::number(stretch[i])));
            // p F^-T: the first entry is theta / stretch, the second theta.
            QVERIFY(std::abs(out[0][i] - expected / stretch[i]) <=
                    1e-14 * std::max(1.0, std::abs(expected / stretch[i])));
            QVERIFY(std::abs(out[4][i] - expected) <= 1e-14 * std::max(1.0, std::abs(expected)));
        }
    }
};

QTEST_GUILESS_MAIN(LatticeKernelsTest)
#include "lattice_kernels_test.moc"
