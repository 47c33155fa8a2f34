#pragma once

#include "core/aggregate/material.h"
#include "core/model/part.h"

#include <optional>

namespace knead {

/// What a material looks like, as far as its numbers tell.
enum class MaterialLook {
    plain,   ///< jelly, foam, and what no rule fits
    rubber,  ///< dark and matt
    clay,    ///< warm and matt
    wood,    ///< warm, hardly shining
    plastic, ///< glossy
    metal    ///< gray with a sharp highlight
};

MaterialLook materialLook(const Material& material);

/// Of a part that has no color of its own. None: that of all others.
std::optional<Color> usualColor(MaterialLook look);

/// Whether its file gave it one, or one of its faces.
bool hasOwnColor(const Part& part);

} // namespace knead
