// The kernels of tensor_law.h; see kernels_impl.h for how they are compiled.
#pragma once

#include "core/kernels/tensor_flow_kernels_impl.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

/// What is elastic of eight objects, as far as their stress needs it.
struct ElasticMetric {
    Symmetric inverse; ///< G = C^-1
    Lanes third;       ///< t = J^(-2/3) G : F^T F / 3
};

/// @param square F^T F
KNEAD_INLINE ElasticMetric elasticMetric(const Gradient& g, const Symmetric& square, const Symmetric& metric)
{
    ElasticMetric e;
    e.inverse = adjugate(metric);
    e.third = g.scale * contraction(e.inverse, square) * (1.0 / 3);
    return e;
}

/// Energy of eight objects, less what their springs have of it.
KNEAD_INLINE Lanes energyOf(const LaneNumbers& numbers, const Gradient& g, Lanes third, const SpringShare& share,
                            double spacing)
{
    const Lanes whole = numbers.volume * (0.5 * numbers.bulk * g.theta * g.theta + 1.5 * numbers.shear * (third - 1));
    return choose(g.isFlat, all(0), g.weight * (whole - spacing * spacing * share.energy));
}

/// Writes the stress of eight objects. @return their energy
KNEAD_INLINE Lanes stressOfTensor(const TensorLawArguments& arguments, std::size_t i, const LaneNumbers& numbers,
                                  const Gradient& g, const ElasticMetric& e, const SpringShare& share)
{
    const Surroundings& a = arguments.at;
    const Writer write{a, i, i < a.begin || i + lanes > a.end};
    const Lanes energy = energyOf(numbers, g, e.third, share, a.spacing);
    if (arguments.energy)
        write(arguments.energy, energy);
    if (arguments.theta)
        write(arguments.theta, g.theta);
    // P = tau F^-T of the weighed energy w e is F A + q cof F with A = w (V mu J^(-2/3) G - S) and
    // q = w V (K theta - mu t) / J + w' e.
    const double inverseSpacing = 1 / a.spacing;
    const Lanes shear = g.weight * numbers.volume * numbers.shear * g.scale * inverseSpacing;
    const Lanes springs = g.weight * a.spacing;
    Symmetric inner;
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n)
        inner.m[n] = shear * e.inverse.m[n] - springs * share.pull.m[n];
    const Lanes pressure = numbers.volume * (numbers.bulk * g.theta - numbers.shear * e.third) / g.ratio;
    const LaneBits fades = (g.weight > all(0)) & (g.weight < all(1));
    constexpr double slope = 1 / (wholeVolumeRatio - leastVolumeRatio);
    const Lanes fading = choose(fades, energy / choose(fades, g.weight, all(1)) * slope, all(0));
    const Lanes volumetric = (g.weight * pressure + fading) * inverseSpacing;
    Lanes p[3][3];
#pragma GCC unroll 9
    for (int column = 0; column < 3; ++column)
#pragma GCC unroll 9
        for (int c = 0; c < 3; ++c)
            p[column][c] = timesInverse(g.f, inner.m, column, c) + volumetric * g.cofactor[column][c];
    Lanes inverse[6];
    loadInverseShape(a, i, inverse);
#pragma GCC unroll 9
    for (int c = 0; c < 3; ++c)
#pragma GCC unroll 9
        for (int column = 0; column < 3; ++column)
            write(arguments.stress[3 * column + c], timesInverse(p, inverse, column, c));
    return energy;
}

template <bool flows>
KNEAD_INLINE void tensorLawOfVector(const TensorLawArguments& arguments, std::size_t i)
{
    const Surroundings& a = arguments.at;
    const Gradient g = gradientOf<true>(a, i);
    const Symmetric square = squareOf(g.f);
    const UnsignedBits behind = behindOf(a, i);
    const LaneNumbers numbers = numbersOf(arguments.numbers, i, g.theta);
    const Symmetric metric = loadSymmetric(arguments.plastic.metric, i);
    const Excess excess = excessOf(a, i, square, metric);
    const ElasticMetric e = elasticMetric(g, square, metric);
    Symmetric after;
    if (flows && flowOfVector(arguments, i, behind, {g, metric, excess, numbers}, after)) {
        const Writer write{a, i, i < a.begin || i + lanes > a.end};
        const SpringShare share = springShare<true>(a, i, behind, square, excess);
        const Lanes before = energyOf(numbers, g, e.third, share, a.spacing);
        const SpringShare left = springShare<true>(a, i, behind, square, excessOf(a, i, square, after));
        const Lanes energy = stressOfTensor(arguments, i, numbers, g, elasticMetric(g, square, after), left);
        write(arguments.flow->dissipated, before - energy);
        return;
    }
    // Only what is asked for energy or fades needs it, a tenth of the work.
    const bool withEnergy = arguments.energy || anyBeyond(1 - g.weight, 0);
    stressOfTensor(arguments, i, numbers, g, e,
                   withEnergy ? springShare<true>(a, i, behind, square, excess)
                              : springShare<false>(a, i, behind, square, excess));
}

void tensorLaw(const TensorLawArguments& arguments)
{
    if (arguments.flow)
        forEachVector(arguments.at, [&](std::size_t i) { tensorLawOfVector<true>(arguments, i); });
    else
        forEachVector(arguments.at, [&](std::size_t i) { tensorLawOfVector<false>(arguments, i); });
}

void deformation(const Surroundings& a, double* theta, double* const* gradient)
{
    forEachVector(a, [&](std::size_t i) {
        const Writer write{a, i, i < a.begin || i + lanes > a.end};
        const Gradient g = gradientOf<false>(a, i);
        write(theta, g.theta);
        for (int n = 0; gradient && n < 9; ++n)
            write(gradient[n], g.f[n / 3][n % 3]);
    });
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
