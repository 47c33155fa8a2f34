#pragma once

#include "core/model/part.h"
#include "core/simulation/scene.h"
#include "core/task/task_control.h"
#include "io/recipe.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace knead {

/// A part that cannot be read, or a recipe that does not fit it: no such body, no such face, an empty fixture.
struct UnusableInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A recipe made ready to run.
struct RecipeScene {
    Scene scene;
    std::vector<Part> parts;                        ///< one per body of the scene, same order
    std::vector<std::vector<FixtureId>> fixtureIds; ///< per fixture of the recipe; one for each body it holds
    std::vector<std::string> warnings;              ///< sentences: of the import, and parts left out
};

/// Imports the part and fills every closed body of it.
/// @throws UnusableInput, and std::runtime_error when the filling fails, each in a sentence. @throws Cancelled
RecipeScene buildScene(const Recipe& recipe, TaskControl& control);

/// Bodies that a name in a recipe means: those whose name or path in the assembly it is; all for an empty name.
/// @throws UnusableInput when there is none
std::vector<BodyId> bodiesNamed(const std::string& name, const std::vector<Part>& parts, const std::string& place);

} // namespace knead
