#pragma once

#include "core/deformation/displacement_field.h"
#include "core/deformation/quadratic_patch.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// How strongly a fitted patch is held to what was known before, of the weight of all nodes: its constant, linear and quadratic
/// terms. What the nodes say nothing of, as across a plane in which they all lie, stays as it was.
using PatchHold = std::array<double, 3>;

/// A hold for each of the terms of a patch.
inline QuadraticPatch::Terms perTerm(const PatchHold& hold)
{
    QuadraticPatch::Terms all = QuadraticPatch::Terms::Constant(hold[2]);
    all[0] = hold[0];
    all.segment<3>(1).setConstant(hold[1]);
    return all;
}

/// What a fit came to.
struct PatchFit {
    QuadraticPatch patch;
    std::vector<float> errors; ///< per node: by how much a fit without it would be off [m]
    double expectedError =
        0; ///< root mean square of these, weighted by fitWeight(t): in the middle no node is extrapolated [m]
};

/// prod (1 - t_k^2) in the cube, 0 outside.
inline double fitWeight(const Vec3& t)
{
    const Vec3 rest = (1 - t.array().square()).max(0.0);
    return rest.x() * rest.y() * rest.z();
}

/// The weighted least squares of
///   sum_i g_i |p(t_i) - u_i|^2 + sum_i g_i sum_k hold_k |c_k - c_k of the prior|^2,  g = prod (1 - t_k^2 / reach^2),
/// over the nodes given. The prior itself where there are no nodes.
/// @param reach of nodes that count, in halves of the cube of the prior
PatchFit fitPatch(const DisplacementField& field, std::span<const std::uint32_t> nodes, const QuadraticPatch& prior,
                  double reach, const PatchHold& hold);

} // namespace knead
