#pragma once

#include "core/model/part.h"
#include "io/importer.h"

#include <string>
#include <vector>

namespace knead {

/// A named, colored surface to write.
struct MeshBody {
    std::string name;
    Color color;
    TriangleMesh mesh; ///< [m]
};

/// Writes bodies to STL (binary), OBJ (with a material library beside it) or PLY (binary); the ending decides. Lengths go out
/// in millimetres. The file appears whole or not at all: it is written under a temporary name and renamed.
/// @throws std::runtime_error, in a sentence, for an unknown ending, nothing to write, or a target that cannot be written.
void writeMeshes(const std::string& path, const std::vector<MeshBody>& bodies);

const std::vector<FileFormat>& exportFormats();

} // namespace knead
