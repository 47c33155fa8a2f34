#pragma once

#include "core/skin/skin.h"
#include "core/skin/skin_stress.h"

#include <span>
#include <vector>

namespace knead {

/// What has become of the material at the vertices of a surface, for files that hold numbers at vertices.
struct SkinFields {
    std::vector<Vec3> displacement;    ///< from rest [m]
    std::vector<float> strain;         ///< see equivalentStrain()
    std::vector<float> vonMisesStress; ///< [Pa]
    std::vector<float> stressError;    ///< about how wrong that may be, see SkinStresses [Pa]
    double stressErrorShare = 0;       ///< the same where stress is largest, as a share of it
};

/// @param stress of the same points
/// @param displacement per object of the skin [m]
/// @param body that its objects are all or a piece of
/// @param loaded see SkinStress::stresses()
SkinFields skinFields(const Skin& skin, const SkinStress& stress, std::span<const Vec3> displacement,
                      const ObjectStrains& body, std::span<const ObjectIndex> loaded = {});

} // namespace knead
