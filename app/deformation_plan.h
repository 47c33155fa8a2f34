#pragma once

#include "core/deformation/deformation.h"
#include "core/deformation/field_fit.h"
#include "core/deformation/number_wish.h"
#include "core/deformation/surface_move.h"
#include "core/model/field_file.h"
#include "core/model/part.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace knead {

/// A FieldDeformation as a person says it.
struct FieldWish {
    std::string path; ///< see readFieldSource()
    FieldChoice choice;
    double factor = 1;
    std::vector<std::string> kept; ///< CAD faces, from 0: "3,7" of the only part, "Lid:3,7" of a part by name or path
    std::optional<double> fade;    ///< [m]; none: fadeShare of the size of the parts
    std::array<bool, 3> locked{};

    static constexpr double fadeShare = 0.1;
};

using DeformationWish = std::variant<NumberWish, FieldWish>;

/// What wishes come to for a model.
struct DeformationPlan {
    /// Of one deformation, of a field.
    struct Source {
        FieldFile file; ///< without the field itself
        std::size_t nodes = 0;
        double largest = 0; ///< of its displacements [m]
        FieldFit fit;
    };

    std::shared_ptr<const std::vector<Deformation>> deformations;
    std::vector<std::optional<Source>> sources;    ///< per deformation; none: by number
    std::vector<std::optional<SurfaceMove>> moves; ///< per part of the model; none: it stays
    std::vector<Message> remarks;                  ///< what a person should know of fields and how they fit
};

/// Which parts are meant. @param names of parts, or paths of parts or assemblies; none: all
/// @return per part of the model @throws Problem where there is none of a name
std::vector<bool> partsNamed(const Model& model, const std::vector<std::string>& names);

/// Reads fields, says how they fit, and fills in what was left open; each deformation is of what those before it have made.
/// @param which per part of the model
/// @throws Problem, in a sentence, also where a field is not one of the parts; Cancelled
DeformationPlan planOf(const std::vector<DeformationWish>& wishes, const Model& model, const std::vector<bool>& which,
                       TaskControl& control);

} // namespace knead
