#pragma once

#include "core/aggregate/connection_id.h"
#include "core/simulation/scene.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace knead {

/// What a click selects.
enum class Level : std::uint8_t {
    Part,
    Face,      ///< of the CAD part
    Edge,      ///< a chain of feature edges, see chainsOf()
    Object,    ///< the paper's first primitive
    Connection ///< structural ones
};
inline constexpr int levelCount = 5;

/// Things of one kind, of any number of bodies. A plain value.
struct Region {
    using Item = std::uint64_t;      ///< a CAD face, a chain of edges, an object, connectionItem(); of a part: 0
    using Items = std::vector<Item>; ///< ascending, each once
    Level level = Level::Part;
    std::map<BodyId, Items> items; ///< none of them empty

    bool isEmpty() const { return items.empty(); }
    std::size_t count() const;
    bool contains(BodyId body, Item item) const;

    void add(BodyId body, Item item); ///< one; to add many use united()
    friend bool operator==(const Region&, const Region&) = default;
};

/// What is in one of them or in both; in the first and not in the second; in just one of them. @pre they have the same level
Region united(const Region& a, const Region& b);
Region without(const Region& a, const Region& b);
Region toggled(const Region& a, const Region& b);

Region regionOf(Level level, BodyId body, Region::Items items); ///< the items in any order
Region::Item connectionItem(const ConnectionId& connection);
ConnectionId connectionOf(Region::Item item);

} // namespace knead
