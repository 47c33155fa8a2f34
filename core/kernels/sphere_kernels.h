#pragma once

#include <cstddef>
#include <cstdint>

/// The innermost loop of the vicinity calculation: one sphere against stretches of spheres. See kernels.h for how it
/// is compiled and picked. It works in single precision and says of each pair that it is none, that it is one, or
/// that single precision cannot tell; the caller then decides in double precision.
namespace knead::sphere_kernels {

/// One value per sphere, with `padding` more behind the last.
struct Spheres {
    const float* x; ///< center, in any unit
    const float* y;
    const float* z;
    const float* reach;        ///< radius and half of the margin, in the same unit
    const std::int32_t* group; ///< loose spheres have one of their own
    const std::int32_t* u;     ///< node in the group's lattice
    const std::int32_t* v;
    const std::int32_t* w;
    const std::int32_t* index; ///< what the caller calls it, >= 0
};
inline constexpr std::size_t padding = 16;

/// Spheres begin .. end.
struct Stretch {
    std::uint32_t begin;
    std::uint32_t end;
};

/// The sphere whose partners are looked for.
struct Query {
    float x, y, z, reach;
    std::int32_t group, u, v, w, index;
};

/// Where partners are written to; there must be room for all spheres of the stretches and `padding` more.
struct Partners {
    std::uint32_t* pairs; ///< of the sphere and a partner, by index: lower, higher, lower, higher ...
    std::size_t pairCount;
    std::int32_t* doubtful; ///< may be partners; their distance does not tell in single precision
    std::size_t doubtfulCount;
};

struct SphereKernels {
    /// Appends the partners of a sphere: those closer than the sum of reaches, but for those of its group within two nodes.
    /// @param doubt by how much distances and reaches may be wrong
    void (*findPartners)(const Spheres& spheres, const Query& query, const Stretch* stretches, std::size_t count,
                         float doubt, Partners& partners);
};

} // namespace knead::sphere_kernels
