#pragma once

#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/session/recipe_files.h"
#include "core/simulation/snapshot.h"
#include "core/task/task_control.h"

#include <string>
#include <vector>

namespace knead {

/// Makes the folders the exports go to, before a long run finds out that it cannot.
/// @throws std::runtime_error, in a sentence.
void prepareFolders(const std::vector<RecipeExport>& exports, const std::string& outputFolder);

/// Writes the parts of a job; pictures show the tools of the snapshot too.
/// @throws std::runtime_error, in a sentence. @throws Cancelled between two files
WrittenExports writeExports(const std::vector<RecipeExport>& exports, const std::string& outputFolder, ExportJob job,
                            const Snapshot& snapshot, TaskControl& control);

} // namespace knead
