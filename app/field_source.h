#pragma once

#include "core/model/field_file.h"

#include <string>

namespace knead {

/// Reads a field from whatever holds one: a project (what was done in it up to an entry of its history, which is its step), a scan of
/// parts, which is a file that is called like a mesh, or a file of another program. Blocks, on any thread.
/// @param parts surface of what is to be deformed, for a scan
/// @throws std::runtime_error, in a sentence; Cancelled
FieldFile readFieldSource(const std::string& path, const FieldChoice& choice, const TriangleMesh& parts,
                          TaskControl& control);

} // namespace knead
