#pragma once

#include "core/document/project.h"
#include "core/message/message.h"
#include "core/session/part_transfer.h"
#include "core/session/recipe_start.h"
#include "core/simulation/scripted_events.h"
#include "core/task/task_control.h"

#include <functional>
#include <string>
#include <vector>

namespace knead {

/// What was done to one part, for another one.
struct AppliedPart {
    RecipeStart start;
    TransferReport report; ///< what was found again
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

    /// What was done in a project, for the part of another file.
    /// @param projectPath as above
    std::function<AppliedPart(const std::string& part, const Project&, const std::string& projectPath,
                              const TransferOptions& options, TaskControl&)>
        apply;
};

} // namespace knead
