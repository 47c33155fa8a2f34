#pragma once

#include "core/document/project.h"
#include "core/model/export_job.h"
#include "core/simulation/snapshot.h"

namespace knead {

/// All parts of a project as a snapshot shows them, in the unit they came in: what is written to a file, and as the window
/// writes it. Parts that are no bodies are written as they were imported.
/// @param start that the snapshot is of
/// @pre the project has a model
ExportJob exportJobOf(const Project& project, const ProjectStart& start, const Snapshot& snapshot);

} // namespace knead
