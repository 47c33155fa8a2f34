#pragma once

#include <string>
#include <vector>

namespace knead {

struct JsonValue;

/// A change to a recipe before it is checked: `manipulators.press.size_mm.0` becomes `12`.
struct RecipeOverride {
    /// Keys of objects, and names or numbers (from 0) of the items of lists, with dots between them. Keys and names that hold
    /// dots themselves are found when they are in the recipe.
    std::string path;
    std::string value; ///< JSON; anything else is a text. null takes away what is there
};

/// Cuts "PATH=VALUE" in two. @throws Problem
RecipeOverride parseOverride(const std::string& text);

/// What a value means: JSON, or else the text itself.
/// @throws Problem, when it begins as an object, a list or a quoted text and is none
JsonValue overrideValue(const RecipeOverride& change);

/// Takes the lines away, of a text that nobody sees.
void forgetLines(JsonValue& value);

/// Carries out the changes in their order. Objects that are missing on the way are made, and a material that is given by its
/// name becomes one with that preset; whether the result is a recipe is checked afterwards.
/// @param file name for messages
/// @throws Problem: the path, where it ends and what there is instead
void applyOverrides(JsonValue& recipe, const std::vector<RecipeOverride>& changes, const std::string& file);

} // namespace knead
