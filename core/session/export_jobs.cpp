#include "core/session/export_jobs.h"

#include <algorithm>

namespace knead {

ExportJob exportJobOf(const Model& model, std::span<const std::size_t> partOfBody, const Snapshot& snapshot,
                      const std::vector<bool>& keep)
{
    ExportJob job;
    job.tree = model.tree;
    job.options.unit = canBeWrittenIn(model.unit) ? model.unit : std::string();
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        if (!keep.empty() && !keep[p])
            continue;
        PartToExport& part = job.parts.emplace_back(PartToExport{.part = model.parts[p]});
        const auto body = static_cast<std::size_t>(std::ranges::find(partOfBody, p) - partOfBody.begin());
        if (body == partOfBody.size())
            continue;
        const Snapshot::BodyState& state = snapshot.bodies[body];
        part.aggregate = state.aggregate;
        part.displacements = state.displacements();
        part.broken = state.broken;
        part.relaxed = state.relaxed;
        part.loaded = loadedObjects(snapshot, static_cast<BodyId>(body));
        part.density = snapshot.materials[body].density;
    }
    return job;
}

} // namespace knead
