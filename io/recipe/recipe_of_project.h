#pragma once

#include "core/aggregate/material.h"
#include "core/document/project.h"
#include "core/message/message.h"

#include <string>
#include <vector>

namespace knead {

/// How a project is to be told.
struct RecipeOfProjectChoices {
    std::string
        recipePath; ///< where the recipe will lie: files are named as seen from there; empty: by their whole paths
    std::string projectPath; ///< empty: the project was not saved
    bool namesProject =
        false; ///< takes the parts from the project even where the files that it was made from are still there
    bool saysDeformations = true; ///< of parts, as steps of the recipe; else it takes these from the project
};

/// The same project with what was set before its first step (materials, kinds of bodies, gravity, floor, integrator) as its
/// start: for changes to these, which commands would undo. It comes to another state in the last bits.
Project withSettingsFirst(Project project);

/// A session as a recipe.
struct RecipeOfProject {
    std::string text;             ///< JSON
    std::vector<Message> remarks; ///< sentences on what the recipe leaves out
};

/// The present branch of a project, from where its part was filled last, as a recipe that a person can read and change. Carried
/// out, it comes to the same state, bit for bit. It exports nothing.
/// @param presets bundled materials, which are named
/// @throws Problem, when a recipe cannot say it
RecipeOfProject recipeOfProject(const Project& project, const RecipeOfProjectChoices& choices,
                                const std::vector<MaterialPreset>& presets);

} // namespace knead
