#include "core/mechanics/run_slots.h"

#include <algorithm>

namespace knead {

namespace {

constexpr auto lanes = static_cast<std::int32_t>(SlotBlock::lanes);

std::int32_t blockOf(std::int32_t w)
{
    return w >= 0 ? w / lanes : -((lanes - 1 - w) / lanes);
}

/// Blocks begin .. end of one row of the lattice, with an empty one before and after them.
struct Row {
    std::int32_t u = 0;
    std::int32_t v = 0;
    std::int32_t begin = 0;
    std::int32_t end = 0;
    std::uint32_t slot = 0; ///< of the first
};

} // namespace

RunSlots::RunSlots(const Lattice& lattice)
    : m_slot(lattice.size())
{
    std::vector<Row> rows;
    std::vector<std::uint8_t> isFilled; ///< by block of slots
    m_size = SlotBlock::lanes;          // empty
    for (ObjectIndex i = 0; i < lattice.size(); ++i) {
        const auto [u, v, w] = lattice.nodes[i];
        const std::int32_t block = blockOf(w);
        const bool sameLine = !rows.empty() && rows.back().u == u && rows.back().v == v;
        const bool sameRow = sameLine && block <= rows.back().end + 1; // over one that is empty
        if (!sameRow) {
            if (!rows.empty())
                m_size += SlotBlock::lanes;
            rows.push_back({u, v, block, block, static_cast<std::uint32_t>(m_size)});
        }
        Row& row = rows.back();
        if (block >= row.end) {
            m_size += static_cast<std::size_t>(block + 1 - row.end) * SlotBlock::lanes;
            row.end = block + 1;
        }
        m_slot[i] = row.slot + static_cast<std::uint32_t>(w - lanes * row.begin);
        if (i > 0 && m_slot[i] == m_slot[i - 1] + 1)
            m_runs.back().end = i + 1;
        else
            m_runs.push_back({i, i + 1});
        isFilled.resize(m_size / SlotBlock::lanes, 0);
        isFilled[m_slot[i] / SlotBlock::lanes] = 1;
    }
    m_size += 2 * SlotBlock::lanes;
    const auto placed = [](const Row& row) { return std::pair(row.u, row.v); };
    /// The first slot of a block of a line of the lattice, or one among empty ones.
    const auto slotAt = [&](std::int32_t u, std::int32_t v, std::int32_t block) -> std::uint32_t {
        auto row =
            std::partition_point(rows.begin(), rows.end(), [&](const Row& r) { return placed(r) < std::pair(u, v); });
        for (; row != rows.end() && placed(*row) == std::pair(u, v); ++row)
            if (block >= row->begin - 1 && block <= row->end)
                return row->slot + static_cast<std::uint32_t>((block - row->begin) * lanes);
        return static_cast<std::uint32_t>(m_size) - SlotBlock::lanes;
    };
    for (const Row& row : rows)
        for (std::int32_t block = row.begin; block < row.end; ++block) {
            SlotBlock next{row.slot + static_cast<std::uint32_t>((block - row.begin) * lanes), {}};
            if (isFilled[next.first / SlotBlock::lanes] == 0)
                continue;
            for (int du = -1; du <= 1; ++du)
                for (int dv = -1; dv <= 1; ++dv)
                    next.offset[3 * (du + 1) + dv + 1] =
                        static_cast<std::int32_t>(slotAt(row.u + du, row.v + dv, block)) -
                        static_cast<std::int32_t>(next.first);
            m_blocks.push_back(next);
        }
}

} // namespace knead
