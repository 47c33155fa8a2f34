#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace knead {

/// How often to look at the error of a fit within a span, and where: nowhere near its ends, at which interpolation is good by itself.
/// @param feature size of what is not to be overlooked, as a parameter @param most looks
inline std::vector<double> looksInto(double begin, double end, double feature, std::size_t most)
{
    constexpr std::size_t leastLooks = 3;
    const double wanted = std::ceil(1.5 * (end - begin) / feature);
    const auto count =
        static_cast<std::size_t>(std::clamp(wanted, static_cast<double>(leastLooks), static_cast<double>(most)));
    std::vector<double> looks;
    for (std::size_t i = 0; i < count; ++i)
        looks.push_back(begin + (end - begin) * (static_cast<double>(i) + 0.45) / static_cast<double>(count));
    return looks;
}

inline bool anyOf(const std::vector<bool>& marks)
{
    return std::ranges::find(marks, true) != marks.end();
}

} // namespace knead
