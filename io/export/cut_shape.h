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

/// Takes a hair's breadth of material out where a knife went into a solid, so that the sides of the cut are two faces: planes that
/// meet at its tip. Faces of the whole on both sides of its plane come in two.
/// @param whole at rest [mm]
/// @return none where the result is not one sound solid for each there was
std::optional<CutShape> slitShape(const TopoDS_Shape& whole, const KnifeSlit& slit);

} // namespace knead
