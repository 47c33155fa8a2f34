#include "app/sweep/sweep_plan.h"

#include "app/file_content.h"
#include "app/resources.h"
#include "io/material_library.h"
#include "io/recipe/recipe_reader.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <stdexcept>

namespace knead {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

std::string nameOf(const SweepInput& input)
{
    return fs::path(input.file).filename().string();
}

std::vector<std::string> filesOf(const Recipe& recipe)
{
    std::vector<std::string> files{recipe.part};
    files.insert(files.end(), recipe.partsBeside.begin(), recipe.partsBeside.end());
    for (const RecipeExtraPart& part : recipe.extraParts)
        files.push_back(part.file);
    for (const RecipeManipulator& manipulator : recipe.manipulators)
        if (!manipulator.partFile.empty())
            files.push_back(manipulator.partFile);
    for (const RecipeEvent& event : recipe.events)
        if (const auto* add = std::get_if<AddRecipeManipulator>(&event.action))
            files.push_back(add->manipulator.partFile);
        else if (const auto* reshape = std::get_if<ReshapeRecipeManipulator>(&event.action))
            files.push_back(reshape->manipulator.partFile);
    std::erase(files, std::string());
    return files;
}

/// Files that readable points name. Points that are no recipe become rows that say so, unless all of them are.
std::set<std::string> partsOf(const SweepPlan& plan)
{
    const std::vector<MaterialPreset> presets = readMaterials(materialsFile());
    std::set<std::string> files;
    std::string failure;
    for (std::size_t i = 0; i < plan.points.size(); ++i)
        try {
            const std::vector<std::string> named = filesOf(readRecipe(plan.recipe, presets, plan.changesOf(i)));
            files.insert(named.begin(), named.end());
        } catch (const std::runtime_error& error) {
            if (failure.empty())
                failure = error.what();
        }
    if (files.empty())
        throw std::runtime_error(failure);
    return files;
}

std::vector<SweepInput> inputsOf(const SweepPlan& plan)
{
    std::vector<std::string> files{plan.recipe, materialsFile()};
    for (const std::string& part : partsOf(plan))
        files.push_back(fs::absolute(part).lexically_normal().string());
    std::vector<SweepInput> inputs(files.size());
    std::transform(files.begin(), files.end(), inputs.begin(), [](const std::string& file) {
        return SweepInput{file, digestOf(file)};
    });
    return inputs;
}

Json settingsToJson(const std::vector<RecipeOverride>& settings)
{
    Json list = Json::array();
    for (const RecipeOverride& setting : settings)
        list.push_back(setting.path + "=" + setting.value);
    return list;
}

/// All that the results depend on.
Json identityOf(const SweepPlan& plan)
{
    Json inputs = Json::array();
    for (const SweepInput& input : plan.inputs)
        inputs.push_back(Json::array({nameOf(input), input.digest}));
    return {{"program", plan.program}, {"set", settingsToJson(plan.settings)}, {"vary", plan.paths},
            {"points", plan.points},   {"exports", plan.keepsExports},         {"inputs", inputs}};
}

std::string keyOf(const SweepPlan& plan)
{
    return digestOfText(identityOf(plan).dump(-1, ' ', false, Json::error_handler_t::replace));
}

bool hasInput(const SweepPlan& plan, const SweepInput& wanted)
{
    return std::any_of(plan.inputs.begin(), plan.inputs.end(), [&](const SweepInput& input) {
        return nameOf(input) == nameOf(wanted) && input.digest == wanted.digest;
    });
}

} // namespace

std::vector<RecipeOverride> SweepPlan::changesOf(std::size_t point) const
{
    std::vector<RecipeOverride> changes = settings;
    for (std::size_t i = 0; i < paths.size(); ++i)
        changes.push_back({paths[i], points[point][i]});
    if (!keepsExports)
        changes.push_back({"exports", "null"});
    return changes;
}

SweepPlan makePlan(const SweepRequest& request)
{
    SweepPlan plan;
    plan.program = KNEAD_VERSION;
    plan.recipe = fs::absolute(request.recipe).lexically_normal().string();
    plan.keepsExports = request.keepsExports;
    std::transform(request.settings.begin(), request.settings.end(), std::back_inserter(plan.settings), parseOverride);
    std::vector<Variation> variations;
    for (const std::string& text : request.variations) {
        variations.push_back(parseVariation(text));
        plan.paths.push_back(variations.back().path);
    }
    plan.points = combine(variations, request.combination);
    plan.inputs = inputsOf(plan);
    plan.key = keyOf(plan);
    return plan;
}

std::string differenceOf(const SweepPlan& before, const SweepPlan& now)
{
    if (before.key == now.key)
        return "";
    if (before.program != now.program)
        return "it was made by Knead " + before.program + ", and this is " + now.program;
    if (settingsToJson(before.settings) != settingsToJson(now.settings))
        return "--set was another";
    if (before.paths != now.paths || before.points != now.points)
        return "--vary was another";
    if (before.keepsExports != now.keepsExports)
        return before.keepsExports ? "it had --exports" : "it had no --exports";
    for (const SweepInput& input : now.inputs)
        if (!hasInput(before, input))
            return nameOf(input) + " has changed since";
    return "its files have changed since";
}

std::string changedInput(const SweepPlan& plan)
{
    for (const SweepInput& input : plan.inputs)
        if (digestOf(input.file) != input.digest)
            return nameOf(input);
    return "";
}

std::string planToJson(const SweepPlan& plan)
{
    Json json = identityOf(plan);
    json["recipe"] = plan.recipe;
    json["inputs"] = Json::array();
    for (const SweepInput& input : plan.inputs)
        json["inputs"].push_back({{"file", input.file}, {"sha256", input.digest}});
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

SweepPlan planFromJson(const std::string& text)
{
    const Json json = Json::parse(text);
    SweepPlan plan;
    plan.program = json.at("program");
    plan.recipe = json.at("recipe");
    for (const std::string setting : json.at("set"))
        plan.settings.push_back(parseOverride(setting));
    plan.paths = json.at("vary").get<std::vector<std::string>>();
    plan.points = json.at("points").get<SweepPoints>();
    plan.keepsExports = json.at("exports");
    for (const Json& input : json.at("inputs"))
        plan.inputs.push_back({input.at("file"), input.at("sha256")});
    plan.key = keyOf(plan);
    return plan;
}

} // namespace knead
