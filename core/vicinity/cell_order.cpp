#include "core/vicinity/cell_order.h"

#include <array>
#include <bit>
#include <utility>

namespace knead {

namespace {

constexpr unsigned mostBits = 11; // of a digit: its counters fit the first cache

using Counters = std::array<std::uint32_t, std::size_t{1} << mostBits>;

} // namespace

/// By counting on one digit of the key after the other, the lowest first.
void sortByCell(std::vector<CellEntry>& entries, std::uint64_t largestKey, std::vector<CellEntry>& scratch)
{
    const auto bits = static_cast<unsigned>(std::bit_width(largestKey));
    const unsigned digits = (bits + mostBits - 1) / mostBits;
    if (digits == 0)
        return;
    const unsigned digitBits = (bits + digits - 1) / digits;
    const std::uint64_t mask = (std::uint64_t{1} << digitBits) - 1;
    scratch.resize(entries.size());
    std::vector<Counters> next(digits);
    for (const CellEntry& entry : entries)
        for (unsigned digit = 0; digit < digits; ++digit)
            ++next[digit][entry.key >> digit * digitBits & mask];
    for (unsigned digit = 0; digit < digits; ++digit) {
        std::uint32_t sum = 0;
        for (std::uint32_t& begin : next[digit])
            sum += std::exchange(begin, sum);
        for (const CellEntry& entry : entries)
            scratch[next[digit][entry.key >> digit * digitBits & mask]++] = entry;
        entries.swap(scratch);
    }
}

} // namespace knead
