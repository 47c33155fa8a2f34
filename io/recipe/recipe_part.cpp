// Which part a recipe is about, and how it is imported.
#include "core/message/message.h"
#include "core/model/length_units.h"
#include "io/recipe/recipe_sections.h"
#include "io/recipe/recipe_values.h"

namespace knead {

namespace {

std::vector<std::string> readTexts(const JsonNode& node)
{
    std::vector<std::string> texts;
    for (const JsonNode& item : node.items())
        texts.push_back(item.text());
    return texts;
}

/// Choices of the import are those that its result depends on.
ImportOptions readImport(const JsonNode& part)
{
    ImportOptions options;
    if (const auto node = part.find("parts"))
        options.parts = readTexts(*node);
    if (const auto node = part.find("unit"))
        options.unit = node->text();
    if (!options.unit.empty() && findLengthUnit(options.unit) == nullptr)
        part.at("unit").failExpecting(Message("Recipe", "must be one of %1").with(lengthUnitNames()));
    if (const auto node = part.find("heal"))
        options.heal = node->boolean();
    if (const auto node = part.find("cap_flat_openings"))
        options.capsFlatOpenings = node->boolean();
    if (const auto node = part.find("deflection_mm"))
        options.linearDeflection = node->positiveThousandth();
    if (const auto node = part.find("relative_deflection"))
        options.relativeDeflection = node->number(1e-9, 1);
    if (const auto node = part.find("angular_deflection_rad"))
        options.angularDeflection = node->number(1e-3, 10);
    return options;
}

} // namespace

void readRecipePart(const JsonNode& part, Recipe& recipe)
{
    part.allowOnly({"file", "files", "parts", "unit", "heal", "cap_flat_openings", "deflection_mm",
                    "relative_deflection", "angular_deflection_rad", "fills_open_parts"});
    const auto file = part.find("file");
    const auto files = part.find("files");
    if (file.has_value() == files.has_value())
        part.fail(Message("Recipe", "must have either file or files."));
    if (file)
        recipe.part = readFilePath(*file, recipe.file);
    else
        for (const JsonNode& item : files->items())
            recipe.partsBeside.push_back(readFilePath(item, recipe.file));
    if (files && recipe.partsBeside.empty())
        files->fail(Message("Recipe", "must hold at least one file."));
    if (files) {
        recipe.part = recipe.partsBeside.front();
        recipe.partsBeside.erase(recipe.partsBeside.begin());
    }
    recipe.import = readImport(part);
    if (const auto node = part.find("fills_open_parts"))
        recipe.fillsOpenParts = node->boolean();
}

} // namespace knead
