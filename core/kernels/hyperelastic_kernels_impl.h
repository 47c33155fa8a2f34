// The kernel of hyperelastic_law.h; see kernels_impl.h for how it is compiled.
#pragma once

#include "core/kernels/tensor_elastic_kernels_impl.h"
#include "core/mechanics/hyperelastic_law.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

/// The volumetric energy K u, its slope, and J^(-2/3) with its relative slope, by the ratio J of present to relaxed volume.
struct Squeeze {
    Lanes theta;
    Lanes energy;
    Lanes slope;
    Lanes scale;
    Lanes scaleSlope;
};

KNEAD_INLINE Squeeze squeezeOf(Lanes volume)
{
    Squeeze s;
    const Lanes ratio = larger(volume, all(leastRubberRatio));
    const Lanes below = smaller(volume - leastRubberRatio, all(0));
    s.theta = logarithm(ratio);
    const Lanes inverse = 1 / ratio;
    const Lanes slope = s.theta * inverse;
    const Lanes curvature = (1 - s.theta) * inverse * inverse;
    s.energy = 0.5 * s.theta * s.theta + below * (slope + 0.5 * curvature * below);
    s.slope = slope + curvature * below;
    const Lanes tangent = 1 - (2.0 / 3) * below * inverse;
    s.scale = exponential(s.theta * (-2.0 / 3)) * tangent;
    s.scaleSlope = (-2.0 / 3) * inverse / tangent;
    return s;
}

KNEAD_INLINE void hyperelasticLawOfVector(const HyperelasticArguments& arguments, std::size_t i)
{
    const Surroundings& a = arguments.at;
    const LaneBits chosen = (valuesOf(arguments.isRubber, i) > all(0)) & inside(i, a.begin, a.end);
    const Lanes marks = choose(chosen, all(1), all(0));
    if (!anyBeyond(marks, 0))
        return;
    const ChosenWriter write{i, chosen, !anyBeyond(1 - marks, 0)};
    const Deformation g = deformationOf(a, i);
    const Symmetric metric = loadSymmetric(arguments.metric, i);

    const Lanes rest = load(a.restDilatation + i);
    const bool isAtRest = !anyBeyond(rest, 0) && !anyBeyond(-rest, 0);
    const Lanes shrinking = isAtRest ? all(1) : exponential(-rest);
    Squeeze squeeze = squeezeOf(g.volume * shrinking);
    if (!isAtRest)
        squeeze.scale *= exponential(rest * (-2.0 / 3));
    const ElasticPart e = elasticPart(g.f, metric, squeeze.scale);
    const LaneNumbers numbers = numbersOf(arguments.numbers, i, squeeze.theta);
    const Lanes share = valuesOf(arguments.secondShare, i);
    const Lanes chain = valuesOf(arguments.inverseChain, i);
    const Lanes scale = valuesOf(arguments.firstScale, i);
    const Lanes first = 3 * e.third;
    const Lanes(&b)[6] = e.b.m;
    const Lanes squared = b[0] * b[0] + b[1] * b[1] + b[2] * b[2] + 2 * (b[3] * b[3] + b[4] * b[4] + b[5] * b[5]);
    const Lanes second = 0.5 * (first * first - squared);
    const Lanes slope = firstSlope(scale, chain, first);

    constexpr double springs = rubberSpringShare;
    if (arguments.energy) {
        const Lanes density = numbers.bulk * squeeze.energy +
                              0.5 * numbers.shear * (firstEnergy(scale, chain, first) + share * (second - 3));
        Lanes follows{};
        for (int column = 0; column < 3; ++column)
            for (int c = 0; c < 3; ++c)
                follows += g.m[column][c] * g.f[column][c];
        write(arguments.energy, numbers.volume * density - (0.25 * springs * a.spacing) * follows);
    }
    if (arguments.theta)
        write(arguments.theta, choose(g.volume > all(0), squeeze.theta, all(2 * flatDilatation)));

    // P = mu [(A' + beta I1) s F G - beta s b F G] + dW/dJ cof F, s = J^(-2/3).
    const Lanes shear = numbers.volume * numbers.shear;
    const Lanes linear = shear * squeeze.scale * (slope + share * first);
    const Lanes quadratic = shear * squeeze.scale * share;
    const Lanes pressure = shrinking * (numbers.volume * numbers.bulk * squeeze.slope +
                                        0.5 * shear * (slope * first + 2 * share * second) * squeeze.scaleSlope);
    const double inverseSpacing = 1 / a.spacing;
    Lanes p[3][3];
    for (int column = 0; column < 3; ++column) {
        const Lanes(&h)[3] = e.h[column];
        const Lanes turned[3] = {b[0] * h[0] + b[3] * h[1] + b[4] * h[2], b[3] * h[0] + b[1] * h[1] + b[5] * h[2],
                                 b[4] * h[0] + b[5] * h[1] + b[2] * h[2]};
        for (int c = 0; c < 3; ++c)
            p[column][c] = (linear * h[c] - quadratic * turned[c] + pressure * g.cofactor[column][c]) * inverseSpacing;
    }
    Lanes inverse[6];
    loadInverseShape(a, i, inverse);
    const double taken = 0.5 * springs * a.spacing;
    for (int c = 0; c < 3; ++c)
        for (int column = 0; column < 3; ++column)
            write(arguments.stress[3 * column + c], timesInverse(p, inverse, column, c) - taken * g.f[column][c]);
}

void hyperelasticLaw(const HyperelasticArguments& arguments)
{
    forEachVector(
        arguments.at, [&](std::size_t i) __attribute__((always_inline)) { hyperelasticLawOfVector(arguments, i); });
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
