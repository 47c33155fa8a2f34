#pragma once

#include "core/deformation/displacement_field.h"
#include "core/geometry/triangle_mesh.h"

#include <array>
#include <memory>

namespace knead {

/// A field that is to deform parts, and where it may not.
///   x(X) = X + factor w(X) (u - locked components of u),
/// where w is 0 on the kept surfaces and rises smoothly to 1 at a distance of `fade` from them.
struct FieldDeformation {
    std::shared_ptr<const DisplacementField> field; ///< never null
    double factor = 1;                              ///< -1: the other way, as compensation wants it
    TriangleMesh kept;                              ///< surfaces that stay exactly where they are [m]; empty: none
    double fade = 0;                                ///< [m], > 0 where surfaces are kept
    std::array<bool, 3> locked{};                   ///< along x, y, z nothing moves
};

} // namespace knead
