#pragma once

#include "core/deformation/displacement_field.h"
#include "core/session/body_maps.h"
#include "core/session/later_fillings.h"
#include "core/session/recipe.h"
#include "core/session/recipe_files.h"
#include "core/session/recipe_scene.h"
#include "core/session/transferred_recipe.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace knead {

/// How another part follows from the one that a recipe is for.
struct TransferOptions {
    std::optional<Vec3>
        mirror; ///< normal of the plane between a part and its mirrored partner, of any length but 0; none: no partner
    std::optional<double> scale = 1; ///< how much larger it is; none: as its box says
    /// Times of steps, ascending: events go by time on another part, whose steps may be of another length. Empty: they keep their steps.
    std::vector<std::pair<std::uint64_t, double>> timesOfSteps;
    /// Of the bodies of the recipe, for what names objects of these; asked for once, where there is such.
    std::function<LaterFillings(TaskControl&)> laterFillings;
    std::string unit; ///< of lengths in the file of the other part, as ImportOptions has it; empty: what that says
};

/// What was done to one part, for another one.
struct PartTransfer {
    Recipe recipe;                            ///< of the other part, without exports
    std::vector<BodyMap> bodies;              ///< where places are on it
    AffineMap base;                           ///< what mirrors and scales
    std::shared_ptr<const Model> partsBefore; ///< that the bodies are of
    TransferReport report;
};

/// Finds the faces of the part of a recipe again on another one, and makes the recipe that does the same there: fixtures, loads, regions
/// and cuts go with their faces, tools and probes with the nearest face, single objects to the nearest ones. The spacing stays, and goes
/// with the scale. What has no place on the other part is left out, with what depends on it, and reported.
/// @param file of the other part
/// @throws UnusableInput, in a sentence: a file without closed parts, or without any face that could be found again. @throws Cancelled
PartTransfer transferToPart(const Recipe& recipe, const std::string& file, const RecipeFiles& files,
                            const TransferOptions& options, TaskControl& control);

/// A field of the part of a recipe, on the other one: nodes where their places are, displacements mirrored and scaled.
/// On all threads. @throws Cancelled
DisplacementField fieldOnPart(const DisplacementField& field, const PartTransfer& transfer,
                              TaskControl& control = TaskControl::none());

} // namespace knead
