#pragma once

#include "app/sweep/variation.h"
#include "io/recipe/recipe_override.h"

#include <cstddef>
#include <string>
#include <vector>

namespace knead {

/// A file that the results depend on.
struct SweepInput {
    std::string file;   ///< absolute path
    std::string digest; ///< SHA-256 of its bytes, hexadecimal
};

/// A recipe and the changes that each point of a sweep makes to it. Kept in the folder of the sweep as sweep.json, so that a
/// point can be carried out by any process, and that a sweep is only gone on with when nothing has changed.
struct SweepPlan {
    std::string program;                  ///< version of Knead
    std::string recipe;                   ///< absolute path
    std::vector<RecipeOverride> settings; ///< of all points
    std::vector<std::string> paths;       ///< that vary
    SweepPoints points;                   ///< a value per path
    bool keepsExports = false;
    std::vector<SweepInput> inputs; ///< the recipe, the materials and the parts

    std::string key; ///< equal for plans with equal results, wherever their files lie

    /// What a point changes in the recipe.
    std::vector<RecipeOverride> changesOf(std::size_t point) const;
};

/// What a person asks for.
struct SweepRequest {
    std::string recipe;
    std::vector<std::string> settings;   ///< "PATH=VALUE"
    std::vector<std::string> variations; ///< as parseVariation() reads them
    Combination combination = Combination::grid;
    bool keepsExports = false;
};

/// Reads the recipe as every point has it.
/// @throws std::runtime_error, in a sentence, for wishes that cannot be read, and when not one point is a recipe
SweepPlan makePlan(const SweepRequest& request);

/// Why results of one plan are none of another; empty when they are.
std::string differenceOf(const SweepPlan& before, const SweepPlan& now);

/// The name of the first input that is no longer what it was; empty when all are.
std::string changedInput(const SweepPlan& plan);

std::string planToJson(const SweepPlan& plan);
/// @throws std::exception when the text is no plan
SweepPlan planFromJson(const std::string& text);

} // namespace knead
