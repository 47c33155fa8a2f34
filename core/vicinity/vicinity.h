#pragma once

#include "core/geometry/vec3.h"
#include "core/vicinity/vicinity_pairs.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace knead {

/// A sphere that may come into contact.
struct VicinitySphere {
    Vec3 center;             ///< [m]
    double radius = 0;       ///< [m], >= 0
    std::uint32_t group = 0; ///< below 2^31; within one, pairs count only when their nodes lie apart or one is loose
    std::array<std::int32_t, 3> node{}; ///< place in the group's lattice
    bool loose = false;                 ///< may touch any sphere of its group
};

/// What a vicinity calculation cost, in numbers that do not depend on the machine.
struct VicinityStatistics {
    std::uint64_t sphereTests = 0;   ///< distances computed
    std::size_t spanningObjects = 0; ///< spheres held by inner nodes of a tree
    int depth = 0;                   ///< of the tree; 0 for the others
};

/// The vicinity calculation: which spheres are close to each other. All back-ends return the same pairs.
class Vicinity {
public:
    virtual ~Vicinity() = default;

    /// All pairs that may touch whose surfaces are closer than the margin, each once; valid until the next call.
    /// @param spheres less than 2^31
    /// @param margin [m], >= 0
    virtual const PairBlocks& findPairs(std::span<const VicinitySphere> spheres, double margin) = 0;

    /// Of the last findPairs().
    const VicinityStatistics& statistics() const { return m_statistics; }

protected:
    VicinityStatistics m_statistics;
    PairBlocks m_pairs; ///< a member, so that its memory is there the next time
};

enum class VicinityMethod {
    uniformGrid,     ///< default: near linear for any scene
    halfPartition,   ///< published: binary space partition through the middle of space
    medianPartition, ///< published: binary space partition through the median sphere
    bruteForce,      ///< every sphere against every other
};

inline constexpr VicinityMethod vicinityMethods[] = {VicinityMethod::uniformGrid, VicinityMethod::halfPartition,
                                                     VicinityMethod::medianPartition, VicinityMethod::bruteForce};

std::string_view nameOf(VicinityMethod method); ///< "uniform-grid", "half-partition" ... as in recipes

std::unique_ptr<Vicinity> makeVicinity(VicinityMethod method);

/// Whether two spheres may touch at all. Within a group they may when they lie more than two nodes apart.
inline bool mayTouch(const VicinitySphere& a, const VicinitySphere& b)
{
    constexpr std::int32_t near = 2;
    if (a.group != b.group || a.loose || b.loose)
        return true;
    for (std::size_t i = 0; i < 3; ++i)
        if (a.node[i] - b.node[i] > near || b.node[i] - a.node[i] > near)
            return true;
    return false;
}

/// True when the surfaces of spheres that may touch are closer than the margin.
inline bool closerThan(const VicinitySphere& a, const VicinitySphere& b, double margin)
{
    const double reach = a.radius + b.radius + margin;
    return (a.center - b.center).squaredNorm() < reach * reach && mayTouch(a, b);
}

} // namespace knead
