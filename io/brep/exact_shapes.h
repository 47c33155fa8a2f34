#pragma once

#include <TopoDS_Shape.hxx>

#include <string>
#include <string_view>
#include <vector>

namespace knead {

/// Shapes as bytes, without triangles; what they share is kept once.
std::string shapesToBytes(const std::vector<TopoDS_Shape>& shapes);

/// The other way, in the same order.
/// @throws Problem when they are something else
std::vector<TopoDS_Shape> shapesFromBytes(std::string_view bytes);

} // namespace knead
