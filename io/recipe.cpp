#include "io/recipe.h"

#include "io/json_reader.h"
#include "io/recipe_sections.h"

#include <algorithm>
#include <filesystem>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr double longestDuration = 3600; // [s]; a longer run is a mistyped number

std::string readPartPath(const JsonNode& part, const std::string& recipePath)
{
    part.allowOnly({"file"});
    const JsonNode file = part.at("file");
    const fs::path path = fs::path(recipePath).parent_path() / file.text();
    std::error_code error;
    if (!fs::is_regular_file(path, error))
        file.fail("names a file that does not exist: " + path.lexically_normal().string() +
                  ". The path is taken from the folder of the recipe.");
    return path.lexically_normal().string();
}

RecipeResolution readResolution(const JsonNode& root)
{
    const auto spacing = root.find("spacing_mm");
    const auto cells = root.find("cells_across");
    const auto objects = root.find("objects");
    if (spacing.has_value() + cells.has_value() + objects.has_value() != 1)
        root.fail("must have exactly one of the keys spacing_mm, cells_across and objects.");
    using Kind = RecipeResolution::Kind;
    if (spacing)
        return {Kind::Spacing, spacing->positive() * millimeter};
    if (cells)
        return {Kind::CellsAcross, cells->number(2, 1000)};
    return {Kind::Objects, objects->number(8, 2e7)};
}

std::vector<std::pair<std::string, Material>> readBodyMaterials(const JsonNode& node, const Material& base,
                                                                const std::vector<MaterialPreset>& presets)
{
    std::vector<std::pair<std::string, Material>> materials;
    for (const std::string& body : node.keys())
        materials.emplace_back(body, readRecipeMaterial(node.at(body), presets).on(base));
    return materials;
}

RecipeFloor readFloor(const JsonNode& node)
{
    node.allowOnly({"height_mm", "friction"});
    RecipeFloor floor;
    floor.height = node.at("height_mm").number() * millimeter;
    if (const auto friction = node.find("friction"))
        floor.friction = friction->number(0, 2);
    return floor;
}

template <class Named>
void checkNameIsNew(const JsonNode& node, const std::vector<Named>& others, const std::string& name)
{
    const auto same = [&](const Named& other) { return other.name == name; };
    if (std::any_of(others.begin(), others.end(), same))
        node.at("name").fail("is used twice: \"" + name + "\".");
}

std::vector<RecipeFixture> readFixtures(const JsonNode& node)
{
    std::vector<RecipeFixture> fixtures;
    for (const JsonNode& item : node.items()) {
        RecipeFixture fixture = readRecipeFixture(item);
        checkNameIsNew(item, fixtures, fixture.name);
        fixtures.push_back(std::move(fixture));
    }
    return fixtures;
}

std::vector<Manipulator> readManipulators(const JsonNode& node)
{
    std::vector<Manipulator> manipulators;
    for (const JsonNode& item : node.items()) {
        Manipulator manipulator = readRecipeManipulator(item);
        checkNameIsNew(item, manipulators, manipulator.name);
        manipulators.push_back(std::move(manipulator));
    }
    return manipulators;
}

std::vector<RecipeExport> readExports(const JsonNode& node)
{
    std::vector<RecipeExport> exports;
    for (const JsonNode& item : node.items()) {
        RecipeExport wanted = readRecipeExport(item);
        const auto same = [&](const RecipeExport& other) { return other.file == wanted.file; };
        if (std::any_of(exports.begin(), exports.end(), same))
            item.at("file").fail("is written twice: \"" + wanted.file + "\".");
        exports.push_back(std::move(wanted));
    }
    return exports;
}

/// Finds the names an event refers to in the sections they come from.
void checkEventNames(const JsonNode& node, const RecipeAction& action, const Recipe& recipe)
{
    const auto check = [&](const std::string& key, const auto& named, const std::string& name) {
        const auto same = [&](const auto& one) { return one.name == name; };
        if (std::none_of(named.begin(), named.end(), same))
            node.at(key).fail("names \"" + name + "\", which is not in the recipe.");
    };
    if (const auto* release = std::get_if<ReleaseFixture>(&action))
        check("remove_fixture", recipe.fixtures, release->fixture);
    if (const auto* away = std::get_if<TakeManipulatorAway>(&action))
        check("remove_manipulator", recipe.manipulators, away->manipulator);
}

std::vector<RecipeEvent> readEvents(const JsonNode& node, const Recipe& recipe,
                                    const std::vector<MaterialPreset>& presets)
{
    std::vector<RecipeEvent> events;
    for (const JsonNode& item : node.items()) {
        RecipeEvent event = readRecipeEvent(item, presets, recipe.duration);
        checkEventNames(item, event.action, recipe);
        if (!events.empty() && event.time < events.back().time)
            item.at("time_s").failExpecting("must not be earlier than that of the event before it");
        events.push_back(std::move(event));
    }
    return events;
}

} // namespace

Material RecipeMaterial::on(const Material& base) const
{
    Material material = preset.value_or(base);
    for (const auto& [member, number] : overrides)
        material.*member = number;
    return material;
}

bool RecipeExport::isPicture() const
{
    return lowerCaseEnding(file) == "png";
}

Recipe readRecipe(const std::string& path, const std::vector<MaterialPreset>& presets)
{
    const JsonNode root = JsonNode::readFile(path);
    root.allowOnly({"version", "part", "spacing_mm", "cells_across", "objects", "material", "body_materials",
                    "fixtures", "manipulators", "gravity_m_s2", "floor", "duration_s", "events", "exports"});
    root.at("version").integer(1, 1);

    Recipe recipe;
    recipe.file = path;
    recipe.part = readPartPath(root.at("part"), path);
    recipe.resolution = readResolution(root);
    recipe.duration = root.at("duration_s").positive();
    if (recipe.duration > longestDuration)
        root.at("duration_s").failExpecting("must be at most 3600 s");
    if (const auto node = root.find("material"))
        recipe.material = readRecipeMaterial(*node, presets).on(Material{});
    if (const auto node = root.find("body_materials"))
        recipe.bodyMaterials = readBodyMaterials(*node, recipe.material, presets);
    if (const auto node = root.find("fixtures"))
        recipe.fixtures = readFixtures(*node);
    if (const auto node = root.find("manipulators"))
        recipe.manipulators = readManipulators(*node);
    if (const auto node = root.find("gravity_m_s2"))
        recipe.gravity = readVector(*node, strongestGravity);
    if (const auto node = root.find("floor"))
        recipe.floor = readFloor(*node);
    if (const auto node = root.find("events"))
        recipe.events = readEvents(*node, recipe, presets);
    if (const auto node = root.find("exports"))
        recipe.exports = readExports(*node);
    return recipe;
}

} // namespace knead
