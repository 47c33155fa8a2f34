#pragma once

#include "io/formats/cad_format.h"
#include "io/importer.h"

namespace knead {

/// Reads STL, OBJ, PLY or glTF; every object in the file becomes a part. The numbers of a glTF are metres by its format,
/// the others are taken as millimetres.
/// @throws Problem. @throws Cancelled
Model readMesh(const std::string& path, FormatKind kind, const ImportOptions& options, TaskControl& control);

/// Welds, repairs if wanted, and measures the meshes of a model, and judges whether they are closed. Box, volume and the like are
/// set. Sick parts are left out.
/// @throws Problem, when none is left. @throws Cancelled
void measureMeshes(const std::string& path, const ImportOptions& options, Model& model, TaskControl& control);

} // namespace knead
