// The force kernels of lattice_kernels.h; see kernels_impl.h for how they are compiled.
//
// Eight objects make a vector, which the compiler cuts into what the instruction set has. An object's own sums stay in
// registers over all directions; its neighbors' are added to in memory.
#pragma once

#include "core/aggregate/lattice_directions.h"
#include "core/kernels/lanes_impl.h"
#include "core/kernels/lattice_kernels.h"

#include <cstdint>

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

KNEAD_INLINE void add(double* to, Lanes values)
{
    store(to, load(to) + values);
}
KNEAD_INLINE void subtract(double* to, Lanes values)
{
    store(to, load(to) - values);
}
// Keeps 1/|d| finite when two objects coincide; the force is then 0 since d is.
constexpr double tinyLengthSquared = 1e-280;

/// Natural logarithm for positive normal numbers to about 2 ulp, of one value or of lanes, from operations that vectorize and
/// round alike everywhere (the C library picks among several versions by machine).
/// ln x = e ln 2 + 2 atanh((m - 1) / (m + 1)), m in [~0.7, ~1.4).
template <typename Bits, typename Real>
KNEAD_INLINE Real naturalLogarithm(const Real& x)
{
    // Unsigned shifts and the 2^52 trick, since AVX2 has neither a signed 64-bit shift nor a conversion from 64-bit integers.
    constexpr auto rootHalf = __builtin_bit_cast(std::uint64_t, 0.70710678118654752);
    constexpr std::uint64_t bias = 1023;
    constexpr double twoTo52 = 4503599627370496.0;
    const Bits bits = reinterpreted<std::uint64_t>(x);
    const Bits biased = (bits - rootHalf + (bias << 52)) >> 52;
    const Real mantissa = reinterpreted<double>(bits - (biased << 52) + (bias << 52));
    const Real exponent = reinterpreted<double>(biased | __builtin_bit_cast(std::uint64_t, twoTo52)) - (twoTo52 + 1023);
    const Real t = (mantissa - 1) / (mantissa + 1);
    const Real s = t * t;
    Real series = s * (1.0 / 21) + 1.0 / 19;
#pragma GCC unroll 9
    for (int n = 17; n >= 1; n -= 2)
        series = series * s + 1.0 / n;
    return exponent * 0.69314718055994531 + 2 * t * series;
}

KNEAD_INLINE Lanes logarithm(Lanes x)
{
    return naturalLogarithm<UnsignedBits>(x);
}

/// Lanes whose object lies in begin .. end, the first one being `first`.
KNEAD_INLINE LaneBits inside(std::size_t first, std::size_t begin, std::size_t end)
{
    LaneBits object;
    count(static_cast<std::int64_t>(first), object);
    return (object >= static_cast<std::int64_t>(begin)) & (object < static_cast<std::int64_t>(end));
}

/// Where the vectors of a run begin: at its first object, or for a long run on the cache line of that.
KNEAD_INLINE std::size_t firstVector(std::size_t begin, std::size_t end)
{
    constexpr std::size_t longRun = 8 * lanes;
    return end - begin < longRun ? begin : begin / lanes * lanes;
}

/// Calls ofVector(i) for the first objects of the vectors of a run.
template <typename OfVector>
KNEAD_INLINE void forEachVector(const Surroundings& a, OfVector ofVector)
{
    for (std::size_t i = firstVector(a.begin, a.end); i < a.end; i += lanes)
        ofVector(i);
}

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

/// Calls visit.operator()<d>() for every direction.
template <int d = 0, typename Visit>
KNEAD_INLINE void forEachDirection(const Visit& visit)
{
    visit.template operator()<d>();
    if constexpr (d + 1 < latticeDirectionCount)
        forEachDirection<d + 1>(visit);
}

/// The same, the last one first.
template <int d = latticeDirectionCount - 1, typename Visit>
KNEAD_INLINE void forEachDirectionBack(const Visit& visit)
{
    visit.template operator()<d>();
    if constexpr (d > 0)
        forEachDirectionBack<d - 1>(visit);
}

/// How much of a vector belongs to a run.
enum class VectorPart { whole, some };

/// Whether nominal lengths, damping times and shares are the same for all connections of a direction, and no share is taken.
enum class Springs { alike, own };

template <bool volumetric, Springs springs, VectorPart part>
KNEAD_INLINE void addForcesOfVector(const ForceArguments& a, std::size_t i)
{
    const LaneBits mask = part == VectorPart::some ? inside(i, a.begin, a.end) : LaneBits{};
    const std::ptrdiff_t s = a.stride;
    const double* position = a.position + i;
    const double* velocity = a.velocity + i;
    const Lanes x = load(position), y = load(position + s), z = load(position + 2 * s);
    const Lanes u = load(velocity), v = load(velocity + s), w = load(velocity + 2 * s);
    Lanes fx{}, fy{}, fz{}, bx{}, by{}, bz{};
    const ForceDirection* const end = a.directions + a.directionCount;
    for (const ForceDirection* direction = a.directions; direction != end; ++direction) {
        const std::ptrdiff_t j = direction->offset;
        const Lanes dx = load(position + j) - x, dy = load(position + j + s) - y, dz = load(position + j + 2 * s) - z;
        const Lanes squared = dx * dx + dy * dy + dz * dz + tinyLengthSquared;
        const Lanes inverseSquared = 1 / squared;
        const Lanes inverse = inverseSquared * squareRoot(squared);
        const Lanes approach =
            (load(velocity + j) - u) * dx + (load(velocity + j + s) - v) * dy + (load(velocity + j + 2 * s) - w) * dz;
        Lanes k = load(direction->stiffness + i);
        if constexpr (part == VectorPart::some)
            k = masked(k, mask);
        constexpr bool own = springs == Springs::own;
        const Lanes length =
            own && direction->nominalLength ? load(direction->nominalLength + i) : all(direction->uniformLength);
        const Lanes time = own && direction->dampingTime ? load(direction->dampingTime + i) : all(a.dampingTime);
        Lanes pull = k * (1 - length * inverse);
        if constexpr (own)
            pull *= direction->springShare ? load(direction->springShare + i) : all(direction->uniformShare);
        const Lanes brake = k * time * (inverseSquared * approach);
        Lanes px = pull * dx, py = pull * dy, pz = pull * dz;
        if constexpr (volumetric) {
            const std::ptrdiff_t c = a.stressStride;
            const double* column = direction->column[0] + i;
            Lanes tx = load(column) + load(column + j), ty = load(column + c) + load(column + c + j),
                  tz = load(column + 2 * c) + load(column + 2 * c + j);
            for (int n = 1; n < direction->columns; ++n) {
                column = direction->column[n] + i;
                const double sign = direction->sign[n];
                tx += sign * (load(column) + load(column + j));
                ty += sign * (load(column + c) + load(column + c + j));
                tz += sign * (load(column + 2 * c) + load(column + 2 * c + j));
            }
            px += k * tx;
            py += k * ty;
            pz += k * tz;
        }
        const Lanes qx = brake * dx, qy = brake * dy, qz = brake * dz;
        fx += px;
        fy += py;
        fz += pz;
        bx += qx;
        by += qy;
        bz += qz;
        double* force = a.neighbors.force + i + j;
        double* damping = a.neighbors.damping + i + j;
        const std::ptrdiff_t t = a.neighbors.stride;
        subtract(force, px);
        subtract(force + t, py);
        subtract(force + 2 * t, pz);
        subtract(damping, qx);
        subtract(damping + t, qy);
        subtract(damping + 2 * t, qz);
    }
    double* force = a.own.force + i;
    double* damping = a.own.damping + i;
    const std::ptrdiff_t t = a.own.stride;
    add(force, fx);
    add(force + t, fy);
    add(force + 2 * t, fz);
    add(damping, bx);
    add(damping + t, by);
    add(damping + 2 * t, bz);
}

template <bool volumetric, Springs springs>
void addForcesOfRun(const ForceArguments& a)
{
    for (std::size_t i = firstVector(a.begin, a.end); i < a.end; i += lanes) {
        if (i >= a.begin && i + lanes <= a.end)
            addForcesOfVector<volumetric, springs, VectorPart::whole>(a, i);
        else
            addForcesOfVector<volumetric, springs, VectorPart::some>(a, i);
    }
}

bool areAlike(const ForceArguments& a)
{
    bool alike = true;
    for (std::size_t d = 0; d < a.directionCount; ++d) {
        const ForceDirection& direction = a.directions[d];
        alike = alike && !direction.nominalLength && !direction.dampingTime && !direction.springShare &&
                direction.uniformShare == 1;
    }
    return alike;
}

void addForces(const ForceArguments& arguments)
{
    const bool isVolumetric = arguments.stressStride != 0;
    if (areAlike(arguments))
        isVolumetric ? addForcesOfRun<true, Springs::alike>(arguments)
                     : addForcesOfRun<false, Springs::alike>(arguments);
    else
        isVolumetric ? addForcesOfRun<true, Springs::own>(arguments) : addForcesOfRun<false, Springs::own>(arguments);
}

/// Columns of M = sum k d o^T over the connections of eight objects, in lattice axes.
struct ShapeSums {
    Lanes m[3][3]; ///< [column][world component]
};

template <int d>
KNEAD_INLINE void addShapeOfDirection(const Surroundings& a, std::size_t i, UnsignedBits behind, ShapeSums& sums)
{
    constexpr int o[3] = {latticeDirections[d][0], latticeDirections[d][1], latticeDirections[d][2]};
    const bool hasNext = (a.forward >> d & 1U) != 0;
    const bool hasPrevious = (a.backward >> d & 1U) != 0;
    if (!hasNext && !hasPrevious)
        return;
    const double* k = a.stiffness[d] + i;
    const LaneBits isOwn = (behind >> d & 1) != 0;
#pragma GCC unroll 9
    for (int c = 0; c < 3; ++c) {
        const double* place = a.position + c * a.stride + i;
        const Lanes here = load(place);
        Lanes pull{};
        if (hasNext)
            pull += load(k) * (load(place + a.ahead[d]) - here);
        if (hasPrevious)
            pull += masked(load(k - a.behind[d]), isOwn) * (here - load(place - a.behind[d]));
#pragma GCC unroll 9
        for (int column = 0; column < 3; ++column) {
            if (o[column] > 0)
                sums.m[column][c] += pull;
            if (o[column] < 0)
                sums.m[column][c] -= pull;
        }
    }
}

KNEAD_INLINE UnsignedBits behindOf(const Surroundings& a, std::size_t i)
{
    UnsignedBits behind;
    widen(a.hasBehind + i, behind);
    return behind;
}

KNEAD_INLINE ShapeSums shapeOfVector(const Surroundings& a, std::size_t i)
{
    ShapeSums sums{};
    const UnsignedBits behind = behindOf(a, i);
    forEachDirection([&]<int d>() __attribute__((always_inline)) { addShapeOfDirection<d>(a, i, behind, sums); });
    return sums;
}

/// K^-1 of eight objects: uu vv ww uv uw vw.
KNEAD_INLINE void loadInverseShape(const Surroundings& a, std::size_t i, Lanes (&inverse)[6])
{
#pragma GCC unroll 9
    for (int n = 0; n < 6; ++n)
        inverse[n] = load(a.inverseShape[n] + i);
}

// How a cell is deformed, for numbers and for lanes. Matrices are by lattice column: [column][world component].

/// A component of a column of A K^-1.
template <typename Real>
KNEAD_INLINE Real timesInverse(const Real (&a)[3][3], const Real (&inverse)[6], int column, int component)
{
    constexpr int entry[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
    return a[0][component] * inverse[entry[column][0]] + a[1][component] * inverse[entry[column][1]] +
           a[2][component] * inverse[entry[column][2]];
}

/// F = M K^-1 / a.
template <typename Real>
KNEAD_INLINE void findGradient(const Real (&m)[3][3], const Real (&inverse)[6], Real inverseSpacing, Real (&f)[3][3])
{
#pragma GCC unroll 9
    for (int c = 0; c < 3; ++c)
#pragma GCC unroll 9
        for (int column = 0; column < 3; ++column)
            f[column][c] = timesInverse(m, inverse, column, c) * inverseSpacing;
}

/// Cofactors of F: F^-T = cof F / det F.
template <typename Real>
KNEAD_INLINE void findCofactors(const Real (&f)[3][3], Real (&cofactor)[3][3])
{
#pragma GCC unroll 9
    for (int column = 0; column < 3; ++column) {
        const Real(&p)[3] = f[(column + 1) % 3];
        const Real(&q)[3] = f[(column + 2) % 3];
#pragma GCC unroll 9
        for (int c = 0; c < 3; ++c)
            cofactor[column][c] = p[(c + 1) % 3] * q[(c + 2) % 3] - p[(c + 2) % 3] * q[(c + 1) % 3];
    }
}

/// det F.
KNEAD_INLINE Lanes volumeOf(const Lanes (&f)[3][3], const Lanes (&cofactor)[3][3])
{
    return f[0][0] * cofactor[0][0] + f[0][1] * cofactor[0][1] + f[0][2] * cofactor[0][2];
}

// Of lanes what lattice_kernels.h has of numbers.
using knead::kernels::boundedVolumeRatio;
KNEAD_INLINE Lanes boundedVolumeRatio(const Lanes& determinant)
{
    return larger(determinant, all(smallestVolumeRatio));
}
KNEAD_INLINE Lanes logarithmOfVolume(const Lanes& determinant)
{
    const Lanes below = choose(determinant < all(smallestVolumeRatio), determinant / smallestVolumeRatio - 1, all(0));
    return logarithm(boundedVolumeRatio(determinant)) + below;
}

template <VectorPart part>
KNEAD_INLINE void stressOfVector(const StressArguments& arguments, std::size_t i)
{
    const Surroundings& a = arguments.at;
    const ShapeSums shape = shapeOfVector(a, i);
    const Lanes inverseSpacing = all(1 / a.spacing);
    Lanes inverse[6];
    loadInverseShape(a, i, inverse);
    Lanes f[3][3];
    findGradient(shape.m, inverse, inverseSpacing, f);
    Lanes cofactor[3][3];
    findCofactors(f, cofactor);
    const Lanes determinant = volumeOf(f, cofactor);
    const Lanes dilatation = logarithmOfVolume(determinant) - load(a.restDilatation + i);
    // See volumetricStrain(): g g' / ratio, g' = 1 / (1 - theta)^2 where g = theta / (1 - theta).
    const Lanes bulk = load(arguments.bulk + i);
    const LaneBits softens = (bulk < all(0)) & (dilatation < all(0));
    const Lanes damped = choose(softens, 1 / (1 - dilatation), all(1));
    const Lanes slope = choose(softens & (determinant < all(0)), all(0), damped * damped * damped);
    const Lanes p = bulk * dilatation * slope * inverseSpacing / boundedVolumeRatio(determinant);
    const Writer write{a, i, part == VectorPart::some};
    write(arguments.theta, dilatation);
#pragma GCC unroll 9
    for (int c = 0; c < 3; ++c)
#pragma GCC unroll 9
        for (int column = 0; column < 3; ++column)
            write(arguments.stress[3 * column + c], p * timesInverse(cofactor, inverse, column, c));
}

void volumetricStress(const StressArguments& arguments)
{
    forEachVector(
        arguments.at, [&](std::size_t i) __attribute__((always_inline)) {
            if (i >= arguments.at.begin && i + lanes <= arguments.at.end)
                stressOfVector<VectorPart::whole>(arguments, i);
            else
                stressOfVector<VectorPart::some>(arguments, i);
        });
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
