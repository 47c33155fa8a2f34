// The kernels of tensor_law.h; see kernels_impl.h for how they are compiled.
#pragma once

#include "core/kernels/tensor_flow_kernels_impl.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

/// Energy of eight objects, less what their springs have of it.
KNEAD_INLINE Lanes energyOf(const LaneNumbers& numbers, const Gradient& g, const ElasticPart& e,
                            const SpringShare& share, double spacing)
{
    const Lanes whole = numbers.volume * (0.5 * numbers.bulk * g.theta * g.theta + 1.5 * numbers.shear * (e.third - 1));
    return choose(g.isFlat, all(0), g.weight * (whole - spacing * spacing * share.energy));
}

/// Writes the stress of eight objects. @return their energy
KNEAD_INLINE Lanes stressOfTensor(const TensorLawArguments& arguments, std::size_t i, const LaneNumbers& numbers,
                                  const Gradient& g, const ElasticPart& e, const SpringShare& share)
{
    const Surroundings& a = arguments.at;
    const Writer write{a, i, i < a.begin || i + lanes > a.end};
    const Lanes energy = energyOf(numbers, g, e, share, a.spacing);
    if (arguments.energy)
        write(arguments.energy, energy);
    if (arguments.theta)
        write(arguments.theta, g.theta);
    // P = tau F^-T of the weighed energy w e: w (e' - springs) + w' e cof F.
    const Lanes shear = numbers.volume * numbers.shear * g.scale;
    const Lanes pressure = numbers.volume * (numbers.bulk * g.theta - numbers.shear * e.third) / g.ratio;
    const double inverseSpacing = 1 / a.spacing;
    const LaneBits fades = (g.weight > all(0)) & (g.weight < all(1));
    constexpr double slope = 1 / (wholeVolumeRatio - leastVolumeRatio);
    const Lanes fading = choose(fades, energy / choose(fades, g.weight, all(1)) * slope, all(0));
    Lanes p[3][3];
    for (int column = 0; column < 3; ++column)
        for (int c = 0; c < 3; ++c)
            p[column][c] = g.weight * ((shear * e.h[column][c] + pressure * g.cofactor[column][c]) * inverseSpacing -
                                       a.spacing * share.pull[column][c]) +
                           fading * g.cofactor[column][c] * inverseSpacing;
    Lanes inverse[6];
    loadInverseShape(a, i, inverse);
    for (int c = 0; c < 3; ++c)
        for (int column = 0; column < 3; ++column)
            write(arguments.stress[3 * column + c], timesInverse(p, inverse, column, c));
    return energy;
}

template <bool flows>
KNEAD_INLINE void tensorLawOfVector(const TensorLawArguments& arguments, std::size_t i)
{
    const Surroundings& a = arguments.at;
    const Gradient g = gradientOf<true>(a, i);
    const UnsignedBits behind = behindOf(a, i);
    const LaneNumbers numbers = numbersOf(arguments.numbers, i, g.theta);
    const Symmetric metric = loadSymmetric(arguments.plastic.metric, i);
    const ElasticPart e = elasticPart(g, metric);
    const Excess excess = excessOf(a, i, g, metric);
    Symmetric after;
    if (flows && flowOfVector(arguments, i, behind, {g, metric, e, excess, numbers}, after)) {
        const Writer write{a, i, i < a.begin || i + lanes > a.end};
        const Lanes before = energyOf(numbers, g, e, springShare<true>(a, i, behind, g, excess), a.spacing);
        const Lanes energy = stressOfTensor(arguments, i, numbers, g, elasticPart(g, after),
                                            springShare<true>(a, i, behind, g, excessOf(a, i, g, after)));
        write(arguments.flow->dissipated, before - energy);
        return;
    }
    // Only what is asked for energy or fades needs it, a tenth of the work.
    const bool withEnergy = arguments.energy || anyBeyond(1 - g.weight, 0);
    stressOfTensor(arguments, i, numbers, g, e,
                   withEnergy ? springShare<true>(a, i, behind, g, excess)
                              : springShare<false>(a, i, behind, g, excess));
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
