#pragma once

#include "core/session/render_mesh.h"

#include <span>
#include <vector>

namespace knead {

/// How light each render vertex is drawn so that the eye tells a hollow from a bump: 1 where the surface is flat, darker in hollows
/// and grooves, a little lighter on ridges.
///
///     k = n . (2 / E) sum (x_j - x_i) / |x_j - x_i|,   E = sum |x_j - x_i|        mean curvature, above 0 in hollows
///     shade = 1 - a x / (1 + |x|),   x = k R
///
/// with R a share of the size of what is drawn (the scale-dependent umbrella of Desbrun, Meyer, Schroeder and Barr 1999), averaged over the
/// neighbors. Where triangles are longer than R it fades, since there a shade would spread over a whole face.
/// @param points, normals x y z per render vertex, as they are drawn
std::vector<float> reliefShades(const RenderMesh& mesh, std::span<const float> points, std::span<const float> normals);

/// What a shade of reliefShades() says of the bend: x / (1 + |x|), -1 .. 1, above 0 in hollows, 0 where it is flat.
float bendOfShade(float shade);

} // namespace knead
