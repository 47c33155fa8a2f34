#pragma once

#include "io/importer.h"

namespace knead {

/// Reads a 3MF: every object that the file builds becomes a part, placed as the file says, with its unit, names and
/// colors down to triangles. Support structures, and other things that are no parts, are hidden, on layers of these names.
/// @throws Problem. @throws Cancelled
Model readThreeMf(const std::string& path, const ImportOptions& options, TaskControl& control);

} // namespace knead
