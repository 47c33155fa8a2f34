#pragma once

#include "core/aggregate/lattice.h"
#include "core/kernels/slot_block.h"

#include <cstdint>
#include <vector>

namespace knead {

/// Where the objects of a body stand in the arrays of the linear solver, so that its loops take eight at a time, with their
/// neighbors in eight slots that begin at one place. Objects in a row along w stand side by side, at w modulo 8; a row begins
/// and ends with empty slots, in which every array has zeros. Immutable.
class RunSlots {
public:
    explicit RunSlots(const Lattice& lattice);

    std::size_t size() const { return m_size; }
    std::uint32_t of(ObjectIndex object) const { return m_slot[object]; }

    /// Those with an object, in the order of their slots.
    const std::vector<SlotBlock>& blocks() const { return m_blocks; }

    /// Objects that stand side by side in ascending slots.
    struct Run {
        ObjectIndex begin = 0;
        ObjectIndex end = 0;
    };
    const std::vector<Run>& runs() const { return m_runs; }

private:
    std::vector<std::uint32_t> m_slot;
    std::vector<SlotBlock> m_blocks;
    std::vector<Run> m_runs;
    std::size_t m_size = 0;
};

} // namespace knead
