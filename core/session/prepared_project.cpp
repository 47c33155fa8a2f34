#include "core/session/prepared_project.h"

#include <limits>
#include <utility>

namespace knead {

PreparedProject prepareProject(Project project, const Packing& packing, TaskControl& control)
{
    const History tree(project.entries, project.current, std::numeric_limits<std::size_t>::max());
    HistoryNavigation navigation;
    navigation.way = tree.wayTo(project.current);
    navigation.start = {
        .start = project.starts.at(navigation.way.start), .content = nullptr, .choices = project.import};
    navigation.model = shownModel(project);
    navigation.packing = packing;
    navigation.changesStart = true;
    HistoryDestination destination = navigation.go(control);
    return {std::move(project), std::move(destination)};
}

} // namespace knead
