#pragma once

#include "core/model/field_file.h"
#include "io/fields/nodal_mesh.h"

#include <string>

namespace knead {

/// As readField(), in a process of its own with limits that grow with the file: one that makes the reader crash, hang or eat
/// memory ends that process and gives a sentence. Cancelling ends it at once. Any number may run beside each other.
/// @param program that calls runFieldWorker() when isFieldWorker()
/// @throws Problem: which file, what is wrong, what to do. @throws Cancelled
FieldFile readFieldIsolated(const std::string& program, const std::string& path, const FieldChoice& choice,
                            TaskControl& control);

/// As readNodes(), likewise.
NodalMesh readNodesIsolated(const std::string& program, const std::string& path, const std::string& unit,
                            TaskControl& control);

} // namespace knead
