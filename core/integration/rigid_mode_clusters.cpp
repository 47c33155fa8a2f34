// Which objects move together as clusters, and the matrix between them. Part of RigidModePreconditioner.
#include "core/geometry/disjoint_sets.h"
#include "core/integration/rigid_mode_preconditioner.h"

#include <Eigen/Dense>

#include <algorithm>
#include <numeric>

namespace knead {

namespace {

using Vec6 = RigidModeLevels::Vec6;
using Mat6 = RigidModeLevels::Mat6;

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

/// A mode that reaches over a few clusters.
struct Reach {
    std::uint32_t cluster;
    Vec6 mode;
};

/// What reaches say of a cluster, at first nothing.
Vec6& modeIn(std::vector<Reach>& reaches, std::uint32_t cluster)
{
    const auto known = std::ranges::find(reaches, cluster, &Reach::cluster);
    return known != reaches.end() ? known->mode : reaches.emplace_back(Reach{cluster, Vec6::Zero()}).mode;
}

/// Adds weight mode mode^T; reaches of no cluster, which is held, do nothing.
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
            const Vec6 mode = restrictedTo(axis, arm);
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
                        std::array<Reach, 2>{{{m_clusterOf[row], restrictedTo(direction, m_arm.at(row))},
                                              {m_clusterOf[other], restrictedTo(-direction, m_arm.at(other))}}},
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
                modeIn(reaches, m_clusterOf[row]) += restrictedTo(slope.gradient, m_arm.at(row));
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
                modeIn(reaches, cluster) += restrictedTo(push, arm);
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

} // namespace knead
