#pragma once

#include "core/mechanics/object_strain.h"
#include "core/skin/skin.h"

#include <span>
#include <vector>

namespace knead {

/// What has become of the material at the vertices of a surface, for files that hold numbers at vertices.
struct SkinFields {
    std::vector<Vec3> displacement;    ///< from rest [m]
    std::vector<float> strain;         ///< see equivalentStrain()
    std::vector<float> vonMisesStress; ///< [Pa]
};

/// The tensors of the objects, each with its weight in the skin; the numbers are made of what that gives.
/// @param displacement per object [m]
/// @param strains per object
SkinFields skinFields(const Skin& skin, std::span<const Vec3> displacement, std::span<const ObjectStrain> strains);

} // namespace knead
