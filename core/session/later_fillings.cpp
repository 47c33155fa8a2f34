#include "core/session/later_fillings.h"

#include "core/document/history.h"
#include "core/skin/former_shape.h"
#include "core/vicinity/point_grid.h"

#include <algorithm>
#include <limits>

namespace knead {

LaterFillings laterFillingsOf(const Project& project, const Packing& packing, TaskControl& control)
{
    LaterFillings fillings;
    const History history(project.entries, project.current, std::numeric_limits<std::size_t>::max());
    const ToolParts parts = toolPartsOf(project);
    for (const History::Entry entry : history.pathTo(project.current)) {
        control.throwIfCancelled();
        const HistoryRecord& record = history.record(entry);
        if (!record.moment || record.start != history.record(project.current).start)
            continue;
        const Moment moment =
            momentFromBytes(*record.moment, project.starts[record.start].scene.bodies, parts, packing);
        for (BodyId b = 0; b < moment.bodies.size(); ++b)
            if (const auto& aggregate = moment.bodies[b].refilled)
                fillings[{b, aggregate->size()}] = aggregate;
    }
    return fillings;
}

std::vector<ObjectIndex> objectsInFirst(const Aggregate& later, const std::vector<ObjectIndex>& objects)
{
    if (!later.former || later.former->isInPieces())
        return {};
    const std::vector<ObjectIndex> nearest = nearestPoints(
        VectorArray(later.lattice.positions()), VectorArray(firstFillingWhenFilled(later)), later.lattice.spacing);
    std::vector<ObjectIndex> first;
    for (ObjectIndex i = 0; i < nearest.size(); ++i)
        if (std::ranges::binary_search(objects, nearest[i]))
            first.push_back(i);
    return first;
}

} // namespace knead
