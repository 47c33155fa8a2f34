#pragma once

#include "core/kernels/contact_kernels.h"
#include "core/kernels/fit_kernels.h"
#include "core/kernels/lattice_kernels.h"
#include "core/kernels/sphere_kernels.h"
#include "core/kernels/tangent_kernels.h"

#include <vector>

/// The innermost loops, compiled once per instruction set and picked at run time. What they compute does not depend
/// on the set: every lane does the same IEEE operations, and fused multiply-add is off.
namespace knead::kernels {

/// All kernels of one instruction set.
struct Kernels : LatticeKernels, TangentKernels, sphere_kernels::SphereKernels, FitKernels, ContactKernels {
    const char* name; ///< "x86-64", "AVX2", "AVX-512"
};

/// All sets that this machine can run, the plainest first.
const std::vector<Kernels>& available();

/// The widest available set.
const Kernels& best();

} // namespace knead::kernels
