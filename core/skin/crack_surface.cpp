#include "core/skin/crack_surface.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace knead {

namespace {

constexpr double jitter = 2e-6;     // [cells]
constexpr double leastShare = 0.02; // of an edge: no border comes closer to a node

// Corners of a cell as bits 4 u + 2 v + w, in the order of a way along the axes; even and odd orders alternate.
constexpr std::size_t ways[6][4] = {{0, 4, 6, 7}, {0, 4, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 1, 5, 7}, {0, 1, 3, 7}};

/// A number from -1 to 1 (Murmur3's finalizer).
double scatter(std::uint64_t bits)
{
    bits = (bits ^ (bits >> 33)) * 0xff51afd7ed558ccdULL;
    bits = (bits ^ (bits >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    bits ^= bits >> 33;
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
}

class Marcher {
public:
    Marcher(const LabeledNodes& nodes, std::uint64_t salt)
        : m_nodes(nodes)
        , m_salt(salt)
    {
    }

    void addCell(const Lattice::Node& lowest)
    {
        std::array<ObjectIndex, 8> corners{};
        if (!m_nodes.cornersAbove(lowest, corners))
            return;
        const auto isFirst = [&](ObjectIndex node) { return m_nodes.label(node) == m_nodes.label(corners[0]); };
        if (std::ranges::all_of(corners, isFirst))
            return;
        const auto begin = static_cast<std::uint32_t>(m_surface.triangles.size());
        for (std::size_t way = 0; way < 6; ++way) {
            for (std::size_t i = 0; i < 4; ++i) {
                m_corner[i] = ways[way][i];
                m_node[i] = corners[m_corner[i]];
            }
            m_center = none;
            addTetrahedron(way % 2 == 0);
        }
        m_surface.cells.push_back({lowest, begin, static_cast<std::uint32_t>(m_surface.triangles.size())});
    }

    CrackSurface finish()
    {
        std::unordered_map<std::uint64_t, std::uint32_t> known;
        for (CrackSurface::Triangle& triangle : m_surface.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const auto [low, high] = std::minmax(triangle.corners[i], triangle.corners[(i + 1) % 3]);
                const auto [edge, isNew] = known.try_emplace(std::uint64_t{low} << 32 | high,
                                                             static_cast<std::uint32_t>(m_surface.edges.size()));
                if (isNew)
                    m_surface.edges.push_back({low, high});
                triangle.edges[i] = edge->second;
            }
        return std::move(m_surface);
    }

private:
    static constexpr std::uint32_t none = 0xffffffffU;
    using Order = std::array<std::size_t, 4>; // of the corners of the tetrahedron

    std::uint32_t label(std::size_t i) const { return m_nodes.label(m_node[i]); }

    Vec3 place(std::size_t i) const
    {
        const Lattice::Node& n = m_nodes.lattice().nodes[m_node[i]];
        return {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])};
    }

    /// Corners of which the first two have other labels than the last two, and the like, are put in the order that a case
    /// is written down for; of a mirrored tetrahedron two equal ones are exchanged.
    void addTetrahedron(bool isRight)
    {
        std::array<std::uint32_t, 4> labels{};
        for (std::size_t i = 0; i < 4; ++i)
            labels[i] = label(i);
        Order order{0, 1, 2, 3};
        std::array<std::ptrdiff_t, 4> times{};
        for (std::size_t i = 0; i < 4; ++i)
            times[i] = std::ranges::count(labels, labels[i]);
        const std::ptrdiff_t most = *std::ranges::max_element(times);
        if (most == 4)
            return;
        // A lone corner first; or else the pairs of equal ones together, the larger group first.
        std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) {
            if (times[i] != times[j])
                return most == 3 ? times[i] < times[j] : times[i] > times[j];
            return labels[i] < labels[j];
        });
        const bool orderIsEven = [&] {
            int swaps = 0;
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = i + 1; j < 4; ++j)
                    swaps += order[i] > order[j] ? 1 : 0;
            return swaps % 2 == 0;
        }();
        if (orderIsEven != isRight) {
            if (most == 3)
                std::swap(order[2], order[3]);
            else if (most == 2)
                std::swap(order[0], order[1]);
        }
        const auto [i, j, k, l] = order;
        if (most == 3) {
            addTriangle(i, j, onEdge(i, j), onEdge(i, k), onEdge(i, l));
        } else if (most == 2 && times[k] == 2) {
            addQuad(i, k, {onEdge(i, k), onEdge(i, l), onEdge(j, l), onEdge(j, k)});
        } else if (most == 2) {
            const std::uint32_t first = onFace(i, k, l);
            const std::uint32_t second = onFace(j, k, l);
            addQuad(i, k, {onEdge(i, k), first, second, onEdge(j, k)});
            addQuad(l, i, {onEdge(i, l), first, second, onEdge(j, l)});
            addTriangle(k, l, onEdge(k, l), first, second);
        } else {
            constexpr std::size_t pairs[6][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                                 {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}};
            for (const auto& p : pairs) {
                const std::size_t third = isRight ? p[2] : p[3];
                const std::size_t fourth = isRight ? p[3] : p[2];
                addQuad(p[0], p[1],
                        {onEdge(p[0], p[1]), onFace(p[0], p[1], third), center(), onFace(p[0], p[1], fourth)});
            }
        }
    }

    void addTriangle(std::size_t back, std::size_t front, std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        m_surface.triangles.push_back({.corners = {a, b, c}, .back = label(back), .front = label(front)});
    }

    void addQuad(std::size_t back, std::size_t front, const std::array<std::uint32_t, 4>& corners)
    {
        addTriangle(back, front, corners[0], corners[1], corners[2]);
        addTriangle(back, front, corners[0], corners[2], corners[3]);
    }

    std::uint32_t addVertex(const Vec3& coordinates)
    {
        const std::uint64_t number = 3 * (m_surface.vertices.size() + 1) + (m_salt << 40);
        const Vec3 moved = coordinates + jitter * Vec3(scatter(number), scatter(number + 1), scatter(number + 2));
        const Lattice& lattice = m_nodes.lattice();
        m_surface.vertices.push_back(lattice.origin + lattice.spacing * (lattice.axes * moved));
        m_coordinates.push_back(coordinates);
        return static_cast<std::uint32_t>(m_surface.vertices.size() - 1);
    }

    /// Where the shares of the labels of two corners are equal. Depends on the two nodes only, as does the vertex.
    std::uint32_t onEdge(std::size_t i, std::size_t j)
    {
        if (i > j)
            std::swap(i, j);
        const std::uint64_t key = std::uint64_t{m_node[i]} * 8 + (m_corner[j] ^ m_corner[i]);
        if (const auto known = m_onEdges.find(key); known != m_onEdges.end())
            return known->second;
        const double lead = m_nodes.share(m_node[i], label(i)) - m_nodes.share(m_node[i], label(j));
        const double otherLead = m_nodes.share(m_node[j], label(j)) - m_nodes.share(m_node[j], label(i));
        const double part = lead + otherLead > 0 ? lead / (lead + otherLead) : 0.5;
        const double way = std::clamp(part, leastShare, 1 - leastShare);
        return m_onEdges[key] = addVertex(place(i) + way * (place(j) - place(i)));
    }

    /// Where the shares of three labels are equal; the middle of the points on its edges where that is not in the face.
    std::uint32_t onFace(std::size_t i, std::size_t j, std::size_t k)
    {
        std::array<std::size_t, 3> c{i, j, k};
        std::ranges::sort(c);
        const std::uint64_t key = std::uint64_t{m_node[c[0]]} * 64 + (m_corner[c[1]] ^ m_corner[c[0]]) * 8 +
                                  (m_corner[c[2]] ^ m_corner[c[0]]);
        if (const auto known = m_onFaces.find(key); known != m_onFaces.end())
            return known->second;
        Mat3 equations;
        for (int corner = 0; corner < 3; ++corner) {
            const auto share = [&](std::size_t of) {
                return m_nodes.share(m_node[c[static_cast<std::size_t>(corner)]], label(c[of]));
            };
            equations.col(corner) = Vec3(share(0) - share(1), share(0) - share(2), 1);
        }
        const Vec3 weights = equations.fullPivLu().solve(Vec3(0, 0, 1));
        const bool isInside =
            weights.allFinite() && weights.minCoeff() > leastShare && std::abs(weights.sum() - 1) < 1e-6;
        Vec3 middle = Vec3::Zero();
        if (isInside) {
            for (std::size_t corner = 0; corner < 3; ++corner)
                middle += weights[static_cast<Eigen::Index>(corner)] * place(c[corner]);
        } else {
            for (std::size_t corner = 0; corner < 3; ++corner)
                middle += m_coordinates[onEdge(c[corner], c[(corner + 1) % 3])] / 3;
        }
        return m_onFaces[key] = addVertex(middle);
    }

    /// Of a tetrahedron with four labels.
    std::uint32_t center()
    {
        if (m_center == none) {
            const Vec3 sum = m_coordinates[onFace(0, 1, 2)] + m_coordinates[onFace(0, 1, 3)] +
                             m_coordinates[onFace(0, 2, 3)] + m_coordinates[onFace(1, 2, 3)];
            m_center = addVertex(sum / 4);
        }
        return m_center;
    }

    const LabeledNodes& m_nodes;
    std::uint64_t m_salt;
    CrackSurface m_surface;
    std::vector<Vec3> m_coordinates; // of the vertices in the lattice, not moved
    std::unordered_map<std::uint64_t, std::uint32_t> m_onEdges;
    std::unordered_map<std::uint64_t, std::uint32_t> m_onFaces;
    std::array<ObjectIndex, 4> m_node{};   // of the present tetrahedron
    std::array<std::size_t, 4> m_corner{}; // of the cell
    std::uint32_t m_center = none;
};

} // namespace

CrackSurface findCrackSurface(const LabeledNodes& nodes, std::uint64_t salt, TaskControl& control)
{
    Marcher marcher(nodes, salt);
    for (std::size_t i = 0; i < nodes.nearBorders().size(); ++i) {
        if (i % 4096 == 0)
            control.throwIfCancelled();
        marcher.addCell(nodes.lattice().nodes[nodes.nearBorders()[i]]);
    }
    return marcher.finish();
}

} // namespace knead
