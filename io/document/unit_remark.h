#pragma once

#include "core/model/part.h"

#include <optional>

namespace knead {

/// Doubts the unit of a model whose longest side is no size of a part that people push and bend: a unit that the file
/// states is believed from 0.5 mm to 20 m, the millimetres that are taken where it states none from 2 mm to 10 m.
/// Proposed is the first of lengthUnits() that makes the longest side 10 mm to 5 m, between a nut and a car; where none
/// does, there is nothing better to propose and so no remark.
/// "bearing.iges: the part is 0.12 mm long; if its lengths are metres, it is 122 mm."
std::optional<UnitRemark> unitRemark(const Model& model);

} // namespace knead
