#pragma once

#include "core/model/field_file.h"
#include "core/task/task_control.h"

#include <string>

namespace knead {

/// How far a scanned surface is from parts, as a field at their surfaces: it is laid over them as a rigid thing first, where it is not in place.
/// @param choice of the unit of lengths in the file, as ImportOptions::unit; empty: as the file says, else mm
/// @param parts the surface of these, as it is now
/// @throws std::runtime_error, in a sentence; Cancelled
FieldFile readScan(const std::string& path, const FieldChoice& choice, const TriangleMesh& parts, TaskControl& control);

} // namespace knead
