#include "core/deformation/patch_detail.h"
#include "core/deformation/patch_tree_builder.h"
#include "core/task/parallel.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double worseAllowed = 1.4;    // than the best fit
constexpr std::size_t nodesJudged = 32; // beside each other, by which that is told: fewer would be told apart by chance
constexpr double splitGain = 0.95; // errors of children, of those of their parent, that make them worth their while
constexpr double detailFrom = 20;  // tolerances
constexpr double detailGain = 0.9; // errors of a patch through its nodes, of those of the quadratic one
constexpr std::size_t leastDetailed = 8; // nodes
constexpr std::size_t mostDetailed = 80; // the work grows with their third power
constexpr std::size_t usuallyDetailed = 50;

} // namespace

/// From the root down: which cells become leaves. @returns children of the others
std::vector<PatchTreeBuilder::Work> PatchTreeBuilder::chooseLevel(std::vector<Work> level)
{
    std::vector<char> isLeaf(level.size());
    forEachBlock(level.size(), blockSizeOf(level.size()), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            isLeaf[i] = isChosen(level[i]) ? 1 : 0;
    });
    const std::size_t families = (level.size() + 7) / 8;
    forEachBlock(families, blockSizeOf(families), [&](std::size_t begin, std::size_t end) {
        for (std::size_t family = begin; family < end; ++family) {
            std::vector<const Work*> leaves;
            for (std::size_t i = 8 * family; i < std::min(8 * family + 8, level.size()); ++i)
                if (isLeaf[i] != 0)
                    leaves.push_back(&level[i]);
            addDetail(leaves);
        }
    });
    std::vector<std::uint32_t> parents;
    for (std::uint32_t i = 0; i < level.size(); ++i) {
        if (isLeaf[i] == 0)
            parents.push_back(i);
        else
            m_cells[level[i].cell].firstChild = 0;
    }
    return childrenOf(level, parents);
}

bool PatchTreeBuilder::isChosen(const Work& work) const
{
    return m_cells[work.cell].firstChild == 0 ||
           ((!gainsBySplitting(work.cell) || isGoodEnough(work)) && !hidesDetail(work));
}

/// Lets patches of leaves beside each other go through their nodes where they are off them by more than enough, and that is better for all
/// of them together: one alone would be told from noise by chance.
void PatchTreeBuilder::addDetail(const std::vector<const Work*>& leaves)
{
    std::vector<std::pair<std::uint32_t, DetailedPatch>> detailed;
    double quadratic = 0;
    double through = 0;
    for (const Work* leaf : leaves) {
        const Nodes& nodes = leaf->wider.empty() ? leaf->nodes : leaf->wider;
        if (leaf->cell == 0 || nodes.size() < leastDetailed || nodes.size() > mostDetailed ||
            m_expected[leaf->cell] < detailFrom * m_tolerance)
            continue;
        const QuadraticPatch& patch = m_patches[leaf->cell];
        const QuadraticPatch prior = m_patches[leaf->parent].about(patch.center, patch.half);
        const auto& [cell, fit] = detailed.emplace_back(leaf->cell, fitThrough(m_field, nodes, prior, childHold));
        const auto count = static_cast<double>(nodes.size());
        quadratic += count * m_expected[cell] * m_expected[cell];
        through += count * fit.expectedError * fit.expectedError;
    }
    if (!(through < detailGain * detailGain * quadratic))
        return;
    for (auto& [cell, fit] : detailed) {
        m_patches[cell] = fit.patch;
        m_sources[cell] = std::move(fit.sources);
    }
}

/// As many of some nodes as a patch goes through, near another, and how far they are along one axis at most.
std::pair<PatchTreeBuilder::Nodes, double> PatchTreeBuilder::nearestOf(const Nodes& nodes, std::uint32_t middle) const
{
    std::vector<std::pair<double, std::uint32_t>> byDistance;
    for (const std::uint32_t node : nodes)
        byDistance.emplace_back((m_field.nodes[node] - m_field.nodes[middle]).cwiseAbs().maxCoeff(), node);
    const auto end = byDistance.begin() + static_cast<std::ptrdiff_t>(std::min(byDistance.size(), usuallyDetailed));
    std::partial_sort(byDistance.begin(), end, byDistance.end());
    Nodes nearest;
    for (auto at = byDistance.begin(); at != end; ++at)
        nearest.push_back(at->second);
    return {nearest, (end - 1)->first};
}

/// Of a cell that is as good as quadratic functions get: whether patches through nodes would be better, which are for small cells.
/// Looked at where it is worst, and elsewhere.
bool PatchTreeBuilder::hidesDetail(const Work& work) const
{
    if (m_expected[work.cell] < detailFrom * m_tolerance || work.nodes.size() < leastDetailed)
        return false;
    constexpr std::size_t places = 4;
    const QuadraticPatch& patch = m_patches[work.cell];
    const std::uint32_t worst = *std::max_element(work.nodes.begin(), work.nodes.end(), [&](auto one, auto other) {
        return squaredOff(one, patch) < squaredOff(other, patch);
    });
    double quadratic = 0;
    double through = 0;
    for (std::size_t i = 0; i < places; ++i) {
        const std::uint32_t middle = i == 0 ? worst : work.nodes[i * work.nodes.size() / places];
        const auto [around, reach] = nearestOf(work.nodes, middle);
        if (!(reach > 0))
            continue;
        const QuadraticPatch there = patch.about(m_field.nodes[middle], reach);
        const double quadraticError = fitPatch(m_field, around, there, 1, childHold).expectedError;
        const double throughError = fitThrough(m_field, around, there, childHold).expectedError;
        quadratic += quadraticError * quadraticError;
        through += throughError * throughError;
    }
    return through < detailGain * detailGain * quadratic;
}

/// Of a cell whose children are not split: whether they are expected to be better.
bool PatchTreeBuilder::gainsBySplitting(std::uint32_t cell) const
{
    const std::uint32_t first = m_cells[cell].firstChild;
    double squares = 0;
    for (std::uint32_t child = first; child < first + 8; ++child) {
        if (m_cells[child].firstChild != 0)
            return true;
        squares += m_squares[child];
    }
    return squares < splitGain * splitGain * m_squares[cell];
}

/// Nowhere in its cube much farther off than the best fit there is expected to be.
bool PatchTreeBuilder::isGoodEnough(const Work& work) const
{
    const QuadraticPatch& patch = m_patches[work.cell];
    for (std::size_t begin = 0; begin < work.nodes.size(); begin += nodesJudged) {
        const std::size_t end = std::min(begin + nodesJudged, work.nodes.size());
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t node = work.nodes[i];
            const double allowed = std::max(m_tolerance, worseAllowed * m_error[node]);
            sum += squaredOff(node, patch) / (allowed * allowed);
        }
        if (sum > static_cast<double>(end - begin))
            return false;
    }
    return true;
}

} // namespace knead
