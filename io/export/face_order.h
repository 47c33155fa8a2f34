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

/// Finds faces that were read back. They come in the order in which they were written, but in shells of which OpenCASCADE turned
/// faces, where it begins at the first one and goes on to its neighbors. A face is the one of its number when their edges lie
/// at the same place, else the nearest of those that are left.
/// @param near how far the middles of their edges may be apart [mm], > 0
/// @return per face of `back`, in the order of TopExp, the number of that of `written`, each once; none when they are not as many, or
/// when nothing says where an edge is
std::vector<std::uint32_t> orderReadBack(const TopoDS_Shape& written, const TopoDS_Shape& back, double near);

} // namespace knead
