#include "core/vicinity/cell_order.h"

#include <array>
#include <bit>

namespace knead {

namespace {

constexpr unsigned mostBits = 11; // of a digit: its counters fit the first cache

} // namespace

/// By counting on one digit of the key after the other, the lowest first.
void sortByCell(std::vector<CellEntry>& entries, std::uint64_t largestKey)
{
    const auto bits = static_cast<unsigned>(std::bit_width(largestKey));
    const unsigned digits = (bits + mostBits - 1) / mostBits;
    if (digits == 0)
        return;
    const unsigned digitBits = (bits + digits - 1) / digits;
    const std::uint64_t mask = (std::uint64_t{1} << digitBits) - 1;
    std::vector<CellEntry> sorted(entries.size());
    for (unsigned shift = 0; shift < bits; shift += digitBits) {
        std::array<std::uint32_t, std::size_t{1} << mostBits> next{};
        for (const CellEntry& entry : entries)
            ++next[entry.key >> shift & mask];
        std::uint32_t sum = 0;
        for (std::uint32_t& begin : next) {
            const std::uint32_t count = begin;
            begin = sum;
            sum += count;
        }
        for (const CellEntry& entry : entries)
            sorted[next[entry.key >> shift & mask]++] = entry;
        entries.swap(sorted);
    }
}

} // namespace knead
