#pragma once

#include "core/model/export_options.h"
#include "core/task/task_control.h"
#include "io/mesh/mesh_body.h"

#include <string>
#include <vector>

namespace knead {

/// Writes bodies to STL, OBJ (with a material library beside it), PLY, glTF, GLB, 3MF or VTP; the ending decides. Files grow piece
/// by piece, so that little more memory is needed than the bodies take, and appear whole or not at all, see SafeFile.
///
/// | | names | colors | unit |
/// |---|---|---|---|
/// | STL, binary or text | in text | no | options.unit, said in the header |
/// | OBJ | without spaces | of faces | options.unit, said in a comment |
/// | PLY, binary or text | no | of faces | options.unit, said in a comment |
/// | glTF, GLB | yes | of faces | m, y up, both as the format asks |
/// | 3MF | yes | of faces | options.unit, of the six that the format knows |
/// | VTP | yes | of faces | options.unit, said in the field data |
///
/// VTP also takes the fields of the bodies and says at points and triangles which part they are of. Numbers are written in single
/// precision. Bodies without triangles are left out. All bodies go into one file, beside each other.
/// @throws Problem, for an unknown ending or unit, nothing to write, or a target that cannot be written.
/// @throws Cancelled
void writeMeshes(const std::string& path, const std::vector<MeshBody>& bodies, const ExportOptions& options = {},
                 TaskControl& control = TaskControl::none());

} // namespace knead
