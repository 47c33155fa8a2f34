#include "core/aggregate/lattice_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knead {

LatticeRows::LatticeRows(const Lattice& lattice)
    : m_lattice(lattice)
{
    const std::vector<Lattice::Node>& nodes = lattice.nodes;
    if (!nodes.empty())
        m_firstPlane = nodes.front()[0];
    for (ObjectIndex i = 0; i < nodes.size(); ++i) {
        m_bounds.extend(Eigen::Vector3i(nodes[i][0], nodes[i][1], nodes[i][2]));
        if (i > 0 && nodes[i][0] == nodes[i - 1][0] && nodes[i][1] == nodes[i - 1][1])
            continue;
        m_planeBegin.resize(std::max(m_planeBegin.size(), static_cast<std::size_t>(nodes[i][0] - m_firstPlane) + 1),
                            m_rows.size());
        m_rows.push_back({nodes[i][1], i});
    }
    m_planeBegin.push_back(m_rows.size());
    m_rows.push_back({0, static_cast<ObjectIndex>(nodes.size())});
}

LatticeRows::Row LatticeRows::row(std::int32_t u, std::int32_t v) const
{
    const std::int64_t plane = std::int64_t{u} - m_firstPlane;
    if (plane < 0 || plane + 1 >= static_cast<std::int64_t>(m_planeBegin.size()))
        return {};
    const auto begin = m_rows.begin() + static_cast<std::ptrdiff_t>(m_planeBegin[static_cast<std::size_t>(plane)]);
    const auto end = m_rows.begin() + static_cast<std::ptrdiff_t>(m_planeBegin[static_cast<std::size_t>(plane) + 1]);
    const auto found =
        std::lower_bound(begin, end, v, [](const RowStart& row, std::int32_t wanted) { return row.v < wanted; });
    if (found == end || found->v != v)
        return {};
    return {found->begin, (found + 1)->begin};
}

ObjectIndex LatticeRows::lowerBound(const Row& row, std::int32_t w) const
{
    const auto begin = m_lattice.nodes.begin();
    const auto found =
        std::lower_bound(begin + row.begin, begin + row.end, w,
                         [](const Lattice::Node& node, std::int32_t wanted) { return node[2] < wanted; });
    return static_cast<ObjectIndex>(found - begin);
}

ObjectIndex LatticeRows::find(const Lattice::Node& node) const
{
    const Row there = row(node[0], node[1]);
    const ObjectIndex object = lowerBound(there, node[2]);
    const bool found = object < there.end && m_lattice.nodes[object][2] == node[2];
    return found ? object : static_cast<ObjectIndex>(m_lattice.size());
}

ObjectIndex LatticeRows::nearest(const Vec3& coordinates) const
{
    const Vec3 place = coordinates.cwiseMax(m_bounds.min().cast<double>()).cwiseMin(m_bounds.max().cast<double>());
    const auto middleU = static_cast<std::int32_t>(std::lround(place.x()));
    const auto middleV = static_cast<std::int32_t>(std::lround(place.y()));
    ObjectIndex best = 0;
    double bestDistance = std::numeric_limits<double>::infinity();
    const auto consider = [&](ObjectIndex object) {
        const Lattice::Node& node = m_lattice.nodes[object];
        const double distance = (Vec3(node[0], node[1], node[2]) - place).norm();
        if (distance < bestDistance || (distance == bestDistance && object < best)) {
            best = object;
            bestDistance = distance;
        }
    };
    const auto considerRow = [&](std::int32_t u, std::int32_t v) {
        const Row objects = row(u, v);
        const ObjectIndex above = lowerBound(objects, static_cast<std::int32_t>(std::ceil(place.z())));
        if (above < objects.end)
            consider(above);
        if (above > objects.begin)
            consider(above - 1);
    };
    // Rings of rows about the place; those of ring r are at least r - 1/2 away.
    for (std::int32_t ring = 0; ring - 0.5 <= bestDistance; ++ring)
        for (std::int32_t u = middleU - ring; u <= middleU + ring; ++u) {
            const bool side = std::abs(u - middleU) == ring;
            for (std::int32_t v = middleV - ring; v <= middleV + ring; v += side || ring == 0 ? 1 : 2 * ring)
                considerRow(u, v);
        }
    return best;
}

} // namespace knead
