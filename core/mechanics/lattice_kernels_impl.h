// The kernels of lattice_kernels.h, compiled once per instruction set: each of lattice_kernels_{baseline,avx2,avx512}.cpp
// defines KNEAD_KERNEL_SET to a namespace name and includes this file. It uses no function of the standard library, since an
// inline one compiled for a newer machine could be picked by the linker for everybody.
// Every loop says ivdep: outputs never overlap inputs, and there are too many arrays for the compiler to check that itself.
#pragma once

#include "core/mechanics/lattice_kernels.h"

#include <cstdint>

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

// Keeps 1/|d| finite when two objects coincide; the force is then 0 since d is.
constexpr double tinyLengthSquared = 1e-280;

/// Natural logarithm for positive normal numbers to about 2 ulp, from operations that vectorize and round alike everywhere
/// (the C library picks among several versions by machine). ln x = e ln 2 + 2 atanh((m - 1) / (m + 1)), m in [~0.7, ~1.4).
inline double naturalLogarithm(double x)
{
    // Unsigned shifts and the 2^52 trick, since AVX2 has neither a signed 64-bit shift nor a conversion from 64-bit integers.
    constexpr auto rootHalf = __builtin_bit_cast(std::uint64_t, 0.70710678118654752);
    constexpr std::uint64_t bias = 1023;
    constexpr double twoTo52 = 4503599627370496.0;
    const auto bits = __builtin_bit_cast(std::uint64_t, x);
    const std::uint64_t biased = (bits - rootHalf + (bias << 52)) >> 52;
    const auto mantissa = __builtin_bit_cast(double, bits - (biased << 52) + (bias << 52));
    const double exponent =
        __builtin_bit_cast(double, biased | __builtin_bit_cast(std::uint64_t, twoTo52)) - (twoTo52 + 1023);
    const double t = (mantissa - 1) / (mantissa + 1);
    const double s = t * t;
    double series = 1.0 / 21;
    for (int n = 19; n >= 1; n -= 2)
        series = series * s + 1.0 / n;
    return exponent * 0.69314718055994531 + 2 * t * series;
}

void connectionForces(std::size_t count, const End& self, const End& neighbor, const double* stiffness,
                      const double* nominalLength, const double* dampingTime, const Vectors& force,
                      const Vectors& damping)
{
    const double *x0 = self.position.x, *y0 = self.position.y, *z0 = self.position.z;
    const double *u0 = self.velocity.x, *v0 = self.velocity.y, *w0 = self.velocity.z;
    const double *x1 = neighbor.position.x, *y1 = neighbor.position.y, *z1 = neighbor.position.z;
    const double *u1 = neighbor.velocity.x, *v1 = neighbor.velocity.y, *w1 = neighbor.velocity.z;
    double *fx = force.x, *fy = force.y, *fz = force.z;
    double *bx = damping.x, *by = damping.y, *bz = damping.z;
    const double *k = stiffness, *l = nominalLength, *time = dampingTime;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x1[i] - x0[i], dy = y1[i] - y0[i], dz = z1[i] - z0[i];
        const double squared = dx * dx + dy * dy + dz * dz + tinyLengthSquared;
        const double inverse = 1 / __builtin_sqrt(squared);
        const double rate = ((u1[i] - u0[i]) * dx + (v1[i] - v0[i]) * dy + (w1[i] - w0[i]) * dz) * inverse;
        const double scaled = k[i] * inverse;
        const double pull = scaled * (squared * inverse - l[i]);
        const double brake = scaled * time[i] * rate;
        fx[i] = pull * dx;
        fy[i] = pull * dy;
        fz[i] = pull * dz;
        bx[i] = brake * dx;
        by[i] = brake * dy;
        bz[i] = brake * dz;
    }
}

void addScaled(std::size_t count, double sign, const ConstVectors& from, const Vectors& target)
{
    const double *x = from.x, *y = from.y, *z = from.z;
    double *tx = target.x, *ty = target.y, *tz = target.z;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        tx[i] += sign * x[i];
        ty[i] += sign * y[i];
        tz[i] += sign * z[i];
    }
}

void addShape(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor, const double* stiffness,
              double sign, const Vectors& column)
{
    const double *x0 = self.x, *y0 = self.y, *z0 = self.z;
    const double *x1 = neighbor.x, *y1 = neighbor.y, *z1 = neighbor.z;
    const double* k = stiffness;
    double *mx = column.x, *my = column.y, *mz = column.z;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double scaled = sign * k[i];
        mx[i] += scaled * (x1[i] - x0[i]);
        my[i] += scaled * (y1[i] - y0[i]);
        mz[i] += scaled * (z1[i] - z0[i]);
    }
}

void volumetricStress(std::size_t count, const StressArguments& arguments)
{
    // Columns of M = sum k d o^T (three world components each), then of F = M K^-1 / a.
    const double *m00 = arguments.shape[0], *m10 = arguments.shape[1], *m20 = arguments.shape[2];
    const double *m01 = arguments.shape[3], *m11 = arguments.shape[4], *m21 = arguments.shape[5];
    const double *m02 = arguments.shape[6], *m12 = arguments.shape[7], *m22 = arguments.shape[8];
    const double *kuu = arguments.inverseShape[0], *kvv = arguments.inverseShape[1];
    const double *kww = arguments.inverseShape[2], *kuv = arguments.inverseShape[3];
    const double *kuw = arguments.inverseShape[4], *kvw = arguments.inverseShape[5];
    const double *bulk = arguments.bulk, *rest = arguments.restDilatation;
    double *s00 = arguments.stress[0], *s10 = arguments.stress[1], *s20 = arguments.stress[2];
    double *s01 = arguments.stress[3], *s11 = arguments.stress[4], *s21 = arguments.stress[5];
    double *s02 = arguments.stress[6], *s12 = arguments.stress[7], *s22 = arguments.stress[8];
    double* theta = arguments.theta;
    const double inverseSpacing = 1 / arguments.spacing;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double f00 = (m00[i] * kuu[i] + m01[i] * kuv[i] + m02[i] * kuw[i]) * inverseSpacing;
        const double f10 = (m10[i] * kuu[i] + m11[i] * kuv[i] + m12[i] * kuw[i]) * inverseSpacing;
        const double f20 = (m20[i] * kuu[i] + m21[i] * kuv[i] + m22[i] * kuw[i]) * inverseSpacing;
        const double f01 = (m00[i] * kuv[i] + m01[i] * kvv[i] + m02[i] * kvw[i]) * inverseSpacing;
        const double f11 = (m10[i] * kuv[i] + m11[i] * kvv[i] + m12[i] * kvw[i]) * inverseSpacing;
        const double f21 = (m20[i] * kuv[i] + m21[i] * kvv[i] + m22[i] * kvw[i]) * inverseSpacing;
        const double f02 = (m00[i] * kuw[i] + m01[i] * kvw[i] + m02[i] * kww[i]) * inverseSpacing;
        const double f12 = (m10[i] * kuw[i] + m11[i] * kvw[i] + m12[i] * kww[i]) * inverseSpacing;
        const double f22 = (m20[i] * kuw[i] + m21[i] * kvw[i] + m22[i] * kww[i]) * inverseSpacing;
        // Cofactors: F^-T = cof F / det F.
        const double c00 = f11 * f22 - f12 * f21, c01 = f12 * f20 - f10 * f22, c02 = f10 * f21 - f11 * f20;
        const double c10 = f21 * f02 - f22 * f01, c11 = f22 * f00 - f20 * f02, c12 = f20 * f01 - f21 * f00;
        const double c20 = f01 * f12 - f02 * f11, c21 = f02 * f10 - f00 * f12, c22 = f00 * f11 - f01 * f10;
        const double determinant = f00 * c00 + f01 * c01 + f02 * c02;
        const double ratio = determinant > smallestVolumeRatio ? determinant : smallestVolumeRatio;
        const double below = determinant < smallestVolumeRatio ? determinant / smallestVolumeRatio - 1 : 0;
        const double dilatation = naturalLogarithm(ratio) + below - rest[i];
        theta[i] = dilatation;
        // See volumetricStrain(): g g' / ratio, g' = 1 / (1 - theta)^2 where g = theta / (1 - theta).
        const bool softens = bulk[i] < 0 && dilatation < 0;
        const double damped = softens ? 1 / (1 - dilatation) : 1;
        const double slope = softens && determinant < 0 ? 0 : damped * damped * damped;
        const double p = bulk[i] * dilatation * slope * inverseSpacing / ratio;
        s00[i] = p * (c00 * kuu[i] + c01 * kuv[i] + c02 * kuw[i]);
        s10[i] = p * (c10 * kuu[i] + c11 * kuv[i] + c12 * kuw[i]);
        s20[i] = p * (c20 * kuu[i] + c21 * kuv[i] + c22 * kuw[i]);
        s01[i] = p * (c00 * kuv[i] + c01 * kvv[i] + c02 * kvw[i]);
        s11[i] = p * (c10 * kuv[i] + c11 * kvv[i] + c12 * kvw[i]);
        s21[i] = p * (c20 * kuv[i] + c21 * kvv[i] + c22 * kvw[i]);
        s02[i] = p * (c00 * kuw[i] + c01 * kvw[i] + c02 * kww[i]);
        s12[i] = p * (c10 * kuw[i] + c11 * kvw[i] + c12 * kww[i]);
        s22[i] = p * (c20 * kuw[i] + c21 * kvw[i] + c22 * kww[i]);
    }
}

void addVolumetricForces(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                         const double* stiffness, double sign, const Vectors& force)
{
    const double *x0 = self.x, *y0 = self.y, *z0 = self.z;
    const double *x1 = neighbor.x, *y1 = neighbor.y, *z1 = neighbor.z;
    const double* k = stiffness;
    double *fx = force.x, *fy = force.y, *fz = force.z;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double scaled = sign * k[i];
        fx[i] += scaled * (x0[i] + x1[i]);
        fy[i] += scaled * (y0[i] + y1[i]);
        fz[i] += scaled * (z0[i] + z1[i]);
    }
}

void flow(std::size_t count, const FlowArguments& arguments)
{
    const double *x0 = arguments.self.x, *y0 = arguments.self.y, *z0 = arguments.self.z;
    const double *x1 = arguments.neighbor.x, *y1 = arguments.neighbor.y, *z1 = arguments.neighbor.z;
    const double *t0 = arguments.selfDilatation, *t1 = arguments.neighborDilatation;
    const double *k = arguments.stiffness, *yield = arguments.yieldStrain, *hardening = arguments.hardening;
    const double* share = arguments.share;
    double *l = arguments.nominalLength, *plastic = arguments.plasticStrain;
    double* dissipated = arguments.dissipated;
    const auto one = [&](std::size_t i, double& sum) {
        const double dx = x1[i] - x0[i], dy = y1[i] - y0[i], dz = z1[i] - z0[i];
        const double length = __builtin_sqrt(dx * dx + dy * dy + dz * dz + tinyLengthSquared);
        const double strain = naturalLogarithm(length / l[i]) - (t0[i] + t1[i]) * (1.0 / 6);
        const double size = strain < 0 ? -strain : strain;
        const double beyond = size - (yield[i] + hardening[i] * plastic[i]);
        const double least = t0[i] < t1[i] ? t0[i] : t1[i];
        const double amount = beyond > 0 && least > leastFlowingDilatation && k[i] > 0 ? beyond * share[i] : 0;
        const double before = length - l[i];
        // exp(strain) to first order, in the form that stays positive.
        const double nominal = strain > 0 ? l[i] * (1 + amount) : l[i] / (1 + amount);
        const double after = length - nominal;
        l[i] = nominal;
        plastic[i] += amount;
        sum += 0.5 * k[i] * (before * before - after * after);
    };
    const std::size_t whole = count - count % sumLanes;
    for (std::size_t first = 0; first < whole; first += sumLanes) {
#pragma GCC ivdep
        for (std::size_t lane = 0; lane < sumLanes; ++lane)
            one(first + lane, dissipated[lane]);
    }
    for (std::size_t i = whole; i < count; ++i)
        one(i, dissipated[i - whole]);
}

void excessStrain(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                  const double* nominalLength, const double* limit, double* excess)
{
    const double *x0 = self.x, *y0 = self.y, *z0 = self.z;
    const double *x1 = neighbor.x, *y1 = neighbor.y, *z1 = neighbor.z;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x1[i] - x0[i], dy = y1[i] - y0[i], dz = z1[i] - z0[i];
        const double length = __builtin_sqrt(dx * dx + dy * dy + dz * dz);
        excess[i] = length / nominalLength[i] - 1 - limit[i];
    }
}

void advance(std::size_t count, double dt, double gravity, const double* mass, const double* inverseMass,
             const double* force, const double* damping, double* velocity, double* position, double* work)
{
    const double half = 0.5 * dt;
    const auto move = [&](std::size_t i, double& sum) {
        const double before = velocity[i];
        const double after = before + dt * inverseMass[i] * (force[i] + damping[i] + mass[i] * gravity);
        velocity[i] = after;
        position[i] += dt * after;
        sum += damping[i] * half * (before + after);
    };
    const std::size_t whole = count - count % sumLanes;
    for (std::size_t first = 0; first < whole; first += sumLanes) {
#pragma GCC ivdep
        for (std::size_t lane = 0; lane < sumLanes; ++lane)
            move(first + lane, work[lane]);
    }
    for (std::size_t i = whole; i < count; ++i)
        move(i, work[i - whole]);
}

} // namespace

extern const Kernels set;
const Kernels set{connectionForces, addScaled, addShape,         volumetricStress, addVolumetricForces, flow,
                  excessStrain,     advance,   KNEAD_KERNEL_NAME};

} // namespace knead::kernels::KNEAD_KERNEL_SET
