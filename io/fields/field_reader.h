#pragma once

#include "core/model/field_file.h"
#include "core/model/field_formats.h"
#include "io/fields/nodal_mesh.h"

#include <string>

namespace knead {

/// Whether a file is a collection of ParaView, which names others. @throws Problem, when it is missing, empty or no ordinary file
bool isFieldCollection(const std::string& path);

/// Reads the displacements at the nodes of another program's result, of any format in fieldFormats. The content decides what a
/// file is where its ending lies. Nodes without a displacement, or with one that is no number, are left out; nodes in one place
/// become one with the mean of their displacements; both are said among the warnings.
/// Files of Knead's own VTP export hold where nodes are; what is returned is where they were.
/// @throws Problem, which names the file, what is wrong and what to do. @throws Cancelled
FieldFile readField(const std::string& path, const FieldChoice& choice, TaskControl& control);

/// Reads the nodes of a mesh, and its cells where the file has some, of any format in fieldFormats or an input of Abaqus or
/// CalculiX.
/// @param unit of lengths in the file, as LengthUnit::name; empty: that which the file says, else mm
/// @throws as readField()
NodalMesh readNodes(const std::string& path, const std::string& unit, TaskControl& control);

} // namespace knead
