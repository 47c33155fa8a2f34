#pragma once

#include "core/model/export_job.h"

#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <vector>

namespace knead {

/// A part with another shape, as if it had come so.
/// @param shape [mm]
/// @param origin per face, in the order of TopExp: that of the part whose color and name it has; others have none
PartToExport withShape(const PartToExport& part, const TopoDS_Shape& shape, const std::vector<std::uint32_t>& origin);

} // namespace knead
