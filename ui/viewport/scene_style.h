#pragma once

#include "core/model/part.h"

namespace knead {

/// Colors of the view, one set per theme.
struct SceneStyle {
    Color top; ///< of the background gradient
    Color bottom;
    Color edge;         ///< feature edges
    Color selectedEdge; ///< of the selected body
    Color grid;
    Color tool;
    Color selectedTool;
    Color force;
    Color openEdge;  ///< where a surface ends
    Color highlight; ///< face under the cursor
    Color fixed;     ///< fixed faces
    Color cube;
    Color cubeText;
};

SceneStyle lightScene();
SceneStyle darkScene();

} // namespace knead
