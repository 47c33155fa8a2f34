#pragma once

#include "core/model/field_file.h"
#include "io/fields/nodal_mesh.h"

#include <string>
#include <string_view>

namespace knead {

/// A field as bytes, to be handed from one process of a machine to another, and the other way.
/// @throws Problem, for the developer, when the bytes are no field
std::string fieldToBytes(const FieldFile& file);
FieldFile fieldFromBytes(std::string_view bytes);

/// A mesh likewise.
std::string meshToBytes(const NodalMesh& mesh);
NodalMesh meshFromBytes(std::string_view bytes);

} // namespace knead
