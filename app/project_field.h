#pragma once

#include "core/model/field_file.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <optional>
#include <string>

namespace knead {

/// What was done in a project up to an entry of its history, as a field: see sessionField(). The entries are its steps.
/// @param entry none: its present one
/// @throws std::runtime_error, in a sentence: no project, no such entry, nothing has moved. @throws Cancelled
FieldFile projectField(const std::string& path, std::optional<std::uint32_t> entry, TaskControl& control);

} // namespace knead
