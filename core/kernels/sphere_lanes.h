// The few instructions that sphere_kernels_impl.h is made of, for each instruction set, included by it alone: numbers side
// by side in lanes, and masks with a bit per lane. The compiler does not find these by itself.
#pragma once

#include "core/kernels/sphere_kernels.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace knead::sphere_kernels::KNEAD_KERNEL_SET {

namespace {

using Mask = std::uint32_t;

#if defined(__AVX512F__)

using Floats = __m512;
using Ints = __m512i;
constexpr std::uint32_t lanes = 16;

inline Floats all(float x)
{
    return _mm512_set1_ps(x);
}
inline Floats load(const float* from)
{
    return _mm512_loadu_ps(from);
}
inline Floats plus(Floats a, Floats b)
{
    return _mm512_add_ps(a, b);
}
inline Floats minus(Floats a, Floats b)
{
    return _mm512_sub_ps(a, b);
}
inline Floats times(Floats a, Floats b)
{
    return _mm512_mul_ps(a, b);
}
inline Floats larger(Floats a, Floats b)
{
    return _mm512_maskz_max_ps(0xffff, a, b);
}
inline Mask isLess(Floats a, Floats b)
{
    return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ);
}
inline Mask isNotGreaterOrEqual(Floats a, Floats b)
{
    return _mm512_cmp_ps_mask(a, b, _CMP_NGE_UQ);
}
inline Ints allInts(std::int32_t x)
{
    return _mm512_set1_epi32(x);
}
inline Ints loadInts(const std::int32_t* from)
{
    return _mm512_loadu_si512(from);
}
inline Ints minus(Ints a, Ints b)
{
    return _mm512_sub_epi32(a, b);
}
inline Mask isEqual(Ints a, Ints b)
{
    return _mm512_cmpeq_epi32_mask(a, b);
}
inline Mask isGreater(Ints a, Ints b)
{
    return _mm512_cmpgt_epi32_mask(a, b);
}

#elif defined(__AVX2__)

using Floats = __m256;
using Ints = __m256i;
constexpr std::uint32_t lanes = 8;

inline Mask maskOf(Floats a)
{
    return static_cast<Mask>(_mm256_movemask_ps(a));
}
inline Mask maskOf(Ints a)
{
    return maskOf(_mm256_castsi256_ps(a));
}
inline Floats all(float x)
{
    return _mm256_set1_ps(x);
}
inline Floats load(const float* from)
{
    return _mm256_loadu_ps(from);
}
inline Floats plus(Floats a, Floats b)
{
    return _mm256_add_ps(a, b);
}
inline Floats minus(Floats a, Floats b)
{
    return _mm256_sub_ps(a, b);
}
inline Floats times(Floats a, Floats b)
{
    return _mm256_mul_ps(a, b);
}
inline Floats larger(Floats a, Floats b)
{
    return _mm256_max_ps(a, b);
}
inline Mask isLess(Floats a, Floats b)
{
    return maskOf(_mm256_cmp_ps(a, b, _CMP_LT_OQ));
}
inline Mask isNotGreaterOrEqual(Floats a, Floats b)
{
    return maskOf(_mm256_cmp_ps(a, b, _CMP_NGE_UQ));
}
inline Ints allInts(std::int32_t x)
{
    return _mm256_set1_epi32(x);
}
inline Ints loadInts(const std::int32_t* from)
{
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}
inline Ints minus(Ints a, Ints b)
{
    return _mm256_sub_epi32(a, b);
}
inline Mask isEqual(Ints a, Ints b)
{
    return maskOf(_mm256_cmpeq_epi32(a, b));
}
inline Mask isGreater(Ints a, Ints b)
{
    return maskOf(_mm256_cmpgt_epi32(a, b));
}

#elif defined(__SSE2__)

using Floats = __m128;
using Ints = __m128i;
constexpr std::uint32_t lanes = 4;

inline Mask maskOf(Floats a)
{
    return static_cast<Mask>(_mm_movemask_ps(a));
}
inline Mask maskOf(Ints a)
{
    return maskOf(_mm_castsi128_ps(a));
}
inline Floats all(float x)
{
    return _mm_set1_ps(x);
}
inline Floats load(const float* from)
{
    return _mm_loadu_ps(from);
}
inline Floats plus(Floats a, Floats b)
{
    return _mm_add_ps(a, b);
}
inline Floats minus(Floats a, Floats b)
{
    return _mm_sub_ps(a, b);
}
inline Floats times(Floats a, Floats b)
{
    return _mm_mul_ps(a, b);
}
inline Floats larger(Floats a, Floats b)
{
    return _mm_max_ps(a, b);
}
inline Mask isLess(Floats a, Floats b)
{
    return maskOf(_mm_cmplt_ps(a, b));
}
inline Mask isNotGreaterOrEqual(Floats a, Floats b)
{
    return maskOf(_mm_cmpnge_ps(a, b));
}
inline Ints allInts(std::int32_t x)
{
    return _mm_set1_epi32(x);
}
inline Ints loadInts(const std::int32_t* from)
{
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}
inline Ints minus(Ints a, Ints b)
{
    return _mm_sub_epi32(a, b);
}
inline Mask isEqual(Ints a, Ints b)
{
    return maskOf(_mm_cmpeq_epi32(a, b));
}
inline Mask isGreater(Ints a, Ints b)
{
    return maskOf(_mm_cmpgt_epi32(a, b));
}

#else // one lane, on any machine

using Floats = float;
using Ints = std::int32_t;
constexpr std::uint32_t lanes = 1;

inline Floats all(float x)
{
    return x;
}
inline Floats load(const float* from)
{
    return *from;
}
inline Floats plus(Floats a, Floats b)
{
    return a + b;
}
inline Floats minus(Floats a, Floats b)
{
    return a - b;
}
inline Floats times(Floats a, Floats b)
{
    return a * b;
}
inline Floats larger(Floats a, Floats b)
{
    return a > b ? a : b;
}
inline Mask isLess(Floats a, Floats b)
{
    return a < b ? 1 : 0;
}
inline Mask isNotGreaterOrEqual(Floats a, Floats b)
{
    return a >= b ? 0 : 1;
}
inline Ints allInts(std::int32_t x)
{
    return x;
}
inline Ints loadInts(const std::int32_t* from)
{
    return *from;
}
inline Ints minus(Ints a, Ints b)
{
    return static_cast<Ints>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
inline Mask isEqual(Ints a, Ints b)
{
    return a == b ? 1 : 0;
}
inline Mask isGreater(Ints a, Ints b)
{
    return a > b ? 1 : 0;
}

#endif

constexpr Mask allLanes = (Mask{1} << (lanes - 1)) - 1 + (Mask{1} << (lanes - 1));

} // namespace

} // namespace knead::sphere_kernels::KNEAD_KERNEL_SET
