#pragma once

#include "core/mechanics/tool_shape.h"
#include "core/message/message.h"
#include "core/model/part.h"
#include "core/session/recipe.h"
#include "core/session/recipe_files.h"
#include "core/task/task_control.h"

#include <memory>
#include <string>
#include <vector>

namespace knead {

/// A part that cannot be read, or a recipe that does not fit it: no such body, no such face, an empty fixture.
struct UnusableInput : Problem {
    using Problem::Problem;
};

/// Everything that a recipe opens.
struct RecipeParts {
    Model source;                                            ///< of the part, without its parts; its tree has the names
    std::vector<Part> bodies;                                ///< closed ones, extra parts after those of the part
    std::vector<std::shared_ptr<const ToolPart>> toolParts;  ///< per manipulator; none for other kinds than part
    std::vector<std::shared_ptr<const ToolPart>> eventParts; ///< per event: of the manipulator that it adds or reshapes
    std::vector<Message> warnings;                           ///< sentences: of the import, and parts left out
};

/// Imports the part, the extra parts at their places, and the parts that manipulators are. Of a project they are those that
/// it keeps, whatever became of the files that it was made from.
/// @throws UnusableInput, in a sentence. @throws Cancelled
RecipeParts importParts(const Recipe& recipe, const RecipeFiles& io, TaskControl& control);

/// All surfaces as one.
TriangleMesh joinedMesh(const std::vector<Part>& parts);

} // namespace knead
