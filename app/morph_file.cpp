#include "app/morph_file.h"

#include "app/cad_process.h"
#include "app/export_file.h"
#include "core/session/export_jobs.h"

#include <utility>

namespace knead {

namespace {

ExportReport writeDeformed(const MorphRequest& request, const Model& model, const DeformationPlan& plan,
                           TaskControl& control)
{
    ExportJob job = exportJobOf(model, {}, {});
    const std::string unit = std::exchange(job.options, request.write).unit;
    if (job.options.unit.empty())
        job.options.unit = unit;
    for (std::size_t p = 0; p < model.parts.size(); ++p)
        if (plan.moves[p])
            job.parts[p].deformations = plan.deformations;
    return exportFile(request.output, std::move(job), control);
}

} // namespace

MorphReport morphFile(MorphRequest request, TaskControl& control, const std::function<void()>& isReady)
{
    TaskPortion reading(control, 0, 0.2);
    Model model = importInChild(request.input, request.import, reading);
    TaskPortion planning(control, 0.2, 0.5);
    DeformationPlan plan = planOf(request.wishes, model, partsNamed(model, request.parts), planning);
    if (isReady)
        isReady();
    TaskPortion writing(control, 0.5, 1);
    ExportReport written = writeDeformed(request, model, plan, writing);
    return {std::move(model), std::move(request.wishes), std::move(plan), std::move(written)};
}

} // namespace knead
