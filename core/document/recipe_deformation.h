#pragma once

#include "core/deformation/number_deformation.h"
#include "core/model/field_file.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace knead {

/// CAD faces of a part that stay where they are.
struct KeptFaces {
    std::string body; ///< empty: of the only part that is meant
    std::vector<std::uint32_t> faces;
};

/// A field in a file that deforms parts, see FieldDeformation.
struct RecipeField {
    std::string file; ///< ready to open
    FieldChoice choice;
    double factor = 1;
    std::vector<KeptFaces> kept;
    double fade = 0;              ///< [m]
    std::array<bool, 3> locked{}; ///< along x, y, z
};

/// What is done to the parts of a file before they are filled.
struct RecipeDeformation {
    std::vector<std::string> bodies; ///< empty: all of them
    std::variant<NumberDeformation, RecipeField> what;
    std::optional<double> kFactor = {}; ///< of a bend, in place of its neutral plane: see neutralOfSheet()
    bool isApart = false;               ///< carries the faces that came of the one before, not those of the file
};

} // namespace knead
