#pragma once

#include "core/document/project.h"
#include "core/message/message.h"
#include "core/session/face_fixture.h"
#include "core/session/recipe.h"
#include "core/session/recipe_files.h"
#include "core/simulation/scripted_events.h"
#include "core/task/task_control.h"

#include <memory>
#include <vector>

namespace knead {

/// A recipe as a document begins with it.
struct RecipeStart {
    std::shared_ptr<const Model> model;
    ImportChoices choices; ///< that lead to the model; without paths where no choices do
    ProjectStart start;
    std::vector<FaceFixture> fixtures; ///< with faces: of its start and of its events
    ScriptedEventsMaker script;
    std::vector<RecipeExport> exports; ///< that "knead run" would write at the end
    std::vector<Message> warnings;     ///< sentences for the person
};

/// Reads its parts and fills them. Its script comes to the same bits as runRecipe().
/// @throws as buildScene() and checkEvents()
RecipeStart recipeStart(Recipe recipe, const RecipeFiles& files, TaskControl& control);

} // namespace knead
