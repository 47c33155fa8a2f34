#pragma once

#include "core/geometry/vec3.h"
#include "core/message/message.h"

#include <cstdint>
#include <string>
#include <vector>

namespace knead {

/// Cells over nodes as VTK numbers and orders them: cell c has the type `types[c]` (10 is a tetrahedron, 24 one with nodes at
/// the middle of its edges) and the nodes connectivity[offsets[c] .. offsets[c + 1]), counted from 0.
struct NodalCells {
    std::vector<std::int64_t> connectivity;
    std::vector<std::int64_t> offsets; ///< one more than cells, the first 0; empty where there are no cells
    std::vector<std::uint8_t> types;
    std::vector<std::int64_t> labels; ///< their numbers in another program; empty where the file has none
    std::vector<std::uint8_t> points; ///< points at which CalculiX integrates each, 0 not known; as labels

    bool isEmpty() const { return types.empty(); }

    /// Makes a cell of the nodes in `connectivity` behind the last one.
    void endCell(std::uint8_t vtkType)
    {
        if (offsets.empty())
            offsets.push_back(0);
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        types.push_back(vtkType);
    }
};

/// The nodes of another program's mesh, in the order of its file, nodes in one place kept apart.
struct NodalMesh {
    std::string path;
    std::string format;               ///< as FieldFile::format; "Abaqus or CalculiX input"
    std::string unit;                 ///< of the file, as it was read: "mm"
    std::vector<Vec3> nodes;          ///< [m]
    std::vector<std::int64_t> labels; ///< their numbers in that program; empty where the file has none
    NodalCells cells;                 ///< may be empty
    std::vector<Message> warnings;    ///< sentences for the person
};

} // namespace knead
