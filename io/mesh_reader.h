#pragma once

#include "io/cad_format.h"
#include "io/importer.h"

namespace knead {

/// Reads STL, OBJ or PLY; every object in the file becomes a part. Numbers are taken as millimetres.
/// @throws std::runtime_error, in a sentence. @throws Cancelled
Model readMesh(const std::string& path, FormatKind kind, const ImportOptions& options, TaskControl& control);

} // namespace knead
