// The kernels of tangent_kernels.h, compiled once per instruction set in the way of lattice_kernels_impl.h.
#pragma once

#include "core/mechanics/tangent_kernels.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

// Keeps 1/|d| finite when two objects coincide.
constexpr double leastLengthSquared = 1e-280;

void connectionTangent(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                       const double* stiffness, const double* nominalLength, const double* dampingTime, double step,
                       const Vectors& root, double* across)
{
    const double *x0 = self.x, *y0 = self.y, *z0 = self.z;
    const double *x1 = neighbor.x, *y1 = neighbor.y, *z1 = neighbor.z;
    const double *k = stiffness, *l = nominalLength, *time = dampingTime;
    double *rx = root.x, *ry = root.y, *rz = root.z, *side = across;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x1[i] - x0[i], dy = y1[i] - y0[i], dz = z1[i] - z0[i];
        const double inverse = 1 / __builtin_sqrt(dx * dx + dy * dy + dz * dz + leastLengthSquared);
        const double sideways = 1 - l[i] * inverse;
        const double least = step * step * k[i] * (sideways > 0 ? sideways : 0);
        const double scale = __builtin_sqrt(step * k[i] * (step + time[i]) - least) * inverse;
        side[i] = least;
        rx[i] = scale * dx;
        ry[i] = scale * dy;
        rz[i] = scale * dz;
    }
}

void connectionPull(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor, const ConstVectors& root,
                    const double* across, const Vectors& pull)
{
    const double *x0 = self.x, *y0 = self.y, *z0 = self.z;
    const double *x1 = neighbor.x, *y1 = neighbor.y, *z1 = neighbor.z;
    const double *rx = root.x, *ry = root.y, *rz = root.z, *side = across;
    double *px = pull.x, *py = pull.y, *pz = pull.z;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x1[i] - x0[i], dy = y1[i] - y0[i], dz = z1[i] - z0[i];
        const double along = rx[i] * dx + ry[i] * dy + rz[i] * dz;
        px[i] = along * rx[i] + side[i] * dx;
        py[i] = along * ry[i] + side[i] * dy;
        pz[i] = along * rz[i] + side[i] * dz;
    }
}

void addConnectionBlocks(std::size_t count, const ConstVectors& root, const double* across, double* const* blocks)
{
    const double *rx = root.x, *ry = root.y, *rz = root.z, *side = across;
    double *xx = blocks[0], *yy = blocks[1], *zz = blocks[2];
    double *xy = blocks[3], *xz = blocks[4], *yz = blocks[5];
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        xx[i] += rx[i] * rx[i] + side[i];
        yy[i] += ry[i] * ry[i] + side[i];
        zz[i] += rz[i] * rz[i] + side[i];
        xy[i] += rx[i] * ry[i];
        xz[i] += rx[i] * rz[i];
        yz[i] += ry[i] * rz[i];
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
    double *g00 = arguments.gradient[0], *g10 = arguments.gradient[1], *g20 = arguments.gradient[2];
    double *g01 = arguments.gradient[3], *g11 = arguments.gradient[4], *g21 = arguments.gradient[5];
    double *g02 = arguments.gradient[6], *g12 = arguments.gradient[7], *g22 = arguments.gradient[8];
    double* weight = arguments.weight;
    const double inverseSpacing = 1 / arguments.spacing;
    const double squared = arguments.step * arguments.step;
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
        const double p = inverseSpacing / ratio;
        g00[i] = p * (c00 * kuu[i] + c01 * kuv[i] + c02 * kuw[i]);
        g10[i] = p * (c10 * kuu[i] + c11 * kuv[i] + c12 * kuw[i]);
        g20[i] = p * (c20 * kuu[i] + c21 * kuv[i] + c22 * kuw[i]);
        g01[i] = p * (c00 * kuv[i] + c01 * kvv[i] + c02 * kvw[i]);
        g11[i] = p * (c10 * kuv[i] + c11 * kvv[i] + c12 * kvw[i]);
        g21[i] = p * (c20 * kuv[i] + c21 * kvv[i] + c22 * kvw[i]);
        g02[i] = p * (c00 * kuw[i] + c01 * kvw[i] + c02 * kww[i]);
        g12[i] = p * (c10 * kuw[i] + c11 * kvw[i] + c12 * kww[i]);
        g22[i] = p * (c20 * kuw[i] + c21 * kvw[i] + c22 * kww[i]);
        weight[i] = bulk[i] > 0 ? squared * bulk[i] : 0;
    }
}

void combineColumns(std::size_t count, const double* const* gradient, const double* steps, const Vectors& combined)
{
    const double *g00 = gradient[0], *g10 = gradient[1], *g20 = gradient[2];
    const double *g01 = gradient[3], *g11 = gradient[4], *g21 = gradient[5];
    const double *g02 = gradient[6], *g12 = gradient[7], *g22 = gradient[8];
    const double u = steps[0], v = steps[1], w = steps[2];
    double *x = combined.x, *y = combined.y, *z = combined.z;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        x[i] = u * g00[i] + v * g01[i] + w * g02[i];
        y[i] = u * g10[i] + v * g11[i] + w * g12[i];
        z[i] = u * g20[i] + v * g21[i] + w * g22[i];
    }
}

void addDilatationRate(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor,
                       const double* stiffness, const ConstVectors& gradient, double* rate)
{
    const double *x0 = self.x, *y0 = self.y, *z0 = self.z;
    const double *x1 = neighbor.x, *y1 = neighbor.y, *z1 = neighbor.z;
    const double *gx = gradient.x, *gy = gradient.y, *gz = gradient.z;
    const double* k = stiffness;
    double* sum = rate;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i)
        sum[i] += k[i] * (gx[i] * (x1[i] - x0[i]) + gy[i] * (y1[i] - y0[i]) + gz[i] * (z1[i] - z0[i]));
}

void addPressurePull(std::size_t count, const double* stiffness, const double* const (&pressure)[2],
                     const ConstVectors (&gradient)[2], const Vectors& pull)
{
    const double *x0 = gradient[0].x, *y0 = gradient[0].y, *z0 = gradient[0].z;
    const double *x1 = gradient[1].x, *y1 = gradient[1].y, *z1 = gradient[1].z;
    const double *k = stiffness, *p0 = pressure[0], *p1 = pressure[1];
    double *px = pull.x, *py = pull.y, *pz = pull.z;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        px[i] += k[i] * (p0[i] * x0[i] + p1[i] * x1[i]);
        py[i] += k[i] * (p0[i] * y0[i] + p1[i] * y1[i]);
        pz[i] += k[i] * (p0[i] * z0[i] + p1[i] * z1[i]);
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

void descend(std::size_t count, double factor, const double* p, const double* q, double* x, double* r)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        x[i] += factor * p[i];
        r[i] -= factor * q[i];
    }
}

void turn(std::size_t count, double factor, const double* z, double* p)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i)
        p[i] = z[i] + factor * p[i];
}

void multiplyBlocks(std::size_t count, const double* const* blocks, const ConstVectors& r, const Vectors& z)
{
    const double *xx = blocks[0], *yy = blocks[1], *zz = blocks[2];
    const double *xy = blocks[3], *xz = blocks[4], *yz = blocks[5];
    const double *rx = r.x, *ry = r.y, *rz = r.z;
    double *x = z.x, *y = z.y, *w = z.z;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        x[i] = xx[i] * rx[i] + xy[i] * ry[i] + xz[i] * rz[i];
        y[i] = xy[i] * rx[i] + yy[i] * ry[i] + yz[i] * rz[i];
        w[i] = xz[i] * rx[i] + yz[i] * ry[i] + zz[i] * rz[i];
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

} // namespace

extern const TangentKernels tangentSet;
const TangentKernels tangentSet{addScaled,
                                addShape,
                                connectionTangent,
                                connectionPull,
                                addConnectionBlocks,
                                dilatationGradient,
                                combineColumns,
                                addDilatationRate,
                                addPressurePull,
                                dot,
                                descend,
                                turn,
                                multiplyBlocks,
                                KNEAD_KERNEL_NAME};

} // namespace knead::kernels::KNEAD_KERNEL_SET
