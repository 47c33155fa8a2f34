#include "core/session/export_jobs.h"

#include "core/model/length_units.h"

namespace knead {

ExportJob exportJobOf(const Model& model, std::span<const std::size_t> partOfBody, const Snapshot& snapshot)
{
    ExportJob job;
    job.tree = model.tree;
    job.options.unit = canBeWrittenIn(model.unit) ? model.unit : std::string();
    for (const Part& part : model.parts)
        job.parts.push_back({.part = part});
    for (std::size_t b = 0; b < partOfBody.size(); ++b) {
        const Snapshot::BodyState& body = snapshot.bodies[b];
        PartToExport& part = job.parts.at(partOfBody[b]);
        part.aggregate = body.aggregate;
        part.displacements = body.displacements();
        part.broken = body.broken;
        part.relaxed = body.relaxed;
        part.loaded = loadedObjects(snapshot, static_cast<BodyId>(b));
        part.density = snapshot.materials[b].density;
    }
    return job;
}

} // namespace knead
