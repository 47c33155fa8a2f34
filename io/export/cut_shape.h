#pragma once

#include "core/model/export_job.h"

#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <optional>
#include <vector>

namespace knead {

/// A piece of a solid that knives cut apart.
struct CutShape {
    TopoDS_Shape shape; ///< [mm]
    std::vector<std::uint32_t>
        origin; ///< per face, in the order of TopExp: that of the whole; noFace: where it was cut
    static constexpr std::uint32_t noFace = 0xffffffffU;
};

/// Cuts the faces of a solid where knives went: along planes where they went straight, else along smooth surfaces that lie within a
/// fraction of a spacing of where they were. Neighbors are cut by the same face, so that their volumes add up.
/// @param whole at rest [mm]
/// @return none where the cuts do not part the solid so that the piece can be told from the others, or not soundly
std::optional<CutShape> cutShape(const TopoDS_Shape& whole, const PieceCut& cut);

} // namespace knead
