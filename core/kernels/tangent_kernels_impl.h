// The kernels of tangent_kernels.h; see kernels_impl.h for how they are compiled.
#pragma once

#include "core/kernels/lattice_force_kernels_impl.h"
#include "core/kernels/slot_kernels_impl.h"
#include "core/kernels/tangent_kernels.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

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
        const double inverse = 1 / __builtin_sqrt(dx * dx + dy * dy + dz * dz + tinyLengthSquared);
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
        const double m[3][3] = {{m00[i], m10[i], m20[i]}, {m01[i], m11[i], m21[i]}, {m02[i], m12[i], m22[i]}};
        const double inverse[6] = {kuu[i], kvv[i], kww[i], kuv[i], kuw[i], kvw[i]};
        double f[3][3];
        findGradient(m, inverse, inverseSpacing, f);
        double cofactor[3][3];
        findCofactors(f, cofactor);
        const double determinant = f[0][0] * cofactor[0][0] + f[1][0] * cofactor[1][0] + f[2][0] * cofactor[2][0];
        const double weight = step * __builtin_sqrt(bulk[i] > 0 ? bulk[i] : 0);
        const double p = weight * inverseSpacing / boundedVolumeRatio(determinant);
        g00[i] = static_cast<float>(p * timesInverse(cofactor, inverse, 0, 0));
        g10[i] = static_cast<float>(p * timesInverse(cofactor, inverse, 0, 1));
        g20[i] = static_cast<float>(p * timesInverse(cofactor, inverse, 0, 2));
        g01[i] = static_cast<float>(p * timesInverse(cofactor, inverse, 1, 0));
        g11[i] = static_cast<float>(p * timesInverse(cofactor, inverse, 1, 1));
        g21[i] = static_cast<float>(p * timesInverse(cofactor, inverse, 1, 2));
        g02[i] = static_cast<float>(p * timesInverse(cofactor, inverse, 2, 0));
        g12[i] = static_cast<float>(p * timesInverse(cofactor, inverse, 2, 1));
        g22[i] = static_cast<float>(p * timesInverse(cofactor, inverse, 2, 2));
    }
}

void dot(std::size_t count, const double* a, const double* b, double* sums)
{
    const std::size_t whole = count - count % sumLanes;
    double partial[sumLanes];
    for (std::size_t lane = 0; lane < sumLanes; ++lane)
        partial[lane] = sums[lane];
    for (std::size_t first = 0; first < whole; first += sumLanes)
        for (std::size_t lane = 0; lane < sumLanes; ++lane)
            partial[lane] += a[first + lane] * b[first + lane];
    for (std::size_t i = whole; i < count; ++i)
        partial[i - whole] += a[i] * b[i];
    for (std::size_t lane = 0; lane < sumLanes; ++lane)
        sums[lane] = partial[lane];
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

} // namespace knead::kernels::KNEAD_KERNEL_SET
