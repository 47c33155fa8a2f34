#pragma once

#include <TopoDS_Shape.hxx>

#include <cstdint>
#include <vector>

namespace knead {

/// A shape whose faces are parts of those of another one.
struct DividedShape {
    TopoDS_Shape shape;
    std::vector<std::uint32_t> origin; ///< per face, in the order of TopExp: that of the other shape
};

/// Whether any face closes in itself.
bool hasClosedFaces(const TopoDS_Shape& shape);

/// Divides faces that close in themselves, as those of a hole do, in two: whoever reads a file makes surfaces that close
/// periodic, and then may not find back where a face begins that has short edges at its seam.
/// @return the shape as it is when there are none, or when they cannot be divided
DividedShape withoutClosedFaces(const TopoDS_Shape& shape);

/// Whether a face goes from pole to pole around its surface and has one hole: OpenCASCADE, and programs that read with it, take what
/// is in the hole for the face, see mendFaceSides().
bool hasBoredClosedFaces(const TopoDS_Shape& shape);

} // namespace knead
