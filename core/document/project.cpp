#include "core/document/project.h"

#include "core/document/moment_bytes.h"

#include <algorithm>

namespace knead {

std::shared_ptr<const Model> shownModel(const Project& project)
{
    if (project.entries.empty())
        return project.model;
    return modelOf(project, project.starts.at(project.entries.at(project.current).start));
}

std::vector<RecipeDeformation> deformationsUntil(const ProjectStart& before, const std::shared_ptr<const Model>& model,
                                                 std::vector<RecipeDeformation> said)
{
    if (model == before.model)
        return before.deformations;
    if (said.empty() || (before.model && before.deformations.empty()))
        return {};
    said.front().isApart = said.front().isApart || !before.deformations.empty();
    said.insert(said.begin(), before.deformations.begin(), before.deformations.end());
    return said;
}

std::vector<std::shared_ptr<const ToolPart>> toolPartsOf(const Project& project)
{
    ToolParts all;
    const auto add = [&all](const ToolParts& parts) {
        for (const auto& part : parts)
            if (std::ranges::find(all, part) == all.end())
                all.push_back(part);
    };
    for (const ProjectStart& start : project.starts)
        add(toolPartsOf(start.scene, {}));
    for (const HistoryRecord& entry : project.entries)
        add(toolPartsOf({}, entry.commands));
    return all;
}

} // namespace knead
