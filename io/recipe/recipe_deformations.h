#pragma once

#include "core/document/recipe_deformation.h"
#include "io/recipe/recipe_kinds.h"

#include <optional>
#include <string>
#include <vector>

namespace knead::recipe_keys {

/// The kind of an item of "deform": by numbers, with a `kind`, or by the `field` of a file.
struct DeformationWords {
    const Context& context;
    RecipeDeformation read(const JsonNode& node) const;
    std::string text(const RecipeDeformation& deformation) const;
};

/// The keys of a deformation by numbers, of which an object may have `others` beside. @throws Problem, in a sentence
NumberDeformation readNumbers(const JsonNode& node, const std::vector<std::string>& others);
/// @param kFactor in place of its neutral plane
void putNumbers(ObjectText& text, const NumberDeformation& deformation, const std::optional<double>& kFactor);

} // namespace knead::recipe_keys
