#pragma once

#include "core/aggregate/lattice_rows.h"
#include "core/aggregate/moment_spread.h"

#include <array>

namespace knead {

/// The objects around nodes, quicker for nodes of the same row one after the other.
class ObjectsAround {
public:
    ObjectsAround(const Lattice& lattice, const LatticeRows& rows)
        : m_lattice(lattice)
        , m_rows(rows)
    {
    }

    const MomentSpread::Objects& around(const Lattice::Node& node)
    {
        constexpr std::int32_t across = MomentSpread::across;
        m_objects.fill(static_cast<ObjectIndex>(m_lattice.size()));
        if (m_row != std::array{node[0], node[1]})
            goTo(node[0], node[1]);
        const std::int32_t low = node[2] - MomentSpread::reach;
        for (std::size_t row = 0; row < m_around.size(); ++row)
            for (ObjectIndex i = m_rows.lowerBound(m_around[row], low); i < m_around[row].end; ++i) {
                const std::int32_t w = m_lattice.nodes[i][2] - low;
                if (w >= across)
                    break;
                m_objects[row * across + static_cast<std::size_t>(w)] = i;
            }
        return m_objects;
    }

private:
    void goTo(std::int32_t u, std::int32_t v)
    {
        constexpr std::int32_t across = MomentSpread::across;
        m_row = {u, v};
        for (std::int32_t row = 0; row < across * across; ++row)
            m_around[static_cast<std::size_t>(row)] =
                m_rows.row(u - MomentSpread::reach + row / across, v - MomentSpread::reach + row % across);
    }

    const Lattice& m_lattice;
    const LatticeRows& m_rows;
    std::array<std::int32_t, 2> m_row{-1, -1}; ///< (u, v) of the node now
    std::array<LatticeRows::Row, MomentSpread::nodes / MomentSpread::across> m_around{};
    MomentSpread::Objects m_objects{};
};

} // namespace knead
