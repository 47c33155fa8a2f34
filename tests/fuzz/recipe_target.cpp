#include "fuzz/scratch_file.h"
#include "fuzz/targets.h"
#include "io/recipe/recipe_reader.h"
#include "io/recipe/recipe_text.h"
#include "io/study/study_reader.h"
#include "support/full_recipes.h"

namespace knead::fuzz {

namespace {

const std::string recipePath = KNEAD_RESOURCES "/examples/tried.recipe.json"; // beside the parts of the examples

/// With another file, which is there, in place of that which they name.
std::string withPart(std::string text)
{
    const std::string named = "bar.stl";
    for (std::size_t place = text.find(named); place != text.npos; place = text.find(named, place + 1))
        text.replace(place, named.size(), "bar.step");
    return text;
}

std::vector<std::string> recipeTexts()
{
    std::vector<std::string> texts;
    for (const auto& recipe : recipe_texts::fullRecipes())
        texts.push_back(withPart(recipe.dump()));
    texts.push_back(R"({"version": 1, "part": ")" KNEAD_RESOURCES R"(/examples/bar.step", "faces": {"bar": [1, 2]},
        "tolerance_mm": 0.1, "rounds": 4, "factor": 0.8, "smoothing_mm": 2, "best_fit": true, "command": ["ccx", "a"],
        "field": {"file": "a.frd", "step": 2, "name": "DISP", "unit": "mm", "in_place": true}})");
    return texts;
}

Recipe recipeIn(const std::string& text)
{
    return readRecipeText(text, recipePath, recipe_texts::presets);
}

/// Not all that can be read can be told as a recipe again: parts beside the first that were placed, pictures.
void requireSameTold(const Recipe& recipe)
{
    const auto told = [](const Recipe& one) { return recipeText(one, recipePath, recipe_texts::presets); };
    if (isTaken([&] { told(recipe); }))
        requireSameBack(recipe, told, recipeIn);
}

bool readRecipeOrStudy(std::string_view bytes)
{
    static const ScratchFile file("study.json");
    const bool isStudy = isTaken([&] { readStudy(file.with(bytes)); });
    return isTaken([&] { requireSameTold(recipeIn(std::string(bytes))); }) || isStudy;
}

} // namespace

Target recipeTarget()
{
    return {recipeTexts, readRecipeOrStudy};
}

} // namespace knead::fuzz
