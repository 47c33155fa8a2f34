// Events of a recipe: what changes on the way.
#include "io/recipe_sections.h"
#include "io/recipe_values.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double longestAnnealing = 3600; // [s]

const std::vector<std::string>& actionKeys()
{
    static const std::vector<std::string> keys{"material",     "remove_fixture", "remove_manipulator",
                                               "gravity_m_s2", "renormalize",    "body_kind"};
    return keys;
}

/// The one key that says what happens.
std::string actionOf(const JsonNode& node)
{
    std::vector<std::string> found;
    for (const std::string& key : actionKeys())
        if (node.find(key))
            found.push_back(key);
    if (found.size() > 1)
        node.fail("must have only one of the keys " + found[0] + " and " + found[1] + ".");
    if (found.empty())
        node.fail("must have exactly one of the keys " + listed(actionKeys(), [](const auto& key) { return key; }) +
                  ".");
    return found.front();
}

std::string readOptionalText(const JsonNode& node, const std::string& key)
{
    const auto text = node.find(key);
    return text ? text->text() : "";
}

std::optional<Box> readOptionalBox(const JsonNode& node)
{
    const auto box = node.find("box_mm");
    return box ? std::optional(readBox(*box)) : std::nullopt;
}

RenormalizeBodies readRenormalize(const JsonNode& node)
{
    node.allowOnly({"body", "box_mm", "duration_s"});
    RenormalizeBodies action{readOptionalText(node, "body"), readOptionalBox(node), 0};
    if (const auto duration = node.find("duration_s"))
        action.duration = duration->number(0, longestAnnealing);
    return action;
}

ChangeBodyKind readChangeOfKind(const JsonNode& node)
{
    node.allowOnly({"body", "kind"});
    return {node.at("body").text(), readBodyKind(node.at("kind"))};
}

RecipeAction readAction(const JsonNode& node, const std::vector<MaterialPreset>& presets)
{
    const std::string key = actionOf(node);
    const JsonNode action = node.at(key);
    if (key != "material")
        for (const char* detail : {"body", "box_mm"})
            if (const auto found = node.find(detail))
                found->fail("belongs to a change of material only.");
    if (key == "material")
        return ChangeMaterial{readOptionalText(node, "body"), readOptionalBox(node),
                              readRecipeMaterial(action, presets)};
    if (key == "remove_fixture")
        return ReleaseFixture{action.text()};
    if (key == "remove_manipulator")
        return TakeManipulatorAway{action.text()};
    if (key == "gravity_m_s2")
        return ChangeGravity{readVector(action, strongestGravity)};
    if (key == "renormalize")
        return readRenormalize(action);
    return readChangeOfKind(action);
}

} // namespace

RecipeEvent readRecipeEvent(const JsonNode& node, const std::vector<MaterialPreset>& presets, double duration)
{
    std::vector<std::string> allowed{"time_s", "body", "box_mm"};
    allowed.insert(allowed.end(), actionKeys().begin(), actionKeys().end());
    node.allowOnly(allowed);
    return {node.at("time_s").number(0, duration), readAction(node, presets)};
}

} // namespace knead
