#pragma once

#include "core/geometry/triangle_mesh.h"
#include "verify/book.h"

#include <string>
#include <vector>

namespace knead::book {

/// A shaded picture of a surface as SVG, seen from the front, right and above.
std::string shadedSvg(const TriangleMesh& mesh);

/// Curves over linear axes as SVG.
/// @param axes "x label;y label"
std::string curvesSvg(const std::vector<Curve>& curves, const std::string& axes);

/// Errors over cells on logarithmic axes as SVG: one curve per quantity, points (cells, |error|).
std::string convergenceSvg(const std::vector<Curve>& errors);

/// Text for HTML and SVG.
std::string escaped(const std::string& text);

} // namespace knead::book
