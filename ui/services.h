#pragma once

#include "core/aggregate/material.h"
#include "core/document/moment_bytes.h"
#include "core/model/export_job.h"
#include "core/model/export_report.h"
#include "core/model/field_file.h"
#include "core/model/file_preview.h"
#include "core/model/part.h"
#include "core/session/deformed_model.h"
#include "core/session/import_files.h"
#include "core/task/task_control.h"
#include "ui/interaction/space_motion.h"
#include "ui/project/project_services.h"
#include "ui/project/recipe_services.h"
#include "ui/project/trace_services.h"

#include <functional>
#include <string>
#include <vector>

namespace knead {

/// What the window needs from files, handed in by app. The functions may be called from any thread and block.
struct Services {
    ImportFiles import;
    /// @throws as import
    std::function<FilePreview(const std::string& path, TaskControl&)> preview;
    /// The ending decides the format. The report can be kept beside the file. @throws as import
    std::function<ExportReport(const std::string& path, const ExportJob&, bool keepsReport, TaskControl&)> exportParts;

    /// Has a file written under another name, given to `write`, and puts it in its place when it is whole. @throws as import, and
    /// what `write` throws: then nothing has changed
    std::function<void(const std::string& path, const std::function<void(const std::string& pathForNow)>& write)>
        writeSafely;

    /// How many threads compute from now on; 0: as many as the machine has. May be null. Window thread.
    std::function<void(unsigned threads)> limitThreads;

    /// Materials that the person saved. None while there is no file yet. @throws std::runtime_error with a sentence
    std::function<std::vector<MaterialPreset>()> readOwnMaterials;
    /// Keeps them instead of those there were, whole or not at all. @throws std::runtime_error with a sentence
    std::function<void(const std::vector<MaterialPreset>&)> writeOwnMaterials;

    Packing packing; ///< of the moments in the history

    std::vector<MaterialPreset> materials;
    std::string examplesFolder;
    /// Of files and of computing, for those who want to know what Knead is made with.
    struct Library {
        std::string name;
        std::string version;
        std::string license;
    };
    std::vector<Library> libraries;
    ListenToSpaceMouse spaceMouse; ///< may be empty
    ProjectServices projects;
    RecipeServices recipes;

    WriteAndRead writeAndRead; ///< of parts that were deformed or kneaded
    ReadField readField;       ///< displacements of another program; may be empty
    TraceServices traces;
};

} // namespace knead
