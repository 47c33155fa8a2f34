#pragma once

#include "core/document/recipe_deformation.h"
#include "io/recipe/recipe_kinds.h"

#include <string>

namespace knead::recipe_keys {

/// The kind of an item of "deform": by numbers, with a `kind`, or by the `field` of a file.
struct DeformationWords {
    const Context& context;
    RecipeDeformation read(const JsonNode& node) const;
    std::string text(const RecipeDeformation& deformation) const;
};

} // namespace knead::recipe_keys
