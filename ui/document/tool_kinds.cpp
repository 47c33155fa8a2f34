#include "ui/document/tool_kinds.h"

#include <algorithm>

namespace knead {

const std::vector<ToolKindLook>& toolKindLooks()
{
    static const std::vector<ToolKindLook> looks{
        {ToolKind::box,
         QT_TRANSLATE_NOOP("Actions", "Block"),
         "block",
         {{QT_TRANSLATE_NOOP("ToolPanel", "Size X"), 0},
          {QT_TRANSLATE_NOOP("ToolPanel", "Size Y"), 1},
          {QT_TRANSLATE_NOOP("ToolPanel", "Size Z"), 2}},
         {1, 1, 1}},
        {ToolKind::ball,
         QT_TRANSLATE_NOOP("Actions", "Ball"),
         "ball",
         {{QT_TRANSLATE_NOOP("ToolPanel", "Diameter"), 0}},
         {1, 1, 1}},
        {ToolKind::cylinder,
         QT_TRANSLATE_NOOP("Actions", "Cylinder"),
         "cylinder",
         {{QT_TRANSLATE_NOOP("ToolPanel", "Diameter"), 0}, {QT_TRANSLATE_NOOP("ToolPanel", "Length"), 2}},
         {0.8, 0.8, 1.2}},
        {ToolKind::wedge,
         QT_TRANSLATE_NOOP("Actions", "Wedge"),
         "wedge",
         {{QT_TRANSLATE_NOOP("ToolPanel", "Edge"), 0},
          {QT_TRANSLATE_NOOP("ToolPanel", "Back"), 1},
          {QT_TRANSLATE_NOOP("ToolPanel", "Height"), 2}},
         {1.4, 0.6, 1}},
        {ToolKind::plate,
         QT_TRANSLATE_NOOP("Actions", "Plate"),
         "plate",
         {{QT_TRANSLATE_NOOP("ToolPanel", "Size X"), 0},
          {QT_TRANSLATE_NOOP("ToolPanel", "Size Y"), 1},
          {QT_TRANSLATE_NOOP("ToolPanel", "Thickness"), 2}},
         {1.6, 1.6, 0.2}},
        {ToolKind::part, QT_TRANSLATE_NOOP("Actions", "Part"), "part", {}, {1, 1, 1}},
    };
    return looks;
}

const std::vector<ToolKindLook>& toolsToAdd()
{
    static const std::vector<ToolKindLook> tools = [] {
        std::vector<ToolKindLook> all = toolKindLooks();
        std::erase_if(all, [](const ToolKindLook& look) { return look.kind == ToolKind::part; });
        ToolKindLook knife = lookOf(ToolKind::wedge);
        knife.name = QT_TRANSLATE_NOOP("Actions", "Knife");
        knife.icon = "knife";
        knife.proportions = {3, 0.06, 1.2};
        ToolKindLook wire = lookOf(ToolKind::cylinder);
        wire.name = QT_TRANSLATE_NOOP("Actions", "Wire");
        wire.icon = "wire";
        wire.proportions = {0.04, 0.04, 4};
        ToolKindLook roller = lookOf(ToolKind::cylinder);
        roller.name = QT_TRANSLATE_NOOP("Actions", "Roller");
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
