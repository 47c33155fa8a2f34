#pragma once

#include "core/message/message.h"
#include "core/model/part.h"

#include <span>
#include <string>
#include <string_view>

namespace knead {

/// A length unit that people use in files.
struct LengthUnit {
    const char* name; ///< as shown and typed: "mm"
    Message plural;   ///< as spoken of: "millimetres"
    double metres;    ///< in one of it
};

/// From the most common to the rarest.
std::span<const LengthUnit> lengthUnits();

/// The unit that a person or a file means, whatever the case: "mm", "millimetre", "MILLIMETERS", "in", "inch".
/// @return null when no such unit is known
const LengthUnit* findLengthUnit(std::string_view text);

/// "mm, m, inch ...": the names of all units, for sentences and help.
std::string lengthUnitNames();

/// How Model::warnings says that the numbers of a file were taken as millimetres.
/// @param file its name
Message noUnitStated(const std::string& file);

/// Multiplies everything that is a length, area or volume.
/// @pre factor > 0
void scaleModel(Model& model, double factor);

/// The model with its numbers read in another unit, whatever the file says: 25.4 times as large when millimetres become
/// inches. The doubt about the unit is settled by it.
/// @param unit as findLengthUnit() takes it
/// @throws Problem, when `unit` or the unit of the model is not known
Model takenIn(Model model, std::string_view unit);

} // namespace knead
