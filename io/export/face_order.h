#pragma once

#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace knead {

/// A shape with the faces of another one, in another order.
struct OrderedShape {
    TopoDS_Shape shape;
    std::vector<std::uint32_t> order; ///< per face, in the order of TopExp: which of the other shape it is
};

/// Puts another face of each solid's outer shell first, and what was before it last. OpenCASCADE, and whoever reads with
/// it, asks by a ray towards the first face whether infinity is inside, and turns the solid inside out if it finds so.
/// Such a ray may graze a face that is wound about itself, as that of a spring is, and be wrong.
/// @param first the number of the face in its shell; modulo how many that has
OrderedShape withFaceFirst(const TopoDS_Shape& shape, std::size_t first);

} // namespace knead
