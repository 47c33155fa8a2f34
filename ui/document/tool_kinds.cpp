#include "ui/document/tool_kinds.h"

#include <algorithm>

namespace knead {

const std::vector<ToolKindLook>& toolKindLooks()
{
    static const std::vector<ToolKindLook> looks{
        {ToolKind::box, "Block", "block", {{"Size X", 0}, {"Size Y", 1}, {"Size Z", 2}}, {1, 1, 1}},
        {ToolKind::ball, "Ball", "ball", {{"Diameter", 0}}, {1, 1, 1}},
        {ToolKind::cylinder, "Cylinder", "cylinder", {{"Diameter", 0}, {"Length", 2}}, {0.8, 0.8, 1.2}},
        {ToolKind::wedge, "Wedge", "wedge", {{"Edge", 0}, {"Back", 1}, {"Height", 2}}, {1.4, 0.6, 1}},
        {ToolKind::plate, "Plate", "plate", {{"Size X", 0}, {"Size Y", 1}, {"Thickness", 2}}, {1.6, 1.6, 0.2}},
        {ToolKind::part, "Part", "part", {}, {1, 1, 1}},
    };
    return looks;
}

const ToolKindLook& lookOf(ToolKind kind)
{
    const auto& looks = toolKindLooks();
    return *std::find_if(looks.begin(), looks.end(), [kind](const ToolKindLook& look) { return look.kind == kind; });
}

} // namespace knead
