#pragma once

#include "app/recipe_parts.h"
#include "core/simulation/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace knead {

/// A recipe made ready to run.
struct RecipeScene {
    Scene scene;
    std::vector<Part> parts;                        ///< one per body of the scene, same order
    std::vector<std::vector<FixtureId>> fixtureIds; ///< per fixture of the recipe; one for each body it holds
    std::vector<std::string> warnings;              ///< sentences: of the import, and parts left out
};

/// Imports the parts and fills every closed body of it.
/// @throws UnusableInput, and std::runtime_error when the filling fails, each in a sentence. @throws Cancelled
RecipeScene buildScene(const Recipe& recipe, TaskControl& control);

/// Bodies that a name in a recipe means: those whose name or path in the assembly it is; all for an empty name.
/// @throws UnusableInput when there is none
std::vector<BodyId> bodiesNamed(const std::string& name, const std::vector<Part>& parts, const std::string& place);

/// Objects of a body.
struct BodyObjects {
    BodyId body = 0;
    std::vector<ObjectIndex> objects;
};

/// What a box takes of the bodies that a name means, leaving out bodies with nothing in it; whole bodies, without
/// objects, when there is no box.
/// @throws UnusableInput when there is no such body, or nothing in the box
std::vector<BodyObjects> objectsWithin(const RecipeScene& ready, const std::string& body, const std::optional<Box>& box,
                                       const std::string& place);

} // namespace knead
