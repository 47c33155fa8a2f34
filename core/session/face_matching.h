#pragma once

#include "core/model/part.h"
#include "core/task/task_control.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace knead {

/// x -> linear (x - from) + to: what takes a part roughly to where another one is, before their faces are looked at.
struct AffineMap {
    Mat3 linear = Mat3::Identity(); ///< a turn, a mirror image, a scale
    Vec3 from = Vec3::Zero();       ///< [m]
    Vec3 to = Vec3::Zero();         ///< [m]

    Vec3 at(const Vec3& x) const { return linear * (x - from) + to; }
};

/// What a face is known by: seen from its triangles, so that what made it does not matter.
struct FaceLook {
    double area = 0;            ///< [m^2]
    Vec3 center = Vec3::Zero(); ///< by area [m]
    Vec3 normal = Vec3::Zero(); ///< mean outward normal, by area: of length 1 for a plane, 0 for a whole cylinder
    Mat3 spread = Mat3::Zero(); ///< mean of n n^T: rank 1 for a plane, 2 for a cylinder, trace 1
    double bulge = 0; ///< mean of (x - center) . n [m]: the radius of a whole cylinder or ball, negative for a hole
    std::optional<Color> color;           ///< that the file gives it
    std::string name = {};                ///< that the file gives it and no other face of the part; else empty
    std::vector<std::uint32_t> neighbors; ///< faces that share an edge with it, ascending
};

/// One per CAD face of a part, in their order; a mesh without faces is one face. @throws Cancelled
std::vector<FaceLook> faceLooks(const Part& part, const TaskControl& control = TaskControl::none());

/// How a face was found again.
enum class FoundBy : std::uint8_t { name, color, place };

/// A face of one part and the one that it is on another.
struct FaceMatch {
    std::uint32_t before = 0;
    std::uint32_t after = 0;
    FoundBy by = FoundBy::place;
    double score = 0; ///< 1: alike in all, 0: barely
};

/// Which face of another part is which of this one. Faces of one name are the same face, whatever else differs. Each other one is
/// compared by the kind of its surface, its size, its normal, its place in the box of the part, counted from whichever end fits
/// better, and, once neighbors are known, by these. Pairs are those of the least sum of differences. A second for 2000 faces on one
/// thread; on all threads.
/// @param to what takes the part to the other one
/// @return by FaceMatch::before, ascending; faces that were not found are missing @throws Cancelled
std::vector<FaceMatch> matchFaces(std::span<const FaceLook> before, const Box& boxBefore,
                                  std::span<const FaceLook> after, const Box& boxAfter, const AffineMap& to,
                                  const TaskControl& control = TaskControl::none());

} // namespace knead
