// Eight numbers at a time, for kernels; see kernels_impl.h for how they are compiled.
//
// Vector types of the compiler that are wider than a register live in memory, and are compared and chosen from number by number, which
// takes several times as long. So eight numbers are one vector where a register holds them, and else a pair of halves. What is done to
// each number is the same, to the last bit.
//
// Loops over the entries of small matrices are unrolled by a pragma, so that they are gone before the compiler decides what stays
// in registers: a tenth less time for the laws of tensor_law.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

#define KNEAD_INLINE inline __attribute__((always_inline))

constexpr std::size_t lanes = 8;

#if defined(__AVX512F__)
constexpr std::size_t registerBytes = 64;
#elif defined(__AVX2__)
constexpr std::size_t registerBytes = 32;
#else
constexpr std::size_t registerBytes = 16;
#endif

/// Numbers of a register.
template <typename Number>
struct Register {
    using Type __attribute__((vector_size(registerBytes))) = Number;
    static constexpr std::size_t count = registerBytes / sizeof(Number);
};

// The same anywhere in memory.
using DoublesAnywhere __attribute__((vector_size(registerBytes), aligned(8), may_alias)) = double;
using BitsAnywhere __attribute__((vector_size(registerBytes), aligned(8), may_alias)) = std::int64_t;
using HalfBitsAnywhere __attribute__((vector_size(registerBytes / 2), aligned(4), may_alias)) = std::uint32_t;

template <typename Number, typename Half>
struct Pair;
template <typename Number, typename Half>
KNEAD_INLINE Pair<Number, Half> pairOf(const Half& low, const Half& high)
{
    return {low, high};
}

/// Numbers of eight bytes that a type holds.
template <typename Numbers>
constexpr std::size_t lanesOf = sizeof(Numbers) / sizeof(double);

/// What a comparison of registers gives, which compilers name differently; that of pairs is so already.
template <typename Compared>
KNEAD_INLINE auto asBits(const Compared& compared)
{
    return __builtin_bit_cast(Register<std::int64_t>::Type, compared);
}
template <typename Half>
KNEAD_INLINE auto asBits(const Pair<std::int64_t, Half>& compared)
{
    return compared;
}

/// Two parts with half of the numbers each: registers, or pairs themselves.
template <typename Number, typename Half>
struct Pair {
    Half low{};
    Half high{};

    Pair() = default;
    KNEAD_INLINE Pair(const Half& l, const Half& h)
        : low(l)
        , high(h)
    {
    }
    KNEAD_INLINE Pair(Number each)
        : low(each - Half{}) // not +, which would lose the sign of -0
        , high(each - Half{})
    {
    }

    KNEAD_INLINE Number operator[](std::size_t lane) const
    {
        return lane < lanesOf<Half> ? low[lane] : high[lane - lanesOf<Half>];
    }

    friend KNEAD_INLINE Pair operator+(const Pair& a, const Pair& b) { return {a.low + b.low, a.high + b.high}; }
    friend KNEAD_INLINE Pair operator-(const Pair& a, const Pair& b) { return {a.low - b.low, a.high - b.high}; }
    friend KNEAD_INLINE Pair operator*(const Pair& a, const Pair& b) { return {a.low * b.low, a.high * b.high}; }
    friend KNEAD_INLINE Pair operator/(const Pair& a, const Pair& b) { return {a.low / b.low, a.high / b.high}; }
    friend KNEAD_INLINE Pair operator&(const Pair& a, const Pair& b) { return {a.low & b.low, a.high & b.high}; }
    friend KNEAD_INLINE Pair operator|(const Pair& a, const Pair& b) { return {a.low | b.low, a.high | b.high}; }
    friend KNEAD_INLINE Pair operator-(const Pair& a) { return {-a.low, -a.high}; }
    friend KNEAD_INLINE Pair operator~(const Pair& a) { return {~a.low, ~a.high}; }
    friend KNEAD_INLINE Pair operator>>(const Pair& a, int bits) { return {a.low >> bits, a.high >> bits}; }
    friend KNEAD_INLINE Pair operator<<(const Pair& a, int bits) { return {a.low << bits, a.high << bits}; }
    KNEAD_INLINE Pair& operator+=(const Pair& b) { return *this = *this + b; }
    KNEAD_INLINE Pair& operator-=(const Pair& b) { return *this = *this - b; }
    KNEAD_INLINE Pair& operator*=(const Pair& b) { return *this = *this * b; }

    // Bits that are all set where it holds.
    friend KNEAD_INLINE auto operator<(const Pair& a, const Pair& b)
    {
        return pairOf<std::int64_t>(asBits(a.low < b.low), asBits(a.high < b.high));
    }
    friend KNEAD_INLINE auto operator>(const Pair& a, const Pair& b)
    {
        return pairOf<std::int64_t>(asBits(a.low > b.low), asBits(a.high > b.high));
    }
    friend KNEAD_INLINE auto operator>=(const Pair& a, const Pair& b)
    {
        return pairOf<std::int64_t>(asBits(a.low >= b.low), asBits(a.high >= b.high));
    }
    friend KNEAD_INLINE auto operator==(const Pair& a, const Pair& b)
    {
        return pairOf<std::int64_t>(asBits(a.low == b.low), asBits(a.high == b.high));
    }
    friend KNEAD_INLINE auto operator!=(const Pair& a, const Pair& b)
    {
        return pairOf<std::int64_t>(asBits(a.low != b.low), asBits(a.high != b.high));
    }
};

template <typename Number>
struct EightOf {
#if defined(__AVX512F__)
    using Type = typename Register<Number>::Type;
#elif defined(__AVX2__)
    using Type = Pair<Number, typename Register<Number>::Type>;
#else
    using Type = Pair<Number, Pair<Number, typename Register<Number>::Type>>;
#endif
};

using Lanes = EightOf<double>::Type;
using LaneBits = EightOf<std::int64_t>::Type;
using UnsignedBits = EightOf<std::uint64_t>::Type;

// What follows is done to registers, and to pairs half by half.

/// The first where bits are set, else the second.
template <typename Bits, typename Numbers>
KNEAD_INLINE Numbers choose(const Bits& bits, const Numbers& set, const Numbers& unset)
{
    return bits ? set : unset;
}
template <typename BitsHalf, typename Number, typename Half>
KNEAD_INLINE Pair<Number, Half> choose(const Pair<std::int64_t, BitsHalf>& bits, const Pair<Number, Half>& set,
                                       const Pair<Number, Half>& unset)
{
    return {choose(bits.low, set.low, unset.low), choose(bits.high, set.high, unset.high)};
}

/// The same bits as other numbers; of one number, too.
template <typename To>
KNEAD_INLINE To reinterpreted(double from)
{
    return __builtin_bit_cast(To, from);
}
template <typename To>
KNEAD_INLINE To reinterpreted(std::uint64_t from)
{
    return __builtin_bit_cast(To, from);
}
template <typename To, typename From>
KNEAD_INLINE auto reinterpreted(const From& from)
{
    return __builtin_bit_cast(typename Register<To>::Type, from);
}
template <typename To, typename Number, typename Half>
KNEAD_INLINE auto reinterpreted(const Pair<Number, Half>& from)
{
    return pairOf<To>(reinterpreted<To>(from.low), reinterpreted<To>(from.high));
}

template <typename Numbers>
KNEAD_INLINE Numbers squareRoot(const Numbers& squares)
{
    Numbers result;
    for (std::size_t n = 0; n < Register<double>::count; ++n)
        result[n] = __builtin_sqrt(squares[n]);
    return result;
}
template <typename Half>
KNEAD_INLINE Pair<double, Half> squareRoot(const Pair<double, Half>& squares)
{
    return {squareRoot(squares.low), squareRoot(squares.high)};
}

/// Whether bits are set for any of them.
template <typename Bits>
KNEAD_INLINE bool any(const Bits& bits)
{
    std::int64_t together = 0;
    for (std::size_t n = 0; n < Register<std::int64_t>::count; ++n)
        together |= bits[n];
    return together != 0;
}
template <typename Half>
KNEAD_INLINE bool any(const Pair<std::int64_t, Half>& bits)
{
    return any(bits.low | bits.high);
}

KNEAD_INLINE void read(const double* from, Register<double>::Type& to)
{
    to = *reinterpret_cast<const DoublesAnywhere*>(from);
}
template <typename Half>
KNEAD_INLINE void read(const double* from, Pair<double, Half>& to)
{
    read(from, to.low);
    read(from + lanesOf<Half>, to.high);
}

KNEAD_INLINE void write(double* to, const Register<double>::Type& numbers)
{
    *reinterpret_cast<DoublesAnywhere*>(to) = numbers;
}
template <typename Half>
KNEAD_INLINE void write(double* to, const Pair<double, Half>& numbers)
{
    write(to, numbers.low);
    write(to + lanesOf<Half>, numbers.high);
}

/// Two rows of a stage of transpose(): blocks of `block` rows and columns beside the diagonal change places.
template <std::size_t block, std::size_t... column>
KNEAD_INLINE void exchangeBlocks(Register<double>::Type& first, Register<double>::Type& second,
                                 std::index_sequence<column...>)
{
    constexpr std::size_t count = sizeof...(column);
    const Register<double>::Type upper =
        __builtin_shufflevector(first, second, ((column & block) != 0 ? count + column - block : column)...);
    second = __builtin_shufflevector(first, second, ((column & block) != 0 ? count + column : column + block)...);
    first = upper;
}
template <std::size_t block>
KNEAD_INLINE void transposeBlocks(Register<double>::Type* rows)
{
    constexpr std::size_t count = Register<double>::count;
    if constexpr (block < count) {
#pragma GCC unroll 8
        for (std::size_t row = 0; row < count; ++row)
            if ((row & block) == 0)
                exchangeBlocks<block>(rows[row], rows[row + block], std::make_index_sequence<count>());
        transposeBlocks<2 * block>(rows);
    }
}

/// Of as many rows as there are columns.
KNEAD_INLINE void transpose(Register<double>::Type* rows)
{
    transposeBlocks<1>(rows);
}
template <typename Half>
KNEAD_INLINE void transpose(Pair<double, Half>* rows)
{
    constexpr std::size_t half = lanesOf<Half>;
    Half blocks[2][2][half];
#pragma GCC unroll 8
    for (std::size_t row = 0; row < 2 * half; ++row) {
        blocks[row / half][0][row % half] = rows[row].low;
        blocks[row / half][1][row % half] = rows[row].high;
    }
    for (auto& ofRows : blocks)
        for (auto& block : ofRows)
            transpose(block);
#pragma GCC unroll 8
    for (std::size_t row = 0; row < 2 * half; ++row)
        rows[row] = {blocks[0][row / half][row % half], blocks[1][row / half][row % half]};
}

KNEAD_INLINE void widen(const std::uint32_t* from, Register<std::uint64_t>::Type& to)
{
    to = __builtin_convertvector(*reinterpret_cast<const HalfBitsAnywhere*>(from), Register<std::uint64_t>::Type);
}
template <typename Half>
KNEAD_INLINE void widen(const std::uint32_t* from, Pair<std::uint64_t, Half>& to)
{
    widen(from, to.low);
    widen(from + lanesOf<Half>, to.high);
}

/// first, first + 1, ...
KNEAD_INLINE void count(std::int64_t first, Register<std::int64_t>::Type& to)
{
    static constexpr std::int64_t numbers[lanes] = {0, 1, 2, 3, 4, 5, 6, 7};
    to = *reinterpret_cast<const BitsAnywhere*>(numbers) + first;
}
template <typename Half>
KNEAD_INLINE void count(std::int64_t first, Pair<std::int64_t, Half>& to)
{
    count(first, to.low);
    count(first + static_cast<std::int64_t>(lanesOf<Half>), to.high);
}

KNEAD_INLINE Lanes load(const double* from)
{
    Lanes numbers;
    read(from, numbers);
    return numbers;
}
KNEAD_INLINE void store(double* to, const Lanes& values)
{
    write(to, values);
}
KNEAD_INLINE Lanes all(double value)
{
    return value - Lanes{}; // not +, which would lose the sign of -0
}
KNEAD_INLINE Lanes masked(const Lanes& values, const LaneBits& mask)
{
    return reinterpreted<double>(reinterpreted<std::int64_t>(values) & mask);
}
KNEAD_INLINE Lanes larger(const Lanes& a, const Lanes& b)
{
    return choose(a > b, a, b);
}
KNEAD_INLINE Lanes smaller(const Lanes& a, const Lanes& b)
{
    return choose(a < b, a, b);
}
KNEAD_INLINE Lanes absolute(const Lanes& numbers)
{
    return larger(numbers, -numbers);
}
KNEAD_INLINE bool anyBeyond(const Lanes& values, double limit)
{
    return any(values > all(limit));
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
