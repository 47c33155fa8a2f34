// The kernels of contact_kernels.h; see kernels_impl.h for how they are compiled.
#pragma once

#include "core/kernels/contact_kernels.h"
#include "core/kernels/lanes_impl.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

static_assert(lanes == motionSize && 2 * lanes == effectSize);

/// Vectors of eight points.
struct PointVectors {
    Lanes x, y, z;
};

KNEAD_INLINE PointVectors load(const double* const (&from)[3], std::size_t i)
{
    return {load(from[0] + i), load(from[1] + i), load(from[2] + i)};
}
KNEAD_INLINE void store(double* const* to, std::size_t i, const PointVectors& v)
{
    store(to[0] + i, v.x);
    store(to[1] + i, v.y);
    store(to[2] + i, v.z);
}
KNEAD_INLINE PointVectors allOf(const double (&v)[3])
{
    return {all(v[0]), all(v[1]), all(v[2])};
}
KNEAD_INLINE PointVectors operator+(const PointVectors& a, const PointVectors& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
KNEAD_INLINE PointVectors operator-(const PointVectors& a, const PointVectors& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
KNEAD_INLINE PointVectors operator*(const Lanes& s, const PointVectors& a)
{
    return {s * a.x, s * a.y, s * a.z};
}
KNEAD_INLINE Lanes dotOf(const PointVectors& a, const PointVectors& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
KNEAD_INLINE PointVectors crossOf(const PointVectors& a, const PointVectors& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
KNEAD_INLINE PointVectors masked(const PointVectors& a, const LaneBits& mask)
{
    return {masked(a.x, mask), masked(a.y, mask), masked(a.z, mask)};
}
KNEAD_INLINE PointVectors toWorld(const double (&rotation)[9], const PointVectors& v)
{
    const double* const r = rotation;
    return {v.x * r[0] + v.y * r[3] + v.z * r[6], v.x * r[1] + v.y * r[4] + v.z * r[7],
            v.x * r[2] + v.y * r[5] + v.z * r[8]};
}
KNEAD_INLINE PointVectors toLocal(const double (&rotation)[9], const PointVectors& v)
{
    const double* const r = rotation;
    return {v.x * r[0] + v.y * r[1] + v.z * r[2], v.x * r[3] + v.y * r[4] + v.z * r[5],
            v.x * r[6] + v.y * r[7] + v.z * r[8]};
}
KNEAD_INLINE Lanes signOf(const Lanes& v)
{
    return choose(v < all(0), all(-1), all(1));
}
/// Where the divisor is 0, 1 takes its place.
KNEAD_INLINE Lanes notZero(const Lanes& divisor)
{
    return choose(divisor > all(0), divisor, all(1));
}

struct LaneSurfacePoint {
    Lanes distance;
    PointVectors normal;
};

KNEAD_INLINE LaneSurfacePoint ballAt(const PlacedForm& form, const PointVectors& at)
{
    const Lanes length = squareRoot(dotOf(at, at));
    const LaneBits isOff = length > all(0);
    const Lanes inverse = 1 / notZero(length);
    return {length - form.half[0], {at.x * inverse, at.y * inverse, choose(isOff, at.z * inverse, all(1))}};
}

KNEAD_INLINE LaneSurfacePoint boxAt(const PlacedForm& form, const PointVectors& at)
{
    const PointVectors beyond = PointVectors{absolute(at.x), absolute(at.y), absolute(at.z)} - allOf(form.half);
    const PointVectors sign{signOf(at.x), signOf(at.y), signOf(at.z)};
    const Lanes largest = larger(beyond.x, larger(beyond.y, beyond.z));
    const LaneBits isX = beyond.x == largest;
    const LaneBits isY = ~isX & (beyond.y == largest);
    const PointVectors outside{larger(beyond.x, all(0)), larger(beyond.y, all(0)), larger(beyond.z, all(0))};
    const Lanes away = squareRoot(dotOf(outside, outside));
    const LaneBits isOut = largest > all(0);
    const Lanes inverse = 1 / notZero(away);
    const auto along = [&](const LaneBits& isAxis, const Lanes& out, const Lanes& way) __attribute__((always_inline))
    {
        return choose(isOut, out * inverse, masked(all(1), isAxis)) * way;
    };
    return {choose(isOut, away, largest),
            {along(isX, outside.x, sign.x), along(isY, outside.y, sign.y), along(~(isX | isY), outside.z, sign.z)}};
}

KNEAD_INLINE LaneSurfacePoint cylinderAt(const PlacedForm& form, const PointVectors& at)
{
    const Lanes length = squareRoot(at.x * at.x + at.y * at.y);
    const LaneBits isOff = length > all(0);
    const Lanes inverse = 1 / notZero(length);
    const Lanes nx = choose(isOff, at.x * inverse, all(1));
    const Lanes ny = at.y * inverse;
    const Lanes across = length - form.half[0];
    const Lanes beyond = absolute(at.z) - form.half[2];
    const Lanes sideways = larger(across, all(0));
    const Lanes along = larger(beyond, all(0));
    const Lanes away = squareRoot(sideways * sideways + along * along);
    const LaneBits isOut = away > all(0);
    const LaneBits isSide = across >= beyond;
    const Lanes share = 1 / notZero(away);
    const Lanes side = choose(isOut, sideways * share, masked(all(1), isSide));
    const Lanes end = choose(isOut, along * share, masked(all(1), ~isSide));
    return {choose(isOut, away, larger(across, beyond)), {side * nx, side * ny, end * signOf(at.z)}};
}

template <typename At>
KNEAD_INLINE void nearestOf(const PlacedForm& form, std::size_t count, const double* const (&place)[3],
                            double* distance, double* const (&normal)[3], const At& at)
{
    const PointVectors center = allOf(form.center);
    for (std::size_t i = 0; i < count; i += lanes) {
        const LaneSurfacePoint nearest = at(form, toLocal(form.rotation, load(place, i) - center));
        store(distance + i, nearest.distance);
        store(normal, i, toWorld(form.rotation, nearest.normal));
    }
}

void nearestOfForm(const PlacedForm& form, std::size_t count, const double* const (&place)[3], double* distance,
                   double* const (&normal)[3])
{
    if (form.form == SurfaceForm::ball)
        nearestOf(form, count, place, distance, normal, ballAt);
    else if (form.form == SurfaceForm::box)
        nearestOf(form, count, place, distance, normal, boxAt);
    else if (form.form == SurfaceForm::cylinder)
        nearestOf(form, count, place, distance, normal, cylinderAt);
    else
        for (std::size_t i = 0; i < count; i += lanes) {
            store(distance + i, load(place[2] + i) - form.center[2]);
            store(normal, i, PointVectors{all(0), all(0), all(1)});
        }
}

/// Calls with the number of objects that carry the points of a group: the usual ones are known to the compiler.
template <typename With>
KNEAD_INLINE void withCount(const PointGroup& group, const With& with)
{
    if (group.count == 4)
        with(4);
    else if (group.count == 8)
        with(8);
    else if (group.count == 1)
        with(1);
    else
        with(group.count);
}

/// Places and velocities of eight points, one after the other, as columns of them.
KNEAD_INLINE void storeColumns(const double* rows, double* const (&columns)[6], std::size_t first)
{
    Lanes block[lanes];
#pragma GCC unroll 8
    for (std::size_t lane = 0; lane < lanes; ++lane)
        block[lane] = load(rows + lane * motionSize);
    transpose(block);
#pragma GCC unroll 6
    for (std::size_t c = 0; c < 6; ++c)
        store(columns[c] + first, block[c]);
}

/// Groups number their points from 0 on, one group after the other; columns are written up to a whole vector behind the last.
void gatherPoints(const CarriedPoints& points, const double* motions, double* const (&columns)[6])
{
    double rows[lanes * motionSize]{};
    std::size_t end = 0;
    for (std::size_t g = 0; g < points.groupCount; ++g) {
        const PointGroup& group = points.groups[g];
        withCount(
            group, [&](std::size_t count) __attribute__((always_inline)) {
                const double* weights = points.weights + group.weights;
                for (std::size_t p = group.begin; p < group.end; ++p, weights += count) {
                    Lanes sum{};
#pragma GCC unroll 8
                    for (std::size_t n = 0; n < count; ++n)
                        sum += all(weights[n]) * load(motions + group.objects[n] * motionSize);
                    store(rows + p % lanes * motionSize, sum);
                    if (p % lanes == lanes - 1)
                        storeColumns(rows, columns, p + 1 - lanes);
                }
            });
        end = group.end;
    }
    if (end % lanes != 0)
        storeColumns(rows, columns, end / lanes * lanes);
}

void scatterEffects(const CarriedPoints& points, const double* overlap, const double* effects, double* objects)
{
    // All bits but the signs of the weights that `addedSlope` and `isTouched` are shared out with.
    constexpr std::uint64_t every = ~std::uint64_t{0};
    const auto isBySize = [](std::size_t effect) { return effect == addedSlope || effect == isTouched; };
    double bits[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane)
        bits[lane] = __builtin_bit_cast(double, isBySize(lane + lanes) ? every >> 1U : every);
    const LaneBits keptBits = reinterpreted<std::int64_t>(load(bits));
    for (std::size_t g = 0; g < points.groupCount; ++g) {
        const PointGroup& group = points.groups[g];
        bool touches = false;
        for (std::size_t p = group.begin; p < group.end; ++p)
            touches = touches || overlap[p] > 0;
        if (!touches)
            continue;
        withCount(
            group, [&](std::size_t count) __attribute__((always_inline)) {
                Lanes first[PointGroup::most]{};
                Lanes second[PointGroup::most]{};
                const double* weights = points.weights + group.weights;
                for (std::size_t p = group.begin; p < group.end; ++p, weights += count) {
                    if (!(overlap[p] > 0))
                        continue;
                    const Lanes low = load(effects + p * effectSize);
                    const Lanes high = load(effects + p * effectSize + lanes);
#pragma GCC unroll 8
                    for (std::size_t n = 0; n < count; ++n) {
                        const Lanes weight = all(weights[n]);
                        first[n] += weight * low;
                        second[n] += masked(weight, keptBits) * high;
                    }
                }
#pragma GCC unroll 8
                for (std::size_t n = 0; n < count; ++n) {
                    double* const to = objects + group.objects[n] * effectSize;
                    store(to, load(to) + first[n]);
                    store(to + lanes, load(to + lanes) + second[n]);
                }
            });
    }
}

struct LaneSpring {
    Lanes force, slope, energy;
};

/// contactSpring() of what overlaps.
KNEAD_INLINE LaneSpring springAt(const ContactColumns& a, std::size_t i, const Lanes& overlap)
{
    const Lanes k = load(a.stiffness + i);
    const Lanes felt = smaller(overlap, load(a.largestOverlap + i));
    const Lanes d = smaller(felt, load(a.steepest + i));
    const Lanes share = d * load(a.inverseStiffening + i);
    const Lanes squared = share * share;
    const Lanes fourth = squared * squared;
    LaneSpring spring{k * d * (1 + fourth), k * (1 + 5 * fourth), 0.5 * k * d * d * (1 + fourth / 3)};
    const Lanes beyond = felt - d;
    spring.energy += beyond * (spring.force + 0.5 * spring.slope * beyond);
    spring.force += spring.slope * beyond;
    spring.energy += spring.force * (overlap - felt);
    spring.slope = masked(spring.slope, ~(overlap > felt));
    return spring;
}

/// For eight points of which some touch.
KNEAD_INLINE void lawAt(const ContactColumns& a, std::size_t i, const Lanes& overlap, const LaneBits& touches)
{
    const LaneSpring spring = springAt(a, i, overlap);
    const PointVectors n = load(a.normal, i);
    const PointVectors arm = load(a.place, i) - allOf(a.center);
    const PointVectors velocity =
        load(a.velocity, i) - (allOf(a.surfaceVelocity) + crossOf(allOf(a.angularVelocity), arm));
    const Lanes damping = load(a.damping + i);
    const Lanes mass = load(a.mass + i);
    const Lanes rate = all(1 / a.duration);
    const Lanes normalSpeed = dotOf(velocity, n);
    const Lanes turned = smaller(overlap, load(a.steepest + i)) * rate + larger(all(0), -normalSpeed);
    const Lanes most = mostTurned * rate * mass * turned;
    const Lanes pushed = larger(all(0), spring.force - damping * normalSpeed);
    const Lanes normalForce = choose((mass > all(0)) & (most < pushed), most, pushed);

    const PointVectors slide = velocity - normalSpeed * n;
    const Lanes sideways = a.duration * spring.force / notZero(overlap);
    const PointVectors before = toWorld(a.rotation, {load(a.hold[0] + i), load(a.hold[1] + i), load(a.hold[2] + i)});
    const PointVectors held = before - dotOf(before, n) * n + sideways * slide;
    const PointVectors sticking = held + damping * slide;
    const Lanes wanted = squareRoot(dotOf(sticking, sticking));
    const Lanes last = load(a.pressure + i);
    const Lanes pressure = normalForce + (last - normalForce) * load(a.kept + i);
    const Lanes limit = load(a.friction + i) * larger(all(0), pressure);
    const LaneBits slips = wanted > limit;
    const Lanes grip = choose(slips, limit / notZero(wanted), all(1)); // 1 sticks, less slips
    const PointVectors friction = -grip * sticking;

    store(a.pressure + i, choose(touches, pressure, last * load(a.keptApart + i)));
    store(a.hold, i, masked(toLocal(a.rotation, grip * held), touches));
    Lanes low[lanes]{};  // effects by columns, and in the end by points
    Lanes high[lanes]{}; // the same, behind the first eight
    const auto put = [&](std::size_t effect, const Lanes& values) __attribute__((always_inline))
    {
        (effect < lanes ? low[effect] : high[effect - lanes]) = masked(values, touches);
    };
    const auto putVectors = [&](std::size_t effect, const PointVectors& values) __attribute__((always_inline))
    {
        put(effect, values.x);
        put(effect + 1, values.y);
        put(effect + 2, values.z);
    };
    putVectors(springForce, spring.force * n);
    putVectors(dampingForce, (normalForce - spring.force) * n + friction);
    putVectors(frictionForce, friction);
    put(addedSlope, spring.slope * load(a.weightSum + i));
    put(storedEnergy, spring.energy);
    put(isTouched, all(1));
    transpose(low);
    transpose(high);
#pragma GCC unroll 8
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        store(a.effects + (i + lane) * effectSize, low[lane]);
        store(a.effects + (i + lane) * effectSize + lanes, high[lane]);
    }
}

ContactTotals contactLaw(const ContactColumns& columns)
{
    const ContactColumns a = columns; // which nothing that is stored changes
    Lanes steepness = all(0);
    Lanes touching = all(0);
    for (std::size_t i = 0; i < a.count; i += lanes) {
        const Lanes overlap = load(a.overlap + i);
        const LaneBits touches = overlap > all(0);
        if (!any(touches)) {
            store(a.pressure + i, load(a.pressure + i) * load(a.keptApart + i));
            store(a.hold, i, PointVectors{all(0), all(0), all(0)});
            continue;
        }
        lawAt(a, i, overlap, touches);
        touching += masked(all(1), touches);
        const Lanes share = smaller(overlap, load(a.steepest + i)) * load(a.inverseStiffening + i);
        steepness = larger(steepness, masked(share, touches));
    }
    double most[lanes];
    double counts[lanes];
    store(most, steepness);
    store(counts, touching);
    ContactTotals totals{0, 0};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        totals.touching += static_cast<std::size_t>(counts[lane]);
        totals.steepness = most[lane] > totals.steepness ? most[lane] : totals.steepness;
    }
    return totals;
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
