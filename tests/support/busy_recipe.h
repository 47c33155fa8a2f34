#pragma once

#include <nlohmann/json.hpp>

#include <string>

/// Recipes for those who carry them out without and within the window.
namespace workshop {

/// A bar held at a face is pressed by one block, then by another one that comes later and goes a path, while the material, the
/// gravity and what holds the bar change.
/// @param part the path of bar.step
inline nlohmann::json busyRecipe(const std::string& part)
{
    nlohmann::json recipe = nlohmann::json::parse(R"({
        "version": 1, "cells_across": 20, "duration_s": 1,
        "material": {"youngs_modulus_pa": 4e5, "damping_ratio": 0.2, "shape_damping_per_s": 40},
        "fixtures": [{"name": "end", "faces": [0]}],
        "manipulators": [{"name": "press", "size_mm": [20, 40, 20], "position_mm": [130, 10, 31],
                          "keyframes": [{"time_s": 0.2, "position_mm": [130, 10, 22]}]}],
        "events": [
            {"time_s": 0.05, "material": {"youngs_modulus_pa": 3e5}},
            {"time_s": 0.08, "add_manipulator": {"name": "second", "size_mm": [16, 40, 16], "position_mm": [70, 10, 29]}},
            {"time_s": 0.1, "move_manipulator": {"name": "second", "velocity_mm_s": [0, 0, -60]}},
            {"time_s": 0.12, "add_fixture": {"name": "other end", "faces": [1]}},
            {"time_s": 0.15, "gravity_m_s2": [0, 0, -9.81]},
            {"time_s": 0.2, "move_manipulator": {"name": "press", "go_to": {"position_mm": [130, 10, 30]}}},
            {"time_s": 0.8, "remove_fixture": "other end"},
            {"time_s": 0.9, "remove_manipulator": "second"}
        ]})");
    recipe["part"] = {{"file", part}};
    return recipe;
}

/// A rigid bar that nothing moves, so that its hash stays the same, before a block comes down on it after a third of the time;
/// then gravity sets in.
/// @param part the path of bar.step
inline nlohmann::json lateRecipe(const std::string& part)
{
    nlohmann::json recipe = busyRecipe(part);
    recipe.erase("manipulators");
    recipe.erase("fixtures");
    recipe["bodies"] = {{"Bar", {{"kind", "rigid"}}}};
    recipe["events"] = nlohmann::json::parse(R"([
        {"time_s": 0.05, "add_manipulator": {"name": "late", "size_mm": [16, 40, 16], "position_mm": [70, 10, 33]}},
        {"time_s": 0.08, "move_manipulator": {"name": "late", "velocity_mm_s": [0, 0, -15]}},
        {"time_s": 0.1, "material": {"friction": 0.1}},
        {"time_s": 0.5, "gravity_m_s2": [0, 0, -2]}])");
    return recipe;
}

} // namespace workshop
