#pragma once

#include "core/model/file_preview.h"
#include "core/task/task_control.h"

#include <string>

namespace knead {

/// Looks into a file: products and their assembly for STEP, counts for STEP and IGES, format and size for the others. Takes a
/// small part of the time of an import. Takes the OpenCASCADE lock; on the calling thread.
/// @throws Problem, as importFile(). @throws Cancelled
FilePreview previewFile(const std::string& path, TaskControl& control = TaskControl::none());

} // namespace knead
