#pragma once

#include "io/recipe/recipe_reader.h"

#include <nlohmann/json.hpp>

#include <QTemporaryDir>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace knead::recipe_texts {

using nlohmann::json;

inline const std::vector<MaterialPreset> presets{{"clay", "Clay", "a pit", {1700, 5e5, 0.45, 0.2, 20, 0.5}},
                                                 {"rubber", "Rubber", "a tree", {950, 1e6, 0.49, 0.05, 2, 0.8}}};

/// The smallest recipe; tests add to it.
inline json smallest()
{
    return json::parse(R"({"version": 1, "part": {"file": "bar.stl"}, "objects": 500, "duration_s": 2})");
}

inline json withManipulator(const std::string& manipulator)
{
    json recipe = smallest();
    recipe["manipulators"] = json::array({json::parse(manipulator)});
    return recipe;
}

inline json with(const std::string& key, const std::string& value)
{
    json recipe = smallest();
    recipe[key] = json::parse(value);
    return recipe;
}

/// Reads a recipe that lies beside a part.
inline Recipe readText(const std::string& text, const std::vector<RecipeOverride>& changes = {})
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("bend.recipe.json").toStdString();
    std::ofstream(folder.filePath("bar.stl").toStdString()) << "solid";
    std::ofstream(path) << text;
    return readRecipe(path, presets, changes);
}

inline Recipe parse(const json& recipe, const std::vector<RecipeOverride>& changes = {})
{
    return readText(recipe.dump(), changes);
}

inline std::string messageForText(const std::string& text)
{
    try {
        readText(text);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "accepted";
}

inline std::string messageFor(const json& recipe)
{
    return messageForText(recipe.dump());
}

} // namespace knead::recipe_texts
