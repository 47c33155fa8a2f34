#pragma once

#include "io/importer.h"

namespace knead {

/// Reads a 3MF: every object that the file builds becomes a part, placed as the file says, with its unit, names and
/// colors down to triangles. Support structures are hidden, on a layer of that name.
/// @throws Problem. @throws Cancelled
Model readThreeMf(const std::string& path, const ImportOptions& options, TaskControl& control);

} // namespace knead
