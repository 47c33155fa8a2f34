// The kernels of tangent_kernels.h, compiled once per instruction set in the way of lattice_kernels_impl.h.
#pragma once

#include "core/mechanics/slot_kernels_impl.h"
#include "core/mechanics/tangent_kernels.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

// Keeps 1/|d| finite when two objects coincide.
constexpr double leastLengthSquared = 1e-280;

void connectionTangent(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                       const double* stiffness, const double* nominalLength, const double* dampingTime, double step,
                       float* const (&root)[3], float* across)
{
    const double *x0 = self.x, *y0 = self.y, *z0 = self.z;
    const double *x1 = neighbor.x, *y1 = neighbor.y, *z1 = neighbor.z;
    const double *k = stiffness, *l = nominalLength, *time = dampingTime;
    float *rx = root[0], *ry = root[1], *rz = root[2], *side = across;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x1[i] - x0[i], dy = y1[i] - y0[i], dz = z1[i] - z0[i];
        const double inverse = 1 / __builtin_sqrt(dx * dx + dy * dy + dz * dz + leastLengthSquared);
        const double sideways = 1 - l[i] * inverse;
        const double least = step * step * k[i] * (sideways > 0 ? sideways : 0);
        const double scale = __builtin_sqrt(step * k[i] * (step + time[i]) - least) * inverse;
        side[i] = static_cast<float>(least);
        rx[i] = static_cast<float>(scale * dx);
        ry[i] = static_cast<float>(scale * dy);
        rz[i] = static_cast<float>(scale * dz);
    }
}

void dilatationGradient(std::size_t count, const GradientArguments& arguments)
{
    const double *m00 = arguments.shape[0], *m10 = arguments.shape[1], *m20 = arguments.shape[2];
    const double *m01 = arguments.shape[3], *m11 = arguments.shape[4], *m21 = arguments.shape[5];
    const double *m02 = arguments.shape[6], *m12 = arguments.shape[7], *m22 = arguments.shape[8];
    const double *kuu = arguments.inverseShape[0], *kvv = arguments.inverseShape[1];
    const double *kww = arguments.inverseShape[2], *kuv = arguments.inverseShape[3];
    const double *kuw = arguments.inverseShape[4], *kvw = arguments.inverseShape[5];
    const double* bulk = arguments.bulk;
    float *g00 = arguments.gradient[0], *g10 = arguments.gradient[1], *g20 = arguments.gradient[2];
    float *g01 = arguments.gradient[3], *g11 = arguments.gradient[4], *g21 = arguments.gradient[5];
    float *g02 = arguments.gradient[6], *g12 = arguments.gradient[7], *g22 = arguments.gradient[8];
    const double inverseSpacing = 1 / arguments.spacing;
    const double step = arguments.step;
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
        const double c00 = f11 * f22 - f12 * f21, c01 = f12 * f20 - f10 * f22, c02 = f10 * f21 - f11 * f20;
        const double c10 = f21 * f02 - f22 * f01, c11 = f22 * f00 - f20 * f02, c12 = f20 * f01 - f21 * f00;
        const double c20 = f01 * f12 - f02 * f11, c21 = f02 * f10 - f00 * f12, c22 = f00 * f11 - f01 * f10;
        const double determinant = f00 * c00 + f01 * c01 + f02 * c02;
        const double ratio = determinant > smallestVolumeRatio ? determinant : smallestVolumeRatio;
        const double weight = step * __builtin_sqrt(bulk[i] > 0 ? bulk[i] : 0);
        const double p = weight * inverseSpacing / ratio;
        g00[i] = static_cast<float>(p * (c00 * kuu[i] + c01 * kuv[i] + c02 * kuw[i]));
        g10[i] = static_cast<float>(p * (c10 * kuu[i] + c11 * kuv[i] + c12 * kuw[i]));
        g20[i] = static_cast<float>(p * (c20 * kuu[i] + c21 * kuv[i] + c22 * kuw[i]));
        g01[i] = static_cast<float>(p * (c00 * kuv[i] + c01 * kvv[i] + c02 * kvw[i]));
        g11[i] = static_cast<float>(p * (c10 * kuv[i] + c11 * kvv[i] + c12 * kvw[i]));
        g21[i] = static_cast<float>(p * (c20 * kuv[i] + c21 * kvv[i] + c22 * kvw[i]));
        g02[i] = static_cast<float>(p * (c00 * kuw[i] + c01 * kvw[i] + c02 * kww[i]));
        g12[i] = static_cast<float>(p * (c10 * kuw[i] + c11 * kvw[i] + c12 * kww[i]));
        g22[i] = static_cast<float>(p * (c20 * kuw[i] + c21 * kvw[i] + c22 * kww[i]));
    }
}

void dot(std::size_t count, const double* a, const double* b, double* sums)
{
    const std::size_t whole = count - count % sumLanes;
    double lanes[sumLanes];
    for (std::size_t lane = 0; lane < sumLanes; ++lane)
        lanes[lane] = sums[lane];
    for (std::size_t first = 0; first < whole; first += sumLanes)
        for (std::size_t lane = 0; lane < sumLanes; ++lane)
            lanes[lane] += a[first + lane] * b[first + lane];
    for (std::size_t i = whole; i < count; ++i)
        lanes[i - whole] += a[i] * b[i];
    for (std::size_t lane = 0; lane < sumLanes; ++lane)
        sums[lane] = lanes[lane];
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

} // namespace

extern const TangentKernels tangentSet;
const TangentKernels tangentSet{addShape,       connectionTangent, dilatationGradient, dot,          slotPressures,
                                slotProduct,    slotDiagonal,      invertBlocks,       descend,      turn,
                                multiplyBlocks, floatDot,          restrictFours,      prolongFours, sweepAhead,
                                leftAfterSweep, sweepBack,         KNEAD_KERNEL_NAME};

} // namespace knead::kernels::KNEAD_KERNEL_SET
