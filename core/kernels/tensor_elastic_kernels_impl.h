// F of eight objects, what is elastic of it, and the numbers of their material: for the kernels of tensor_law.h and hyperelastic_law.h.
#pragma once

#include "core/kernels/lattice_force_kernels_impl.h"
#include "core/kernels/tensor_law.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

/// e^x to about 2 ulp for |x| < 700, from operations that round alike everywhere: 2^n e^r with n the nearest integer to x / ln 2.
KNEAD_INLINE Lanes exponential(Lanes x)
{
    constexpr double shift = 6755399441055744.0; // 1.5 * 2^52: adding it leaves n in the lowest bits
    const Lanes shifted = x * 1.4426950408889634 + shift;
    const Lanes n = shifted - shift;
    // ln 2 in two parts, the first with zeros at its end, so that n times it is exact.
    const Lanes r = (x - n * 0.693147180369123816490) - n * 1.90821492927058770002e-10;
    Lanes series = all(1.0 / 6227020800.0);
    constexpr double inverseFactorials[] = {
        1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
        1.0 / 120,       1.0 / 24,       1.0 / 6,       0.5,          1.0,         1.0};
    for (const double coefficient : inverseFactorials)
        series = series * r + coefficient;
    const UnsignedBits power = (reinterpreted<std::uint64_t>(shifted) - __builtin_bit_cast(std::uint64_t, shift) + 1023)
                               << 52;
    return series * reinterpreted<double>(power);
}

/// A symmetric matrix: 00 11 22 01 02 12.
struct Symmetric {
    Lanes m[6];
};

KNEAD_INLINE Lanes determinant(const Symmetric& a)
{
    const Lanes(&m)[6] = a.m;
    return m[0] * (m[1] * m[2] - m[5] * m[5]) - m[3] * (m[3] * m[2] - m[5] * m[4]) + m[4] * (m[3] * m[5] - m[1] * m[4]);
}

/// The inverse where the determinant is 1.
KNEAD_INLINE Symmetric adjugate(const Symmetric& a)
{
    const Lanes(&m)[6] = a.m;
    return {{m[1] * m[2] - m[5] * m[5], m[0] * m[2] - m[4] * m[4], m[0] * m[1] - m[3] * m[3], m[4] * m[5] - m[3] * m[2],
             m[3] * m[5] - m[1] * m[4], m[3] * m[4] - m[0] * m[5]}};
}

/// o^T A o for an integer direction.
template <int d>
KNEAD_INLINE Lanes quadratic(const Symmetric& a)
{
    constexpr int u = latticeDirections[d][0], v = latticeDirections[d][1], w = latticeDirections[d][2];
    Lanes sum{};
    if (u != 0)
        sum += a.m[0];
    if (v != 0)
        sum += a.m[1];
    if (w != 0)
        sum += a.m[2];
    if (u * v != 0)
        sum += (2.0 * u * v) * a.m[3];
    if (u * w != 0)
        sum += (2.0 * u * w) * a.m[4];
    if (v * w != 0)
        sum += (2.0 * v * w) * a.m[5];
    return sum;
}

/// A : B.
KNEAD_INLINE Lanes contraction(const Symmetric& a, const Symmetric& b)
{
    const Lanes(&m)[6] = a.m;
    const Lanes(&n)[6] = b.m;
    return m[0] * n[0] + m[1] * n[1] + m[2] * n[2] + 2 * (m[3] * n[3] + m[4] * n[4] + m[5] * n[5]);
}

/// x sum c_n x^n.
template <int count>
KNEAD_INLINE Lanes series(const double (&coefficients)[count], Lanes x)
{
    Lanes sum = all(coefficients[count - 1]);
#pragma GCC unroll 9
    for (int n = count - 2; n >= 0; --n)
        sum = sum * x + coefficients[n];
    return x * sum;
}

/// F of eight objects, by lattice column.
struct Deformation {
    Lanes m[3][3];        ///< sum k d o^T [column][world component]
    Lanes f[3][3];        ///< F; the identity where surroundings are flat
    Lanes cofactor[3][3]; ///< of F: J F^-T
    Lanes volume;         ///< det F
    LaneBits isFlat;      ///< nothing is known of F
};

KNEAD_INLINE Deformation deformationOf(const Surroundings& a, std::size_t i)
{
    const ShapeSums shape = shapeOfVector(a, i);
    Lanes inverse[6];
    loadInverseShape(a, i, inverse);
    Deformation g;
    g.isFlat = inverse[0] == all(0);
#pragma GCC unroll 9
    for (int c = 0; c < 3; ++c)
#pragma GCC unroll 9
        for (int column = 0; column < 3; ++column)
            g.m[column][c] = shape.m[column][c];
    findGradient(shape.m, inverse, all(1 / a.spacing), g.f);
#pragma GCC unroll 9
    for (int c = 0; c < 3; ++c)
#pragma GCC unroll 9
        for (int column = 0; column < 3; ++column)
            g.f[column][c] = choose(g.isFlat, all(c == column ? 1 : 0), g.f[column][c]);
    findCofactors(g.f, g.cofactor);
    g.volume = volumeOf(g.f, g.cofactor);
    return g;
}

/// F^T F, in lattice axes.
KNEAD_INLINE Symmetric squareOf(const Lanes (&f)[3][3])
{
    constexpr int rows[6] = {0, 1, 2, 0, 0, 1};
    constexpr int columns[6] = {0, 1, 2, 1, 2, 2};
    Symmetric square;
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n) {
        const Lanes(&p)[3] = f[rows[n]];
        const Lanes(&q)[3] = f[columns[n]];
        square.m[n] = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    }
    return square;
}

/// F of eight objects with what follows from it.
struct Gradient : Deformation {
    Lanes ratio;  ///< J, not below leastVolumeRatio
    Lanes weight; ///< of the law: 1 from wholeVolumeRatio on, 0 up to leastVolumeRatio
    Lanes theta;
    Lanes scale; ///< ratio^(-2/3)
};

// Of J, determinants and lengthenings less 1. Below this, series to the ninth power are exact to rounding, and much quicker than a logarithm and an exponential.
constexpr double smallDilatation = 0.02;

/// @param i the first of the eight objects; what lies outside of the run decides nothing
template <bool withScale>
KNEAD_INLINE Gradient gradientOf(const Surroundings& a, std::size_t i)
{
    Gradient g;
    static_cast<Deformation&>(g) = deformationOf(a, i);
    g.ratio = larger(g.volume, all(leastVolumeRatio));
    const Lanes part = (g.volume - leastVolumeRatio) * (1 / (wholeVolumeRatio - leastVolumeRatio));
    g.weight = smaller(larger(part, all(0)), all(1));
    const Lanes change = g.ratio - 1;
    const LaneBits isLarge = (larger(change, -change) > all(smallDilatation)) & inside(i, a.begin, a.end);
    Lanes logarithmic;
    if (any(isLarge)) {
        logarithmic = logarithm(g.ratio);
        if constexpr (withScale)
            g.scale = exponential(logarithmic * (-2.0 / 3));
    } else {
        constexpr double ofLogarithm[] = {1,        -1.0 / 2, 1.0 / 3,  -1.0 / 4, 1.0 / 5,
                                          -1.0 / 6, 1.0 / 7,  -1.0 / 8, 1.0 / 9};
        constexpr double ofScale[] = {-2.0 / 3,      5.0 / 9,         -40.0 / 81,      110.0 / 243,        -308.0 / 729,
                                      2618.0 / 6561, -7480.0 / 19683, 21505.0 / 59049, -559130.0 / 1594323};
        logarithmic = series(ofLogarithm, change);
        if constexpr (withScale)
            g.scale = 1 + series(ofScale, change);
    }
    g.theta = choose(g.isFlat, all(0), logarithmic - load(a.restDilatation + i));
    return g;
}

/// b = J^(-2/3) F G F^T of eight objects, and what comes from it.
struct ElasticPart {
    Lanes h[3][3]; ///< F G by lattice column
    Symmetric b;   ///< in world axes
    Lanes third;   ///< tr b / 3
};

/// @param scale J^(-2/3)
KNEAD_INLINE ElasticPart elasticPart(const Lanes (&f)[3][3], const Symmetric& metric, Lanes scale)
{
    const Symmetric inverse = adjugate(metric);
    ElasticPart e;
#pragma GCC unroll 9
    for (int c = 0; c < 3; ++c) {
        e.h[0][c] = f[0][c] * inverse.m[0] + f[1][c] * inverse.m[3] + f[2][c] * inverse.m[4];
        e.h[1][c] = f[0][c] * inverse.m[3] + f[1][c] * inverse.m[1] + f[2][c] * inverse.m[5];
        e.h[2][c] = f[0][c] * inverse.m[4] + f[1][c] * inverse.m[5] + f[2][c] * inverse.m[2];
    }
    constexpr int rows[6] = {0, 1, 2, 0, 0, 1};
    constexpr int columns[6] = {0, 1, 2, 1, 2, 2};
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n) {
        const int r = rows[n], c = columns[n];
        e.b.m[n] = scale * (e.h[0][r] * f[0][c] + e.h[1][r] * f[1][c] + e.h[2][r] * f[2][c]);
    }
    e.third = (e.b.m[0] + e.b.m[1] + e.b.m[2]) * (1.0 / 3);
    return e;
}

KNEAD_INLINE Symmetric loadSymmetric(const double* const* from, std::size_t i)
{
    Symmetric a;
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n)
        a.m[n] = from ? load(from[n] + i) : all(n < 3 ? 1 : 0);
    return a;
}

/// Lanes of a vector that are chosen are written, the others kept.
struct ChosenWriter {
    std::size_t i;
    LaneBits chosen;
    bool areAll;

    KNEAD_INLINE void operator()(double* to, Lanes values) const
    {
        if (areAll) {
            store(to + i, values);
            return;
        }
        for (std::size_t lane = 0; lane < lanes; ++lane)
            if (chosen[lane] != 0)
                to[i + lane] = values[lane];
    }
};

/// What eight objects are made of.
struct LaneNumbers {
    Lanes volume, shear, bulk;
};

KNEAD_INLINE Lanes valuesOf(const ObjectNumber& number, std::size_t i)
{
    return number.each ? load(number.each + i) : all(number.all);
}

KNEAD_INLINE LaneNumbers numbersOf(const TensorLawNumbers& a, std::size_t i, Lanes theta)
{
    const Lanes tension = valuesOf(a.tensionShare, i);
    return {load(a.volume + i), valuesOf(a.shear, i), valuesOf(a.bulk, i) * choose(theta > all(0), tension, all(1))};
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
