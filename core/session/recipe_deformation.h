#pragma once

#include "core/deformation/number_deformation.h"
#include "core/model/field_file.h"

#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace knead {

/// A field in a file that deforms parts, see FieldDeformation.
struct RecipeField {
    std::string file; ///< ready to open
    FieldChoice choice;
    double factor = 1;
    std::vector<std::uint32_t> keptFaces; ///< of the only part that is meant: they stay where they are
    double fade = 0;                      ///< [m]
    std::array<bool, 3> locked{};         ///< along x, y, z
};

/// What is done to the parts of a recipe's file before they are filled.
struct RecipeDeformation {
    std::string body; ///< empty: all of them
    std::variant<NumberDeformation, RecipeField> what;
};

} // namespace knead
