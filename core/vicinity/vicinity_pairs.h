#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// Two spheres by index, first < second.
struct VicinityPair {
    std::uint32_t first;
    std::uint32_t second;
    friend auto operator<=>(const VicinityPair&, const VicinityPair&) = default;
};

/// The pairs that one part of the work found, in memory that is kept from one time to the next.
class PairBlock {
public:
    std::span<const VicinityPair> pairs() const { return {m_room.data(), m_count}; }

    /// Makes room for so many more and returns the place of the next one.
    VicinityPair* room(std::size_t more);

    /// So many have been written there.
    void wrote(std::size_t count) { m_count += count; }

    void clear() { m_count = 0; }

private:
    std::vector<VicinityPair>
        m_room; ///< longer than what is used of it: growing it for each pair would cost more than pairs
    std::size_t m_count = 0;
};

/// All pairs of a scene, each once, in blocks. Their order depends on the spheres only, but nothing sorts them.
class PairBlocks {
public:
    /// No blocks; their memory is kept for use.
    void clear() { m_count = 0; }

    /// Appends empty blocks, for as many parts of work, and returns the number of the first.
    std::size_t append(std::size_t count);

    PairBlock& operator[](std::size_t block) { return m_blocks[block]; }

    std::span<const PairBlock> blocks() const { return {m_blocks.data(), m_count}; }

    std::size_t pairCount() const;

    /// All pairs, sorted.
    /// @param spheres how many there are
    std::vector<VicinityPair> sorted(std::size_t spheres) const;

private:
    std::vector<PairBlock> m_blocks; ///< those in use first
    std::size_t m_count = 0;
};

/// Sorts pairs of so many spheres. O(pairs + spheres) when a sphere has few partners. On all threads.
void sortPairs(std::vector<VicinityPair>& pairs, std::size_t spheres);

} // namespace knead
