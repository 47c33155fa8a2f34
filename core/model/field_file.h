#pragma once

#include "core/deformation/displacement_field.h"
#include "core/geometry/triangle_mesh.h"
#include "core/message/message.h"
#include "core/task/task_control.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// Which of the fields of a file is meant.
struct FieldChoice {
    std::optional<std::size_t> step; ///< in the order of the file; none: the last one
    std::string name;                ///< of the vectors at the nodes; empty: the displacements
    std::string unit;       ///< of lengths in the file, as LengthUnit::name; empty: that which the file says, else mm
    bool isInPlace = false; ///< a scan has the axes of the parts; else it is laid over them first
};

/// A file with a displacement at each of its nodes, as it was read.
struct FieldFile {
    std::string path;
    std::string format;             ///< "CalculiX results", "VTK", "Gmsh", "table" ...
    std::vector<std::string> steps; ///< what the file calls its time steps, in order; one at least
    std::vector<std::string> names; ///< of its vectors at nodes that could be meant
    std::size_t step = 0;           ///< that was read
    std::string name;               ///< of the vectors that were read
    std::string unit;               ///< of the file, as it was read
    DisplacementField field;        ///< [m]; nodes in one place are one
    std::vector<Message> warnings;  ///< sentences for the person
};

/// Reads a field. Blocks, on any thread.
/// @param parts the surface of what it is to deform, as that is now: what a scan is compared with
/// @throws Problem, in a sentence; Cancelled
using ReadField =
    std::function<FieldFile(const std::string& path, const FieldChoice&, const TriangleMesh& parts, TaskControl&)>;

} // namespace knead
