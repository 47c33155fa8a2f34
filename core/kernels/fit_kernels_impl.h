// The kernels of fit_kernels.h; see kernels_impl.h for how they are compiled.
#pragma once

#include "core/kernels/fit_kernels.h"
#include "core/kernels/lanes_impl.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

static_assert(lanes == fitLanes);

KNEAD_INLINE void read(const float* from, Register<double>::Type& to)
{
    using FloatsAnywhere __attribute__((vector_size(registerBytes / 2), aligned(4), may_alias)) = float;
    to = __builtin_convertvector(*reinterpret_cast<const FloatsAnywhere*>(from), Register<double>::Type);
}
template <typename Half>
KNEAD_INLINE void read(const float* from, Pair<double, Half>& to)
{
    read(from, to.low);
    read(from + lanesOf<Half>, to.high);
}

/// In an order that does not depend on the set.
KNEAD_INLINE double sumOf(const Lanes& numbers)
{
    double n[lanes];
    store(n, numbers);
    return ((n[0] + n[4]) + (n[2] + n[6])) + ((n[1] + n[5]) + (n[3] + n[7]));
}

double lookAround(std::size_t count, const float* const (&steps)[3], const double (&point)[3],
                  double* const (&place)[3], double* distance)
{
    Lanes least = all(1e300);
    for (std::size_t i = 0; i < count; i += lanes) {
        Lanes squared{};
        for (std::size_t c = 0; c < 3; ++c) {
            Lanes step;
            read(steps[c] + i, step);
            const Lanes offset = step - all(point[c]);
            store(place[c] + i, offset);
            squared += offset * offset;
        }
        const Lanes away = squareRoot(squared);
        store(distance + i, away);
        least = smaller(least, away);
    }
    double n[lanes];
    store(n, least);
    for (std::size_t lane = 1; lane < lanes; ++lane)
        n[0] = n[lane] < n[0] ? n[lane] : n[0];
    return n[0];
}

FitContent content(const FitNodes& nodes, double support)
{
    const Lanes one = all(1);
    const Lanes three = all(3);
    const Lanes inverse = all(1 / support);
    Lanes count{};
    Lanes slope{};
    for (std::size_t i = 0; i < nodes.count; i += lanes) {
        const Lanes r = smaller(load(nodes.distance + i) * inverse, one);
        const Lanes rest = one - r;
        const Lanes square = load(nodes.share + i) * rest * rest;
        count += square * rest * (three * r + one);
        slope += r * r * square;
    }
    return {sumOf(count), 12 / support * sumOf(slope)};
}

void moments(const FitNodes& nodes, double support, double* weight, double (&sums)[FitMonomials::count])
{
    const Lanes one = all(1);
    const Lanes three = all(3);
    const Lanes inverse = all(1 / support);
    Lanes total[FitMonomials::count]{};
    for (std::size_t i = 0; i < nodes.count; i += lanes) {
        const Lanes r = smaller(load(nodes.distance + i) * inverse, one);
        const Lanes rest = one - r;
        Lanes values[FitMonomials::count];
        values[0] = load(nodes.share + i) * rest * rest * rest * (three * r + one);
        store(weight + i, values[0]);
        total[0] += values[0];
        const Lanes place[3] = {load(nodes.place[0] + i) * inverse, load(nodes.place[1] + i) * inverse,
                                load(nodes.place[2] + i) * inverse};
#pragma GCC unroll 35
        for (std::size_t k = 1; k < FitMonomials::count; ++k) {
            values[k] = values[fitMonomials.factor[k]] * place[fitMonomials.axis[k]];
            total[k] += values[k];
        }
    }
    for (std::size_t k = 0; k < FitMonomials::count; ++k)
        sums[k] = sumOf(total[k]);
}

double functions(const FitNodes& nodes, double support, const double* weight, const double (&coefficients)[10],
                 double* values)
{
    const Lanes inverse = all(1 / support);
    Lanes c[10];
    for (std::size_t k = 0; k < 10; ++k)
        c[k] = all(coefficients[k]);
    Lanes sum{};
    for (std::size_t i = 0; i < nodes.count; i += lanes) {
        const Lanes x = load(nodes.place[0] + i) * inverse;
        const Lanes y = load(nodes.place[1] + i) * inverse;
        const Lanes z = load(nodes.place[2] + i) * inverse;
        const Lanes value = load(weight + i) * (c[0] + x * (c[1] + c[4] * x + c[7] * y) +
                                                y * (c[2] + c[5] * y + c[8] * z) + z * (c[3] + c[6] * z + c[9] * x));
        store(values + i, value);
        sum += absolute(value);
    }
    return sumOf(sum);
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
