#include "core/session/recipe_deforming.h"

#include "core/deformation/kept_faces.h"
#include "core/message/message.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace knead {

namespace {

std::vector<bool> partsMeant(const Model& model, const std::string& body)
{
    std::vector<bool> meant;
    for (const Part& part : model.parts)
        meant.push_back(body.empty() || part.name == body || part.path == body);
    if (std::ranges::count(meant, true) == 0)
        throw Problem(Message("Recipe", "\"deform\" names the body \"%1\", which the part does not have.").with(body));
    return meant;
}

/// The triangles of faces of the only part that is meant.
TriangleMesh keptFaces(const Model& model, const std::vector<bool>& meant, const std::vector<std::uint32_t>& faces)
{
    if (faces.empty())
        return {};
    if (std::ranges::count(meant, true) > 1)
        throw Problem(Message("Recipe", "\"deform\" keeps faces; name the body that they are of."));
    const Part& part = model.parts[static_cast<std::size_t>(std::ranges::find(meant, true) - meant.begin())];
    const auto missing = std::ranges::find_if(faces, [&](std::uint32_t face) { return face >= part.faces.size(); });
    if (missing != faces.end())
        throw Problem(Message("Recipe", "\"deform\" keeps face %1 of \"%2\", which has %3; they are numbered from 0.")
                          .with(*missing, part.name, part.faces.size()));
    return facesOf(part.mesh, {faces.begin(), faces.end()});
}

Deformation deformationOf(const RecipeDeformation& wanted, const Model& model, const std::vector<bool>& meant,
                          const RecipeFiles& files, std::vector<Message>& warnings, TaskControl& control)
{
    if (const auto* number = std::get_if<NumberDeformation>(&wanted.what))
        return *number;
    const auto& field = std::get<RecipeField>(wanted.what);
    if (!files.readField)
        throw Problem(
            Message("Recipe", "Fields in files cannot be read here; deform by numbers, or use \"knead morph\"."));
    FieldFile file = files.readField(field.file, field.choice, control);
    warnings.insert(warnings.end(), file.warnings.begin(), file.warnings.end());
    return FieldDeformation{.field = std::make_shared<const DisplacementField>(std::move(file.field)),
                            .factor = field.factor,
                            .kept = keptFaces(model, meant, field.keptFaces),
                            .fade = field.fade,
                            .locked = field.locked};
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
        const std::string& body = all[i].body;
        const std::vector<bool> meant = partsMeant(model, body);
        // Those of the same parts in one go; a field that keeps faces keeps them where they are by then.
        auto together = std::make_shared<std::vector<Deformation>>();
        do {
            together->push_back(deformationOf(all[i], model, meant, files, warnings, portion));
            ++i;
        } while (i < all.size() && all[i].body == body && std::holds_alternative<NumberDeformation>(all[i].what));
        DeformedModel deformed = deformedModel(model, std::move(together), meant, files.writeAndRead, portion);
        tellOf(deformed.report, warnings);
        model = std::move(deformed.model);
    }
    return model;
}

} // namespace knead
