// Plastic flow of eight objects, and of the nominal lengths of connections that follow it, see tensor_law.h.
#pragma once

#include "core/kernels/tensor_springs_kernels_impl.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

/// N of the namespace squared, from |s|^2.
KNEAD_INLINE Lanes squaredNorm(const TensorLawArguments& arguments, std::size_t i, UnsignedBits behind,
                               const Gradient& g, const Excess& excess, const LaneNumbers& numbers,
                               Lanes squaredDeviator)
{
    const Surroundings& a = arguments.at;
    const FlowResult& flow = *arguments.flow;
    const Writer write{a, i, i < a.begin || i + lanes > a.end};
    const Lanes volume = g.theta + load(a.restDilatation + i); // of lengths that are relative to C, which has none
    Lanes beyond{};
    Lanes weights = all(1e-300);
    forEachDirection([&]<int d>() __attribute__((always_inline)) {
        if (((a.forward | a.backward) >> d & 1U) == 0)
            return;
        const Lanes affine = choose(g.isFlat, all(0), naturalStretch(excess.rho[d], excess.isSmall));
        write(flow.affine[d], affine);
        const Lanes shape = affine - volume * (1.0 / 3);
        const Lanes follows = choose(g.isFlat, all(0), shape * shape);
        if ((a.forward >> d & 1U) != 0) {
            const Lanes k = squaredStep<d> * load(a.stiffness[d] + i);
            const Lanes other = masked(load(flow.dilatation + i + a.ahead[d]), k > all(0)); // else it may be anything
            const Lanes strain = load(flow.connectionStrain[d] + i) - (volume + other) * (1.0 / 6);
            beyond += k * (strain * strain - follows);
            weights += k;
        }
        if ((a.backward >> d & 1U) != 0) {
            const LaneBits isOwn = (behind >> d & 1) != 0;
            const Lanes k = squaredStep<d> * masked(load(a.stiffness[d] + i - a.behind[d]), isOwn);
            const Lanes strain = masked(load(flow.connectionStrain[d] + i - a.behind[d]), isOwn) -
                                 (volume + masked(load(flow.dilatation + i - a.behind[d]), isOwn)) * (1.0 / 6);
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
    const Excess& excess;
    const LaneNumbers& numbers;
};

/// C where b^-1 of what is elastic afterwards is `inverse`: J^(-2/3) F^T b^-1 F.
KNEAD_INLINE Symmetric metricOf(const Gradient& g, const Symmetric& inverse)
{
    Lanes product[3][3]; // b^-1 F by lattice column
#pragma GCC unroll 9
    for (int column = 0; column < 3; ++column) {
        const Lanes(&f)[3] = g.f[column];
        product[column][0] = inverse.m[0] * f[0] + inverse.m[3] * f[1] + inverse.m[4] * f[2];
        product[column][1] = inverse.m[3] * f[0] + inverse.m[1] * f[1] + inverse.m[5] * f[2];
        product[column][2] = inverse.m[4] * f[0] + inverse.m[5] * f[1] + inverse.m[2] * f[2];
    }
    constexpr int rows[6] = {0, 1, 2, 0, 0, 1};
    constexpr int columns[6] = {0, 1, 2, 1, 2, 2};
    Symmetric metric;
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n) {
        const Lanes(&f)[3] = g.f[rows[n]];
        const Lanes(&p)[3] = product[columns[n]];
        metric.m[n] = g.scale * (f[0] * p[0] + f[1] * p[1] + f[2] * p[2]);
    }
    return metric;
}

/// Of eight objects, some of which flowed at the time before.
KNEAD_INLINE void writeNoFlow(const TensorLawArguments& arguments, std::size_t i, const Symmetric& metric, Lanes alpha,
                              Lanes damage)
{
    const Surroundings& a = arguments.at;
    const FlowResult& flow = *arguments.flow;
    const Writer write{a, i, i < a.begin || i + lanes > a.end};
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n)
        write(flow.metric[n], metric.m[n]);
    write(flow.equivalentStrain, alpha);
    write(flow.damage, damage);
    write(flow.share, all(1));
    write(flow.dissipated, all(0));
    for (int d = 0; d < latticeDirectionCount; ++d)
        if (((a.forward | a.backward) >> d & 1U) != 0)
            write(flow.lengthening[d], all(1));
}

/// x^(-1/3) for x >= 1e-300. @param counts lanes that decide how it is found
KNEAD_INLINE Lanes inverseCubeRoot(Lanes x, LaneBits counts)
{
    constexpr double coefficients[] = {-1.0 / 3,     2.0 / 9,         -14.0 / 81,     35.0 / 243,         -91.0 / 729,
                                       728.0 / 6561, -1976.0 / 19683, 5434.0 / 59049, -135850.0 / 1594323};
    const Lanes change = x - 1;
    if (any((larger(change, -change) > all(smallDilatation)) & counts))
        return exponential(logarithm(larger(x, all(1e-300))) * (-1.0 / 3));
    return 1 + series(coefficients, change);
}

/// The return of eight objects: writes their plastic state afterwards, C in `after`. @return whether any of them flows
KNEAD_INLINE bool flowOfVector(const TensorLawArguments& arguments, std::size_t i, UnsignedBits behind,
                               const Trial& trial, Symmetric& after)
{
    const Surroundings& a = arguments.at;
    const FlowResult& flow = *arguments.flow;
    const Writer write{a, i, i < a.begin || i + lanes > a.end};
    const Gradient& g = trial.g;
    const ElasticPart e = elasticPart(g.f, trial.metric, g.scale);
    const Lanes shear = trial.numbers.shear;
    Symmetric deviator = e.b;
#pragma GCC unroll 9
    for (int n = 0; n < 3; ++n)
        deviator.m[n] -= e.third;
    Lanes squared{};
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n) {
        deviator.m[n] = choose(g.isFlat, all(0), shear * deviator.m[n]);
        squared += (n < 3 ? 1.0 : 2.0) * deviator.m[n] * deviator.m[n];
    }
    const Lanes norm = squareRoot(squaredNorm(arguments, i, behind, g, trial.excess, trial.numbers, squared)) + 1e-300;

    constexpr double rootTwoThirds = 0.81649658092772603;
    const Lanes alpha = arguments.plastic.equivalentStrain ? load(arguments.plastic.equivalentStrain + i) : all(0);
    const Lanes damage = arguments.plastic.damage ? load(arguments.plastic.damage + i) : all(0);
    const Lanes hardening = valuesOf(arguments.numbers.hardening, i);
    const Lanes yield = rootTwoThirds * (valuesOf(arguments.numbers.yieldStress, i) + hardening * alpha);
    const LaneBits flows = (norm > yield) & (g.weight == all(1)) & inside(i, a.begin, a.end);
    after = trial.metric;
    if (!any(flows)) {
        // Other threads may be at the rest of a partial vector.
        if (write.isPartial || any(~(load(flow.share + i) >= all(1))))
            writeNoFlow(arguments, i, trial.metric, alpha, damage);
        return false;
    }
    const Lanes duration = all(flow.duration + 1e-300);
    const Lanes within = duration / (duration + valuesOf(arguments.numbers.flowTime, i));
    const Lanes modulus = shear * e.third;
    const Lanes beyond = within * (norm - yield) / (2 * modulus * (1 + hardening / (3 * modulus)));
    const Lanes share = choose(flows, 1 - 2 * modulus * beyond / norm, all(1));
    const Lanes amount = choose(share < all(1), beyond, all(0));
    const Lanes grown = rootTwoThirds * amount;
    // Triaxiality is sigma_m / sigma_eq of the stress afterwards, sigma_eq = sqrt(3/2) |s|.
    const Lanes equivalent = 1.2247448713915890 * squareRoot(squared) * share + 1e-300;
    const Lanes sheared = valuesOf(arguments.numbers.shearDamage, i);
    const Lanes drawn = sheared + 3 * (1 - sheared) * trial.numbers.bulk * g.theta / equivalent;
    const Lanes counted = smaller(larger(drawn, 2 * sheared - 1), all(1));

    Symmetric relaxed;
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n)
        relaxed.m[n] = share * deviator.m[n] / shear + (n < 3 ? e.third : all(0));
    const Lanes unit = inverseCubeRoot(determinant(relaxed), inside(i, a.begin, a.end));
    for (Lanes& entry : relaxed.m)
        entry *= unit;
    const Symmetric flowed = metricOf(g, adjugate(relaxed));
    const LaneBits changes = (share < all(1)) & ~g.isFlat;
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n) {
        after.m[n] = choose(changes, flowed.m[n], trial.metric.m[n]);
        write(flow.metric[n], after.m[n]);
    }
    write(flow.equivalentStrain, alpha + grown);
    write(flow.damage, larger(damage + counted * grown, all(0)));
    write(flow.share, share);
    forEachInverse(
        a.forward | a.backward, [&]<int d>() __attribute__((always_inline)) { return quadratic<d>(trial.metric); },
        [&]<int d>(Lanes inverse) __attribute__((always_inline)) {
            write(flow.lengthening[d], choose(changes, quadratic<d>(after) * inverse, all(1)));
        });
    return true;
}

KNEAD_INLINE Lanes squaredLengths(const ConstVectors& from, const ConstVectors& to, std::size_t i)
{
    const Lanes dx = load(to.x + i) - load(from.x + i), dy = load(to.y + i) - load(from.y + i),
                dz = load(to.z + i) - load(from.z + i);
    return dx * dx + dy * dy + dz * dz;
}

KNEAD_INLINE double squaredLength(const ConstVectors& from, const ConstVectors& to, std::size_t i)
{
    const double dx = to.x[i] - from.x[i], dy = to.y[i] - from.y[i], dz = to.z[i] - from.z[i];
    return dx * dx + dy * dy + dz * dz;
}

void naturalStrain(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor, const double* length,
                   double* strain)
{
    const std::size_t whole = count - count % lanes;
    for (std::size_t i = 0; i < whole; i += lanes) {
        const Lanes nominal = load(length + i);
        const Lanes excess = 1 - nominal * nominal / (squaredLengths(self, neighbor, i) + tinyLengthSquared);
        store(strain + i, naturalStretch(excess, !anyBeyond(larger(excess, -excess), smallExcess)));
    }
    for (std::size_t i = whole; i < count; ++i)
        strain[i] = 0.5 * naturalLogarithm<std::uint64_t>((squaredLength(self, neighbor, i) + tinyLengthSquared) /
                                                          (length[i] * length[i]));
}

/// e^x for x that are not large, to 1e-5 at 1/2, positive for |x| < 3.
template <typename Real>
KNEAD_INLINE Real smallExponential(Real x)
{
    const Real even = 12 + x * x;
    return (even + 6 * x) / (even - 6 * x);
}

KNEAD_INLINE double larger(double a, double b)
{
    return a > b ? a : b;
}
KNEAD_INLINE double smaller(double a, double b)
{
    return a < b ? a : b;
}

KNEAD_INLINE double fourthRoot(double x)
{
    return __builtin_sqrt(__builtin_sqrt(x));
}
KNEAD_INLINE Lanes fourthRoot(Lanes x)
{
    constexpr double coefficients[] = {1.0 / 4,         -3.0 / 32,           7.0 / 128,
                                       -77.0 / 2048,    231.0 / 8192,        -1463.0 / 65536,
                                       4807.0 / 262144, -129789.0 / 8388608, 447051.0 / 33554432};
    const Lanes change = x - 1;
    return anyBeyond(larger(change, -change), smallDilatation) ? squareRoot(squareRoot(x))
                                                               : 1 + series(coefficients, change);
}

/// By what nominal lengths are multiplied; no number where something is none. @param beyond strain that the flow of the ends does not follow
/// @param share that stays, of both ends @param lengthening of both ends
template <typename Real>
KNEAD_INLINE Real lengtheningOf(Real beyond, Real share, Real lengthening)
{
    const Real amount = beyond * (1 - 0.5 * share);
    return fourthRoot(lengthening) * smallExponential(larger(Real{} - 1, smaller(Real{} + 1, amount)));
}

/// Eight connections. Where no end flows they are as before.
KNEAD_INLINE void lengthenEight(const LengthArguments& a, std::size_t i)
{
    const Lanes before = load(a.before + i);
    const Lanes lowerShare = load(a.lowerShare + i), upperShare = load(a.upperShare + i);
    if (!any(~((lowerShare >= all(1)) & (upperShare >= all(1))))) {
        store(a.after + i, before);
        return;
    }
    const Lanes beyond = load(a.strain + i) - 0.5 * (load(a.lowerAffine + i) + load(a.upperAffine + i));
    const Lanes after = before * lengtheningOf<Lanes>(beyond, lowerShare + upperShare,
                                                      load(a.lowerLengthening + i) * load(a.upperLengthening + i));
    const Lanes length = squareRoot(squaredLengths(a.lower, a.upper, i));
    const Lanes k = load(a.stiffness + i);
    const Lanes stretch = length - before, left = length - after;
    store(a.dissipated, load(a.dissipated) + 0.5 * k * (stretch * stretch - left * left));
    store(a.work, load(a.work) + k * left * (after - before));
    store(a.after + i, after);
}

void lengthen(std::size_t count, const LengthArguments& a)
{
    static_assert(lanes == sumLanes);
    const std::size_t whole = count - count % lanes;
    for (std::size_t i = 0; i < whole; i += lanes)
        lengthenEight(a, i);
    for (std::size_t i = whole; i < count; ++i) {
        const double before = a.before[i];
        const double after = before * lengtheningOf<double>(a.strain[i] - 0.5 * (a.lowerAffine[i] + a.upperAffine[i]),
                                                            a.lowerShare[i] + a.upperShare[i],
                                                            a.lowerLengthening[i] * a.upperLengthening[i]);
        const double length = __builtin_sqrt(squaredLength(a.lower, a.upper, i));
        const double stretch = length - before, left = length - after;
        a.dissipated[i - whole] += 0.5 * a.stiffness[i] * (stretch * stretch - left * left);
        a.work[i - whole] += a.stiffness[i] * left * (after - before);
        a.after[i] = after;
    }
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
