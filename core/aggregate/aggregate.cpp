#include "core/aggregate/aggregate.h"

#include <algorithm>

namespace knead {

std::size_t Aggregate::connectionCount() const
{
    std::size_t count = 0;
    for (const std::vector<double>& weights : weight)
        count += static_cast<std::size_t>(std::ranges::count_if(weights, [](double w) { return w > 0; }));
    return count;
}

} // namespace knead
