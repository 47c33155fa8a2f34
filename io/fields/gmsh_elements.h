#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace knead {

/// An element as Gmsh numbers its types, and the same as VTK does.
struct GmshElement {
    std::size_t nodes = 0;
    std::uint8_t vtkType = 0;             ///< 0: no cell of it is taken
    std::vector<std::uint8_t> order = {}; ///< VTK's node i is the file's node order[i]; empty: the same
};

/// Null for a type that is not known.
const GmshElement* gmshElement(std::int64_t type);

} // namespace knead
