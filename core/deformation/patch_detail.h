#pragma once

#include "core/deformation/patch_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace knead {

/// What a patch adds to its quadratic function around a node: value (1 - r)^4 (4 r + 1), r = |t - at| / patchDetailReach, up to
/// r = 1 (Wendland's function of 1995, twice continuously differentiable). In single precision: what they add is small.
struct PatchSource {
    Eigen::Vector3f at;    ///< in the cube of the patch
    Eigen::Vector3f value; ///< [m]
};

constexpr float patchDetailReach = 3; ///< halves of the cube

/// A patch that goes through its nodes.
struct DetailedPatch {
    QuadraticPatch patch;
    std::vector<PatchSource> sources;
    double expectedError = 0; ///< of nodes that it would not have, as PatchFit::expectedError [m]
};

/// The function p + sum of sources through all nodes given that is least away from the prior:
///   sum_k hold_k |c_k - c_k of the prior|^2 + |sources|^2 of Wendland's space.
/// For few nodes: O(n^3).
DetailedPatch fitThrough(const DisplacementField& field, std::span<const std::uint32_t> nodes,
                         const QuadraticPatch& prior, const PatchHold& hold);

/// What sources add at t.
inline Vec3 detailAt(const Vec3& t, std::span<const PatchSource> sources)
{
    const Eigen::Vector3f place = t.cast<float>();
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const PatchSource& source : sources) {
        const float r = std::sqrt((place - source.at).squaredNorm()) / patchDetailReach;
        const float rest = std::max(1 - r, 0.0F);
        sum += (rest * rest) * (rest * rest) * (4 * r + 1) * source.value;
    }
    return sum.cast<double>();
}

} // namespace knead
