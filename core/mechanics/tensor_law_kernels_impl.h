// The kernels of tensor_law.h; see lattice_kernels_impl.h for how they are compiled.
#pragma once

#include "core/mechanics/lattice_force_kernels_impl.h"
#include "core/mechanics/tensor_law.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

KNEAD_INLINE Lanes larger(Lanes a, Lanes b)
{
    return a > b ? a : b;
}
KNEAD_INLINE Lanes smaller(Lanes a, Lanes b)
{
    return a < b ? a : b;
}
KNEAD_INLINE Lanes logarithm(Lanes x)
{
    return naturalLogarithm<UnsignedBits>(x);
}

/// e^x to about 2 ulp for |x| < 700, from operations that round alike everywhere: 2^n e^r with n the nearest integer to x / ln 2.
KNEAD_INLINE Lanes exponential(Lanes x)
{
    constexpr double shift = 6755399441055744.0; // 1.5 * 2^52: adding it leaves n in the lowest bits
    const Lanes shifted = x * 1.4426950408889634 + shift;
    const Lanes n = shifted - shift;
    // ln 2 in two parts, the first with zeros at its end, so that n times it is exact.
    const Lanes r = (x - n * 0.693147180369123816490) - n * 1.90821492927058770002e-10;
    Lanes series = all(1.0 / 6227020800.0);
    constexpr double inverseFactorials[] = {1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320,
                                            1.0 / 5040,      1.0 / 720,      1.0 / 120,     1.0 / 24,     1.0 / 6,
                                            0.5,             1.0,            1.0};
    for (const double coefficient : inverseFactorials)
        series = series * r + coefficient;
    const auto power = (__builtin_bit_cast(UnsignedBits, shifted) - __builtin_bit_cast(std::uint64_t, shift) + 1023) << 52;
    return series * __builtin_bit_cast(Lanes, power);
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

/// F of eight objects, by lattice column, with what follows from it.
struct Gradient {
    Lanes f[3][3];        ///< [column][world component]
    Lanes cofactor[3][3]; ///< of F: J F^-T
    Lanes ratio;          ///< J, not below leastVolumeRatio
    Lanes weight;         ///< of the law: 1 from wholeVolumeRatio on, 0 up to leastVolumeRatio
    LaneBits isFlat;      ///< nothing is known of F
    Lanes theta;
    Lanes scale; ///< ratio^(-2/3)
};

template <bool withScale>
KNEAD_INLINE Gradient gradientOf(const Surroundings& a, std::size_t i)
{
    const ShapeSums shape = shapeOfVector(a, i);
    const Lanes(&m)[3][3] = shape.m;
    const Lanes inverseSpacing = all(1 / a.spacing);
    const Lanes uu = load(a.inverseShape[0] + i), vv = load(a.inverseShape[1] + i), ww = load(a.inverseShape[2] + i);
    const Lanes uv = load(a.inverseShape[3] + i), uw = load(a.inverseShape[4] + i), vw = load(a.inverseShape[5] + i);
    Gradient g;
    g.isFlat = uu == all(0);
    for (int c = 0; c < 3; ++c) {
        g.f[0][c] = (m[0][c] * uu + m[1][c] * uv + m[2][c] * uw) * inverseSpacing;
        g.f[1][c] = (m[0][c] * uv + m[1][c] * vv + m[2][c] * vw) * inverseSpacing;
        g.f[2][c] = (m[0][c] * uw + m[1][c] * vw + m[2][c] * ww) * inverseSpacing;
    }
    for (int c = 0; c < 3; ++c)
        for (int column = 0; column < 3; ++column)
            g.f[column][c] = g.isFlat ? all(c == column ? 1 : 0) : g.f[column][c];
    for (int column = 0; column < 3; ++column) {
        const Lanes(&p)[3] = g.f[(column + 1) % 3];
        const Lanes(&q)[3] = g.f[(column + 2) % 3];
        for (int c = 0; c < 3; ++c)
            g.cofactor[column][c] = p[(c + 1) % 3] * q[(c + 2) % 3] - p[(c + 2) % 3] * q[(c + 1) % 3];
    }
    const Lanes volume =
        g.f[0][0] * g.cofactor[0][0] + g.f[0][1] * g.cofactor[0][1] + g.f[0][2] * g.cofactor[0][2];
    const Lanes smallest = all(leastVolumeRatio);
    g.ratio = larger(volume, smallest);
    const Lanes logarithmic = logarithm(g.ratio);
    const Lanes part = (volume - leastVolumeRatio) * (1 / (wholeVolumeRatio - leastVolumeRatio));
    g.weight = smaller(larger(part, all(0)), all(1));
    g.theta = g.isFlat ? all(0) : logarithmic - load(a.restDilatation + i);
    if constexpr (withScale)
        g.scale = exponential(logarithmic * (-2.0 / 3));
    return g;
}

/// b = J^(-2/3) F G F^T of eight objects, and what comes from it.
struct ElasticPart {
    Lanes h[3][3]; ///< F G by lattice column
    Symmetric b;   ///< in world axes
    Lanes third;   ///< tr b / 3
};

KNEAD_INLINE ElasticPart elasticPart(const Gradient& g, const Symmetric& metric)
{
    const Symmetric inverse = adjugate(metric);
    ElasticPart e;
    for (int c = 0; c < 3; ++c) {
        e.h[0][c] = g.f[0][c] * inverse.m[0] + g.f[1][c] * inverse.m[3] + g.f[2][c] * inverse.m[4];
        e.h[1][c] = g.f[0][c] * inverse.m[3] + g.f[1][c] * inverse.m[1] + g.f[2][c] * inverse.m[5];
        e.h[2][c] = g.f[0][c] * inverse.m[4] + g.f[1][c] * inverse.m[5] + g.f[2][c] * inverse.m[2];
    }
    constexpr int rows[6] = {0, 1, 2, 0, 0, 1};
    constexpr int columns[6] = {0, 1, 2, 1, 2, 2};
    for (int n = 0; n < 6; ++n) {
        const int r = rows[n], c = columns[n];
        e.b.m[n] =
            g.scale * (e.h[0][r] * g.f[0][c] + e.h[1][r] * g.f[1][c] + e.h[2][r] * g.f[2][c]);
    }
    e.third = (e.b.m[0] + e.b.m[1] + e.b.m[2]) * (1.0 / 3);
    return e;
}

KNEAD_INLINE Symmetric loadSymmetric(const double* const* from, std::size_t i)
{
    Symmetric a;
    for (int n = 0; n < 6; ++n)
        a.m[n] = from ? load(from[n] + i) : all(n < 3 ? 1 : 0);
    return a;
}

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

KNEAD_INLINE UnsignedBits behindOf(const Surroundings& a, std::size_t i)
{
    return __builtin_convertvector(*reinterpret_cast<const HalfLaneBits*>(a.hasBehind + i), UnsignedBits);
}

/// Calls visit.operator()<d>() for every direction.
template <typename Visit>
KNEAD_INLINE void forEachDirection(Visit visit)
{
    visit.template operator()<0>();
    visit.template operator()<1>();
    visit.template operator()<2>();
    visit.template operator()<3>();
    visit.template operator()<4>();
    visit.template operator()<5>();
    visit.template operator()<6>();
    visit.template operator()<7>();
    visit.template operator()<8>();
    visit.template operator()<9>();
    visit.template operator()<10>();
    visit.template operator()<11>();
    visit.template operator()<12>();
}

/// F o for an integer direction.
template <int d>
KNEAD_INLINE void along(const Gradient& g, Lanes (&step)[3])
{
    constexpr int o[3] = {latticeDirections[d][0], latticeDirections[d][1], latticeDirections[d][2]};
    for (int c = 0; c < 3; ++c) {
        step[c] = Lanes{};
        for (int column = 0; column < 3; ++column) {
            if (o[column] > 0)
                step[c] += g.f[column][c];
            if (o[column] < 0)
                step[c] -= g.f[column][c];
        }
    }
}

template <int d>
constexpr double squaredStep = latticeDirections[d][0] * latticeDirections[d][0] +
                               latticeDirections[d][1] * latticeDirections[d][1] +
                               latticeDirections[d][2] * latticeDirections[d][2];

/// Lanes of a vector that belong to the run are written, the others kept.
struct Writer {
    const Surroundings& at;
    std::size_t i;
    bool isPartial;

    KNEAD_INLINE void operator()(double* to, Lanes values) const
    {
        if (!isPartial) {
            store(to + i, values);
            return;
        }
        for (std::size_t lane = 0; lane < lanes; ++lane)
            if (i + lane >= at.begin && i + lane < at.end)
                to[i + lane] = values[lane];
    }
};

/// How far connections that follow F are from l_b: rho = 1 - l_b^2 / |F D|^2 per direction.
struct Excess {
    Lanes rho[latticeDirectionCount];
    bool isSmall; ///< all of them are within smallExcess
};

// Below this, series to the tenth power are exact to rounding, and much quicker than roots and logarithms.
constexpr double smallExcess = 0.04;

KNEAD_INLINE bool anyBeyond(Lanes values, double limit)
{
    std::int64_t beyond = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane)
        beyond |= values[lane] > limit ? 1 : 0;
    return beyond != 0;
}

KNEAD_INLINE Excess excessOf(const Surroundings& a, const Gradient& g, const Symmetric& metric)
{
    // One division for all: each inverse is the product of the others times the inverse of the product.
    Lanes squared[latticeDirectionCount];
    Lanes products[latticeDirectionCount];
    Lanes product = all(1);
    const std::uint32_t used = a.forward | a.backward;
    forEachDirection([&]<int d>() __attribute__((always_inline)) {
        squared[d] = all(1);
        if ((used >> d & 1U) != 0) {
            Lanes step[3];
            along<d>(g, step);
            squared[d] = step[0] * step[0] + step[1] * step[1] + step[2] * step[2] + 1e-12; // finite where F is flat
        }
        products[d] = product;
        product *= squared[d];
    });
    Lanes inverse = 1 / product;
    Excess excess;
    Lanes largest{};
    const auto find = [&]<int d>() __attribute__((always_inline)) {
        excess.rho[d] = Lanes{};
        if ((used >> d & 1U) == 0)
            return;
        excess.rho[d] = (squared[d] - quadratic<d>(metric)) * (inverse * products[d]);
        inverse *= squared[d];
        largest = larger(largest, larger(excess.rho[d], -excess.rho[d]));
    };
    find.template operator()<12>();
    find.template operator()<11>();
    find.template operator()<10>();
    find.template operator()<9>();
    find.template operator()<8>();
    find.template operator()<7>();
    find.template operator()<6>();
    find.template operator()<5>();
    find.template operator()<4>();
    find.template operator()<3>();
    find.template operator()<2>();
    find.template operator()<1>();
    find.template operator()<0>();
    excess.isSmall = !anyBeyond(largest, smallExcess);
    return excess;
}

/// x sum c_n x^n.
template <int count>
KNEAD_INLINE Lanes series(const double (&coefficients)[count], Lanes x)
{
    Lanes sum = all(coefficients[count - 1]);
    for (int n = count - 2; n >= 0; --n)
        sum = sum * x + coefficients[n];
    return x * sum;
}

/// 1 - l_b / |F D| = 1 - sqrt(1 - rho).
KNEAD_INLINE Lanes relativeStretch(Lanes rho, bool isSmall)
{
    constexpr double coefficients[] = {1.0 / 2,    1.0 / 8,     1.0 / 16,     5.0 / 128,    7.0 / 256,
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

/// What the connections of eight objects would bear if all followed F: sum_b k / 2 (1 - l_b / |F o|) F o o^T by lattice column,
/// and the energy sum_b k / 4 (|F o| - l_b)^2 (each connection belongs to two objects); both for a spacing of 1.
struct SpringShare {
    Lanes pull[3][3];
    Lanes energy;
};

KNEAD_INLINE SpringShare springShare(const Surroundings& a, std::size_t i, UnsignedBits behind, const Gradient& g,
                                     const Excess& excess)
{
    SpringShare share{};
    forEachDirection([&]<int d>() __attribute__((always_inline)) {
        if (((a.forward | a.backward) >> d & 1U) == 0)
            return;
        constexpr int o[3] = {latticeDirections[d][0], latticeDirections[d][1], latticeDirections[d][2]};
        const Lanes k = stiffnessAround<d>(a, i, behind);
        Lanes step[3];
        along<d>(g, step);
        const Lanes squared = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
        const Lanes whole = relativeStretch(excess.rho[d], excess.isSmall);
        const LaneBits isShort = whole < all(leastStretch);
        const Lanes stretch = isShort ? all(leastStretch) : whole;
        const Lanes half = 0.5 * k * stretch;
        // Below the least stretch the force goes on in proportion to |F o|: sum_b k / 4 (l_b^2 / 2 - |F o|^2).
        share.energy += 0.25 * k * squared * (isShort ? -0.5 - 0.5 * excess.rho[d] : stretch * stretch);
        for (int c = 0; c < 3; ++c)
            for (int column = 0; column < 3; ++column) {
                if (o[column] > 0)
                    share.pull[column][c] += half * step[c];
                if (o[column] < 0)
                    share.pull[column][c] -= half * step[c];
            }
    });
    return share;
}

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
    return {load(a.volume + i), valuesOf(a.shear, i), valuesOf(a.bulk, i) * (theta > all(0) ? tension : all(1))};
}

/// Energy of eight objects, less what their springs have of it.
KNEAD_INLINE Lanes energyOf(const LaneNumbers& numbers, const Gradient& g, const ElasticPart& e, const SpringShare& share,
                            double spacing)
{
    const Lanes whole =
        numbers.volume * (0.5 * numbers.bulk * g.theta * g.theta + 1.5 * numbers.shear * (e.third - 1));
    return g.isFlat ? all(0) : g.weight * (whole - spacing * spacing * share.energy);
}

/// N of the namespace squared, from |s|^2.
KNEAD_INLINE Lanes squaredNorm(const TensorLawArguments& arguments, std::size_t i, UnsignedBits behind, const Gradient& g,
                               const Excess& excess, const LaneNumbers& numbers, Lanes squaredDeviator)
{
    const Surroundings& a = arguments.at;
    const FlowResult& flow = *arguments.flow;
    const Writer write{a, i, i < a.begin || i + lanes > a.end};
    Lanes beyond{};
    Lanes weights = all(1e-300);
    forEachDirection([&]<int d>() __attribute__((always_inline)) {
        if (((a.forward | a.backward) >> d & 1U) == 0)
            return;
        const Lanes affine = g.isFlat ? all(0) : naturalStretch(excess.rho[d], excess.isSmall);
        write(flow.affine[d], affine);
        const Lanes shape = affine - g.theta * (1.0 / 3);
        const Lanes follows = g.isFlat ? all(0) : shape * shape;
        if ((a.forward >> d & 1U) != 0) {
            const Lanes k = squaredStep<d> * load(a.stiffness[d] + i);
            const Lanes strain = load(flow.connectionStrain[d] + i) -
                                 (g.theta + load(flow.dilatation + i + a.ahead[d])) * (1.0 / 6);
            beyond += k * (strain * strain - follows);
            weights += k;
        }
        if ((a.backward >> d & 1U) != 0) {
            const LaneBits isOwn = (behind >> d & 1) != 0;
            const Lanes k = squaredStep<d> * masked(load(a.stiffness[d] + i - a.behind[d]), isOwn);
            const Lanes strain = masked(load(flow.connectionStrain[d] + i - a.behind[d]), isOwn) -
                                 (g.theta + load(flow.dilatation + i - a.behind[d])) * (1.0 / 6);
            beyond += k * (strain * strain - follows);
            weights += k;
        }
    });
    const Lanes extra = 30 * numbers.shear * numbers.shear * beyond / weights;
    return squaredDeviator + larger(extra, all(0));
}

/// Of eight objects, before they flow.
struct Trial {
    const Gradient& g;
    const Symmetric& metric;
    const ElasticPart& elastic;
    const Excess& excess;
    const LaneNumbers& numbers;
};

/// C where b^-1 of what is elastic afterwards is `inverse`: J^(-2/3) F^T b^-1 F.
KNEAD_INLINE Symmetric metricOf(const Gradient& g, const Symmetric& inverse)
{
    Lanes product[3][3]; // b^-1 F by lattice column
    for (int column = 0; column < 3; ++column) {
        const Lanes(&f)[3] = g.f[column];
        product[column][0] = inverse.m[0] * f[0] + inverse.m[3] * f[1] + inverse.m[4] * f[2];
        product[column][1] = inverse.m[3] * f[0] + inverse.m[1] * f[1] + inverse.m[5] * f[2];
        product[column][2] = inverse.m[4] * f[0] + inverse.m[5] * f[1] + inverse.m[2] * f[2];
    }
    constexpr int rows[6] = {0, 1, 2, 0, 0, 1};
    constexpr int columns[6] = {0, 1, 2, 1, 2, 2};
    Symmetric metric;
    for (int n = 0; n < 6; ++n) {
        const Lanes(&f)[3] = g.f[rows[n]];
        const Lanes(&p)[3] = product[columns[n]];
        metric.m[n] = g.scale * (f[0] * p[0] + f[1] * p[1] + f[2] * p[2]);
    }
    return metric;
}

/// The return of eight objects: writes their plastic state afterwards, C in `after`. @return whether any of them flows
KNEAD_INLINE bool flowOfVector(const TensorLawArguments& arguments, std::size_t i, UnsignedBits behind, const Trial& trial,
                               Symmetric& after)
{
    const Surroundings& a = arguments.at;
    const FlowResult& flow = *arguments.flow;
    const Writer write{a, i, i < a.begin || i + lanes > a.end};
    const Gradient& g = trial.g;
    const ElasticPart& e = trial.elastic;
    const Lanes shear = trial.numbers.shear;
    Symmetric deviator = e.b;
    for (int n = 0; n < 3; ++n)
        deviator.m[n] -= e.third;
    Lanes squared{};
    for (int n = 0; n < 6; ++n) {
        deviator.m[n] = g.isFlat ? all(0) : shear * deviator.m[n];
        squared += (n < 3 ? 1.0 : 2.0) * deviator.m[n] * deviator.m[n];
    }
    const Lanes norm =
        squareRoot(squaredNorm(arguments, i, behind, g, trial.excess, trial.numbers, squared)) + 1e-300;

    constexpr double rootTwoThirds = 0.81649658092772603;
    const Lanes alpha = arguments.plastic.equivalentStrain ? load(arguments.plastic.equivalentStrain + i) : all(0);
    const Lanes damage = arguments.plastic.damage ? load(arguments.plastic.damage + i) : all(0);
    const Lanes hardening = valuesOf(arguments.numbers.hardening, i);
    const Lanes yield = rootTwoThirds * (valuesOf(arguments.numbers.yieldStress, i) + hardening * alpha);
    const LaneBits flows = (norm > yield) & (g.weight == all(1));
    after = trial.metric;
    if (!anyBeyond(flows ? all(1) : all(0), 0)) {
        for (int n = 0; n < 6; ++n)
            write(flow.metric[n], after.m[n]);
        write(flow.equivalentStrain, alpha);
        write(flow.damage, damage);
        write(flow.share, all(1));
        write(flow.dissipated, all(0));
        forEachDirection([&]<int d>() __attribute__((always_inline)) {
            if (((a.forward | a.backward) >> d & 1U) != 0)
                write(flow.lengthening[d], all(1));
        });
        return false;
    }
    const Lanes time = valuesOf(arguments.numbers.flowTime, i);
    const Lanes within = time > all(0) ? 1 - exponential(larger(-flow.duration / time, all(-600))) : all(1);
    const Lanes modulus = shear * e.third;
    const Lanes amount = flows ? within * (norm - yield) / (2 * modulus * (1 + hardening / (3 * modulus))) : all(0);
    const Lanes share = flows ? 1 - 2 * modulus * amount / norm : all(1);
    const Lanes grown = rootTwoThirds * amount;
    // 1/2 + 3/2 sigma_m / sigma_eq of the stress afterwards, sigma_eq = sqrt(3/2) |s|.
    const Lanes equivalent = 1.2247448713915890 * squareRoot(squared) * share + 1e-300;
    const Lanes counted =
        smaller(larger(0.5 + 1.5 * trial.numbers.bulk * g.theta / equivalent, all(0)), all(1));

    Symmetric relaxed;
    for (int n = 0; n < 6; ++n)
        relaxed.m[n] = share * deviator.m[n] / shear + (n < 3 ? e.third : all(0));
    const Lanes unit = exponential(logarithm(larger(determinant(relaxed), all(1e-300))) * (-1.0 / 3));
    for (Lanes& entry : relaxed.m)
        entry *= unit;
    const Symmetric flowed = metricOf(g, adjugate(relaxed));
    const LaneBits changes = flows & ~g.isFlat;
    for (int n = 0; n < 6; ++n) {
        after.m[n] = changes ? flowed.m[n] : trial.metric.m[n];
        write(flow.metric[n], after.m[n]);
    }
    write(flow.equivalentStrain, alpha + grown);
    write(flow.damage, damage + counted * grown);
    write(flow.share, share);
    forEachDirection([&]<int d>() __attribute__((always_inline)) {
        if (((a.forward | a.backward) >> d & 1U) != 0)
            write(flow.lengthening[d], changes ? quadratic<d>(after) / quadratic<d>(trial.metric) : all(1));
    });
    return true;
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
    const Lanes pressure =
        numbers.volume * (numbers.bulk * g.theta - numbers.shear * e.third) / g.ratio;
    const double inverseSpacing = 1 / a.spacing;
    const LaneBits fades = (g.weight > all(0)) & (g.weight < all(1));
    constexpr double slope = 1 / (wholeVolumeRatio - leastVolumeRatio);
    const Lanes fading = fades ? energy / (fades ? g.weight : all(1)) * slope : all(0);
    Lanes p[3][3];
    for (int column = 0; column < 3; ++column)
        for (int c = 0; c < 3; ++c)
            p[column][c] = g.weight * ((shear * e.h[column][c] + pressure * g.cofactor[column][c]) * inverseSpacing -
                                       a.spacing * share.pull[column][c]) +
                           fading * g.cofactor[column][c] * inverseSpacing;
    const Lanes uu = load(a.inverseShape[0] + i), vv = load(a.inverseShape[1] + i), ww = load(a.inverseShape[2] + i);
    const Lanes uv = load(a.inverseShape[3] + i), uw = load(a.inverseShape[4] + i), vw = load(a.inverseShape[5] + i);
    for (int c = 0; c < 3; ++c) {
        write(arguments.stress[c], p[0][c] * uu + p[1][c] * uv + p[2][c] * uw);
        write(arguments.stress[3 + c], p[0][c] * uv + p[1][c] * vv + p[2][c] * vw);
        write(arguments.stress[6 + c], p[0][c] * uw + p[1][c] * vw + p[2][c] * ww);
    }
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
    const Excess excess = excessOf(a, g, metric);
    const SpringShare share = springShare(a, i, behind, g, excess);
    Symmetric after;
    if (flows && flowOfVector(arguments, i, behind, {g, metric, e, excess, numbers}, after)) {
        const Writer write{a, i, i < a.begin || i + lanes > a.end};
        const Lanes before = energyOf(numbers, g, e, share, a.spacing);
        const Lanes energy = stressOfTensor(arguments, i, numbers, g, elasticPart(g, after),
                                            springShare(a, i, behind, g, excessOf(a, g, after)));
        write(arguments.flow->dissipated, before - energy);
        return;
    }
    stressOfTensor(arguments, i, numbers, g, e, share);
}

template <typename OfVector>
KNEAD_INLINE void forEachVector(const Surroundings& a, OfVector ofVector)
{
    for (std::size_t i = firstVector(a.begin, a.end); i < a.end; i += lanes)
        ofVector(i);
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

/// e^x for x that are not large, to 1e-5 at 1/2, positive for |x| < 3.
KNEAD_INLINE double smallExponential(double x)
{
    const double even = 12 + x * x;
    return (even + 6 * x) / (even - 6 * x);
}

void naturalStrain(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor, const double* length,
                   double* strain)
{
    const double *x0 = self.x, *y0 = self.y, *z0 = self.z;
    const double *x1 = neighbor.x, *y1 = neighbor.y, *z1 = neighbor.z;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x1[i] - x0[i], dy = y1[i] - y0[i], dz = z1[i] - z0[i];
        const double squared = dx * dx + dy * dy + dz * dz + tinyLengthSquared;
        strain[i] = 0.5 * naturalLogarithm<std::uint64_t>(squared / (length[i] * length[i]));
    }
}

void lengthen(std::size_t count, const LengthArguments& a)
{
    const auto one = [&](std::size_t i, double& sum) __attribute__((always_inline)) {
        const double beyond = a.strain[i] - 0.5 * (a.lowerAffine[i] + a.upperAffine[i]);
        double amount = beyond * (1 - 0.5 * (a.lowerShare[i] + a.upperShare[i]));
        amount = amount > 1 ? 1 : amount;
        amount = amount < -1 ? -1 : amount;
        const double before = a.before[i];
        const double stretch = __builtin_sqrt(__builtin_sqrt(a.lowerLengthening[i] * a.upperLengthening[i]));
        const double after = before * stretch * smallExponential(amount);
        const double dx = a.upper.x[i] - a.lower.x[i], dy = a.upper.y[i] - a.lower.y[i],
                     dz = a.upper.z[i] - a.lower.z[i];
        const double length = __builtin_sqrt(dx * dx + dy * dy + dz * dz);
        sum += 0.5 * a.stiffness[i] * ((length - before) * (length - before) - (length - after) * (length - after));
        a.after[i] = after;
    };
    const std::size_t whole = count - count % sumLanes;
    for (std::size_t first = 0; first < whole; first += sumLanes) {
#pragma GCC ivdep
        for (std::size_t lane = 0; lane < sumLanes; ++lane)
            one(first + lane, a.dissipated[lane]);
    }
    for (std::size_t i = whole; i < count; ++i)
        one(i, a.dissipated[i - whole]);
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
