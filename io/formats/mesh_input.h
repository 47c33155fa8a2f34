#pragma once

#include "core/aggregate/cell_mesh.h"

#include <string>

namespace knead {

/// Writes a mesh as finite element programs read it (.inp of CalculiX and Abaqus), in mm: *NODE with the set NALL, *ELEMENT of type
/// C3D8I with the set EALL, and a *NSET for each set. Nodes and elements are numbered from 1. The file appears whole or not at all.
/// @throws Problem that names the file and why the disk refused
void writeMeshInput(const std::string& path, const CellMesh& mesh);

} // namespace knead
