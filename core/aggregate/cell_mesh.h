#pragma once

#include "core/aggregate/aggregate.h"
#include "core/geometry/vec3.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace knead {

/// Hexahedra for finite elements.
struct CellMesh {
    using Cell = std::array<std::uint32_t, 8>; ///< nodes around the lower face, then those above them, counted from 0

    struct NodeSet {
        std::string name;
        std::vector<std::uint32_t> nodes; ///< ascending
    };

    std::vector<Vec3> nodes; ///< [m]
    std::vector<Cell> cells;
    std::vector<NodeSet> sets;
};

/// The filling of a part to be added to a mesh, and what its sets are called.
struct FillingToMesh {
    const Aggregate* filling = nullptr;
    std::string name; ///< before the names of its sets
};

/// The cells of fillings as whole cubes: a mesh whose curved faces are steps of a spacing. Of each filling the sets are
///   NAME: all its nodes; NAME_FACE_0 ...: nodes at the CAD face of that number, within half a spacing,
/// and of all of them
///   REST_1, REST_2, REST_3: a node each. Held along x, y and z; y and z; z, they take the mesh its six rigid motions, and nothing else.
CellMesh cellMesh(std::span<const FillingToMesh> fillings);

} // namespace knead
