#pragma once

#include "core/document/project.h"
#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/model/field_file.h"
#include "core/session/deformed_model.h"
#include "core/session/import_files.h"
#include "core/session/recipe.h"
#include "core/simulation/snapshot.h"
#include "core/task/task_control.h"

#include <functional>
#include <string>
#include <vector>

namespace knead {

/// What was written at the end of a recipe.
struct WrittenExports {
    std::vector<std::string> files;    ///< paths
    std::vector<ExportReport> reports; ///< of those that are no pictures
};

/// Files as carrying out a recipe needs them, handed in. The functions block; each throws std::runtime_error in a sentence, or
/// Cancelled.
struct RecipeFiles {
    ImportFiles import;
    std::function<bool(const std::string& path)> isProject;
    std::function<Project(const std::string& path, TaskControl&)> readProject;

    /// Makes the folders that exports go to, before a long run finds out that it cannot.
    std::function<void(const std::vector<RecipeExport>&, const std::string& outputFolder)> prepareFolders;
    /// Writes the parts of a job; pictures show the tools of the snapshot too. Files appear whole or not at all.
    std::function<WrittenExports(const std::vector<RecipeExport>&, const std::string& outputFolder, ExportJob,
                                 const Snapshot&, TaskControl&)>
        writeExports;
    /// A table of text; whole or not at all.
    std::function<void(const std::string& path, const std::string& text)> writeTable;

    WriteAndRead writeAndRead; ///< for parts that are deformed first
    ReadField readField = {};  ///< may be empty: then recipes with fields cannot be carried out
};

} // namespace knead
