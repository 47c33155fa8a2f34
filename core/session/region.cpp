#include "core/session/region.h"

#include <algorithm>
#include <iterator>

namespace knead {

namespace {

template <class Operation>
Region combined(const Region& a, const Region& b, const Operation& operation)
{
    static const Region::Items none;
    Region result;
    result.level = a.level;
    const auto itemsOf = [](const Region& region, BodyId body) -> const Region::Items& {
        const auto found = region.items.find(body);
        return found == region.items.end() ? none : found->second;
    };
    const auto combine = [&](BodyId body) {
        const Region::Items& first = itemsOf(a, body);
        const Region::Items& second = itemsOf(b, body);
        Region::Items items;
        operation(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(items));
        if (!items.empty())
            result.items[body] = std::move(items);
    };
    for (const auto& [body, items] : a.items)
        combine(body);
    for (const auto& [body, items] : b.items)
        if (!a.items.contains(body))
            combine(body);
    return result;
}

} // namespace

std::size_t Region::count() const
{
    std::size_t sum = 0;
    for (const auto& [body, own] : items)
        sum += own.size();
    return sum;
}

bool Region::contains(BodyId body, Item item) const
{
    const auto found = items.find(body);
    return found != items.end() && std::ranges::binary_search(found->second, item);
}

void Region::add(BodyId body, Item item)
{
    Items& own = items[body];
    const auto place = std::lower_bound(own.begin(), own.end(), item);
    if (place == own.end() || *place != item)
        own.insert(place, item);
}

Region united(const Region& a, const Region& b)
{
    return combined(a, b, [](auto... range) { std::set_union(range...); });
}

Region without(const Region& a, const Region& b)
{
    return combined(a, b, [](auto... range) { std::set_difference(range...); });
}

Region toggled(const Region& a, const Region& b)
{
    return combined(a, b, [](auto... range) { std::set_symmetric_difference(range...); });
}

Region regionOf(Level level, BodyId body, Region::Items items)
{
    Region region;
    region.level = level;
    std::ranges::sort(items);
    items.erase(std::unique(items.begin(), items.end()), items.end());
    if (!items.empty())
        region.items[body] = std::move(items);
    return region;
}

Region::Item connectionItem(const ConnectionId& connection)
{
    return (Region::Item{connection.direction} << 32U) | connection.lower;
}

ConnectionId connectionOf(Region::Item item)
{
    return {static_cast<std::uint32_t>(item >> 32U), static_cast<ObjectIndex>(item)};
}

} // namespace knead
