#pragma once

#include "core/session/material_look.h"
#include "ui/viewport/color_scale.h"
#include "ui/viewport/scene_style.h"

class vtkActor;

namespace knead {

/// How a skin answers light, where its colors do not tell values.
enum class Shading {
    usual,     ///< in the colors of the part, dull or shining as its material is
    clay,      ///< all parts in one matt color, so that nothing but their shape is seen
    polished,  ///< in the colors of the part, as polished metal in a studio
    zebra,     ///< mirrors a room of black and white stripes, which show how smoothly faces go over into each other
    curvature, ///< blue in hollows, white where it is flat, orange on ridges and bumps
    wax,       ///< in the colors of the part, soft, with light that comes through at its rims
    chrome,    ///< without color, mirrors a bright sky above a dark ground
    porcelain  ///< white and glazed, with two windows mirrored in it
};

/// The color of faces for a shading, of those that the part has.
Color colorFor(Shading shading, const Color& own);

/// What the color of a vertex is multiplied with where the shading tells curvature: that of the map over that of flat
/// places, so that marks on faces stay visible. @param bend see bendOfShade()
Color curvatureTint(float bend);

/// The legend of Shading::curvature: colors by words instead of numbers.
ColorScale curvatureScale();
ScaleText curvatureText();

/// Has faces drawn so. Costs nothing where they are already.
void shadeFaces(vtkActor& faces, Shading shading, MaterialLook look);

} // namespace knead
