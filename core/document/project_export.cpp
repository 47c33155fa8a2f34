#include "core/document/project_export.h"

#include "core/model/length_units.h"

namespace knead {

ExportJob exportJobOf(const Project& project, const ProjectStart& start, const Snapshot& snapshot)
{
    const Model& model = *project.model;
    ExportJob job;
    job.tree = model.tree;
    job.options.unit = canBeWrittenIn(model.unit) ? model.unit : std::string();
    for (const Part& part : model.parts)
        job.parts.push_back({.part = part});
    for (std::size_t b = 0; b < start.partOfBody.size(); ++b) {
        PartToExport& part = job.parts.at(start.partOfBody[b]);
        part.aggregate = snapshot.bodies[b].aggregate;
        part.displacements = snapshot.bodies[b].displacements();
        part.broken = snapshot.bodies[b].broken;
        part.relaxed = snapshot.bodies[b].relaxed;
        part.density = snapshot.materials[b].density;
    }
    return job;
}

} // namespace knead
