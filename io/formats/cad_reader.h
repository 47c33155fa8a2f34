#pragma once

#include "io/formats/cad_format.h"
#include "io/importer.h"

namespace knead {

/// Reads STEP, IGES or BREP into parts with exact measures and triangles. Takes the OpenCASCADE lock.
/// @throws Problem. @throws Cancelled
Model readCad(const std::string& path, FormatKind kind, const ImportOptions& options, TaskControl& control);

} // namespace knead
