#pragma once

#include "core/aggregate/material.h"
#include "support/recipe_texts.h"

#include <vector>

namespace knead::recipe_texts {

/// As sessions are told.
inline json session()
{
    return json::parse(R"({"version": 1, "part": {"files": ["bar.stl", "bar.stl"], "parts": ["a/b"], "unit": "inch",
        "heal": false, "cap_flat_openings": true, "deflection_mm": 0.1, "relative_deflection": 0.001,
        "angular_deflection_rad": 0.3, "fills_open_parts": true}, "spacing_mm": 3,
        "deform": [{"kind": "bend", "axis": [1, 0, 0], "side": [0, 1, 0], "from_mm": 0, "to_mm": 9, "radius_mm": 20},
                   {"kind": "twist", "axis": [1, 0, 0], "from_mm": 0, "to_mm": 9, "angle_rad": 1},
                   {"kind": "scale", "axis": [1, 0, 0], "from_mm": 0, "to_mm": 9, "factor": 2},
                   {"kind": "shear", "axis": [1, 0, 0], "side": [0, 1, 0], "from_mm": 0, "to_mm": 9, "shift_mm": 2},
                   {"kind": "bend", "body": ["Bar", "lid"], "axis": [1, 0, 0], "side": [0, 1, 0], "from_mm": 0, "to_mm": 9,
                    "angle_deg": 3, "k_factor": 0.4, "separately": true},
                   {"field": "bar.stl", "in_place": true, "kept_faces": [{"body": "Bar", "faces": [1]}], "fade_mm": 5,
                    "separately": true}], "duration_steps": 500,
        "bodies": {"lid": {"angular_velocity_rad_s": [0, 0, 1]}},
        "fixtures": [{"name": "end", "body": "lid", "objects": [3, [7, 9]], "objects_in_body": 20,
                      "velocity_mm_s": [0, 0, 1],
                      "turn": {"center_mm": [0, 0, 0], "angular_velocity_rad_s": [0, 0, 1], "angle_rad": 1}}],
        "manipulators": [{"name": "a", "size_mm": [1, 2, 3], "position_mm": [0, 0, 0], "rotation_wxyz": [1, 0, 0, 0],
                          "motion": {"velocity_mm_s": [0, 0, 1], "angular_velocity_rad_s": [0, 0, 1]}},
                         {"name": "b", "kind": "part", "part_file": "bar.stl", "part_number": 1, "position_mm": [0, 0, 0]}],
        "events": [{"step": 0, "material": "clay", "body": "lid", "objects": [1], "objects_in_body": 20},
                   {"step": 0, "renormalize": {"body": "lid", "objects": [1], "objects_in_body": 20}},
                   {"step": 1, "floor": {"height_mm": -1, "friction": 0.3}}, {"step": 1, "integrator": "implicit-euler"},
                   {"step": 2, "add_fixture": {"name": "grip", "faces": [1]}},
                   {"step": 2, "move_fixture": {"name": "grip", "velocity_mm_s": [1, 0, 0]}},
                   {"step": 2, "move_fixture": {"name": "grip", "turn": {"center_mm": [1, 2, 3], "axis": [0, 0, 1],
                    "speed_deg_s": 90, "angle_deg": 45}}},
                   {"step": 2, "add_load": {"name": "push", "body": "lid", "faces": [1, 2], "force_n": [0, 0, -5],
                    "moment_nm": [0, 1, 0], "pressure_pa": 1e5, "ramp_s": 1}},
                   {"step": 2, "change_load": {"name": "push", "force_n": [0, 0, -5], "moment_nm": [0, 1, 0],
                    "pressure_pa": 1e5, "ramp_s": 1}},
                   {"step": 2, "remove_load": "push"},
                   {"step": 3, "add_manipulator": {"name": "c", "kind": "ball", "size_mm": 3, "position_mm": [0, 0, 0],
                    "motion": {"go_to": {"position_mm": [0, 0, 1], "rotation_wxyz": [0, 1, 0, 0]}}}},
                   {"step": 4, "move_manipulator": {"name": "c", "path": [[0, 1, 2, 3], [2, 1, 2, 4, 0, 1, 0, 0]]}},
                   {"step": 9, "move_manipulator": {"name": "c", "velocity_mm_s": [0, 0, 1],
                    "angular_velocity_rad_s": [0, 1, 0]}},
                   {"step": 9, "move_manipulator": {"name": "c", "hold": true}},
                   {"step": 9, "move_manipulator": {"name": "c", "keyframes": [{"time_s": 0, "position_mm": [0, 0, 0],
                    "rotation_wxyz": [1, 0, 0, 0]}, {"time_s": 1, "rotation_deg": [1, 2, 3]}]}},
                   {"step": 9, "place_manipulator": {"name": "c", "position_mm": [0, 0, 9], "rotation_deg": [0, 0, 9]}},
                   {"step": 9, "reshape_manipulator": {"name": "c", "kind": "cylinder", "size_mm": [3, 4], "friction": 1,
                    "speed_limit_mm_s": 9, "force_limit_n": 9, "rolls_freely": false}},
                   {"step": 9, "keep_moment": ""}, {"step": 9, "reset": true},
                   {"step": 1, "renormalize": {"body": "lid", "objects": [1], "objects_in_body": 22, "filled_anew": true}},
                   {"step": 1, "material": "clay", "body": "lid", "objects": [1], "objects_in_body": 22, "filled_anew": true},
                   {"step": 1, "add_fixture": {"name": "late", "body": "lid", "objects": [1], "objects_in_body": 22,
                    "filled_anew": true}}]})");
}

/// Recipes that together have everything in them.
inline std::vector<json> fullRecipes()
{
    json recipe = json::parse(R"({"version": 1, "part": {"file": "bar.stl"}, "objects": 500, "duration_s": 2,
        "deform": [{"kind": "bend", "body": "Bar", "origin_mm": [0, 0, 5], "axis": [2, 0, 0], "side": [0, 0, 1], "from_mm": 10,
                    "to_mm": 40, "stays": 0.5, "eases": true, "angle_deg": 30, "neutral_mm": 1},
                   {"field": "bar.stl", "body": "Bar", "step": 2, "name": "U", "unit": "mm", "factor": -1, "kept_faces": [1],
                    "fade_mm": 5, "locked": ["z"]}],
        "extra_parts": [{"file": "bar.stl", "name": "lid", "position_mm": [1, 2, 3], "rotation_deg": [0, 0, 90]}],
        "arrangement": "cut-cells", "material": {"preset": "clay", "friction": 1}, "body_materials": {"lid": "rubber"},
        "regions": [{"name": "hard", "body": "lid", "faces": [0, 3], "material": {"youngs_modulus_pa": 1e6}}],
        "bodies": {"lid": {"kind": "rigid", "velocity_mm_s": [0, 0, 1], "angular_velocity_deg_s": [0, 0, 1]}},
        "touching": "glued", "structural_friction": 1, "gravity_m_s2": [0, 0, -9.8],
        "fixtures": [{"name": "end", "body": "lid", "box_mm": [0, 0, 0, 1, 1, 1], "moment_center_mm": [1, 2, 3]}],
        "loads": [{"name": "wind", "box_mm": [0, 0, 0, 1, 1, 1], "pressure_pa": 100}],
        "probes": [{"name": "tip", "body": "lid", "place_mm": [1, 2, 3]}], "analysis": "dynamic",
        "manipulators": [{"name": "a", "size_mm": [1, 2, 3], "position_mm": [0, 0, 0], "rotation_deg": [1, 2, 3],
                          "friction": 1, "speed_limit_mm_s": 1e9, "force_limit_n": 5,
                          "keyframes": [{"time_s": 1, "position_mm": [1, 2, 3], "rotation_deg": [1, 2, 3]}]},
                         {"name": "b", "kind": "ball", "size_mm": 3, "position_mm": [0, 0, 0]},
                         {"name": "c", "kind": "cylinder", "size_mm": [3, 4], "position_mm": [0, 0, 0], "rolls_freely": true},
                         {"name": "d", "kind": "part", "part_file": "bar.stl", "position_mm": [0, 0, 0]}],
        "floor": {"height_mm": -1, "friction": 1}, "integrator": "automatic", "vicinity": "brute-force", "refilling": true,
        "time_step_s": 1e-4, "mass_scaling_time_step_s": 1e-4,
        "events": [{"time_s": 0, "material": {"preset": "clay"}, "body": "lid", "box_mm": [0, 0, 0, 1, 1, 1]},
                   {"time_s": 0, "remove_fixture": "end"}, {"time_s": 0, "remove_manipulator": "a"},
                   {"time_s": 0, "gravity_m_s2": [0, 0, 0]},
                   {"time_s": 0, "renormalize": {"body": "lid", "box_mm": [0, 0, 0, 1, 1, 1], "duration_s": 1}},
                   {"time_s": 0, "body_kind": {"body": "lid", "kind": "glue"}},
                   {"time_s": 0, "find_balance_s": 0.1}, {"time_s": 0, "refill": {"body": "lid", "spacing_mm": 2}},
                   {"time_s": 0, "cut": {"body": "lid", "point_mm": [1, 2, 3], "normal": [0, 0, 1]}},
                   {"time_s": 0, "deform_by_physics": {"name": "hand", "kind": "bend", "body": "lid", "origin_mm": [0, 0, 5],
                    "axis": [1, 0, 0], "side": [0, 0, 1], "from_mm": 10, "to_mm": 40, "stays": 0.5, "angle_deg": 30,
                    "neutral_mm": 1, "duration_s": 0.5, "let_go": true}}],
        "exports": [{"file": "a.step", "unit": "mm", "tolerance_mm": 0.1, "ap214": true, "report": false},
                    {"file": "b.PNG", "width": 20, "height": 20, "view": "front", "show_tools": false},
                    {"file": "c/d.png", "view": [0, 1, 0]}]})");
    for (const MaterialField& field : materialFields())
        recipe["material"][field.key] = field.maximum;
    std::vector<json> recipes{recipe, session()};
    for (const char* key : {"spacing_mm", "cells_across", "cells_across_wall"}) {
        recipes.push_back(smallest());
        recipes.back().erase("objects");
        recipes.back()[key] = 3;
    }
    recipes[2]["arrangement"] = "published";
    recipes[3]["analysis"] = "static";
    recipes[3]["load_steps"] = 5;
    return recipes;
}

} // namespace knead::recipe_texts
