#include "core/session/recipe_deforming.h"

#include "core/deformation/kept_faces.h"
#include "core/deformation/number_placement.h"
#include "core/message/message.h"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

namespace knead {

namespace {

bool isCalled(const Part& part, const std::string& name)
{
    return part.name == name || part.path == name;
}

std::vector<bool> partsMeant(const Model& model, const std::vector<std::string>& bodies)
{
    std::vector<bool> meant(model.parts.size(), bodies.empty());
    for (const std::string& body : bodies) {
        bool isThere = false;
        for (std::size_t p = 0; p < model.parts.size(); ++p)
            if (isCalled(model.parts[p], body))
                meant[p] = isThere = true;
        if (!isThere)
            throw Problem(
                Message("Recipe", "\"deform\" names the body \"%1\", which the part does not have.").with(body));
    }
    return meant;
}

/// The part that a choice of faces is of.
const Part& partOf(const KeptFaces& kept, const Model& model, const std::vector<bool>& meant)
{
    const Part* found = nullptr;
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        if (!meant[p] || !(kept.body.empty() || isCalled(model.parts[p], kept.body)))
            continue;
        if (found != nullptr)
            throw Problem(Message("Recipe", "\"deform\" keeps faces; name the body that they are of."));
        found = &model.parts[p];
    }
    if (found == nullptr)
        throw Problem(
            Message("Recipe", "\"deform\" keeps faces of the body \"%1\", which it does not deform.").with(kept.body));
    return *found;
}

/// The triangles of faces that stay.
TriangleMesh keptFaces(const Model& model, const std::vector<bool>& meant, const std::vector<KeptFaces>& all)
{
    TriangleMesh surface;
    for (const KeptFaces& kept : all) {
        const Part& part = partOf(kept, model, meant);
        const auto missing =
            std::ranges::find_if(kept.faces, [&](std::uint32_t face) { return face >= part.faces.size(); });
        if (missing != kept.faces.end())
            throw Problem(
                Message("Recipe", "\"deform\" keeps face %1 of \"%2\", which has %3; they are numbered from 0.")
                    .with(*missing, part.name, part.faces.size()));
        surface = besides(std::move(surface), facesOf(part.mesh, {kept.faces.begin(), kept.faces.end()}));
    }
    return surface;
}

std::vector<TriangleMesh> meshesOf(const Model& model, const std::vector<bool>& meant)
{
    std::vector<TriangleMesh> meshes;
    for (std::size_t p = 0; p < model.parts.size(); ++p)
        if (meant[p])
            meshes.push_back(model.parts[p].mesh);
    return meshes;
}

/// With its neutral plane where the k factor says, in what lies between the planes by then.
/// @param before deformations that come first
NumberDeformation numbersOf(const RecipeDeformation& wanted, const Model& model, const std::vector<bool>& meant,
                            std::span<const Deformation> before)
{
    auto numbers = std::get<NumberDeformation>(wanted.what);
    if (!wanted.kFactor)
        return numbers;
    std::vector<TriangleMesh> meshes = meshesOf(model, meant);
    if (!before.empty()) {
        const std::shared_ptr<const SmoothMap> map = mapOf(before);
        for (TriangleMesh& mesh : meshes)
            map->evaluate(std::vector<Vec3>(mesh.vertices), mesh.vertices);
    }
    if (const HeightRange heights = heightsBetweenPlanes(numbers, std::span<const TriangleMesh>(meshes));
        !heights.isEmpty())
        numbers.neutral = neutralOfSheet(numbers, heights, *wanted.kFactor);
    return numbers;
}

Deformation fieldOf(const RecipeField& field, const Model& model, const std::vector<bool>& meant,
                    const RecipeFiles& files, std::vector<Message>& warnings, TaskControl& control)
{
    if (!files.readField)
        throw Problem(
            Message("Recipe", "Fields in files cannot be read here; deform by numbers, or use \"knead morph\"."));
    TriangleMesh surface;
    for (const TriangleMesh& mesh : meshesOf(model, meant))
        surface = besides(std::move(surface), mesh);
    FieldFile file = files.readField(field.file, field.choice, surface, control);
    warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
    return FieldDeformation{.field = std::make_shared<const DisplacementField>(std::move(file.field)),
                            .factor = field.factor,
                            .kept = keptFaces(model, meant, field.kept),
                            .fade = field.fade,
                            .locked = field.locked};
}

/// Whether an item of a recipe goes on with the faces that the one before is carrying, so that both are carried at one go.
bool goesOn(const RecipeDeformation& before, const RecipeDeformation& item)
{
    return !item.isApart && item.bodies == before.bodies && std::holds_alternative<NumberDeformation>(item.what);
}

void tellOf(const ExportReport& report, std::vector<Message>& warnings)
{
    warnings.insert(warnings.end(), report.warnings.begin(), report.warnings.end());
    for (const PartExportReport& part : report.parts)
        if (!part.isSound())
            warnings.push_back(
                Message("Recipe", "\"%1\" did not come out sound when it was deformed; look at it closely.")
                    .with(part.name));
}

} // namespace

Model deformedParts(Model model, const Recipe& recipe, const RecipeFiles& files, std::vector<Message>& warnings,
                    TaskControl& control)
{
    const std::vector<RecipeDeformation>& all = recipe.deformations;
    for (std::size_t i = 0; i < all.size();) {
        TaskPortion portion(control, static_cast<double>(i) / static_cast<double>(all.size()), 1);
        const std::vector<bool> meant = partsMeant(model, all[i].bodies);
        // Those of the same parts in one go; a field that keeps faces keeps them where they are by then.
        auto together = std::make_shared<std::vector<Deformation>>();
        do {
            const auto* field = std::get_if<RecipeField>(&all[i].what);
            together->push_back(field != nullptr ? fieldOf(*field, model, meant, files, warnings, portion)
                                                 : numbersOf(all[i], model, meant, *together));
            ++i;
        } while (i < all.size() && goesOn(all[i - 1], all[i]));
        DeformedModel deformed = deformedModel(model, std::move(together), meant, files.writeAndRead, portion);
        tellOf(deformed.report, warnings);
        model = std::move(deformed.model);
    }
    return model;
}

} // namespace knead
