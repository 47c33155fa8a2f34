#pragma once

#include "core/document/project.h"
#include "io/json/json_text.h"

#include <vector>

namespace knead {

/// Adds what says which objects are meant: `faces` or `box_mm`, which mean something in other fillings too, where they mean
/// exactly these objects; else `objects` one by one.
/// @param objects of the body
/// @throws Problem when there are none
void putObjects(ObjectText& text, const Aggregate& aggregate, const TriangleMesh& mesh,
                std::vector<ObjectIndex> objects);

/// The same where faces are not among the choices.
void putObjects(ObjectText& text, const Aggregate& aggregate, std::vector<ObjectIndex> objects);

/// The same of a body that was filled anew by then, of which no more is known than how many objects it has.
void putLaterObjects(ObjectText& text, std::uint32_t count, std::vector<ObjectIndex> objects);

} // namespace knead
