#include "app/part_application.h"

#include "app/cad_process.h"
#include "app/export_file.h"
#include "app/project_field.h"
#include "app/recipe_files.h"
#include "app/resources.h"
#include "core/document/history.h"
#include "core/session/export_jobs.h"
#include "io/material_library.h"
#include "io/project/packing.h"
#include "io/recipe/recipe_of_project.h"
#include "io/recipe/recipe_reader.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace knead {

namespace {

/// Of the ends of what was done at one go, from where steps count to the present entry.
std::vector<std::pair<std::uint64_t, double>> timesOfSteps(const Project& project)
{
    const History history(project.entries, project.current, std::numeric_limits<std::size_t>::max());
    const std::uint32_t start = history.record(project.current).start;
    std::vector<std::pair<std::uint64_t, double>> times{{0, 0}};
    for (const History::Entry entry : history.pathTo(project.current)) {
        const HistoryRecord& record = history.record(entry);
        if (record.start == start && record.step > times.back().first)
            times.emplace_back(record.step, record.time);
    }
    return times;
}

} // namespace

PartTransfer transferProject(const Project& project, const std::string& projectPath, const std::string& part,
                             TransferOptions options, TaskControl& control)
{
    const std::vector<MaterialPreset> presets = readMaterials(materialsFile());
    const RecipeOfProject told = recipeOfProject(project,
                                                 {.recipePath = projectPath,
                                                  .projectPath = projectPath,
                                                  .namesProject = !projectPath.empty(),
                                                  .saysDeformations = false},
                                                 presets);
    const Recipe recipe = readRecipeText(told.text, projectPath.empty() ? "recipe" : projectPath, presets);
    if (options.timesOfSteps.empty())
        options.timesOfSteps = timesOfSteps(project);
    options.laterFillings = [&project](TaskControl& finding) {
        return laterFillingsOf(project, zstandardPacking(), finding);
    };
    PartTransfer transfer = transferToPart(recipe, part, recipeFiles(), options, control);
    transfer.report.leftOut.insert(transfer.report.leftOut.begin(), told.remarks.begin(), told.remarks.end());
    return transfer;
}

ExportReport carryShape(const std::string& projectPath, const PartTransfer& transfer, std::uint32_t entry,
                        const std::string& output, TaskControl& control)
{
    TaskPortion reading(control, 0, 0.3);
    FieldFile known = projectField(projectPath, entry, reading);
    TaskPortion carrying(control, 0.3, 0.4);
    auto field = std::make_shared<const DisplacementField>(fieldOnPart(known.field, transfer, carrying));
    const auto deformations =
        std::make_shared<const std::vector<Deformation>>(std::vector<Deformation>{FieldDeformation{.field = field}});
    TaskPortion importing(control, 0.4, 0.5);
    const Model model = importInChild(transfer.recipe.part, transfer.recipe.import, importing);
    ExportJob job = exportJobOf(model, {}, {});
    for (PartToExport& part : job.parts)
        part.deformations = deformations;
    TaskPortion writing(control, 0.5, 1);
    return exportFile(output, std::move(job), writing);
}

} // namespace knead
