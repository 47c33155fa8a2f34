#include "core/deformation/patch_tree_builder.h"

#include "core/task/parallel_progress.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace knead {

namespace {

constexpr double rootSides = 3;  // of the root, of the longest side of the box of the nodes
constexpr double rootCube = 1.2; // of the cube in which the whole is fitted: its weights are nowhere nearly 0 then
constexpr std::size_t mostFitted =
    2048; // nodes that a fit looks at: more say hardly more, and would take a pass per level
constexpr std::size_t leastToSplit = 64; // nodes in a cube: its children see eight on average
constexpr std::size_t leastFitted = 24;  // else the cube is made wider
constexpr double fitWidening = 1.45;     // by this: so far the nodes of the parent reach
constexpr std::size_t deepest = 22;      // levels
constexpr double nearEnough = 2e-6;      // of what the nodes move against each other
constexpr double roundedOff = 1e-13;     // of displacements, by which they are off any function

/// Children by their bits: all, and those toward -x, -y, -z.
constexpr unsigned allChildren = 0xff;
constexpr std::array<unsigned, 3> lowChildren{0x55, 0x33, 0x0f};

constexpr double untied = 1e-12;
constexpr double tied = 1e6;

/// Bits of a number of 21 bits, with two empty ones between any two.
std::uint64_t spread(std::uint64_t x)
{
    x &= 0x1fffffU;
    x = (x | x << 32U) & 0x1f00000000ffffU;
    x = (x | x << 16U) & 0x1f0000ff0000ffU;
    x = (x | x << 8U) & 0x100f00f00f00f00fU;
    x = (x | x << 4U) & 0x10c30c30c30c30c3U;
    return (x | x << 2U) & 0x1249249249249249U;
}

/// The nodes along Morton's curve, so that those of a cell lie together in memory.
DisplacementField sorted(const DisplacementField& field, const Box& box)
{
    const double scale = 0x1fffff / std::max(box.sizes().maxCoeff(), std::numeric_limits<double>::min());
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(field.nodes.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        const Vec3 at = scale * (field.nodes[i] - box.min());
        std::uint64_t code = 0;
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            code |= spread(static_cast<std::uint64_t>(at[axis])) << static_cast<unsigned>(axis);
        order[i] = {code, i};
    }
    std::sort(order.begin(), order.end());
    DisplacementField result;
    result.nodes.reserve(order.size());
    result.displacements.reserve(order.size());
    for (const auto& [code, node] : order) {
        result.nodes.push_back(field.nodes[node]);
        result.displacements.push_back(field.displacements[node]);
    }
    return result;
}

Box boxIn(const DisplacementField& field)
{
    const Box box = boxOfPlaces(field.nodes);
    return box.sizes().maxCoeff() > 0 ? box : Box(box.min() - Vec3::Constant(0.5), box.max() + Vec3::Constant(0.5));
}

/// At most so many, evenly.
std::vector<std::uint32_t> thinned(const std::vector<std::uint32_t>& nodes)
{
    const std::size_t count = std::min(nodes.size(), mostFitted);
    std::vector<std::uint32_t> some(count);
    for (std::size_t i = 0; i < count; ++i)
        some[i] = nodes[i * nodes.size() / count];
    return some;
}

Vec3 childCenter(const PatchTree::Cell& parent, std::uint32_t child)
{
    const Vec3 toward((child & 1U) != 0 ? 1 : -1, (child & 2U) != 0 ? 1 : -1, (child & 4U) != 0 ? 1 : -1);
    return parent.center + parent.side / 4 * toward;
}

bool isIn(const PatchTree::Cell& cell, const Vec3& place)
{
    const Vec3 from = place - cell.center;
    return (from.array() >= -cell.side / 2).all() && (from.array() < cell.side / 2).all();
}

} // namespace

PatchTreeBuilder::PatchTreeBuilder(const DisplacementField& field, TaskControl& control)
    : m_control(control)
    , m_field(sorted(field, boxIn(field)))
    , m_error(field.nodes.size(), std::numeric_limits<double>::infinity())
{
    const Box values = boxOfPlaces(field.displacements);
    const double largest = values.min().cwiseAbs().cwiseMax(values.max().cwiseAbs()).norm();
    m_tolerance = std::max(nearEnough * values.diagonal().norm(), roundedOff * largest);
}

void PatchTreeBuilder::build(PatchTree& tree)
{
    fitRoot(tree);
    Work all;
    all.nodes.resize(m_field.nodes.size());
    std::iota(all.nodes.begin(), all.nodes.end(), 0U);
    TaskPortion fitting(m_control, 0, 0.8);
    std::vector<Work> level{all};
    for (std::size_t depth = 0; !level.empty() && depth < deepest; ++depth) {
        m_control.throwIfCancelled();
        m_control.report(0.8 * (1 - std::pow(0.7, static_cast<double>(depth))), "fitting the field");
        level = fitLevel(std::move(level));
    }
    m_sources.resize(m_cells.size());
    level.clear();
    level.push_back(std::move(all));
    while (!level.empty()) {
        m_control.throwIfCancelled();
        m_control.report(0.9, "fitting the field");
        level = chooseLevel(std::move(level));
    }
    takeOver(tree);
}

/// Order by order, and more than once: what a hold took off, or rounding, is then put on again.
void PatchTreeBuilder::fitRoot(PatchTree& tree)
{
    const Box box = boxIn(m_field);
    const double side = box.sizes().maxCoeff();
    std::vector<std::uint32_t> nodes(m_field.nodes.size());
    std::iota(nodes.begin(), nodes.end(), 0U);
    nodes = thinned(nodes);
    QuadraticPatch patch{box.center(), rootCube * side / 2, QuadraticPatch::Coefficients::Zero()};
    const auto improve = [&](const PatchHold& hold) { patch = fitPatch(m_field, nodes, patch, 1, hold).patch; };
    improve({untied, tied, tied});
    for (int pass = 0; pass < 2; ++pass)
        improve({untied, untied, tied});
    tree.m_linear = patch;
    tree.m_linear.coefficients.rightCols<6>().setZero();
    for (int pass = 0; pass < 4; ++pass)
        improve({untied, untied, untied});
    m_cells.push_back({box.center(), rootSides * side, 0, 0});
    m_patches.push_back(patch.about(box.center(), patchOverlap * rootSides * side / 2));
    m_squares.push_back(std::numeric_limits<double>::infinity());
    m_expected.push_back(0);
}

std::vector<PatchTreeBuilder::Work> PatchTreeBuilder::fitLevel(std::vector<Work> level)
{
    std::vector<char> splits(level.size());
    forEachBlock(level.size(), blockSizeOf(level.size()), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            fit(level[i]);
            splits[i] = isWorthSplitting(level[i]) ? 1 : 0;
        }
    });
    std::vector<std::uint32_t> parents;
    for (std::uint32_t i = 0; i < level.size(); ++i) {
        if (splits[i] == 0)
            continue;
        parents.push_back(i);
        const PatchTree::Cell cell = m_cells[level[i].cell];
        m_cells[level[i].cell].firstChild = static_cast<std::uint32_t>(m_cells.size());
        for (std::uint32_t child = 0; child < 8; ++child) {
            m_cells.push_back({childCenter(cell, child), cell.side / 2, 0, 0});
            m_patches.push_back(m_patches[level[i].cell].about(m_cells.back().center, patchOverlap * cell.side / 4));
            m_squares.push_back(0);
            m_expected.push_back(0);
        }
    }
    return childrenOf(level, parents);
}

/// The patch of a cell, which until now is that of its parent; and what nodes in the cell learn of how good fits are.
void PatchTreeBuilder::fit(const Work& work)
{
    if (work.nodes.empty() || work.cell == 0)
        return;
    const bool isWide = !work.wider.empty();
    const std::vector<std::uint32_t> nodes = thinned(isWide ? work.wider : work.nodes);
    const PatchFit fit = fitPatch(m_field, nodes, m_patches[work.cell], isWide ? fitWidening : 1, childHold);
    m_patches[work.cell] = fit.patch;
    if (nodes.size() < work.nodes.size()) {
        m_squares[work.cell] = std::numeric_limits<double>::infinity();
        return;
    }
    m_expected[work.cell] = fit.expectedError;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!isIn(m_cells[work.cell], m_field.nodes[nodes[i]]))
            continue;
        m_squares[work.cell] += fit.errors[i] * fit.errors[i];
        m_error[nodes[i]] = std::min(m_error[nodes[i]], fit.expectedError);
    }
}

double PatchTreeBuilder::squaredOff(std::uint32_t node, const QuadraticPatch& patch) const
{
    return (m_field.displacements[node] - patch.at(patch.within(m_field.nodes[node]))).squaredNorm();
}

bool PatchTreeBuilder::isWorthSplitting(const Work& work) const
{
    if (work.nodes.size() < leastToSplit)
        return false;
    const QuadraticPatch& patch = m_patches[work.cell];
    return std::any_of(work.nodes.begin(), work.nodes.end(),
                       [&](std::uint32_t node) { return squaredOff(node, patch) > m_tolerance * m_tolerance; });
}

/// @param parents by their places in the level, all of which have children
std::vector<PatchTreeBuilder::Work> PatchTreeBuilder::childrenOf(const std::vector<Work>& level,
                                                                 const std::vector<std::uint32_t>& parents) const
{
    std::vector<Work> children(8 * parents.size());
    forEachBlock(parents.size(), blockSizeOf(parents.size()), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            shareOut(level[parents[i]], std::span(children).subspan(8 * i).first<8>());
    });
    return children;
}

/// The nodes of a cell to its children: all in one go, since they are read from all over the memory.
void PatchTreeBuilder::shareOut(const Work& parent, std::span<Work, 8> children) const
{
    const std::uint32_t first = m_cells[parent.cell].firstChild;
    for (std::uint32_t i = 0; i < 8; ++i) {
        children[i].cell = first + i;
        children[i].parent = parent.cell;
    }
    const PatchTree::Cell& low = m_cells[first];
    const PatchTree::Cell& high = m_cells[first + 7];
    const auto share = [&](double half, Nodes Work::*list, unsigned wanted) {
        for (const std::uint32_t node : parent.nodes) {
            const Eigen::Array<bool, 3, 1> isLow = (m_field.nodes[node] - low.center).array().abs() < half;
            const Eigen::Array<bool, 3, 1> isHigh = (m_field.nodes[node] - high.center).array().abs() < half;
            unsigned in = wanted;
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                in &= (isLow[axis] ? lowChildren[axis] : 0U) | (isHigh[axis] ? ~lowChildren[axis] : 0U);
            for (; in != 0; in &= in - 1)
                (children[static_cast<std::size_t>(std::countr_zero(in))].*list).push_back(node);
        }
    };
    const double half = patchOverlap / 2 * low.side;
    share(half, &Work::nodes, allChildren);
    unsigned few = 0;
    for (std::uint32_t i = 0; i < 8; ++i)
        if (!children[i].nodes.empty() && children[i].nodes.size() < leastFitted)
            few |= 1U << i;
    if (few != 0)
        share(fitWidening * half, &Work::wider, few);
}

/// Only what leaves are made of.
void PatchTreeBuilder::takeOver(PatchTree& tree) const
{
    std::vector<std::uint32_t> from{0}; // cells of the builder, in the order of those of the tree
    tree.m_cells.push_back(m_cells.front());
    for (std::size_t i = 0; i < from.size(); ++i) {
        const PatchTree::Cell& old = m_cells[from[i]];
        if (old.firstChild == 0) {
            const std::vector<PatchSource>& sources = m_sources[from[i]];
            tree.m_cells[i].leaf = static_cast<std::uint32_t>(tree.m_leaves.size());
            tree.m_leaves.push_back({m_patches[from[i]], tree.m_sources.size(), sources.size()});
            tree.m_sources.insert(tree.m_sources.end(), sources.begin(), sources.end());
            continue;
        }
        tree.m_cells[i].firstChild = static_cast<std::uint32_t>(tree.m_cells.size());
        for (std::uint32_t child = old.firstChild; child < old.firstChild + 8; ++child) {
            from.push_back(child);
            tree.m_cells.push_back(m_cells[child]);
        }
    }
    tree.m_leafSide = leafSideOf(tree);
}

double PatchTreeBuilder::leafSideOf(const PatchTree& tree) const
{
    std::vector<double> sides(m_field.nodes.size());
    forEachBlock(sides.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::size_t cell = 0;
            while (tree.m_cells[cell].firstChild != 0) {
                const Vec3 from = m_field.nodes[i] - tree.m_cells[cell].center;
                cell = tree.m_cells[cell].firstChild + (from.x() >= 0 ? 1U : 0U) + (from.y() >= 0 ? 2U : 0U) +
                       (from.z() >= 0 ? 4U : 0U);
            }
            sides[i] = tree.m_cells[cell].side;
        }
    });
    const auto tenth = sides.begin() + static_cast<std::ptrdiff_t>(sides.size() / 10);
    std::nth_element(sides.begin(), tenth, sides.end());
    return *tenth;
}

} // namespace knead
