#pragma once

#include "app/recipe_scene.h"
#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/simulation/snapshot.h"
#include "core/task/task_control.h"
#include "io/recipe/recipe.h"

#include <string>
#include <vector>

namespace knead {

/// Makes the folders the exports go to, before a long run finds out that it cannot.
/// @throws std::runtime_error, in a sentence.
void prepareFolders(const std::vector<RecipeExport>& exports, const std::string& outputFolder);

/// What was written at the end of a recipe.
struct WrittenExports {
    std::vector<std::string> files;    ///< paths
    std::vector<ExportReport> reports; ///< of those that are no pictures
};

/// The bodies of a recipe as they are in a snapshot.
ExportJob exportJobOf(const RecipeScene& ready, const Snapshot& snapshot);

/// Writes the parts of a job; pictures show the tools of the snapshot too.
/// @throws std::runtime_error, in a sentence. @throws Cancelled between two files
WrittenExports writeExports(const std::vector<RecipeExport>& exports, const std::string& outputFolder, ExportJob job,
                            const Snapshot& snapshot, TaskControl& control);

} // namespace knead
