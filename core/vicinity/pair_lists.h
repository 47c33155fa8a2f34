#pragma once

#include "core/vicinity/sphere_kernels.h"
#include "core/vicinity/vicinity.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace knead {

/// Pairs in the order in which a part of the work found them: stretches of partners with the same first sphere.
struct PairList {
    struct Stretch {
        std::uint32_t first;
        std::uint32_t count;
    };

    std::vector<Stretch> stretches;
    std::vector<std::int32_t> partners; ///< the second spheres, stretch by stretch; longer than what is used of it
    std::size_t used = 0;
    std::uint64_t sphereTests = 0;

    /// Makes room for more partners and returns the place of the next.
    std::int32_t* room(std::size_t more);

    void clear();
};

/// All pairs found, and the order they are wanted in.
class PairLists {
public:
    /// Empty lists, their memory kept for use.
    void clear();

    /// Appends empty lists, for as many parts of work, and returns the number of the first.
    std::size_t append(std::size_t count);

    PairList& operator[](std::size_t list) { return m_lists[list]; }

    std::uint64_t sphereTests() const;

    /// Writes all pairs, sorted, whatever list and order they are in.
    void sort(std::size_t spheres, const sphere_kernels::Kernels& kernels, std::vector<VicinityPair>& pairs);

private:
    bool isWhole(const PairList::Stretch& stretch) const
    {
        return stretch.count == m_begin[stretch.first + 1] - m_begin[stretch.first];
    }

    void joinStretches(std::vector<VicinityPair>& pairs);

    std::vector<PairList> m_lists; ///< those in use first
    std::size_t m_count = 0;
    std::vector<std::uint32_t> m_begin; ///< per sphere: place of its first pair, and the end
    std::vector<std::uint32_t> m_next;  ///< per sphere: place of the next pair to come
};

} // namespace knead
