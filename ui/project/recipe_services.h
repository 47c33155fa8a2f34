#pragma once

#include "core/document/project.h"
#include "core/message/message.h"
#include "core/simulation/scripted_events.h"
#include "core/task/task_control.h"
#include "ui/document/face_fixture.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace knead {

/// A recipe as a document begins with it.
struct RecipeStart {
    std::shared_ptr<const Model> model;
    ImportChoices choices; ///< that lead to the model; without paths where no choices do
    ProjectStart start;
    std::vector<FaceFixture> fixtures; ///< with faces: of its start and of its events
    ScriptedEventsMaker script;
    std::vector<Message> warnings; ///< sentences for the person
};

/// Recipes on the disk. The functions may be called from any thread and block; what they throw is a std::runtime_error with a
/// sentence for the person, or Cancelled.
struct RecipeServices {
    std::string ending; ///< of recipe files: "json"

    std::function<RecipeStart(const std::string& path, TaskControl&)> open;

    /// The file appears whole or not at all.
    /// @param projectPath where the project was saved; empty: nowhere yet
    /// @return sentences on what the recipe leaves out
    std::function<std::vector<Message>(const std::string& path, const Project&, const std::string& projectPath)> write;
};

} // namespace knead
