// The loops of the linear solver over slots; see kernels_impl.h for how they are compiled. Each object gathers what
// its neighbors give it, so that a thread writes to its own objects only, and every lane does the same whatever the
// width of the instructions.
#pragma once

#include "core/kernels/tangent_kernels.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

using Eight = float __attribute__((vector_size(32)));
using EightAnywhere __attribute__((vector_size(32), aligned(4), may_alias)) = float;
using Four = float __attribute__((vector_size(16)));
using FourAnywhere __attribute__((vector_size(16), aligned(4), may_alias)) = float;

[[gnu::always_inline]] inline Eight load8(const float* from)
{
    return *reinterpret_cast<const EightAnywhere*>(from);
}
[[gnu::always_inline]] inline void store8(float* to, Eight value)
{
    *reinterpret_cast<EightAnywhere*>(to) = value;
}
[[gnu::always_inline]] inline Four load4(const float* from)
{
    return *reinterpret_cast<const FourAnywhere*>(from);
}
[[gnu::always_inline]] inline void store4(float* to, Four value)
{
    *reinterpret_cast<FourAnywhere*>(to) = value;
}

[[gnu::always_inline]] inline double sumOf(Eight v)
{
    double sum = 0;
    for (int lane = 0; lane < 8; ++lane)
        sum += static_cast<double>(v[lane]);
    return sum;
}
[[gnu::always_inline]] inline double sumOf(Four v)
{
    return (static_cast<double>(v[0]) + static_cast<double>(v[1])) +
           (static_cast<double>(v[2]) + static_cast<double>(v[3]));
}

struct Three {
    Eight x, y, z;
};
[[gnu::always_inline]] inline Three load8(const float* from, std::ptrdiff_t stride)
{
    return {load8(from), load8(from + stride), load8(from + 2 * stride)};
}
[[gnu::always_inline]] inline Three operator-(const Three& a, const Three& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[gnu::always_inline]] inline Three operator+(const Three& a, const Three& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[gnu::always_inline]] inline Three operator*(Eight factor, const Three& a)
{
    return {factor * a.x, factor * a.y, factor * a.z};
}

/// Slot of the eight neighbors ahead in direction d, or behind.
template <int d, int sign>
[[gnu::always_inline]] inline std::ptrdiff_t besideOf(const SlotBlock& block)
{
    constexpr auto step = latticeDirections[d];
    constexpr int row = 3 * (sign * step[0] + 1) + sign * step[1] + 1;
    return static_cast<std::ptrdiff_t>(block.first) + block.offset[row] + sign * step[2];
}

/// Adds a * step, whose components are -1, 0 or 1.
template <int component>
[[gnu::always_inline]] inline void addSigned(Three& sum, const Three& a)
{
    if constexpr (component > 0)
        sum = sum + a;
    if constexpr (component < 0)
        sum = sum - a;
}

/// Columns of what every object makes of the differences to its neighbors, sum k (u_j - u_i) o^T.
template <int d>
[[gnu::always_inline]] inline void addColumns(const SlotBlock& block, const SlotTangent& t, const float* u,
                                              const Three& own, Three (&columns)[3])
{
    constexpr auto step = latticeDirections[d];
    if (t.stiffness[d] == nullptr)
        return;
    const auto add = [&](const Three& weighed) {
        addSigned<step[0]>(columns[0], weighed);
        addSigned<step[1]>(columns[1], weighed);
        addSigned<step[2]>(columns[2], weighed);
    };
    const std::ptrdiff_t ahead = besideOf<d, 1>(block);
    const std::ptrdiff_t behind = besideOf<d, -1>(block);
    add(load8(t.stiffness[d] + block.first) * (load8(u + ahead, t.vectorStride) - own));
    add(load8(t.stiffness[d] + behind) * (own - load8(u + behind, t.vectorStride)));
    if constexpr (d + 1 < latticeDirectionCount)
        addColumns<d + 1>(block, t, u, own, columns);
}

void slotPressures(std::size_t count, const SlotBlock* blocks, const SlotTangent& t, const float* u)
{
    for (std::size_t b = 0; b < count; ++b) {
        const SlotBlock& block = blocks[b];
        Three columns[3]{};
        addColumns<0>(block, t, u, load8(u + block.first, t.vectorStride), columns);
        const float* gradient = t.gradient + block.first;
        float* pressure = t.pressure + block.first;
        Eight rate{};
        for (int c = 0; c < 3; ++c) {
            const Three g = load8(gradient + 3 * c * t.stride, t.stride);
            rate += g.x * columns[c].x + g.y * columns[c].y + g.z * columns[c].z;
        }
        for (int c = 0; c < 9; ++c)
            store8(pressure + c * t.stride, rate * load8(gradient + c * t.stride));
    }
}

/// What connections in direction d, ahead and behind, make of the difference to each neighbor.
template <int d>
[[gnu::always_inline]] inline void addPulls(const SlotBlock& block, const SlotTangent& t, const float* u,
                                            const Three& own, Three& sum)
{
    if (t.root[d] == nullptr)
        return;
    const auto add = [&](std::ptrdiff_t lower, std::ptrdiff_t neighbor) {
        const Three between = own - load8(u + neighbor, t.vectorStride);
        const Three root = load8(t.root[d] + lower, t.stride);
        const Eight along = root.x * between.x + root.y * between.y + root.z * between.z;
        sum = sum + (along * root + load8(t.across[d] + lower) * between);
    };
    const std::ptrdiff_t behind = besideOf<d, -1>(block);
    add(block.first, besideOf<d, 1>(block));
    add(behind, behind);
    if constexpr (d + 1 < latticeDirectionCount)
        addPulls<d + 1>(block, t, u, own, sum);
}

/// Pressures of both ends along a direction, times its stiffness.
template <int d>
[[gnu::always_inline]] inline void addPressurePulls(const SlotBlock& block, const SlotTangent& t, Three& sum)
{
    constexpr auto step = latticeDirections[d];
    if (t.stiffness[d] == nullptr)
        return;
    const auto towards = [&](std::ptrdiff_t slot, Three& pull) {
        const float* pressure = t.pressure + slot;
        if constexpr (step[0] != 0)
            addSigned<step[0]>(pull, load8(pressure, t.stride));
        if constexpr (step[1] != 0)
            addSigned<step[1]>(pull, load8(pressure + 3 * t.stride, t.stride));
        if constexpr (step[2] != 0)
            addSigned<step[2]>(pull, load8(pressure + 6 * t.stride, t.stride));
    };
    const std::ptrdiff_t behind = besideOf<d, -1>(block);
    Three own{};
    towards(block.first, own);
    Three ahead = own;
    towards(besideOf<d, 1>(block), ahead);
    towards(behind, own);
    sum = sum + (load8(t.stiffness[d] + behind) * own - load8(t.stiffness[d] + block.first) * ahead);
    if constexpr (d + 1 < latticeDirectionCount)
        addPressurePulls<d + 1>(block, t, sum);
}

double slotProduct(std::size_t count, const SlotBlock* blocks, const SlotTangent& t, const float* u, float* product)
{
    Eight sums{};
    for (std::size_t b = 0; b < count; ++b) {
        const SlotBlock& block = blocks[b];
        const Three own = load8(u + block.first, t.vectorStride);
        Three sum{};
        addPulls<0>(block, t, u, own, sum);
        if (t.gradient != nullptr)
            addPressurePulls<0>(block, t, sum);
        sum = sum + load8(t.mass + block.first) * own;
        store8(product + block.first, sum.x);
        store8(product + block.first + t.vectorStride, sum.y);
        store8(product + block.first + 2 * t.vectorStride, sum.z);
        sums += own.x * sum.x + own.y * sum.y + own.z * sum.z;
    }
    return sumOf(sums);
}

using FourDouble = double __attribute__((vector_size(32)));
using FourDoubleAnywhere __attribute__((vector_size(32), aligned(8), may_alias)) = double;

[[gnu::always_inline]] inline FourDouble wide4(const float* from)
{
    return __builtin_convertvector(load4(from), FourDouble);
}

/// Blocks of four objects, in double, since those of few connections are nearly singular.
struct FourBlocks {
    FourDouble xx, yy, zz, xy, xz, yz;
};
struct FourVectors {
    FourDouble x, y, z;
};
[[gnu::always_inline]] inline FourVectors wide4(const float* from, std::ptrdiff_t stride)
{
    return {wide4(from), wide4(from + stride), wide4(from + 2 * stride)};
}
[[gnu::always_inline]] inline void addDyads(const FourVectors& v, FourBlocks& blocks)
{
    blocks.xx += v.x * v.x;
    blocks.yy += v.y * v.y;
    blocks.zz += v.z * v.z;
    blocks.xy += v.x * v.y;
    blocks.xz += v.x * v.z;
    blocks.yz += v.y * v.z;
}

/// The four gradients from `slot` on times a vector each.
[[gnu::always_inline]] inline FourVectors gradientsTimes(const SlotTangent& t, std::ptrdiff_t slot,
                                                         const FourVectors& v)
{
    const float* g = t.gradient + slot;
    const FourVectors a = wide4(g, t.stride);
    const FourVectors b = wide4(g + 3 * t.stride, t.stride);
    const FourVectors c = wide4(g + 6 * t.stride, t.stride);
    return {v.x * a.x + v.y * b.x + v.z * c.x, v.x * a.y + v.y * b.y + v.z * c.y, v.x * a.z + v.y * b.z + v.z * c.z};
}

/// What one connection of four objects adds to their blocks, and to sum k o. `half` of the block: 0 or 4.
template <int d, int sign>
[[gnu::always_inline]] inline void addBlocks(const SlotBlock& block, int half, const SlotTangent& t,
                                             FourVectors& balance, FourBlocks& blocks)
{
    constexpr auto step = latticeDirections[d];
    const std::ptrdiff_t neighbor = besideOf<d, sign>(block) + half;
    const std::ptrdiff_t lower = sign > 0 ? static_cast<std::ptrdiff_t>(block.first) + half : neighbor;
    addDyads(wide4(t.root[d] + lower, t.stride), blocks);
    const FourDouble across = wide4(t.across[d] + lower);
    blocks.xx += across;
    blocks.yy += across;
    blocks.zz += across;
    if (t.gradient == nullptr)
        return;
    const FourDouble k = wide4(t.stiffness[d] + lower);
    const FourVectors way{sign * step[0] * k, sign * step[1] * k, sign * step[2] * k};
    balance.x += way.x;
    balance.y += way.y;
    balance.z += way.z;
    addDyads(gradientsTimes(t, neighbor, way), blocks);
}

template <int d>
[[gnu::always_inline]] inline void addAllBlocks(const SlotBlock& block, int half, const SlotTangent& t,
                                                FourVectors& balance, FourBlocks& blocks)
{
    if (t.root[d] == nullptr)
        return;
    addBlocks<d, 1>(block, half, t, balance, blocks);
    addBlocks<d, -1>(block, half, t, balance, blocks);
    if constexpr (d + 1 < latticeDirectionCount)
        addAllBlocks<d + 1>(block, half, t, balance, blocks);
}

void slotDiagonal(std::size_t count, const SlotBlock* blocks, const SlotTangent& t, double* const* diagonal)
{
    for (std::size_t b = 0; b < count; ++b)
        for (int half = 0; half < 8; half += 4) {
            const auto self = static_cast<std::ptrdiff_t>(blocks[b].first) + half;
            const FourDouble mass = wide4(t.mass + self);
            FourBlocks sum{mass, mass, mass, {}, {}, {}};
            FourVectors balance{};
            addAllBlocks<0>(blocks[b], half, t, balance, sum);
            if (t.gradient != nullptr)
                addDyads(gradientsTimes(t, self, balance), sum);
            const FourDouble entries[] = {sum.xx, sum.yy, sum.zz, sum.xy, sum.xz, sum.yz};
            for (int c = 0; c < 6; ++c)
                *reinterpret_cast<FourDoubleAnywhere*>(diagonal[c] + self) = entries[c];
        }
}

void invertBlocks(std::size_t count, const double* const* blocks, float* const* inverse)
{
    const double *xx = blocks[0], *yy = blocks[1], *zz = blocks[2];
    const double *xy = blocks[3], *xz = blocks[4], *yz = blocks[5];
    float *axx = inverse[0], *ayy = inverse[1], *azz = inverse[2];
    float *axy = inverse[3], *axz = inverse[4], *ayz = inverse[5];
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const double cxx = yy[i] * zz[i] - yz[i] * yz[i];
        const double cxy = xz[i] * yz[i] - xy[i] * zz[i];
        const double cxz = xy[i] * yz[i] - xz[i] * yy[i];
        const double determinant = xx[i] * cxx + xy[i] * cxy + xz[i] * cxz;
        const double factor = determinant > 0 ? 1 / determinant : 0;
        axx[i] = static_cast<float>(factor * cxx);
        ayy[i] = static_cast<float>(factor * (xx[i] * zz[i] - xz[i] * xz[i]));
        azz[i] = static_cast<float>(factor * (xx[i] * yy[i] - xy[i] * xy[i]));
        axy[i] = static_cast<float>(factor * cxy);
        axz[i] = static_cast<float>(factor * cxz);
        ayz[i] = static_cast<float>(factor * (xy[i] * xz[i] - xx[i] * yz[i]));
    }
}

void descend(std::size_t count, float factor, const float* p, const float* q, float* x, float* r)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        x[i] += factor * p[i];
        r[i] -= factor * q[i];
    }
}

void turn(std::size_t count, float factor, const float* z, float* p)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i)
        p[i] = z[i] + factor * p[i];
}

void multiplyBlocks(std::size_t count, const float* const* blocks, const float* r, float* z, std::ptrdiff_t stride)
{
    const float *xx = blocks[0], *yy = blocks[1], *zz = blocks[2];
    const float *xy = blocks[3], *xz = blocks[4], *yz = blocks[5];
    const float *rx = r, *ry = r + stride, *rz = r + 2 * stride;
    float *x = z, *y = z + stride, *w = z + 2 * stride;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        x[i] = xx[i] * rx[i] + xy[i] * ry[i] + xz[i] * rz[i];
        y[i] = xy[i] * rx[i] + yy[i] * ry[i] + yz[i] * rz[i];
        w[i] = xz[i] * rx[i] + yz[i] * ry[i] + zz[i] * rz[i];
    }
}

/// @param count a multiple of eight
double floatDot(std::size_t count, const float* a, const float* b)
{
    Eight sums{};
    for (std::size_t i = 0; i < count; i += 8)
        sums += load8(a + i) * load8(b + i);
    return sumOf(sums);
}

void restrictFours(std::size_t count, const std::uint32_t* fours, const float* r, const float* arm,
                   std::ptrdiff_t stride, float* into)
{
    Four force[3]{};
    Four torque[3]{};
    for (std::size_t i = 0; i < count; ++i) {
        const Four rx = load4(r + fours[i]), ry = load4(r + fours[i] + stride), rz = load4(r + fours[i] + 2 * stride);
        const Four ax = load4(arm + fours[i]), ay = load4(arm + fours[i] + stride),
                   az = load4(arm + fours[i] + 2 * stride);
        force[0] += rx;
        force[1] += ry;
        force[2] += rz;
        torque[0] += ay * rz - az * ry;
        torque[1] += az * rx - ax * rz;
        torque[2] += ax * ry - ay * rx;
    }
    for (int c = 0; c < 3; ++c) {
        into[c] = static_cast<float>(sumOf(force[c]));
        into[3 + c] = static_cast<float>(sumOf(torque[c]));
    }
    into[6] = into[7] = 0;
}

void prolongFours(std::size_t count, const std::int32_t* motion, const float* motions, const float* arm, float* z,
                  std::ptrdiff_t stride)
{
    for (std::size_t i = 0; i < count; ++i) {
        if (motion[i] < 0)
            continue;
        const float* m = motions + 8 * static_cast<std::ptrdiff_t>(motion[i]);
        const auto at = static_cast<std::ptrdiff_t>(4 * i);
        const Four ax = load4(arm + at), ay = load4(arm + at + stride), az = load4(arm + at + 2 * stride);
        store4(z + at, load4(z + at) + (m[0] + (m[4] * az - m[5] * ay)));
        store4(z + at + stride, load4(z + at + stride) + (m[1] + (m[5] * ax - m[3] * az)));
        store4(z + at + 2 * stride, load4(z + at + 2 * stride) + (m[2] + (m[3] * ay - m[4] * ax)));
    }
}

/// Sum of blocks from..to of a row times x.
[[gnu::always_inline]] inline Eight productOf(const BlockRows& rows, std::size_t from, std::size_t to, const float* x)
{
    Eight sum{};
    for (std::size_t n = from; n < to; ++n) {
        const float* block = rows.blocks + 48 * n;
        const float* own = x + 8 * static_cast<std::size_t>(rows.columns[n]);
        for (int c = 0; c < 6; ++c)
            sum += own[c] * load8(block + 8 * c);
    }
    return sum;
}

[[gnu::always_inline]] inline void solveRow(const BlockRows& rows, std::size_t row, Eight load, float* x)
{
    const float* block = rows.inverse + 48 * row;
    Eight sum{};
    for (int c = 0; c < 6; ++c)
        sum += load[c] * load8(block + 8 * c);
    store8(x + 8 * row, sum);
}

void sweepAhead(const BlockRows& rows, const float* load, float* x)
{
    for (std::size_t row = 0; row < rows.rows; ++row)
        solveRow(rows, row, load8(load + 8 * row) - productOf(rows, rows.begin[row], rows.behind[row], x), x);
}

void leftAfterSweep(const BlockRows& rows, const float* x, float* left)
{
    for (std::size_t row = 0; row < rows.rows; ++row)
        store8(left + 8 * row, -productOf(rows, rows.behind[row], rows.begin[row + 1], x));
}

void sweepBack(const BlockRows& rows, const float* load, float* x)
{
    for (std::size_t row = rows.rows; row-- > 0;)
        solveRow(rows, row, load8(load + 8 * row) - productOf(rows, rows.begin[row], rows.begin[row + 1], x), x);
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
