#pragma once

#include "core/mechanics/tool_shape.h"

#include <QString>

#include <vector>

namespace knead {

/// A measure that a person sees: which edge of the tool's box it is.
struct ToolMeasure {
    const char* name; ///< "Diameter", for ToolPanel to translate
    int axis;         ///< of Manipulator::size
};

/// A form of tools as the window offers it.
struct ToolKindLook {
    ToolKind kind;
    const char* name; ///< "Ball", for Actions to translate
    const char* icon;
    std::vector<ToolMeasure> measures; ///< those it has
    Vec3 proportions;                  ///< of a new one, in blocks
    bool rollsFreely = false;
};

/// Tools that a person may add: all forms but parts, which come from files, and those of their forms that cut.
const std::vector<ToolKindLook>& toolsToAdd();
/// All forms, in the order of menus.
const std::vector<ToolKindLook>& toolKindLooks();
const ToolKindLook& lookOf(ToolKind kind);

} // namespace knead
