#include "core/simulation/carried_state.h"

#include "core/aggregate/pieces.h"
#include "core/mechanics/object_strain.h"
#include "core/skin/shape_functions.h"
#include "core/task/parallel.h"
#include "core/vicinity/point_grid.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace knead {

namespace {

constexpr std::size_t objectsPerBlock = 256;
constexpr std::size_t mostAround = 16; // old objects that one new object is told by
constexpr double supportShare = 1.15;  // of the distance to the last of them

constexpr int connectionsOfCorner = 6;     // that an object has at least in a sound lattice
constexpr double mostDilatation = 0.5;     // elastic, in a body with cracks: beyond it is none of the material
constexpr double suspectDilatation = 0.05; // elastic, from where on it is looked at whether the neighbors have it, too

using Vec6 = Eigen::Matrix<double, 6, 1>;

Vec6 packed(const Mat3& m)
{
    Vec6 c;
    c << m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2);
    return c;
}

Mat3 unpacked(const Vec6& c)
{
    Mat3 m;
    m << c[0], c[3], c[4], c[3], c[1], c[5], c[4], c[5], c[2];
    return m;
}

Mat3 exponential(const Mat3& symmetric)
{
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(symmetric);
    return solver.eigenvectors() * solver.eigenvalues().array().exp().matrix().asDiagonal() *
           solver.eigenvectors().transpose();
}

/// Per object.
std::vector<int> liveConnections(const Aggregate& aggregate, std::span<const BrokenConnection> broken)
{
    std::vector<int> count(aggregate.size(), connectionsOfCorner);
    if (broken.empty())
        return count;
    std::fill(count.begin(), count.end(), 0);
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
            for (ObjectIndex i = segment.begin; i < segment.end; ++i)
                if (aggregate.weight[d][i] > 0 && (isBroken[i] >> d & 1U) == 0) {
                    ++count[i];
                    ++count[i + static_cast<ObjectIndex>(segment.offset)];
                }
    return count;
}

/// A sliver of the surface that a tool has squashed does not say how the material around it is strained: objects whose dilatation is
/// far from the median of their neighbors' go on with the mean of these.
/// @param elastic strain per object, packed @param isTold per object, by which the strain is known at all
void evenOut(std::vector<Vec6>& elastic, const std::vector<std::uint8_t>& isTold, const Aggregate& aggregate,
             std::span<const BrokenConnection> broken)
{
    const auto dilatation = [&](ObjectIndex i) { return elastic[i].head<3>().sum(); };
    std::map<ObjectIndex, std::vector<ObjectIndex>> neighbors;
    for (ObjectIndex i = 0; i < elastic.size(); ++i)
        if (std::abs(dilatation(i)) > suspectDilatation)
            neighbors[i];
    if (neighbors.empty())
        return;
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : aggregate.lattice.segments[d])
            for (ObjectIndex i = segment.begin; i < segment.end; ++i) {
                const ObjectIndex upper = i + static_cast<ObjectIndex>(segment.offset);
                if (aggregate.weight[d][i] <= 0 || (isBroken[i] >> d & 1U) != 0)
                    continue;
                if (const auto found = neighbors.find(i); found != neighbors.end() && isTold[upper] != 0)
                    found->second.push_back(upper);
                if (const auto found = neighbors.find(upper); found != neighbors.end() && isTold[i] != 0)
                    found->second.push_back(i);
            }
    std::vector<std::pair<ObjectIndex, Vec6>> evened;
    for (auto& [object, around] : neighbors) {
        if (around.empty())
            continue;
        const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
        std::ranges::nth_element(around, middle, {}, dilatation);
        const double median = dilatation(*middle);
        if (std::abs(dilatation(object) - median) <= std::max(suspectDilatation, std::abs(median)))
            continue;
        Vec6 sum = Vec6::Zero();
        double count = 0;
        for (const ObjectIndex one : around)
            if (std::abs(dilatation(one) - median) <= std::max(suspectDilatation, std::abs(median))) {
                sum += elastic[one];
                ++count;
            }
        evened.emplace_back(object, sum / count);
    }
    for (const auto& [object, strain] : evened)
        elastic[object] = strain;
}

} // namespace

CarriedState::CarriedState(const StructuralConnections& before, const ObjectState& state, const NewFilling& filling)
    : m_before(before)
    , m_state(state)
    , m_filling(filling)
    , m_aggregate(*filling.aggregate)
    , m_first(filling.aggregate->size() + 1, 0)
{
    findAround();
}

void CarriedState::findAround()
{
    const double spacing = m_before.aggregate().lattice.spacing;
    struct OldObjects {
        std::vector<ObjectIndex> numbers;
        VectorArray places;
    };
    std::vector<OldObjects> old(m_filling.pieces);
    for (ObjectIndex i = 0; i < m_state.size(); ++i)
        old[m_filling.pieceOfOld[i]].numbers.push_back(i);
    std::vector<PointGrid> grids;
    for (OldObjects& piece : old) {
        piece.places.resize(piece.numbers.size());
        for (std::size_t i = 0; i < piece.numbers.size(); ++i)
            piece.places.set(i, m_state.position.at(piece.numbers[i]));
        grids.emplace_back(piece.places, spacing);
    }
    const std::size_t count = m_aggregate.size();
    std::vector<std::vector<Around>> lists(count);
    forEachBlock(count, objectsPerBlock, [&](std::size_t begin, std::size_t end) {
        std::vector<PointGrid::Found> found;
        std::vector<Vec3> offsets;
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3 place = m_filling.places.at(i);
            const std::uint32_t piece = m_filling.pieceOfNew[i];
            grids[piece].nearest(place, mostAround, found);
            offsets.clear();
            for (PointGrid::Found& one : found) {
                one.point = old[piece].numbers[one.point];
                offsets.push_back((m_state.position.at(one.point) - place) / spacing);
            }
            const std::vector<double> shares = shapeFunctions(offsets, supportShare * offsets.back().norm());
            for (std::size_t k = 0; k < found.size(); ++k)
                if (shares[k] != 0)
                    lists[i].push_back({found[k].point, shares[k]});
        }
    });
    for (std::size_t i = 0; i < count; ++i) {
        m_first[i + 1] = m_first[i] + lists[i].size();
        m_around.insert(m_around.end(), lists[i].begin(), lists[i].end());
    }
}

VectorArray CarriedState::velocities(const LaneVector<double>& mass) const
{
    struct Momentum {
        double mass = 0;
        Vec3 linear = Vec3::Zero();
        Vec3 center = Vec3::Zero();
        Vec3 angular = Vec3::Zero();
        Mat3 inertia = Mat3::Zero();
    };
    const auto momentumOf = [](const std::vector<std::uint32_t>& pieceOf, std::uint32_t piece, const auto& masses,
                               const VectorArray& places, const VectorArray& velocities) {
        Momentum sum;
        const auto massOf = [&](std::size_t i) { return static_cast<double>(masses[i]); };
        const auto placeOf = [&](std::size_t i) { return places.at(i); };
        const auto velocityOf = [&](std::size_t i) { return velocities.at(i); };
        for (std::size_t i = 0; i < pieceOf.size(); ++i) {
            if (pieceOf[i] != piece)
                continue;
            sum.mass += massOf(i);
            sum.center += massOf(i) * placeOf(i);
        }
        sum.center /= sum.mass;
        for (std::size_t i = 0; i < pieceOf.size(); ++i) {
            if (pieceOf[i] != piece)
                continue;
            const Vec3 arm = placeOf(i) - sum.center;
            const double m = massOf(i);
            sum.linear += m * velocityOf(i);
            sum.angular += m * arm.cross(velocityOf(i));
            sum.inertia += m * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
        }
        return sum;
    };
    VectorArray velocities(m_aggregate.size());
    for (ObjectIndex i = 0; i < velocities.size(); ++i) {
        Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
        Vec3 high = -low;
        Vec3 sum = Vec3::Zero();
        for (const Around& one : around(i)) {
            const Vec3 velocity = m_state.velocity.at(one.object);
            sum += one.share * velocity;
            low = low.cwiseMin(velocity);
            high = high.cwiseMax(velocity);
        }
        velocities.set(i, sum.cwiseMax(low).cwiseMin(high));
    }
    for (std::uint32_t piece = 0; piece < m_filling.pieces; ++piece) {
        const Momentum before =
            momentumOf(m_filling.pieceOfOld, piece, m_state.mass, m_state.position, m_state.velocity);
        const Momentum now = momentumOf(m_filling.pieceOfNew, piece, mass, m_filling.places, velocities);
        // The same velocity of the whole, and the same turn: mass may differ in the last digits of the volume.
        const Vec3 push = before.linear / before.mass - now.linear / now.mass;
        const Vec3 spin = before.inertia.ldlt().solve(before.angular) - now.inertia.ldlt().solve(now.angular);
        if (push.allFinite() && spin.allFinite())
            for (std::size_t i = 0; i < velocities.size(); ++i)
                if (m_filling.pieceOfNew[i] == piece)
                    velocities.add(i, push + spin.cross(m_filling.places.at(i) - now.center));
    }
    return velocities;
}

StructuralConnections::Changes CarriedState::changes(const MaterialMap& materials) const
{
    const StructuralConnections::Changes& old = m_before.changes();
    const Aggregate& from = m_before.aggregate();
    RelaxedState relaxed{.materials = materials};
    for (std::size_t n = 0; n < 6; ++n) {
        relaxed.metric[n].resize(old.plastic.metric[n].size());
        for (std::size_t i = 0; i < relaxed.metric[n].size(); ++i)
            relaxed.metric[n][i] =
                static_cast<float>(old.plastic.metric[n][i] * std::exp(2.0 / 3 * old.restDilatation[i]));
    }
    std::vector<Vec3> displacements(from.size());
    for (ObjectIndex i = 0; i < from.size(); ++i)
        displacements[i] = m_state.position.at(i) - from.lattice.position(i);
    const ObjectStrains strains(from, displacements, relaxed, old.broken);
    // What hangs on a few connections beside cracks says nothing of how the material around it is strained.
    const std::vector<int> connections = liveConnections(from, old.broken);
    std::vector<Vec6> elastic(from.size(), Vec6::Zero());
    std::vector<std::uint8_t> isTold(from.size(), 0);
    forEachBlock(from.size(), objectsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (connections[i] < connectionsOfCorner)
                continue;
            const Mat3 strain = strains.elastic(static_cast<ObjectIndex>(i)).strain;
            if (old.broken.empty() || std::abs(strain.trace()) < mostDilatation) {
                elastic[i] = packed(strain);
                isTold[i] = 1;
            }
        }
    });

    evenOut(elastic, isTold, from, old.broken);

    const std::size_t count = m_aggregate.size();
    const Mat3& axes = m_aggregate.lattice.axes;
    StructuralConnections::Changes changes;
    for (auto& component : changes.plastic.metric)
        component.assign(count, 0);
    changes.plastic.equivalentStrain.assign(count, 0);
    changes.plastic.damage.assign(count, 0);
    changes.restDilatation.assign(count, 0);
    std::vector<Mat3> metric(count);
    const auto numberAt = [](const LaneVector<double>& numbers, ObjectIndex object) {
        return numbers.empty() ? 0 : numbers[object];
    };
    forEachBlock(count, objectsPerBlock, [&](std::size_t begin, std::size_t end) {
        using Vec8 = Eigen::Matrix<double, 8, 1>;
        for (std::size_t i = begin; i < end; ++i) {
            Vec8 low = Vec8::Constant(std::numeric_limits<double>::infinity());
            Vec8 high = -low;
            Vec8 sum = Vec8::Zero();
            for (const Around& one : around(static_cast<ObjectIndex>(i))) {
                Vec8 values;
                values << elastic[one.object], numberAt(old.plastic.equivalentStrain, one.object),
                    numberAt(old.plastic.damage, one.object);
                sum += one.share * values;
                low = low.cwiseMin(values);
                high = high.cwiseMax(values);
            }
            sum = sum.cwiseMax(low).cwiseMin(high);
            const Mat3 strain = axes.transpose() * unpacked(sum.head<6>()) * axes;
            metric[i] = exponential(-2 * (strain - strain.trace() / 3 * Mat3::Identity()));
            const Vec6 components = packed(metric[i]);
            for (std::size_t n = 0; n < 6; ++n)
                changes.plastic.metric[n][i] = components[static_cast<Eigen::Index>(n)];
            changes.restDilatation[i] = -strain.trace();
            changes.plastic.equivalentStrain[i] = std::max(0.0, sum[6]);
            changes.plastic.damage[i] = std::max(0.0, sum[7]);
        }
    });

    // What the map of the surface won or lost of the volume is compressed now, and comes out again.
    // Of all pieces together: objects on both sides of a fresh cut do not say how much of each piece is theirs.
    const double volume = m_before.keptVolume();
    double volumeNow = 0;
    for (std::size_t i = 0; i < count; ++i)
        volumeNow += m_aggregate.volume[i] * std::exp(changes.restDilatation[i]);
    for (double& dilatation : changes.restDilatation)
        dilatation += std::log(volume / volumeNow);

    for (std::size_t d = 0; d < Lattice::directionCount; ++d) {
        const Lattice::Node& o = Lattice::directions[d];
        const Vec3 step = m_aggregate.lattice.spacing * Vec3(o[0], o[1], o[2]); // in lattice axes
        LaneVector<double>& lengths = changes.plastic.nominalLength[d];
        lengths.assign(m_aggregate.weight[d].size(), step.norm());
        if (!lengths.empty())
            for (const Lattice::Segment& segment : m_aggregate.lattice.segments[d])
                for (ObjectIndex i = segment.begin; i < segment.end; ++i) {
                    const Mat3& other = metric[i + static_cast<ObjectIndex>(segment.offset)];
                    lengths[i] = std::pow(step.dot(metric[i] * step) * step.dot(other * step), 0.25);
                }
    }
    return changes;
}

} // namespace knead
