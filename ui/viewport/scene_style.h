#pragma once

#include "core/model/part.h"

namespace knead {

/// Colors of the view, one set per theme.
struct SceneStyle {
    Color top; ///< of the background gradient
    Color bottom;
    Color edge;          ///< feature edges
    Color selectedEdge;  ///< of the selected body; of selected faces
    Color selectedOther; ///< of selected faces whose own color is like that
    Color grid;
    Color tool;
    Color selectedTool;
    Color force;
    Color openEdge;       ///< where a surface ends
    Color highlight;      ///< face under the cursor
    Color highlightOther; ///< on faces whose own color is like that
    Color fixed;          ///< fixed faces
    Color cube;
    Color cubeText;
};

/// The usual color of a mark, or the other one where the usual one is hard to tell from what it lies on.
const Color& standingOut(const Color& ground, const Color& usual, const Color& other);
/// How different two colors look, 0 .. 3: differences of the channels, weighted as eyes do.
double differenceOf(const Color& a, const Color& b);

SceneStyle lightScene();
SceneStyle darkScene();

} // namespace knead
