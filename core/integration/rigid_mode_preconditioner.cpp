#include "core/integration/rigid_mode_preconditioner.h"

#include "core/mechanics/tangent_kernels.h"
#include "core/task/parallel.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace knead {

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

constexpr std::size_t blockSize = 4096;
const std::array<Vec3, 3> worldAxes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

// Objects along the edge of a block. Smaller blocks take fewer iterations, but their factor grows with the square of their
// number; larger bodies get larger blocks, so that there are about so many of them.
constexpr double leastBlockEdge = 4;
constexpr double mostBlocks = 250;

// Clusters of one object, or of objects in a row, have rotations that do nothing; so much of the diagonal keeps the
// factor of the coarse matrix finite.
constexpr double coarseShift = 1e-10;

/// Sets of connected rows.
class DisjointRows {
public:
    explicit DisjointRows(std::size_t count)
        : m_parent(count)
    {
        std::iota(m_parent.begin(), m_parent.end(), 0U);
    }
    std::uint32_t find(std::uint32_t row)
    {
        while (m_parent[row] != row)
            row = m_parent[row] = m_parent[m_parent[row]];
        return row;
    }
    void join(std::uint32_t a, std::uint32_t b) // the lower one names the set
    {
        a = find(a);
        b = find(b);
        m_parent[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> m_parent;
};

/// Which block of the lattice each object of a body lies in: blocks as even as can be, about `edge` objects long.
std::vector<std::uint32_t> blocksOf(const Lattice& lattice, double edge)
{
    Eigen::AlignedBox3i bounds;
    for (const Lattice::Node& node : lattice.nodes)
        bounds.extend(Eigen::Vector3i(node[0], node[1], node[2]));
    const Eigen::Vector3i extent = bounds.sizes() + Eigen::Vector3i::Ones();
    const Eigen::Vector3i blocks =
        (extent.cast<double>() / edge).array().round().cast<int>().max(1); // at least one along each axis
    std::vector<std::uint32_t> block(lattice.size());
    for (std::size_t i = 0; i < block.size(); ++i) {
        Eigen::Vector3i place;
        for (int axis = 0; axis < 3; ++axis)
            place[axis] = static_cast<int>(
                static_cast<std::int64_t>(lattice.nodes[i][static_cast<std::size_t>(axis)] - bounds.min()[axis]) *
                blocks[axis] / extent[axis]);
        block[i] = static_cast<std::uint32_t>((place[0] * blocks[1] + place[1]) * blocks[2] + place[2]);
    }
    return block;
}

/// P^T of a momentum on a member: force and torque in the cluster's units.
Vec6 restricted(const Vec3& momentum, const Vec3& arm)
{
    Vec6 mode;
    mode << momentum, arm.cross(momentum);
    return mode;
}

} // namespace

/// P^T A P by 6x6 blocks, and its factor.
class RigidModePreconditioner::Coarse {
public:
    explicit Coarse(std::size_t clusters)
        : m_size(static_cast<Eigen::Index>(6 * clusters))
    {
    }

    /// Adds mode mode^T, where the mode reaches over a few clusters.
    struct Reach {
        std::uint32_t cluster;
        Vec6 mode;
    };
    template <typename Reaches>
    void addDyad(const Reaches& reaches, double weight = 1)
    {
        for (const Reach& a : reaches)
            for (const Reach& b : reaches)
                if (a.cluster != none && b.cluster != none && a.cluster >= b.cluster)
                    block(a.cluster, b.cluster) += weight * a.mode * b.mode.transpose();
    }
    Mat6& block(std::uint32_t row, std::uint32_t column)
    {
        const std::pair key(row, column);
        if (m_last == m_blocks.end() || m_last->first != key)
            m_last = m_blocks.try_emplace(key, Mat6::Zero()).first;
        return m_last->second;
    }

    void factor()
    {
        if (m_size == 0)
            return;
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(36 * m_blocks.size());
        for (auto& [key, values] : m_blocks)
            for (int r = 0; r < 6; ++r)
                for (int c = 0; c < 6; ++c) {
                    const auto row = static_cast<int>(6 * key.first) + r;
                    const auto column = static_cast<int>(6 * key.second) + c;
                    if (row < column)
                        continue;
                    double value = values(r, c);
                    if (row == column) {
                        const double scale = values.diagonal().maxCoeff();
                        value = value > coarseShift * scale ? value * (1 + coarseShift) : std::max(scale, 1e-300);
                    }
                    entries.emplace_back(row, column, value);
                }
        Eigen::SparseMatrix<double> matrix(m_size, m_size);
        matrix.setFromTriplets(entries.begin(), entries.end());
        m_factor.compute(matrix);
        m_blocks.clear();
        m_last = m_blocks.end();
    }
    bool isUsable() const { return m_size > 0 && m_factor.info() == Eigen::Success; }
    Eigen::VectorXd solve(const Eigen::VectorXd& load) const { return m_factor.solve(load); }
    Eigen::Index size() const { return m_size; }

private:
    using Blocks = std::map<std::pair<std::uint32_t, std::uint32_t>, Mat6>;
    Eigen::Index m_size;
    Blocks m_blocks; ///< of the lower triangle
    Blocks::iterator m_last = m_blocks.end();
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factor;
};

RigidModePreconditioner::RigidModePreconditioner() = default;
RigidModePreconditioner::~RigidModePreconditioner() = default;
RigidModePreconditioner::RigidModePreconditioner(RigidModePreconditioner&&) noexcept = default;
RigidModePreconditioner& RigidModePreconditioner::operator=(RigidModePreconditioner&&) noexcept = default;

void RigidModePreconditioner::updateBlocks(const ImplicitSystem& system)
{
    const std::size_t rows = system.rows();
    std::array<std::vector<double>, 6> blocks;
    for (std::size_t c = 0; c < 6; ++c) {
        blocks[c].assign(rows, 0);
        m_inverse[c].resize(rows);
    }
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t row = 0; row < rows; ++row)
            blocks[c][row] = system.massOf(row);
    for (const ImplicitSystem::DeformableBody& body : system.deformables()) {
        std::array<double*, 6> own{};
        for (std::size_t c = 0; c < 6; ++c)
            own[c] = &blocks[c][body.first];
        body.tangent.addBlocks(own);
    }
    const auto add = [&](std::size_t row, const Mat3& matrix) {
        const double entries[] = {matrix(0, 0), matrix(1, 1), matrix(2, 2), matrix(0, 1), matrix(0, 2), matrix(1, 2)};
        for (std::size_t c = 0; c < 6; ++c)
            blocks[c][row] += entries[c];
    };
    for (const ImplicitSystem::RigidBody& body : system.rigids()) {
        add(body.first, body.mass * Mat3::Identity());
        add(body.first + 1, body.inertia);
    }
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
    forEachBlock(rows, blockSize, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Mat3 block;
            block << blocks[0][i], blocks[3][i], blocks[4][i], blocks[3][i], blocks[1][i], blocks[5][i], blocks[4][i],
                blocks[5][i], blocks[2][i];
            const Mat3 inverse = system.isHeld(i) ? Mat3(Mat3::Zero()) : Mat3(block.inverse());
            m_inverse[0][i] = inverse(0, 0);
            m_inverse[1][i] = inverse(1, 1);
            m_inverse[2][i] = inverse(2, 2);
            m_inverse[3][i] = inverse(0, 1);
            m_inverse[4][i] = inverse(0, 2);
            m_inverse[5][i] = inverse(1, 2);
        }
    });
}

void RigidModePreconditioner::updateClusters(const ImplicitSystem& system)
{
    findClusters(system);
    measureClusters(system);
    assemble(system);
}

void RigidModePreconditioner::findClusters(const ImplicitSystem& system)
{
    const double edge = std::max(leastBlockEdge, std::cbrt(static_cast<double>(system.rows()) / mostBlocks));
    DisjointRows sets(system.rows());
    for (const ImplicitSystem::DeformableBody& body : system.deformables()) {
        const std::vector<std::uint32_t> block = blocksOf(body.tangent.connections().aggregate().lattice, edge);
        body.tangent.forEachConnection([&](ObjectIndex i, ObjectIndex j, const Vec3&, double) {
            if (block[i] == block[j] && !system.isHeld(body.first + i) && !system.isHeld(body.first + j))
                sets.join(static_cast<std::uint32_t>(body.first + i), static_cast<std::uint32_t>(body.first + j));
        });
    }
    m_turnsOnly.assign(system.rows(), 0);
    for (const ImplicitSystem::RigidBody& body : system.rigids()) {
        sets.join(static_cast<std::uint32_t>(body.first), static_cast<std::uint32_t>(body.first + 1));
        m_turnsOnly[body.first + 1] = 1;
    }
    // Numbered by their lowest rows.
    std::uint32_t count = 0;
    m_clusterOf.assign(system.rows(), none);
    for (std::uint32_t row = 0; row < system.rows(); ++row) {
        if (system.isHeld(row))
            continue;
        const std::uint32_t root = sets.find(row);
        m_clusterOf[row] = root == row ? count++ : m_clusterOf[root];
    }
    m_membersBegin.assign(count + 1, 0);
    for (const std::uint32_t cluster : m_clusterOf)
        if (cluster != none)
            ++m_membersBegin[cluster + 1];
    std::partial_sum(m_membersBegin.begin(), m_membersBegin.end(), m_membersBegin.begin());
    m_members.resize(m_membersBegin.back());
    std::vector<std::size_t> next(m_membersBegin.begin(), m_membersBegin.end() - 1);
    for (std::uint32_t row = 0; row < system.rows(); ++row)
        if (m_clusterOf[row] != none)
            m_members[next[m_clusterOf[row]]++] = row;
}

void RigidModePreconditioner::measureClusters(const ImplicitSystem& system)
{
    const std::size_t count = m_membersBegin.size() - 1;
    m_center.assign(count, Vec3::Zero());
    m_size.assign(count, 1);
    m_arm = {};
    m_arm.resize(system.rows());
    for (const ImplicitSystem::DeformableBody& body : system.deformables())
        for (std::size_t i = 0; i < body.state->size(); ++i)
            m_arm.set(body.first + i, body.state->position.at(i));
    for (std::size_t cluster = 0; cluster < count; ++cluster) {
        const std::size_t begin = m_membersBegin[cluster];
        const std::size_t end = m_membersBegin[cluster + 1];
        for (std::size_t m = begin; m < end; ++m)
            m_center[cluster] += m_arm.at(m_members[m]) / static_cast<double>(end - begin);
        double farthest = 0;
        for (std::size_t m = begin; m < end; ++m)
            farthest = std::max(farthest, (m_arm.at(m_members[m]) - m_center[cluster]).norm());
        if (farthest > 0)
            m_size[cluster] = farthest;
        for (std::size_t m = begin; m < end; ++m)
            m_arm.set(m_members[m], (m_arm.at(m_members[m]) - m_center[cluster]) / m_size[cluster]);
    }
}

void RigidModePreconditioner::assemble(const ImplicitSystem& system)
{
    using Reach = Coarse::Reach;
    m_coarse = std::make_unique<Coarse>(clusters());
    for (std::size_t row = 0; row < system.rows(); ++row) {
        const std::uint32_t cluster = m_clusterOf[row];
        if (cluster == none)
            continue;
        const double mass = system.massOf(row);
        const Vec3 arm = m_arm.at(row);
        Mat6& block = m_coarse->block(cluster, cluster);
        for (const Vec3& axis : worldAxes) {
            const Vec6 mode = restricted(axis, arm);
            block += mass * mode * mode.transpose();
        }
    }
    for (const ImplicitSystem::RigidBody& body : system.rigids()) {
        const std::uint32_t cluster = m_clusterOf[body.first];
        m_coarse->block(cluster, cluster).topLeftCorner<3, 3>() += body.mass * Mat3::Identity();
        m_coarse->block(cluster, cluster).bottomRightCorner<3, 3>() += body.inertia;
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
                    m_coarse->block(m_clusterOf[row], m_clusterOf[row]).bottomRightCorner<3, 3>() +=
                        across * (between.squaredNorm() * Mat3::Identity() - between * between.transpose());
                return;
            }
            isInside[i] = isInside[j] = 0;
            const auto add = [&](const Vec3& direction, double weight) {
                m_coarse->addDyad(std::array<Reach, 2>{{{m_clusterOf[row], restricted(direction, m_arm.at(row))},
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
        for (ObjectIndex i = 0; i < isInside.size(); ++i) {
            if (isInside[i] != 0)
                continue;
            reaches.clear();
            for (const TangentOperator::Slope& slope : body.tangent.slopesOf(i)) {
                const std::size_t row = body.first + slope.object;
                if (m_clusterOf[row] == none)
                    continue;
                auto reach = std::find_if(reaches.begin(), reaches.end(),
                                          [&](const Reach& r) { return r.cluster == m_clusterOf[row]; });
                if (reach == reaches.end())
                    reach = reaches.insert(reaches.end(), {m_clusterOf[row], Vec6::Zero()});
                reach->mode += restricted(slope.gradient, m_arm.at(row));
            }
            m_coarse->addDyad(reaches, body.tangent.weightOf(i));
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
            m_coarse->addDyad(reaches, std::max(0.0, roots.eigenvalues()[axis]));
        }
    }
    m_coarse->factor();
}

void RigidModePreconditioner::apply(const VectorArray& r, VectorArray& z)
{
    Eigen::VectorXd load(m_coarse->size());
    forEachBlock(clusters(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            Vec3 force = Vec3::Zero();
            Vec3 torque = Vec3::Zero();
            for (std::size_t m = m_membersBegin[cluster]; m < m_membersBegin[cluster + 1]; ++m) {
                const std::uint32_t row = m_members[m];
                const Vec3 momentum = r.at(row);
                if (m_turnsOnly[row] != 0) {
                    torque += momentum;
                } else {
                    force += momentum;
                    torque += m_arm.at(row).cross(momentum);
                }
            }
            load.segment<6>(static_cast<Eigen::Index>(6 * cluster)) << force, torque;
        }
    });
    const Eigen::VectorXd motion = m_coarse->isUsable() ? m_coarse->solve(load) : Eigen::VectorXd::Zero(load.size());
    forEachBlock(r.size(), blockSize, [&](std::size_t begin, std::size_t end) {
        const double* blocks[6];
        for (std::size_t c = 0; c < 6; ++c)
            blocks[c] = &m_inverse[c][begin];
        kernels::bestTangents().multiplyBlocks(end - begin, blocks, kernels::from(r, begin), kernels::into(z, begin));
        for (std::size_t row = begin; row < end; ++row) {
            if (m_clusterOf[row] == none)
                continue;
            const double* mode = &motion[static_cast<Eigen::Index>(6 * m_clusterOf[row])];
            const Vec3 turn(mode[3], mode[4], mode[5]);
            z.add(row,
                  m_turnsOnly[row] != 0 ? turn : Vec3(Vec3(mode[0], mode[1], mode[2]) + turn.cross(m_arm.at(row))));
        }
    });
}

} // namespace knead
