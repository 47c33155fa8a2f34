#include "app/compensate/recipe_field.h"

#include "app/recipe_files.h"
#include "app/resources.h"
#include "core/geometry/refine.h"
#include "core/message/message.h"
#include "core/session/recipe_runner.h"
#include "core/skin/former_shape.h"
#include "core/skin/skin_map.h"
#include "io/fields/field_writer.h"
#include "io/material_library.h"
#include "io/recipe/recipe_reader.h"

#include <iostream>
#include <stdexcept>

namespace knead {

namespace {

constexpr const char* anyExport = "shape.step"; // not written: what would be is taken instead
constexpr const char* fieldUnit = "mm";
constexpr double perFieldUnit = 1000;

/// A part at rest: its surface, and the objects of its first filling in it.
std::vector<Vec3> placesOf(const PartToExport& part, double spacing)
{
    const Aggregate& first = firstFillingOf(*part.aggregate);
    std::vector<Vec3> places = refine(part.part.mesh, spacing > 0 ? spacing : first.lattice.spacing).vertices;
    for (ObjectIndex i = 0; i < first.size(); ++i)
        if (first.depth[i] > 0.5 * first.lattice.spacing)
            places.push_back(first.lattice.position(i));
    return places;
}

/// Adds where a part was and how far it has moved.
void add(const PartToExport& part, double spacing, NodalFields& fields)
{
    if (part.aggregate == nullptr)
        return;
    if ((part.broken && !part.broken->empty()) || (part.aggregate->former && part.aggregate->former->isInPieces()))
        throw std::runtime_error(
            "The part breaks, so that nothing says where all of it went; let the recipe break nothing.");
    const std::vector<Vec3> before = placesOf(part, spacing);
    std::vector<Vec3> after(before.size());
    SkinMap(*part.aggregate, part.displacements).evaluate(before, after);
    for (std::size_t i = 0; i < before.size(); ++i) {
        fields.nodes.push_back(before[i]);
        for (const double moved : (perFieldUnit * (after[i] - before[i])).eval())
            fields.arrays[0].values.push_back(moved);
    }
}

/// The recipe with the other part, its shape at the end wanted.
Recipe recipeFor(const RecipeOfShape& what)
{
    Recipe recipe = readRecipe(what.recipe, readMaterials(materialsFile()));
    recipe.part = what.part;
    recipe.partsBeside.clear();
    recipe.import = {};
    recipe.exports = {RecipeExport{.file = anyExport}};
    return recipe;
}

} // namespace

void writeFieldOfRecipe(const RecipeOfShape& what, TaskControl& control)
{
    NodalFields fields{.unit = fieldUnit, .arrays = {{.name = "displacement [mm]"}}};
    RecipeFiles files = recipeFiles();
    files.prepareFolders = [](const std::vector<RecipeExport>&, const std::string&) {};
    files.writeExports = [&](const std::vector<RecipeExport>&, const std::string&, const ExportJob& job,
                             const Snapshot&, TaskControl&) {
        for (const PartToExport& part : job.parts)
            add(part, what.spacing, fields);
        return WrittenExports{};
    };
    runRecipe(recipeFor(what), files, ".", control,
              [](const std::string& said) { std::cerr << "warning: " << said << '\n'; });
    writeFields(what.field, fields, control);
}

} // namespace knead
