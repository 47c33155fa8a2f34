#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace knead {

/// Sets of connected things, numbered from 0; each set is known by one of its members.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t size)
        : m_parent(size)
    {
        std::iota(m_parent.begin(), m_parent.end(), std::size_t{0});
    }

    std::size_t find(std::size_t item)
    {
        while (m_parent[item] != item)
            item = m_parent[item] = m_parent[m_parent[item]];
        return item;
    }

    void join(std::size_t a, std::size_t b) { m_parent[find(a)] = find(b); }

    /// The same, with the lowest member for the whole set: where all of it is joined so.
    void joinToLowest(std::size_t a, std::size_t b)
    {
        const auto [low, high] = std::minmax({find(a), find(b)});
        m_parent[high] = low;
    }

    std::size_t count() const
    {
        std::size_t roots = 0;
        for (std::size_t i = 0; i < m_parent.size(); ++i)
            roots += m_parent[i] == i ? 1 : 0;
        return roots;
    }

private:
    std::vector<std::size_t> m_parent;
};

} // namespace knead
