// What the springs of connections bear of eight objects when all of them follow F, see tensor_law.h.
#pragma once

#include "core/kernels/tensor_elastic_kernels_impl.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

/// k of the connections of eight objects on both sides together, per direction.
template <int d>
KNEAD_INLINE Lanes stiffnessAround(const Surroundings& a, std::size_t i, UnsignedBits behind)
{
    Lanes sum{};
    if ((a.forward >> d & 1U) != 0)
        sum += load(a.stiffness[d] + i);
    if ((a.backward >> d & 1U) != 0)
        sum += masked(load(a.stiffness[d] + i - a.behind[d]), (behind >> d & 1) != 0);
    return sum;
}

template <int d>
constexpr double squaredStep =
    latticeDirections[d][0] * latticeDirections[d][0] + latticeDirections[d][1] * latticeDirections[d][1] +
    latticeDirections[d][2] * latticeDirections[d][2];

/// A + x o o^T for an integer direction.
template <int d>
KNEAD_INLINE void addDyad(Symmetric& a, Lanes x)
{
    constexpr int u = latticeDirections[d][0], v = latticeDirections[d][1], w = latticeDirections[d][2];
    constexpr int products[6] = {u * u, v * v, w * w, u * v, u * w, v * w};
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n) {
        if (products[n] > 0)
            a.m[n] += x;
        if (products[n] < 0)
            a.m[n] -= x;
    }
}

/// Calls visit.operator()<d>(1 / x_d) for the directions in use, the last one first, by one division: each inverse is the product of
/// the others times the inverse of the product. @param numberOf gives x_d, numberOf.operator()<d>()
template <typename NumberOf, typename Visit>
KNEAD_INLINE void forEachInverse(std::uint32_t used, const NumberOf& numberOf, const Visit& visit)
{
    Lanes numbers[latticeDirectionCount];
    Lanes products[latticeDirectionCount];
    Lanes product = all(1);
    forEachDirection([&]<int d>() __attribute__((always_inline)) {
        numbers[d] = (used >> d & 1U) != 0 ? numberOf.template operator()<d>() : all(1);
        products[d] = product;
        product *= numbers[d];
    });
    Lanes inverse = 1 / product;
    forEachDirectionBack([&]<int d>() __attribute__((always_inline)) {
        if ((used >> d & 1U) == 0)
            return;
        visit.template operator()<d>(inverse * products[d]);
        inverse *= numbers[d];
    });
}

/// How far connections that follow F are from l_b: rho = 1 - l_b^2 / |F D|^2 per direction.
struct Excess {
    Lanes rho[latticeDirectionCount];
    bool isSmall; ///< all of them are within smallExcess
};

// Below this, series to the tenth power are exact to rounding, and much quicker than roots and logarithms.
constexpr double smallExcess = 0.04;

/// @param square F^T F
/// @param i the first of the eight objects; what lies outside of the run decides nothing
KNEAD_INLINE Excess excessOf(const Surroundings& a, std::size_t i, const Symmetric& square, const Symmetric& metric)
{
    Symmetric beyond;
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n)
        beyond.m[n] = square.m[n] - metric.m[n];
    Excess excess{};
    Lanes largest{};
    forEachInverse(
        a.forward | a.backward,
        [&]<int d>() __attribute__((always_inline)) { return quadratic<d>(square) + 1e-12; }, // finite where F is flat
        [&]<int d>(Lanes inverse) __attribute__((always_inline)) {
            excess.rho[d] = quadratic<d>(beyond) * inverse;
            largest = larger(largest, larger(excess.rho[d], -excess.rho[d]));
        });
    excess.isSmall = !any((largest > all(smallExcess)) & inside(i, a.begin, a.end));
    return excess;
}

/// 1 - l_b / |F D| = 1 - sqrt(1 - rho).
KNEAD_INLINE Lanes relativeStretch(Lanes rho, bool isSmall)
{
    constexpr double coefficients[] = {1.0 / 2,     1.0 / 8,     1.0 / 16,      5.0 / 128,     7.0 / 256,
                                       21.0 / 1024, 33.0 / 2048, 429.0 / 32768, 715.0 / 65536, 2431.0 / 262144};
    return isSmall ? series(coefficients, rho) : 1 - squareRoot(1 - rho);
}

/// ln(|F D| / l_b) = -ln(1 - rho) / 2.
KNEAD_INLINE Lanes naturalStretch(Lanes rho, bool isSmall)
{
    constexpr double coefficients[] = {1.0 / 2,  1.0 / 4,  1.0 / 6,  1.0 / 8,  1.0 / 10,
                                       1.0 / 12, 1.0 / 14, 1.0 / 16, 1.0 / 18, 1.0 / 20};
    return isSmall ? series(coefficients, rho) : -0.5 * logarithm(1 - rho);
}

// 1 - l_b / |F D| of a connection at half its length. Where it is shorter, its share is taken off no further: it turns ever
// more quickly with F, and steps that were chosen before cannot take that.
constexpr double leastStretch = -1;

/// What the connections of eight objects would bear if all followed F, F S with S = sum_b k / 2 (1 - l_b / |F o|) o o^T, and the
/// energy sum_b k / 4 (|F o| - l_b)^2 (each connection belongs to two objects); both for a spacing of 1.
struct SpringShare {
    Symmetric pull; ///< S
    Lanes energy;   ///< 0 unless it was asked for
};

/// @param square F^T F
template <bool withEnergy>
KNEAD_INLINE SpringShare springShare(const Surroundings& a, std::size_t i, UnsignedBits behind, const Symmetric& square,
                                     const Excess& excess)
{
    SpringShare share{};
    forEachDirection([&]<int d>() __attribute__((always_inline)) {
        if (((a.forward | a.backward) >> d & 1U) == 0)
            return;
        const Lanes k = stiffnessAround<d>(a, i, behind);
        const Lanes whole = relativeStretch(excess.rho[d], excess.isSmall);
        const LaneBits isShort = whole < all(leastStretch);
        const Lanes stretch = choose(isShort, all(leastStretch), whole);
        if constexpr (withEnergy)
            // Below the least stretch the force goes on in proportion to |F o|: sum_b k / 4 (l_b^2 / 2 - |F o|^2).
            share.energy +=
                0.25 * k * quadratic<d>(square) * choose(isShort, -0.5 - 0.5 * excess.rho[d], stretch * stretch);
        addDyad<d>(share.pull, 0.5 * k * stretch);
    });
    return share;
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
