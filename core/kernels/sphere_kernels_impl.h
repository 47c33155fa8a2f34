// The kernel of sphere_kernels.h; see kernels_impl.h for how it is compiled.
#pragma once

#include "core/kernels/sphere_lanes.h"

namespace knead::sphere_kernels::KNEAD_KERNEL_SET {

namespace {

/// Appends the values in the lanes of a mask.
inline void append(Mask chosen, const std::int32_t* values, std::int32_t* list, std::size_t& count)
{
    for (; chosen != 0; chosen &= chosen - 1)
        list[count++] = values[__builtin_ctz(chosen)];
}

/// Appends pairs of a sphere with those in the lanes of a mask, the lower index first.
inline void appendPairs(Mask chosen, std::int32_t sphere, const std::int32_t* others, std::uint32_t* pairs,
                        std::size_t& count)
{
#ifdef __AVX512F__
    const Ints other = _mm512_maskz_compress_epi32(static_cast<__mmask16>(chosen), loadInts(others));
    const Ints lower = _mm512_maskz_min_epi32(0xffff, other, allInts(sphere));
    const Ints upper = _mm512_maskz_max_epi32(0xffff, other, allInts(sphere));
    const Ints zip = _mm512_set_epi32(23, 7, 22, 6, 21, 5, 20, 4, 19, 3, 18, 2, 17, 1, 16, 0);
    const auto chosenCount = static_cast<std::size_t>(__builtin_popcount(chosen));
    _mm512_storeu_si512(pairs + 2 * count, _mm512_permutex2var_epi32(lower, zip, upper));
    if (chosenCount > 8)
        _mm512_storeu_si512(pairs + 2 * count + 16,
                            _mm512_permutex2var_epi32(lower, _mm512_add_epi32(zip, allInts(8)), upper));
    count += chosenCount;
#else
    for (; chosen != 0; chosen &= chosen - 1, ++count) {
        const std::int32_t other = others[__builtin_ctz(chosen)];
        pairs[2 * count] = static_cast<std::uint32_t>(other < sphere ? other : sphere);
        pairs[2 * count + 1] = static_cast<std::uint32_t>(other < sphere ? sphere : other);
    }
#endif
}

/// Lanes in which two values differ by at most two.
inline Mask within2(Ints a, Ints b)
{
    const Ints difference = minus(a, b);
    return isGreater(difference, allInts(-3)) & isGreater(allInts(3), difference);
}

void findPartners(const Spheres& spheres, const Query& query, const Stretch* stretches, std::size_t count, float doubt,
                  Partners& partners)
{
    const Floats x = all(query.x);
    const Floats y = all(query.y);
    const Floats z = all(query.z);
    const Floats reach = all(query.reach);
    const Floats more = all(doubt);
    const Floats none = all(0);
    const Ints group = allInts(query.group);
    const Spheres there = spheres; // copies, which what is written cannot change
    Partners found = partners;
    for (std::size_t s = 0; s < count; ++s)
        for (std::uint32_t j = stretches[s].begin; j < stretches[s].end; j += lanes) {
            const std::uint32_t left = stretches[s].end - j;
            const Mask filled = left >= lanes ? allLanes : (Mask{1} << left) - 1;
            const Floats dx = minus(load(there.x + j), x);
            const Floats dy = minus(load(there.y + j), y);
            const Floats dz = minus(load(there.z + j), z);
            const Floats squared = plus(times(dx, dx), plus(times(dy, dy), times(dz, dz)));
            const Floats sum = plus(load(there.reach + j), reach);
            const Floats far = plus(sum, more);
            Mask possible = filled & isNotGreaterOrEqual(squared, times(far, far));
            if (possible == 0)
                continue;
            const Mask same = possible & isEqual(loadInts(there.group + j), group);
            if (same != 0)
                possible &= ~(same & within2(loadInts(there.u + j), allInts(query.u)) &
                              within2(loadInts(there.v + j), allInts(query.v)) &
                              within2(loadInts(there.w + j), allInts(query.w)));
            const Floats near = larger(minus(sum, more), none);
            const Mask certain = possible & isLess(squared, times(near, near));
            appendPairs(certain, query.index, there.index + j, found.pairs, found.pairCount);
            if (certain != possible)
                append(possible & ~certain, there.index + j, found.doubtful, found.doubtfulCount);
        }
    partners = found;
}

} // namespace

} // namespace knead::sphere_kernels::KNEAD_KERNEL_SET
