#pragma once

#include "core/skin/neighborhood.h"

#include <tbb/concurrent_hash_map.h>

#include <atomic>
#include <cstddef>
#include <memory>

namespace knead {

/// Neighborhoods that are asked for again and again, each gathered once. Its members may be called from any thread.
class NeighborhoodCache {
public:
    /// The aggregate must outlive it.
    /// @param mostBytes that are kept; what goes beyond is gathered anew each time
    explicit NeighborhoodCache(const Aggregate& aggregate, std::size_t mostBytes = std::size_t{128} << 20);

    const NeighborhoodFinder& finder() const { return m_finder; }

    std::shared_ptr<const Neighborhood> around(const SkinOwner& owner);

    std::size_t bytes() const { return m_bytes; } ///< that are kept

private:
    struct Hash {
        static std::size_t hash(const SkinOwner& owner);
        static bool equal(const SkinOwner& a, const SkinOwner& b) { return a == b; }
    };

    NeighborhoodFinder m_finder;
    std::size_t m_mostBytes;
    std::atomic<std::size_t> m_bytes = 0;
    tbb::concurrent_hash_map<SkinOwner, std::shared_ptr<const Neighborhood>, Hash> m_kept;
};

} // namespace knead
