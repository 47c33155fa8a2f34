#pragma once

#include "core/simulation/pace.h"
#include "core/simulation/scene.h"
#include "io/recipe/recipe_values.h"

#include <algorithm>
#include <string>

namespace knead {

/// @pre there is one
template <class Choice>
const std::string& wordFor(Choice wanted, const Choices<Choice>& words)
{
    return std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.second == wanted; })->first;
}

// The words that recipes and projects have for the choices of a scene.

const Choices<BodyKind>& bodyKindWords();     ///< "deformable", "rigid", "glue"
const Choices<Pace>& paceWords();             ///< "full" ...
const Choices<Integrator>& integratorWords(); ///< "automatic" ...
const Choices<Touching>& touchingWords();
const Choices<ToolKind>& toolKindWords();
const Choices<VicinityMethod>& vicinityWords();

} // namespace knead
