#pragma once

#include <string>

namespace knead {

/// Reads the JSON of a glTF or GLB and refuses what the mesh reader cannot take or would not survive: other versions,
/// compression that it does not know, nodes that hold themselves, files beside it that are missing.
/// @throws Problem
void checkGltf(const std::string& path);

} // namespace knead
