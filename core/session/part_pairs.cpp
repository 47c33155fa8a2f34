#include "core/session/part_pairs.h"

#include <algorithm>
#include <numeric>

namespace knead {

std::vector<PartPair> pairsOfParts(std::span<const Part* const> before, std::span<const Part* const> after)
{
    std::vector<std::size_t> originals(before.size());
    std::vector<std::size_t> others(after.size());
    std::iota(originals.begin(), originals.end(), std::size_t{0});
    std::iota(others.begin(), others.end(), std::size_t{0});
    std::vector<PartPair> pairs;
    const auto pair = [&](auto belong) {
        std::erase_if(others, [&](std::size_t other) {
            const auto found =
                std::ranges::find_if(originals, [&](std::size_t one) { return belong(*before[one], *after[other]); });
            if (found == originals.end())
                return false;
            pairs.push_back({*found, other});
            originals.erase(found);
            return true;
        });
    };
    pair([](const Part& a, const Part& b) { return a.path == b.path && a.name == b.name; });
    pair([](const Part& a, const Part& b) { return a.name == b.name; });
    pair([](const Part&, const Part&) { return true; });
    return pairs;
}

} // namespace knead
