#include "core/integration/rigid_mode_preconditioner.h"

#include "core/geometry/disjoint_sets.h"
#include "core/mechanics/tangent_kernels.h"
#include "core/task/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace knead {

namespace {

using Vec6 = RigidModeLevels::Vec6;
using Mat6 = RigidModeLevels::Mat6;

constexpr std::size_t slotsAtATime = 2048; // whole lanes of every kind
constexpr std::size_t clustersAtATime = 64;

// Weight of what clusters do: regions that are rigid are stiffer than the material. At 2, bars take .5 (Poisson's ratio .49) to 1
// times the iterations of 1; from 1.5 to 3 it makes little difference.
constexpr float clusterWeight = 2;

const std::array<Vec3, 3> worldAxes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

/// Which block of the lattice an object of a body lies in: about `edge` objects long, as even as can be along u and v; along w
/// blocks begin where `edge` slots do, and one of a single layer at an end belongs to its neighbor.
class Blocks {
public:
    Blocks(const Lattice& lattice, std::int32_t edge)
        : m_edge(edge)
    {
        for (const Lattice::Node& node : lattice.nodes)
            m_bounds.extend(Eigen::Vector3i(node[0], node[1], node[2]));
        m_extent = m_bounds.sizes() + Eigen::Vector3i::Ones();
        m_blocks = ((2 * m_extent.array() + edge) / (2 * edge)).max(1);
        m_first = rowBlock(m_bounds.min()[2] + 1);
        m_last = std::max(m_first, rowBlock(m_bounds.max()[2] - 1));
    }

    std::array<std::int32_t, 3> of(const Lattice::Node& node) const
    {
        const auto even = [&](int axis) {
            return (node[static_cast<std::size_t>(axis)] - m_bounds.min()[axis]) * m_blocks[axis] / m_extent[axis];
        };
        return {even(0), even(1), std::clamp(rowBlock(node[2]), m_first, m_last)};
    }

private:
    std::int32_t rowBlock(std::int32_t w) const { return w >= 0 ? w / m_edge : -((m_edge - 1 - w) / m_edge); }

    std::int32_t m_edge;
    Eigen::AlignedBox3i m_bounds;
    Eigen::Vector3i m_extent;
    Eigen::Vector3i m_blocks;
    std::int32_t m_first;
    std::int32_t m_last;
};

/// P^T of a momentum on a member: force and torque in the cluster's units.
Vec6 restricted(const Vec3& momentum, const Vec3& arm)
{
    Vec6 mode;
    mode << momentum, arm.cross(momentum);
    return mode;
}

void addBlock(std::array<LaneVector<double>, 6>& blocks, std::size_t slot, const Mat3& matrix)
{
    const double entries[] = {matrix(0, 0), matrix(1, 1), matrix(2, 2), matrix(0, 1), matrix(0, 2), matrix(1, 2)};
    for (std::size_t c = 0; c < 6; ++c)
        blocks[c][slot] += entries[c];
}

/// A mode that reaches over a few clusters.
struct Reach {
    std::uint32_t cluster;
    Vec6 mode;
};

/// Adds weight mode mode^T. @param none the cluster of what is held
template <typename Reaches>
void addDyad(RigidModeLevels& levels, const Reaches& reaches, double weight)
{
    const auto isFree = [&](const Reach& reach) { return reach.cluster < levels.clusters(); };
    for (const Reach& a : reaches)
        for (const Reach& b : reaches)
            if (isFree(a) && isFree(b) && a.cluster >= b.cluster)
                levels.block(a.cluster, b.cluster) += weight * a.mode * b.mode.transpose();
}

} // namespace

double scaleOf(const VectorArray& rows)
{
    double largest = 0;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < rows.size(); ++i)
            largest = std::max(largest, std::abs(rows.component(c)[i]));
    if (!(largest > 0) || !std::isfinite(largest))
        return 1;
    return std::ldexp(1.0, -std::ilogb(largest));
}

void RigidModePreconditioner::updateBlocks(const ImplicitSystem& system)
{
    const std::size_t slots = system.slotCount();
    for (std::size_t c = 0; c < 6; ++c) {
        m_diagonal[c].assign(slots, 0);
        m_inverse[c].resize(slots);
        m_linked[c].resize(slots);
    }
    for (const ImplicitSystem::DeformableBody& body : system.deformables()) {
        std::array<double*, 6> own{};
        for (std::size_t c = 0; c < 6; ++c)
            own[c] = &m_diagonal[c][body.slot];
        body.tangent.findDiagonal(own);
    }
    for (const ImplicitSystem::RigidBody& body : system.rigids()) {
        addBlock(m_diagonal, body.slot, body.mass * Mat3::Identity());
        addBlock(m_diagonal, body.slot + 1, body.inertia);
    }
    forEachBlock(slots, slotsAtATime, [&](std::size_t begin, std::size_t end) { invert(m_diagonal, begin, end); });
    for (const std::uint32_t row : system.heldRows())
        for (std::size_t c = 0; c < 6; ++c)
            m_inverse[c][system.slotOf(row)] = 0;
    updateLinks(system);
}

/// What links add lies beside the diagonal, so that the next ones can take their place.
void RigidModePreconditioner::updateLinks(const ImplicitSystem& system)
{
    const auto refresh = [&] {
        for (const std::uint32_t row : m_linkedRows) {
            const std::size_t slot = system.slotOf(row);
            double sum[6];
            const double* blocks[6];
            float* inverse[6];
            for (std::size_t c = 0; c < 6; ++c) {
                sum[c] = m_diagonal[c][slot] + m_linked[c][slot];
                blocks[c] = &sum[c];
                inverse[c] = &m_inverse[c][slot];
            }
            kernels::bestTangents().invertBlocks(1, blocks, inverse);
        }
    };
    for (const std::uint32_t row : m_linkedRows)
        for (std::size_t c = 0; c < 6; ++c)
            m_linked[c][system.slotOf(row)] = 0;
    refresh();
    m_linkedRows.clear();
    const auto add = [&](std::uint32_t row, const Mat3& matrix) {
        if (system.isHeld(row))
            return;
        addBlock(m_linked, system.slotOf(row), matrix);
        m_linkedRows.push_back(row);
    };
    for (const Link& link : system.links())
        for (const LinkEnd& end : {link.first, link.second}) {
            if (end.row == LinkEnd::immovable)
                continue;
            if (!end.isRigid) {
                end.forEachRow([&](std::uint32_t row, double weight) { add(row, weight * weight * link.matrix); });
                continue;
            }
            add(end.row, link.matrix);
            Mat3 cross;
            cross << 0, -end.arm.z(), end.arm.y(), end.arm.z(), 0, -end.arm.x(), -end.arm.y(), end.arm.x(), 0;
            add(end.row + 1, cross * link.matrix * cross.transpose());
        }
    std::sort(m_linkedRows.begin(), m_linkedRows.end());
    m_linkedRows.erase(std::unique(m_linkedRows.begin(), m_linkedRows.end()), m_linkedRows.end());
    refresh();
}

void RigidModePreconditioner::invert(const std::array<LaneVector<double>, 6>& diagonal, std::size_t begin,
                                     std::size_t end)
{
    const double* blocks[6];
    float* inverse[6];
    for (std::size_t c = 0; c < 6; ++c) {
        blocks[c] = &diagonal[c][begin];
        inverse[c] = &m_inverse[c][begin];
    }
    kernels::bestTangents().invertBlocks(end - begin, blocks, inverse);
}

void RigidModePreconditioner::updateClusters(const ImplicitSystem& system)
{
    findClusters(system);
    measureClusters(system);
    listSlots(system);
    assemble(system);
}

void RigidModePreconditioner::findClusters(const ImplicitSystem& system)
{
    std::vector<std::array<std::int32_t, 3>> blocks(system.rows());
    DisjointSets sets(system.rows());
    for (const ImplicitSystem::DeformableBody& body : system.deformables()) {
        const Lattice& lattice = body.tangent.connections().aggregate().lattice;
        const Blocks blocksOf(lattice, static_cast<std::int32_t>(lanes));
        for (std::size_t i = 0; i < lattice.size(); ++i)
            blocks[body.first + i] = blocksOf.of(lattice.nodes[i]);
        body.tangent.forEachConnection([&](ObjectIndex i, ObjectIndex j, const Vec3&, double) {
            if (!system.isHeld(body.first + i) && !system.isHeld(body.first + j) &&
                blocks[body.first + i] == blocks[body.first + j])
                sets.join(body.first + i, body.first + j);
        });
    }
    for (const ImplicitSystem::RigidBody& body : system.rigids())
        sets.join(body.first, body.first + 1);
    // Numbered by their lowest rows.
    m_clusterOf.assign(system.rows(), none);
    m_clusters.clear();
    std::vector<std::uint32_t> numbers(system.rows(), none);
    const auto number = [&](std::size_t row, const RigidModeLevels::Cluster& cluster) {
        if (system.isHeld(row))
            return;
        std::uint32_t& own = numbers[sets.find(row)];
        if (own == none) {
            own = static_cast<std::uint32_t>(m_clusters.size());
            m_clusters.push_back(cluster);
        }
        m_clusterOf[row] = own;
    };
    std::uint32_t bodies = 0;
    for (const ImplicitSystem::DeformableBody& body : system.deformables()) {
        for (std::size_t i = 0; i < body.state->size(); ++i)
            number(body.first + i, {.body = bodies, .block = blocks[body.first + i]});
        ++bodies;
    }
    for (const ImplicitSystem::RigidBody& body : system.rigids())
        for (const std::size_t row : {body.first, body.first + 1})
            number(row, {.body = bodies, .isAlone = true});
}

/// Centers, sizes and arms; a rigid body's rows are in units of its own.
void RigidModePreconditioner::measureClusters(const ImplicitSystem& system)
{
    m_arm = {};
    m_arm.resize(system.rows());
    std::vector<double> members(m_clusters.size(), 0);
    std::vector<double> farthest(m_clusters.size(), 0);
    const auto forEachMember = [&](auto&& visit) {
        for (const ImplicitSystem::DeformableBody& body : system.deformables())
            for (std::size_t i = 0; i < body.state->size(); ++i)
                if (const std::size_t row = body.first + i; m_clusterOf[row] != none)
                    visit(row, m_clusterOf[row], body.state->position.at(i));
    };
    forEachMember([&](std::size_t, std::uint32_t cluster, const Vec3& place) {
        m_clusters[cluster].center += place;
        members[cluster] += 1;
    });
    for (std::size_t cluster = 0; cluster < m_clusters.size(); ++cluster)
        if (members[cluster] > 0)
            m_clusters[cluster].center /= members[cluster];
    forEachMember([&](std::size_t, std::uint32_t cluster, const Vec3& place) {
        farthest[cluster] = std::max(farthest[cluster], (place - m_clusters[cluster].center).norm());
    });
    for (std::size_t cluster = 0; cluster < m_clusters.size(); ++cluster)
        if (farthest[cluster] > 0)
            m_clusters[cluster].size = farthest[cluster];
    forEachMember([&](std::size_t row, std::uint32_t cluster, const Vec3& place) {
        m_arm.set(row, (place - m_clusters[cluster].center) / m_clusters[cluster].size);
    });
}

/// Which slots move with which cluster: four at a time where all of them do.
void RigidModePreconditioner::listSlots(const ImplicitSystem& system)
{
    system.gather(m_arm, 1, m_slotArm);
    std::vector<std::uint32_t> clusterOf(system.slotCount(), none);
    std::vector<std::uint8_t> isTaken(system.slotCount(), 0); // by a row, held or not
    for (const ImplicitSystem::DeformableBody& body : system.deformables())
        for (std::size_t i = 0; i < body.state->size(); ++i) {
            clusterOf[system.slotOf(body.first + i)] = m_clusterOf[body.first + i];
            isTaken[system.slotOf(body.first + i)] = 1;
        }
    m_odd.clear();
    m_motionOf.assign(system.slotCount() / lanes, -1);
    std::vector<std::size_t> counts(m_clusters.size() + 1, 0);
    for (std::size_t four = 0; four < m_motionOf.size(); ++four) {
        std::uint32_t first = none;
        bool isOdd = false;
        for (std::size_t slot = lanes * four; slot < lanes * (four + 1); ++slot) {
            if (isTaken[slot] == 0)
                continue;
            isOdd = isOdd || clusterOf[slot] == none || (first != none && clusterOf[slot] != first);
            first = first == none ? clusterOf[slot] : first;
        }
        if (first == none)
            continue;
        if (!isOdd) {
            m_motionOf[four] = static_cast<std::int32_t>(first);
            ++counts[first + 1];
            continue;
        }
        for (std::size_t slot = lanes * four; slot < lanes * (four + 1); ++slot)
            if (clusterOf[slot] != none)
                m_odd.push_back({static_cast<std::uint32_t>(slot), clusterOf[slot]});
    }
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
    m_foursBegin = counts;
    m_fours.resize(counts.back());
    for (std::size_t four = 0; four < m_motionOf.size(); ++four)
        if (m_motionOf[four] >= 0)
            m_fours[counts[static_cast<std::size_t>(m_motionOf[four])]++] = static_cast<std::uint32_t>(lanes * four);
    m_rigid.clear();
    for (const ImplicitSystem::RigidBody& body : system.rigids())
        m_rigid.push_back({static_cast<std::uint32_t>(body.slot), m_clusterOf[body.first]});
}

void RigidModePreconditioner::assemble(const ImplicitSystem& system)
{
    m_levels = std::make_unique<RigidModeLevels>(m_clusters);
    for (std::size_t row = 0; row < system.rows(); ++row) {
        const std::uint32_t cluster = m_clusterOf[row];
        if (cluster == none)
            continue;
        const double mass = system.massOf(row);
        const Vec3 arm = m_arm.at(row);
        Mat6& block = m_levels->block(cluster, cluster);
        for (const Vec3& axis : worldAxes) {
            const Vec6 mode = restricted(axis, arm);
            block += mass * mode * mode.transpose();
        }
    }
    for (const ImplicitSystem::RigidBody& body : system.rigids()) {
        const std::uint32_t cluster = m_clusterOf[body.first];
        m_levels->block(cluster, cluster).topLeftCorner<3, 3>() += body.mass * Mat3::Identity();
        m_levels->block(cluster, cluster).bottomRightCorner<3, 3>() += body.inertia;
    }
    for (const ImplicitSystem::DeformableBody& body : system.deformables()) {
        std::vector<std::uint8_t> isInside(body.state->size(), 1); // all connections stay within its cluster
        body.tangent.forEachConnection([&](ObjectIndex i, ObjectIndex j, const Vec3& root, double across) {
            const std::size_t row = body.first + i;
            const std::size_t other = body.first + j;
            if (m_clusterOf[row] == none && m_clusterOf[other] == none)
                return;
            if (m_clusterOf[row] == m_clusterOf[other]) { // a rigid motion does not change its length
                const Vec3 between = m_arm.at(row) - m_arm.at(other);
                if (across > 0)
                    m_levels->block(m_clusterOf[row], m_clusterOf[row]).bottomRightCorner<3, 3>() +=
                        across * (between.squaredNorm() * Mat3::Identity() - between * between.transpose());
                return;
            }
            isInside[i] = isInside[j] = 0;
            const auto add = [&](const Vec3& direction, double weight) {
                addDyad(*m_levels,
                        std::array<Reach, 2>{{{m_clusterOf[row], restricted(direction, m_arm.at(row))},
                                              {m_clusterOf[other], restricted(-direction, m_arm.at(other))}}},
                        weight);
            };
            add(root, 1);
            if (across > 0)
                for (const Vec3& axis : worldAxes)
                    add(axis, across);
        });
        if (!body.tangent.hasBulk())
            continue;
        std::vector<Reach> reaches;
        std::vector<TangentOperator::Slope> slopes;
        for (ObjectIndex i = 0; i < isInside.size(); ++i) {
            if (isInside[i] != 0)
                continue;
            reaches.clear();
            body.tangent.slopesOf(i, slopes);
            for (const TangentOperator::Slope& slope : slopes) {
                const std::size_t row = body.first + slope.object;
                if (m_clusterOf[row] == none)
                    continue;
                auto reach = std::find_if(reaches.begin(), reaches.end(),
                                          [&](const Reach& r) { return r.cluster == m_clusterOf[row]; });
                if (reach == reaches.end())
                    reach = reaches.insert(reaches.end(), {m_clusterOf[row], Vec6::Zero()});
                reach->mode += restricted(slope.gradient, m_arm.at(row));
            }
            addDyad(*m_levels, reaches, 1);
        }
    }
    for (const Link& link : system.links()) {
        const Eigen::SelfAdjointEigenSolver<Mat3> roots(link.matrix);
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 direction = roots.eigenvectors().col(axis);
            std::vector<Reach> reaches;
            const auto add = [&](std::uint32_t row, const Vec3& push, const Vec3& arm) {
                const std::uint32_t cluster = m_clusterOf[row];
                if (cluster == none)
                    return;
                auto reach =
                    std::find_if(reaches.begin(), reaches.end(), [&](const Reach& r) { return r.cluster == cluster; });
                if (reach == reaches.end())
                    reach = reaches.insert(reaches.end(), {cluster, Vec6::Zero()});
                reach->mode += restricted(push, arm);
            };
            const auto addEnd = [&](const LinkEnd& end, double sign) {
                if (end.row == LinkEnd::immovable)
                    return;
                if (end.isRigid)
                    return add(end.row, sign * direction, end.arm);
                end.forEachRow(
                    [&](std::uint32_t row, double weight) { add(row, sign * weight * direction, m_arm.at(row)); });
            };
            addEnd(link.first, 1);
            addEnd(link.second, -1);
            addDyad(*m_levels, reaches, std::max(0.0, roots.eigenvalues()[axis]));
        }
    }
    m_levels->finish();
}

void RigidModePreconditioner::begin(const FloatArray& r, FloatArray& z, std::size_t begin, std::size_t end) const
{
    const float* blocks[6];
    for (std::size_t c = 0; c < 6; ++c)
        blocks[c] = &m_inverse[c][begin];
    kernels::bestTangents().multiplyBlocks(end - begin, blocks, r.data() + begin, z.data() + begin,
                                           static_cast<std::ptrdiff_t>(r.stride()));
}

double RigidModePreconditioner::finish(const FloatArray& r, FloatArray& z)
{
    const auto stride = static_cast<std::ptrdiff_t>(r.stride());
    const kernels::TangentKernels& kernel = kernels::bestTangents();
    m_load.resize(8 * clusters());
    forEachBlock(clusters(), clustersAtATime, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cluster = begin; cluster < end; ++cluster)
            kernel.restrictFours(m_foursBegin[cluster + 1] - m_foursBegin[cluster],
                                 m_fours.data() + m_foursBegin[cluster], r.data(), m_slotArm.data(), stride,
                                 &m_load[8 * cluster]);
    });
    const auto motionOf = [&](std::uint32_t cluster, std::size_t first) {
        const float* own = &m_motion[8 * static_cast<std::size_t>(cluster) + first];
        return Vec3(own[0], own[1], own[2]);
    };
    const auto addLoad = [&](std::uint32_t cluster, const Vec6& load) {
        for (int c = 0; c < 6; ++c)
            m_load[8 * static_cast<std::size_t>(cluster) + static_cast<std::size_t>(c)] += static_cast<float>(load[c]);
    };
    for (const OddSlot& odd : m_odd)
        addLoad(odd.cluster, restricted(r.at(odd.slot), m_slotArm.at(odd.slot)));
    for (const RigidSlots& body : m_rigid)
        addLoad(body.cluster, (Vec6() << r.at(body.slot), r.at(body.slot + 1)).finished());
    m_levels->solve(m_load, m_motion);
    for (float& value : m_motion)
        value *= clusterWeight;
    for (const RigidSlots& body : m_rigid) {
        z.add(body.slot, motionOf(body.cluster, 0));
        z.add(body.slot + 1, motionOf(body.cluster, 3));
    }
    std::vector<double> sums((r.size() + slotsAtATime - 1) / slotsAtATime);
    forEachBlock(r.size(), slotsAtATime, [&](std::size_t begin, std::size_t end) {
        kernel.prolongFours((end - begin) / lanes, &m_motionOf[begin / lanes], m_motion.data(),
                            m_slotArm.data() + begin, z.data() + begin, stride);
        auto odd = std::partition_point(m_odd.begin(), m_odd.end(), [&](const OddSlot& o) { return o.slot < begin; });
        for (; odd != m_odd.end() && odd->slot < end; ++odd) {
            const Vec3 turn = motionOf(odd->cluster, 3);
            z.add(odd->slot, motionOf(odd->cluster, 0) + turn.cross(m_slotArm.at(odd->slot)));
        }
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c)
            sum += kernel.floatDot(end - begin, r.component(c) + begin, z.component(c) + begin);
        sums[begin / slotsAtATime] = sum;
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double RigidModePreconditioner::apply(const FloatArray& r, FloatArray& z)
{
    forEachBlock(r.size(), slotsAtATime, [&](std::size_t begin, std::size_t end) { this->begin(r, z, begin, end); });
    return finish(r, z);
}

double RigidModePreconditioner::sizeOf(const ImplicitSystem& system, const VectorArray& momenta)
{
    const double scale = scaleOf(momenta);
    system.gather(momenta, scale, m_r);
    if (m_z.size() != m_r.size())
        m_z.resize(m_r.size());
    return apply(m_r, m_z) / (scale * scale);
}

} // namespace knead
