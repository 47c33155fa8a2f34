// The kernels of sphere_kernels.h, compiled once per instruction set: each of sphere_kernels_{baseline,avx2,avx512}.cpp
// defines KNEAD_KERNEL_SET to a namespace name and includes this file. It uses no function of the standard library, since an
// inline one compiled for a newer machine could be picked by the linker for everybody.
#pragma once

#include "core/vicinity/sphere_lanes.h"

namespace knead::sphere_kernels::KNEAD_KERNEL_SET {

namespace {

/// Appends the values in the lanes of a mask.
inline void append(Mask chosen, const std::int32_t* values, std::int32_t* list, std::size_t& count)
{
#ifdef __AVX512F__
    _mm512_storeu_si512(list + count, _mm512_maskz_compress_epi32(static_cast<__mmask16>(chosen), loadInts(values)));
    count += static_cast<std::size_t>(__builtin_popcount(chosen));
#else
    for (; chosen != 0; chosen &= chosen - 1)
        list[count++] = values[__builtin_ctz(chosen)];
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
    const Ints after = allInts(query.after);
    const Ints group = allInts(query.group);
    for (std::size_t s = 0; s < count; ++s)
        for (std::uint32_t j = stretches[s].begin; j < stretches[s].end; j += lanes) {
            const std::uint32_t left = stretches[s].end - j;
            const Mask there = left >= lanes ? allLanes : (Mask{1} << left) - 1;
            const Floats dx = minus(load(spheres.x + j), x);
            const Floats dy = minus(load(spheres.y + j), y);
            const Floats dz = minus(load(spheres.z + j), z);
            const Floats squared = plus(times(dx, dx), plus(times(dy, dy), times(dz, dz)));
            const Floats sum = plus(load(spheres.reach + j), reach);
            const Floats far = plus(sum, more);
            Mask possible =
                there & isNotGreaterOrEqual(squared, times(far, far)) & isGreater(loadInts(spheres.index + j), after);
            if (possible == 0)
                continue;
            const Mask same = possible & isEqual(loadInts(spheres.group + j), group);
            if (same != 0)
                possible &= ~(same & within2(loadInts(spheres.u + j), allInts(query.u)) &
                              within2(loadInts(spheres.v + j), allInts(query.v)) &
                              within2(loadInts(spheres.w + j), allInts(query.w)));
            const Floats near = larger(minus(sum, more), none);
            const Mask certain = possible & isLess(squared, times(near, near));
            append(certain, spheres.index + j, partners.certain, partners.certainCount);
            if (certain != possible)
                append(possible & ~certain, spheres.index + j, partners.doubtful, partners.doubtfulCount);
        }
}

#ifdef __AVX512F__

/// One layer of a sorting network: lanes whose bits meet `step` are compared, and the lanes in `upper` keep the larger.
template <int step>
inline Ints exchange(Ints numbers, __mmask16 upper)
{
    const Ints lane = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    const Ints other = _mm512_maskz_permutexvar_epi32(0xffff, _mm512_xor_si512(lane, allInts(step)), numbers);
    const Ints smaller = _mm512_maskz_min_epi32(0xffff, numbers, other);
    return _mm512_mask_max_epi32(smaller, upper, numbers, other);
}

/// Batcher's bitonic network in one register.
void sortBehind(std::uint32_t first, const std::int32_t* numbers, std::size_t count, std::uint32_t* pairs)
{
    const auto there = static_cast<__mmask16>((1U << count) - 1);
    Ints n = _mm512_mask_loadu_epi32(allInts(0x7fffffff), there, numbers);
    n = exchange<1>(n, 0x6666);
    n = exchange<2>(n, 0x3c3c);
    n = exchange<1>(n, 0x5a5a);
    n = exchange<4>(n, 0x0ff0);
    n = exchange<2>(n, 0x33cc);
    n = exchange<1>(n, 0x55aa);
    n = exchange<8>(n, 0xff00);
    n = exchange<4>(n, 0xf0f0);
    n = exchange<2>(n, 0xcccc);
    n = exchange<1>(n, 0xaaaa);
    const Ints low = _mm512_set_epi32(7, 7, 6, 6, 5, 5, 4, 4, 3, 3, 2, 2, 1, 1, 0, 0);
    const Ints both = allInts(static_cast<std::int32_t>(first));
    const std::uint32_t places = count < 16 ? (1U << 2 * count) - 1 : 0xffffffffU;
    _mm512_mask_storeu_epi32(pairs, static_cast<__mmask16>(places),
                             _mm512_mask_permutexvar_epi32(both, 0xaaaa, low, n));
    if (count > 8)
        _mm512_mask_storeu_epi32(pairs + 16, static_cast<__mmask16>(places >> 16),
                                 _mm512_mask_permutexvar_epi32(both, 0xaaaa, minus(low, allInts(-8)), n));
}

#else

/// Each number goes to the place that is the count of lesser ones: no branch depends on the numbers, which would be guessed
/// wrong as often as not.
void sortBehind(std::uint32_t first, const std::int32_t* numbers, std::size_t count, std::uint32_t* pairs)
{
    std::int32_t every[few];
    std::int32_t lesser[few];
    for (std::size_t k = 0; k < few; ++k) {
        every[k] = k < count ? numbers[k] : 0;
        lesser[k] = 0;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t number = numbers[i];
        for (std::size_t k = 0; k < few; ++k)
            lesser[k] += number < every[k] ? 1 : 0;
    }
    for (std::size_t k = 0; k < count; ++k) {
        pairs[2 * lesser[k]] = first;
        pairs[2 * lesser[k] + 1] = static_cast<std::uint32_t>(every[k]);
    }
}

#endif

} // namespace

extern const Kernels set;
const Kernels set{findPartners, sortBehind, KNEAD_KERNEL_NAME};

} // namespace knead::sphere_kernels::KNEAD_KERNEL_SET
