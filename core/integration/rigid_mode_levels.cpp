#include "core/integration/rigid_mode_levels.h"

#include "core/geometry/disjoint_sets.h"
#include "core/integration/solver_settings.h"
#include "core/kernels/kernels.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace knead {

namespace {

using Mat6 = RigidModeLevels::Mat6;

constexpr std::size_t blockSize = 48; // numbers of a block of BlockRows

void addShift(Eigen::Ref<Mat6> block, double shift)
{
    const double scale = block.diagonal().maxCoeff();
    for (int i = 0; i < 6; ++i)
        block(i, i) = block(i, i) > shift * scale ? block(i, i) * (1 + shift) : std::max(scale, 1e-300);
}

std::int32_t half(std::int32_t block)
{
    return block >= 0 ? block / 2 : -((1 - block) / 2);
}

} // namespace

RigidModeLevels::Mat6& RigidModeLevels::Blocks::at(std::uint32_t row, std::uint32_t column)
{
    std::vector<Entry>& entries = m_rows[row];
    for (const Entry& entry : entries)
        if (entry.column == column)
            return m_values[entry.index];
    entries.push_back({column, static_cast<std::uint32_t>(m_values.size())});
    return m_values.emplace_back(Mat6::Zero());
}

void RigidModeLevels::Blocks::sort()
{
    for (std::vector<Entry>& entries : m_rows)
        std::ranges::sort(entries, {}, &Entry::column);
}

template <typename Visit>
void RigidModeLevels::Blocks::forEach(Visit&& visit) const
{
    for (std::uint32_t row = 0; row < m_rows.size(); ++row)
        for (const Entry& entry : m_rows[row])
            visit(row, entry.column, m_values[entry.index]);
}

RigidModeLevels::RigidModeLevels(std::vector<Cluster> clusters)
    : m_clusters(std::move(clusters))
    , m_blocks(m_clusters.size())
{
}

kernels::BlockRows RigidModeLevels::Level::view() const
{
    return {parent.size(), begin.data(), behind.data(), columns.data(), blocks.data(), inverse.data()};
}

/// Rows from the blocks of the lower triangle.
void RigidModeLevels::Level::setRows(const Blocks& lower)
{
    const std::size_t rows = parent.size();
    begin.assign(rows + 1, 0);
    lower.forEach([&](std::uint32_t row, std::uint32_t column, const Mat6&) {
        if (row != column) {
            ++begin[row + 1];
            ++begin[column + 1];
        }
    });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    columns.resize(begin.back());
    blocks.assign(blockSize * columns.size(), 0);
    inverse.assign(blockSize * rows, 0);
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    const auto write = [](const Mat6& matrix, float* to) {
        for (int column = 0; column < 6; ++column)
            for (int row = 0; row < 6; ++row)
                to[8 * column + row] = static_cast<float>(matrix(row, column));
    };
    const auto place = [&](std::uint32_t row, std::uint32_t column, const Mat6& matrix) {
        columns[next[row]] = column;
        write(matrix, &blocks[blockSize * next[row]++]);
    };
    // Sorted by row and column: first what is before the diagonal of each row, then what is behind it, in ascending order.
    lower.forEach([&](std::uint32_t row, std::uint32_t column, const Mat6& matrix) {
        if (row != column)
            place(row, column, matrix);
    });
    behind = next;
    lower.forEach([&](std::uint32_t row, std::uint32_t column, const Mat6& matrix) {
        if (row != column)
            return place(column, row, matrix.transpose());
        Mat6 own = matrix;
        addShift(own, solverSettings.linear.singleShift);
        write(own.ldlt().solve(Mat6::Identity()), &inverse[blockSize * row]);
    });
}

RigidModeLevels::Mat6 RigidModeLevels::Level::prolongation(std::size_t child) const
{
    Mat6 matrix = Mat6::Identity();
    matrix.topRightCorner<3, 3>() = -crossMatrix(arm[child]);
    matrix.bottomRightCorner<3, 3>() *= share[child];
    return matrix;
}

/// Parents of clusters, which take their place.
RigidModeLevels::Level RigidModeLevels::nextLevel(std::vector<Cluster>& clusters, const Blocks& blocks) const
{
    const auto placeOf = [&](const Cluster& cluster) {
        return std::tuple(cluster.body, half(cluster.block[0]), half(cluster.block[1]), half(cluster.block[2]));
    };
    DisjointSets sets(clusters.size());
    blocks.forEach([&](std::uint32_t row, std::uint32_t column, const Mat6&) {
        const Cluster& a = clusters[row];
        const Cluster& b = clusters[column];
        if (!a.isAlone && !b.isAlone && placeOf(a) == placeOf(b))
            sets.join(row, column);
    });
    Level level;
    std::map<std::size_t, std::uint32_t> numbers; ///< by set
    std::vector<Cluster> parents;
    std::vector<double> children;
    level.parent.resize(clusters.size());
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const auto [place, isNew] = numbers.try_emplace(sets.find(i), static_cast<std::uint32_t>(parents.size()));
        level.parent[i] = place->second;
        if (isNew) {
            parents.push_back(clusters[i]);
            parents.back().center.setZero();
            for (std::int32_t& along : parents.back().block)
                along = half(along);
            children.push_back(0);
        }
        parents[place->second].center += clusters[i].center;
        children[place->second] += 1;
    }
    for (std::size_t p = 0; p < parents.size(); ++p)
        parents[p].center /= children[p];
    std::vector<double> sizes(parents.size(), 0);
    for (std::size_t i = 0; i < clusters.size(); ++i)
        sizes[level.parent[i]] = std::max(
            sizes[level.parent[i]], (clusters[i].center - parents[level.parent[i]].center).norm() + clusters[i].size);
    for (std::size_t p = 0; p < parents.size(); ++p)
        parents[p].size = sizes[p];
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        const Cluster& parent = parents[level.parent[i]];
        level.arm.emplace_back((clusters[i].center - parent.center) / parent.size);
        level.share.push_back(clusters[i].size / parent.size);
    }
    level.parents = parents.size();
    clusters = std::move(parents);
    return level;
}

void RigidModeLevels::finish()
{
    m_blocks.sort();
    std::vector<Cluster> clusters = m_clusters;
    while (clusters.size() > solverSettings.linear.mostAtTop) {
        std::vector<Cluster> next = clusters;
        Level level = nextLevel(next, m_blocks);
        if (static_cast<double>(next.size()) > solverSettings.linear.leastGain * static_cast<double>(clusters.size()))
            break;
        level.setRows(m_blocks);
        Blocks above(level.parents);
        m_blocks.forEach([&](std::uint32_t i, std::uint32_t j, const Mat6& matrix) {
            const std::uint32_t row = level.parent[i];
            const std::uint32_t column = level.parent[j];
            Mat6 whole = level.prolongation(i).transpose() * matrix * level.prolongation(j);
            if (row == column && i != j)
                whole = (whole + whole.transpose()).eval();
            if (row < column)
                whole.transposeInPlace();
            above.at(std::max(row, column), std::min(row, column)) += whole;
        });
        above.sort();
        m_blocks = std::move(above);
        m_levels.push_back(std::move(level));
        clusters = std::move(next);
    }
    const auto unknowns = static_cast<Eigen::Index>(6 * clusters.size());
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(unknowns, unknowns);
    m_blocks.forEach([&](std::uint32_t row, std::uint32_t column, const Mat6& matrix) {
        Mat6 own = matrix;
        if (row == column)
            addShift(own, solverSettings.linear.doubleShift);
        whole.block<6, 6>(6 * row, 6 * column) = own;
        whole.block<6, 6>(6 * column, 6 * row) = own.transpose();
    });
    const Eigen::LLT<Eigen::MatrixXd> factor(whole);
    m_top = factor.info() == Eigen::Success
                ? Eigen::MatrixXd(factor.solve(Eigen::MatrixXd::Identity(unknowns, unknowns)))
                : Eigen::MatrixXd::Zero(unknowns, unknowns);
    m_blocks = Blocks(0);
}

void RigidModeLevels::solve(const std::vector<float>& load, std::vector<float>& motion)
{
    motion.resize(load.size());
    solve(0, load, motion);
}

void RigidModeLevels::solve(std::size_t number, const std::vector<float>& load, std::vector<float>& motion)
{
    if (number == m_levels.size()) {
        Eigen::VectorXd loads(m_top.rows());
        for (Eigen::Index i = 0; i < loads.size(); ++i)
            loads[i] = static_cast<double>(load[static_cast<std::size_t>(8 * (i / 6) + i % 6)]);
        const Eigen::VectorXd motions = m_top * loads;
        for (Eigen::Index i = 0; i < loads.size(); ++i)
            motion[static_cast<std::size_t>(8 * (i / 6) + i % 6)] = static_cast<float>(motions[i]);
        return;
    }
    Level& level = m_levels[number];
    const kernels::Kernels& kernel = kernels::best();
    const kernels::BlockRows rows = level.view();
    kernel.sweepAhead(rows, load.data(), motion.data());
    level.left.resize(load.size());
    kernel.leftAfterSweep(rows, motion.data(), level.left.data());
    level.loadAbove.assign(8 * level.parents, 0);
    level.motionAbove.resize(8 * level.parents);
    for (std::size_t i = 0; i < level.parent.size(); ++i) {
        const float* from = &level.left[8 * i];
        float* to = &level.loadAbove[8 * static_cast<std::size_t>(level.parent[i])];
        const Eigen::Vector3f force(from[0], from[1], from[2]);
        const Eigen::Vector3f torque = level.arm[i].cast<float>().cross(force) +
                                       static_cast<float>(level.share[i]) * Eigen::Vector3f(from[3], from[4], from[5]);
        for (int c = 0; c < 3; ++c) {
            to[c] += force[c];
            to[3 + c] += torque[c];
        }
    }
    solve(number + 1, level.loadAbove, level.motionAbove);
    for (std::size_t i = 0; i < level.parent.size(); ++i) {
        const float* from = &level.motionAbove[8 * static_cast<std::size_t>(level.parent[i])];
        float* to = &motion[8 * i];
        const Eigen::Vector3f turn(from[3], from[4], from[5]);
        const Eigen::Vector3f way = turn.cross(level.arm[i].cast<float>());
        for (int c = 0; c < 3; ++c) {
            to[c] += solverSettings.linear.overCorrection * (from[c] + way[c]);
            to[3 + c] += solverSettings.linear.overCorrection * static_cast<float>(level.share[i]) * turn[c];
        }
    }
    kernel.sweepBack(rows, load.data(), motion.data());
}

} // namespace knead
