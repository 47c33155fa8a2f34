#pragma once

#include "app/deformation_plan.h"
#include "core/model/export_options.h"
#include "core/model/import_options.h"
#include "core/session/recipe_runner.h"
#include "core/task/task_control.h"

#include <optional>
#include <string>
#include <vector>

namespace knead {

/// How a deformation by number is left to physics.
struct PhysicsWish {
    std::string material;               ///< id of a preset; empty: none is said
    std::optional<double> duration;     ///< of the way of the grips [s]; none: 1
    bool letsGo = false;                ///< one grip opens at the end
    std::optional<std::size_t> objects; ///< about how many the part is filled with; none: 20 000

    bool saysAnything() const { return !material.empty() || duration || letsGo || objects; }
};

/// A file whose part is to be deformed by grips and written to another one.
struct PhysicalMorphRequest {
    std::string input;
    std::string output; ///< its ending is the format
    std::vector<DeformationWish> wishes;
    std::vector<std::string> parts; ///< that is deformed, one at most; empty: all
    ImportOptions import;
    ExportOptions write;
    bool wantsReport = false;
    PhysicsWish physics;
};

/// Carries it out as a recipe: the part is filled, grips go their way, and the file is written when nothing has moved for long.
/// @throws std::runtime_error, in a sentence. @throws Cancelled
RunReport morphByPhysics(const PhysicalMorphRequest& request, TaskControl& control, const SayAtOnce& say = {});

} // namespace knead
