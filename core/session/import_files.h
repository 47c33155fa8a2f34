#pragma once

#include "core/model/import_options.h"
#include "core/model/part.h"
#include "core/task/task_control.h"

#include <functional>
#include <string>
#include <vector>

namespace knead {

/// Reads files; several become one model. Blocks, on any thread. @throws std::runtime_error, in a sentence; Cancelled
using ImportFiles = std::function<Model(const std::vector<std::string>& paths, const ImportOptions&, TaskControl&)>;

} // namespace knead
