#include "core/model/export_job.h"

#include <map>

namespace knead {

void makeMaps(ExportJob& job, TaskControl& control)
{
    std::map<const std::vector<Deformation>*, std::shared_ptr<const SmoothMap>> maps;
    for (PartToExport& part : job.parts) {
        if (part.deformations == nullptr || part.deformations->empty())
            continue;
        std::shared_ptr<const SmoothMap>& map = maps[part.deformations.get()];
        if (map == nullptr)
            map = mapOf(std::span(*part.deformations), control);
        part.deformed = map;
    }
}

} // namespace knead
