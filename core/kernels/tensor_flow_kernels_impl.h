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
    const Lanes time = valuesOf(arguments.numbers.flowTime, i);
    const Lanes within = choose(time > all(0), 1 - exponential(larger(-flow.duration / time, all(-600))), all(1));
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
    const Lanes unit = exponential(logarithm(larger(determinant(relaxed), all(1e-300))) * (-1.0 / 3));
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
    forEachDirection([&]<int d>() __attribute__((always_inline)) {
        if (((a.forward | a.backward) >> d & 1U) != 0)
            write(flow.lengthening[d], choose(changes, quadratic<d>(after) / quadratic<d>(trial.metric), all(1)));
    });
    return true;
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
    const auto one = [&](std::size_t i, double& sum, double& work) __attribute__((always_inline))
    {
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
        work += a.stiffness[i] * (length - after) * (after - before);
        a.after[i] = after;
    };
    const std::size_t whole = count - count % sumLanes;
    for (std::size_t first = 0; first < whole; first += sumLanes) {
#pragma GCC ivdep
        for (std::size_t lane = 0; lane < sumLanes; ++lane)
            one(first + lane, a.dissipated[lane], a.work[lane]);
    }
    for (std::size_t i = whole; i < count; ++i)
        one(i, a.dissipated[i - whole], a.work[i - whole]);
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
