// Loops over connections and objects of lattice_kernels.h; see kernels_impl.h for how they are compiled.
#pragma once

#include "core/kernels/hyperelastic_kernels_impl.h"
#include "core/kernels/lattice_force_kernels_impl.h"
#include "core/kernels/lattice_kernels.h"
#include "core/kernels/tensor_law_kernels_impl.h"

#include <cstdint>

namespace knead::kernels::KNEAD_KERNEL_SET {

namespace {

bool anyLonger(std::size_t count, const ConstVectors& self, const ConstVectors& neighbor, const double* stiffness,
               const double* nominalLength, double factor)
{
    const double *x0 = self.x, *y0 = self.y, *z0 = self.z;
    const double *x1 = neighbor.x, *y1 = neighbor.y, *z1 = neighbor.z;
    std::int64_t longer = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double dx = x1[i] - x0[i], dy = y1[i] - y0[i], dz = z1[i] - z0[i];
        const double most = factor * nominalLength[i];
        const bool isLonger = dx * dx + dy * dy + dz * dz > most * most;
        longer |= (isLonger ? 1 : 0) & (stiffness[i] > 0 ? 1 : 0);
    }
    return longer != 0;
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

AdvanceReport advance(const AdvanceArguments& a)
{
    const double dt = a.dt;
    Lanes work{};
    LaneBits largest{};
    for (std::size_t i = 0; i < a.count; i += lanes) {
        const Lanes weighed = load(a.weighedMass + i);
        const Lanes share = dt * load(a.inverseMass + i);
        Lanes squared{};
        for (int c = 0; c < 3; ++c) {
            const std::ptrdiff_t at = c * a.stride + static_cast<std::ptrdiff_t>(i);
            const Lanes damping = load(a.damping + at);
            const Lanes before = load(a.velocity + at);
            const Lanes after = before + share * (load(a.force + at) + damping + weighed * a.gravity[c]);
            store(a.velocity + at, after);
            store(a.position + at, load(a.position + at) + dt * after);
            work += damping * (before + after);
            squared += after * after;
        }
        // Bit patterns of numbers without a sign compare like the numbers, with infinities and what is no number on top.
        const LaneBits bits = reinterpreted<std::int64_t>(squared) & INT64_MAX;
        largest = choose(bits > largest, bits, largest);
    }
    AdvanceReport report{0, 0};
    std::int64_t top = 0;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        report.dampingWork += 0.5 * dt * work[lane];
        top = largest[lane] > top ? largest[lane] : top;
    }
    report.squaredSpeed = __builtin_bit_cast(double, top);
    return report;
}

} // namespace

} // namespace knead::kernels::KNEAD_KERNEL_SET
