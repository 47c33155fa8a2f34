#pragma once

#include "core/document/project.h"
#include "core/session/recipe.h"

#include <vector>

namespace knead {

/// Which objects are meant, without names: `faces` or `box_mm`, which mean something in other fillings too, where they mean
/// exactly these objects; else the objects one by one.
/// @param mesh of the body; null: faces are not among the choices
/// @param objects of the body
/// @throws Problem when there are none
RecipeRegion placeOf(const Aggregate& aggregate, const TriangleMesh* mesh, std::vector<ObjectIndex> objects);

/// The same of a body that was filled anew by then, of which no more is known than how many objects it has.
RecipeRegion laterPlaceOf(std::uint32_t count, std::vector<ObjectIndex> objects);

} // namespace knead
