#pragma once

#include "core/session/recipe.h"
#include "io/recipe/recipe_kinds.h"

#include <string>

namespace knead::recipe_keys {

/// The kind of "deform_by_physics": a deformation by numbers, with what it takes to do it by grips.
struct PhysicsWords {
    using Of = DeformByPhysics;
    static DeformByPhysics read(const JsonNode& node);
    static std::string text(const DeformByPhysics& deform);
};

} // namespace knead::recipe_keys
