#pragma once

#include "core/session/material_look.h"
#include "ui/viewport/scene_style.h"

class vtkActor;

namespace knead {

/// How a skin answers light, where its colors do not tell values.
enum class Shading {
    usual,    ///< in the colors of the part, dull or shining as its material is
    clay,     ///< all parts in one matt color, so that nothing but their shape is seen
    polished, ///< in the colors of the part, as polished metal in a studio
    zebra     ///< mirrors a room of black and white stripes, which show how smoothly faces go over into each other
};

/// The color of faces for a shading, of those that the part has.
Color colorFor(Shading shading, const Color& own);

/// Has faces drawn so. Costs nothing where they are already.
void shadeFaces(vtkActor& faces, Shading shading, MaterialLook look);

} // namespace knead
