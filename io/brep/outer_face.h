#pragma once

#include <TopoDS_Face.hxx>

#include <optional>

namespace knead {

/// The face that a closed border means by its direction, on a surface that closes in itself from pole to pole, as a ball does: all
/// of the surface but what is within. The border's edges stay, and so does what meets them.
/// @param face with that border, and perhaps with seams and poles that are of no use
/// @param goesBack the border is meant to run the other way round than it does in `face`
/// @return as oriented that it fits where `face` was; none when the surface is no such one, the border reaches around it, or what is
/// within is meant
std::optional<TopoDS_Face> outerFace(const TopoDS_Face& face, bool goesBack);

} // namespace knead
