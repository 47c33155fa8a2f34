#pragma once

#include "io/fields/field_content.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// Three columns of a table that are a vector.
struct VectorColumns {
    std::string name; ///< "displacement"
    std::string unit; ///< as its heading says; empty: not said
    std::array<std::size_t, 3> columns{};
};

/// What the columns of a table mean.
struct TableColumns {
    std::optional<std::size_t> label;
    VectorColumns nodes;
    std::vector<VectorColumns> vectors;
};

/// What their headings say, in whatever order, as "X [mm]", "Node", "U.U1", "disp_y", "displacement z (m)".
/// @return none, when coordinates are not among them
std::optional<TableColumns> columnsNamed(const std::vector<std::string>& headings);

/// What so many columns without headings mean: x y z dx dy dz, or behind the number of a node; without displacements for a mesh.
/// @param isFirstWhole whether the first column holds whole numbers only
std::optional<TableColumns> columnsCounted(std::size_t count, bool isFirstWhole);

} // namespace knead
