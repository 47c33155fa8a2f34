#include "core/skin/labeled_nodes.h"

#include "core/aggregate/surface_cells.h"
#include "core/task/parallel_progress.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace knead {

namespace {

constexpr double margin = 1e-3;      // cells as close as this to the surface count as touched [cells]
constexpr std::int32_t fitReach = 3; // nodes that a fit looks at, along an axis
constexpr double fitWidth = 1.5;     // standard deviation of its weights [cells]
constexpr double leastSlopeMoment = 1e-2;
constexpr double leastLead = 0.04;      // of the own label of an object: borders stay clear of objects
constexpr double leastLeadAtCut = 2e-3; // where it is known how far they are
constexpr std::size_t nodesPerBlock = 2048;
constexpr std::size_t trianglesPerBlock = 4096;

/// Calls visit(direction, weight) for a node's surroundings: near ones weigh more.
template <typename Visit>
void forEachAround(Visit&& visit)
{
    for (std::int32_t u = -1; u <= 1; ++u)
        for (std::int32_t v = -1; v <= 1; ++v)
            for (std::int32_t w = -1; w <= 1; ++w)
                if (u != 0 || v != 0 || w != 0)
                    visit(Lattice::Node{u, v, w}, 8 >> (u * u + v * v + w * w));
}

/// By squared distance.
std::array<double, fitReach * fitReach + 3> fitWeights()
{
    std::array<double, fitReach * fitReach + 3> weights{};
    for (std::size_t squared = 0; squared < weights.size(); ++squared)
        weights[squared] = std::exp(-static_cast<double>(squared) / (2 * fitWidth * fitWidth));
    return weights;
}

void sortOut(std::vector<Lattice::Node>& nodes)
{
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

} // namespace

LabeledNodes::LabeledNodes(const Aggregate& aggregate, std::span<const std::uint32_t> labels, const CutBorders& cuts,
                           const TriangleMesh& skin, const Vec3& shift, TaskControl& control)
{
    m_lattice.spacing = aggregate.lattice.spacing;
    m_lattice.axes = aggregate.lattice.axes;
    m_lattice.origin = aggregate.lattice.position(Lattice::Node{}) + m_lattice.spacing * (m_lattice.axes * shift);
    collectNodes(aggregate, labels, skin, control);
    m_rows = std::make_unique<const LatticeRows>(m_lattice);
    labelObjects(aggregate, labels);
    spreadLabels(aggregate, labels);
    findBorders();
    findShares(cuts, m_lattice.spacing * (m_lattice.axes * shift), control);
}

void LabeledNodes::collectNodes(const Aggregate& aggregate, std::span<const std::uint32_t> labels,
                                const TriangleMesh& skin, TaskControl& control)
{
    const std::size_t count = skin.triangles.size();
    std::vector<std::vector<Lattice::Node>> touched((count + trianglesPerBlock - 1) / trianglesPerBlock);
    forEachBlock(count, trianglesPerBlock, control, "finding the cracks", [&](std::size_t begin, std::size_t end) {
        std::vector<Lattice::Node>& cells = touched[begin / trianglesPerBlock];
        for (std::size_t t = begin; t < end; ++t) {
            std::array<Vec3, 3> corners;
            for (std::size_t i = 0; i < 3; ++i)
                corners[i] = m_lattice.coordinates(skin.vertices[skin.triangles[t][i]]);
            forEachTouchedCell(corners, margin, [&](const Lattice::Node& cell) { cells.push_back(cell); });
        }
        sortOut(cells);
    });
    std::vector<Lattice::Node> cells;
    for (const std::vector<Lattice::Node>& block : touched)
        cells.insert(cells.end(), block.begin(), block.end());
    sortOut(cells);

    std::vector<Lattice::Node>& nodes = m_lattice.nodes;
    for (const Lattice::Node& cell : cells)
        for (std::size_t c = 0; c < 8; ++c)
            nodes.push_back(Lattice::sum(cell, Lattice::cellCorners[c]));
    for (std::size_t object = 0; object < labels.size(); ++object)
        if (labels[object] != noLabel)
            nodes.push_back(aggregate.lattice.nodes[object]);
    sortOut(nodes);
    control.throwIfCancelled();
}

/// Both lists of nodes are sorted.
void LabeledNodes::labelObjects(const Aggregate& aggregate, std::span<const std::uint32_t> labels)
{
    m_label.assign(m_lattice.size(), noLabel);
    m_isObject.assign(m_lattice.size(), 0);
    std::size_t node = 0;
    for (std::size_t object = 0; object < labels.size(); ++object) {
        if (labels[object] == noLabel)
            continue;
        while (m_lattice.nodes[node] != aggregate.lattice.nodes[object])
            ++node;
        m_label[node] = labels[object];
        m_isObject[node] = 1;
    }
}

/// Nodes without an object take the label that most of those next to them have, layer by layer.
void LabeledNodes::spreadLabels(const Aggregate& aggregate, std::span<const std::uint32_t> labels)
{
    std::vector<ObjectIndex> open;
    for (ObjectIndex node = 0; node < m_lattice.size(); ++node)
        if (m_label[node] == noLabel)
            open.push_back(node);
    while (!open.empty()) {
        std::vector<std::uint32_t> found(open.size(), noLabel);
        forEachBlock(open.size(), nodesPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                std::vector<std::pair<std::uint32_t, int>> votes;
                forEachAround([&](const Lattice::Node& direction, int weight) {
                    const ObjectIndex other = m_rows->find(Lattice::sum(m_lattice.nodes[open[i]], direction));
                    if (other == m_lattice.size() || m_label[other] == noLabel)
                        return;
                    const auto vote =
                        std::ranges::find_if(votes, [&](const auto& v) { return v.first == m_label[other]; });
                    if (vote == votes.end())
                        votes.emplace_back(m_label[other], weight);
                    else
                        vote->second += weight;
                });
                const auto best = std::ranges::max_element(votes, [](const auto& a, const auto& b) {
                    return a.second != b.second ? a.second < b.second : a.first > b.first;
                });
                if (best != votes.end())
                    found[i] = best->first;
            }
        });
        std::vector<ObjectIndex> left;
        for (std::size_t i = 0; i < open.size(); ++i) {
            m_label[open[i]] = found[i];
            if (found[i] == noLabel)
                left.push_back(open[i]);
        }
        if (left.size() == open.size())
            break;
        open = std::move(left);
    }
    if (open.empty())
        return;
    // What no object is near to, such as a solid too thin to hold any.
    const LatticeRows objects(aggregate.lattice);
    const std::uint32_t any = *std::ranges::min_element(labels);
    for (const ObjectIndex node : open) {
        const Lattice::Node& n = m_lattice.nodes[node];
        const std::uint32_t label = labels[objects.nearest(Vec3(n[0], n[1], n[2]))];
        m_label[node] = label == noLabel ? any : label;
    }
}

void LabeledNodes::findBorders()
{
    findSegments(m_lattice, Lattice::directionCount);
    m_placeInNear.assign(m_lattice.size(), far);
    const auto add = [&](ObjectIndex node) {
        if (m_placeInNear[node] != far)
            return;
        m_placeInNear[node] = 0;
        m_near.push_back(node);
    };
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : m_lattice.segments[d])
            for (ObjectIndex node = segment.begin; node < segment.end; ++node) {
                const ObjectIndex other = node + static_cast<ObjectIndex>(segment.offset);
                if (m_label[node] != m_label[other] &&
                    Lattice::sum(m_lattice.nodes[node], Lattice::directions[d]) == m_lattice.nodes[other]) {
                    add(node);
                    add(other);
                }
            }
    m_isBorder.assign(m_lattice.size(), 0);
    for (const ObjectIndex node : m_near)
        m_isBorder[node] = 1;
    for (std::size_t i = 0, borders = m_near.size(); i < borders; ++i)
        forEachAround([&](const Lattice::Node& direction, int) {
            const ObjectIndex other = m_rows->find(Lattice::sum(m_lattice.nodes[m_near[i]], direction));
            if (other != m_lattice.size())
                add(other);
        });
    std::ranges::sort(m_near);
    for (std::size_t i = 0; i < m_near.size(); ++i)
        m_placeInNear[m_near[i]] = static_cast<std::uint32_t>(i);
}

/// @param offset of the nodes from the lattice of objects [m]: cuts are moved along with it, or objects beside them would be on the
/// wrong side
void LabeledNodes::findShares(const CutBorders& cuts, const Vec3& offset, TaskControl& control)
{
    m_shares.resize(m_near.size());
    m_isAtCut.assign(m_near.size(), 0);
    forEachBlock(m_near.size(), nodesPerBlock, control, "smoothing the cracks",
                 [&](std::size_t begin, std::size_t end) {
                     for (std::size_t near = begin; near < end; ++near) {
                         const auto cut = cuts.at(m_lattice.position(m_near[near]) - offset);
                         m_isAtCut[near] = cut ? 1 : 0;
                         m_shares[near] =
                             cut ? Shares{{cut->below, 0.5 - 0.5 * cut->height}, {cut->above, 0.5 + 0.5 * cut->height}}
                                 : fitted(m_near[near]);
                     }
                 });
    addLeads();
    for (std::size_t near = 0; near < m_near.size(); ++near)
        keepOwnLabel(near);
}

/// The share of a label; one that is not there yet begins at 0.
double& LabeledNodes::shareIn(Shares& shares, std::uint32_t label)
{
    const auto known = std::ranges::find(shares, label, &Share::label);
    return known != shares.end() ? known->share : shares.emplace_back(Share{label, 0}).share;
}

/// The labels of the objects around a node are 1 there and 0 elsewhere; a linear function fitted to them, near ones first,
/// makes a plane of stairs, and carries it on beyond the outermost objects.
LabeledNodes::Shares LabeledNodes::fitted(ObjectIndex node) const
{
    static const std::array<double, fitReach* fitReach + 3> weights = fitWeights();
    struct Sample {
        std::uint32_t label;
        Eigen::Vector4d weighted; // basis functions 1, u, v, w
    };
    std::array<Sample, (2 * fitReach + 1) * (2 * fitReach + 1) * (2 * fitReach + 1)> samples;
    std::size_t count = 0;
    Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
    const Lattice::Node& here = m_lattice.nodes[node];
    for (std::int32_t u = -fitReach; u <= fitReach; ++u)
        for (std::int32_t v = -fitReach; v <= fitReach; ++v) {
            const LatticeRows::Row row = m_rows->row(here[0] + u, here[1] + v);
            for (ObjectIndex other = m_rows->lowerBound(row, here[2] - fitReach);
                 other < row.end && m_lattice.nodes[other][2] <= here[2] + fitReach; ++other) {
                const std::int32_t w = m_lattice.nodes[other][2] - here[2];
                const auto squared = static_cast<std::size_t>(u * u + v * v + w * w);
                if (m_isObject[other] == 0 || squared >= weights.size())
                    continue;
                const Eigen::Vector4d basis(1, u, v, w);
                samples[count] = {m_label[other], weights[squared] * basis};
                moments += samples[count].weighted * basis.transpose();
                ++count;
            }
        }
    if (count == 0)
        return {{m_label[node], 1}};
    // A little stiffness against slopes settles those that too few objects tell.
    moments.diagonal().tail<3>().array() += leastSlopeMoment * moments(0, 0);
    const Eigen::Vector4d functions = moments.ldlt().solve(Eigen::Vector4d::UnitX());
    Shares shares;
    for (std::size_t i = 0; i < count; ++i) {
        const double part = samples[i].weighted.dot(functions);
        shareIn(shares, samples[i].label) += part;
    }
    return shares;
}

/// Of thin or strongly curved pieces too little is left by the fit. Each label gets a lead on its own nodes, as much as puts
/// its border half way between its objects and their neighbors, on average.
void LabeledNodes::addLeads()
{
    struct Leads {
        double own = 0;
        double others = 0;
        double count = 0;
    };
    std::map<std::uint32_t, Leads> leads;
    const auto add = [&](ObjectIndex node, ObjectIndex other) {
        Leads& sum = leads[m_label[node]];
        sum.own += share(node, m_label[node]) - share(node, m_label[other]);
        sum.others += share(other, m_label[other]) - share(other, m_label[node]);
        ++sum.count;
    };
    for (std::size_t d = 0; d < 3; ++d) // along the axes
        for (const Lattice::Segment& segment : m_lattice.segments[d])
            for (ObjectIndex node = segment.begin; node < segment.end; ++node) {
                const ObjectIndex other = node + static_cast<ObjectIndex>(segment.offset);
                if (m_label[node] != m_label[other] && m_isObject[node] != 0 && m_isObject[other] != 0 &&
                    !isAtCut(node) && !isAtCut(other) &&
                    Lattice::sum(m_lattice.nodes[node], Lattice::directions[d]) == m_lattice.nodes[other]) {
                    add(node, other);
                    add(other, node);
                }
            }
    for (std::size_t near = 0; near < m_near.size(); ++near) {
        if (m_isAtCut[near] != 0)
            continue;
        const std::uint32_t label = m_label[m_near[near]];
        const Leads& sum = leads[label];
        const double lead = sum.count > 0 ? std::max(0.0, (sum.others - sum.own) / sum.count) : 0;
        shareIn(m_shares[near], label) += lead;
    }
}

/// An object's own label stays ahead of all others, as does that of a node that may not change; other nodes without an
/// object take the label of the largest share.
void LabeledNodes::keepOwnLabel(std::size_t near)
{
    const ObjectIndex node = m_near[near];
    const bool mayChange = m_isObject[node] == 0 && m_isBorder[node] != 0;
    double largest = -std::numeric_limits<double>::infinity();
    std::uint32_t label = m_label[node];
    for (const Share& share : m_shares[near])
        if ((mayChange || share.label != m_label[node]) &&
            (share.share > largest || (share.share == largest && share.label < label))) {
            largest = share.share;
            label = share.label;
        }
    if (mayChange) {
        m_label[node] = label;
        return;
    }
    for (Share& share : m_shares[near])
        if (share.label == m_label[node])
            share.share = std::max(share.share, largest + (m_isAtCut[near] != 0 ? leastLeadAtCut : leastLead));
}

double LabeledNodes::share(std::size_t node, std::uint32_t label) const
{
    if (m_placeInNear[node] == far)
        return m_label[node] == label ? 1 : 0;
    for (const Share& share : m_shares[m_placeInNear[node]])
        if (share.label == label)
            return share.share;
    return 0;
}

bool LabeledNodes::cornersAbove(const Lattice::Node& lowest, std::array<ObjectIndex, 8>& corners) const
{
    for (std::size_t c = 0; c < 8; ++c) {
        corners[c] = m_rows->find(Lattice::sum(lowest, Lattice::cellCorners[c]));
        if (corners[c] == m_lattice.size())
            return false;
    }
    return true;
}

LabeledNodes::Found LabeledNodes::find(const Vec3& place) const
{
    const Vec3 coordinates = m_lattice.coordinates(place);
    const Vec3 low = coordinates.array().floor();
    std::array<ObjectIndex, 8> corners{};
    if (!cornersAbove({static_cast<std::int32_t>(low.x()), static_cast<std::int32_t>(low.y()),
                       static_cast<std::int32_t>(low.z())},
                      corners))
        return {};
    const std::uint32_t first = m_label[corners[0]];
    if (std::ranges::all_of(corners, [&](ObjectIndex node) { return m_label[node] == first; }))
        return {first, true};
    std::array<double, 8> weights{};
    const Vec3 part = coordinates - low;
    for (std::size_t c = 0; c < 8; ++c) {
        const Lattice::Node& n = Lattice::cellCorners[c];
        weights[c] = 1;
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = part[static_cast<Eigen::Index>(i)];
            weights[c] *= n[i] == 1 ? x : 1 - x;
        }
    }
    Found found;
    double largest = -1;
    for (const ObjectIndex candidate : corners) {
        double total = 0;
        for (std::size_t c = 0; c < 8; ++c)
            total += weights[c] * share(corners[c], m_label[candidate]);
        if (total > largest) {
            largest = total;
            found.label = m_label[candidate];
        }
    }
    return found;
}

} // namespace knead
