#pragma once

#include "core/simulation/scene.h"
#include "io/recipe_values.h"

namespace knead {

// The words that recipes and projects have for the choices of a scene.

const Choices<BodyKind>& bodyKindWords();     ///< "deformable", "rigid", "glue"
const Choices<Integrator>& integratorWords(); ///< "automatic" ...
const Choices<Touching>& touchingWords();
const Choices<ToolKind>& toolKindWords();
const Choices<VicinityMethod>& vicinityWords();

} // namespace knead
