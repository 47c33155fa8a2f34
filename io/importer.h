#pragma once

#include "core/model/import_options.h"
#include "core/model/part.h"
#include "core/task/task_control.h"

#include <string>

namespace knead {

/// Reads any supported file: STEP, IGES, BREP with exact geometry; STL, OBJ, PLY, 3MF, glTF as meshes. The content decides
/// the format, not the ending. One import at a time per process runs (a lock inside): the CAD readers share global state.
/// Runs on the calling thread.
///
/// @throws Problem whose text is one sentence for the person: which file, what is wrong, what to do.
/// @throws Cancelled
Model importFile(const std::string& path, const ImportOptions& options = {},
                 TaskControl& control = TaskControl::none());

} // namespace knead
