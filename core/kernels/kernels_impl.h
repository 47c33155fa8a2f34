// All kernels of kernels.h, compiled once per instruction set: each of kernels_{baseline,avx2,avx512}.cpp defines
// KNEAD_KERNEL_SET to a namespace name and includes this file. What it includes uses no function of the standard
// library, since an inline one compiled for a newer machine could be picked by the linker for everybody; functions of
// other headers are always inlined. Plain loops say ivdep: outputs never overlap inputs, and there are too many
// arrays for the compiler to check that itself.
#pragma once

#include "core/kernels/contact_kernels_impl.h"
#include "core/kernels/fit_kernels_impl.h"
#include "core/kernels/kernels.h"
#include "core/kernels/lattice_kernels_impl.h"
#include "core/kernels/sphere_kernels_impl.h"
#include "core/kernels/tangent_kernels_impl.h"

namespace knead::kernels::KNEAD_KERNEL_SET {

extern const Kernels set;
const Kernels set{{addForces, volumetricStress, tensorLaw, hyperelasticLaw, deformation, naturalStrain, lengthen,
                   anyLonger, excessStrain, advance},
                  {addShape, connectionTangent, dilatationGradient, dot, slotPressures, slotProduct, slotDiagonal,
                   invertBlocks, descend, turn, multiplyBlocks, floatDot, restrictFours, prolongFours, sweepAhead,
                   leftAfterSweep, sweepBack},
                  {sphere_kernels::KNEAD_KERNEL_SET::findPartners},
                  {lookAround, content, moments, functions},
                  {gatherPoints, nearestOfForm, contactLaw, scatterEffects},
                  KNEAD_KERNEL_NAME};

} // namespace knead::kernels::KNEAD_KERNEL_SET
