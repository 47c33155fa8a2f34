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

const std::vector<ToolKindLook>& toolsToAdd()
{
    static const std::vector<ToolKindLook> tools = [] {
        std::vector<ToolKindLook> all = toolKindLooks();
        std::erase_if(all, [](const ToolKindLook& look) { return look.kind == ToolKind::part; });
        ToolKindLook knife = lookOf(ToolKind::wedge);
        knife.name = "Knife";
        knife.icon = "knife";
        knife.proportions = {3, 0.06, 1.2};
        ToolKindLook wire = lookOf(ToolKind::cylinder);
        wire.name = "Wire";
        wire.icon = "wire";
        wire.proportions = {0.04, 0.04, 4};
        ToolKindLook roller = lookOf(ToolKind::cylinder);
        roller.name = "Roller";
        roller.icon = "roller";
        roller.proportions = {0.7, 0.7, 3};
        roller.rollsFreely = true;
        all.insert(all.end(), {roller, knife, wire});
        return all;
    }();
    return tools;
}

const ToolKindLook& lookOf(ToolKind kind)
{
    const auto& looks = toolKindLooks();
    return *std::find_if(looks.begin(), looks.end(), [kind](const ToolKindLook& look) { return look.kind == kind; });
}

} // namespace knead
