#pragma once

#include "core/geometry/vec3.h"
#include "core/kernels/fit_kernels.h"

#include <span>
#include <vector>

namespace knead {

/// Moving-least-squares shape functions at the origin for nodes at `offsets`, with the weight (1 - r)^3 (3 r + 1) of the given
/// support, twice continuously differentiable (Wendland). They reproduce quadratic functions; where the nodes hardly determine
/// one, such as across a sheet of two layers, linear functions, with the second derivatives that they leave open kept small; where
/// they do not determine that either, constants. From one to the other they change by and by, so that they are continuous in the
/// offsets. They sum to 1; nodes beyond the support get 0.
/// @pre at least one node is closer than the support
std::vector<double> shapeFunctions(std::span<const Vec3> offsets, double support);

/// The same of nodes that are side by side already, weighed with their shares.
/// @param functions of nodes.count, written: 0 for those beyond the support
/// @pre at least one node with a share is closer than the support
void shapeFunctions(const kernels::FitNodes& nodes, double support, std::span<double> functions);

/// The same fit with its slopes at the origin.
struct ShapeSlopes {
    std::vector<double> values; ///< those of shapeFunctions()
    /// By what each node's value moves the gradient at the origin [1 / unit of the offsets]: the linear terms of the fit, exact for
    /// quadratic functions, for linear ones where the nodes hardly determine more. What the fit is not trusted with is left out.
    std::vector<Vec3> slopes;
    double trust =
        0; ///< 0 .. 1: the part of the fit that has slopes; where it is below 1, the nodes say too little of them
};

/// @return for nodes.count; of those beyond the support 0 @pre as for shapeFunctions()
ShapeSlopes shapeSlopes(const kernels::FitNodes& nodes, double support);

} // namespace knead
