#include "core/document/moment_hash.h"

#include "core/document/moment_content.h"

namespace knead {

std::uint64_t momentHash(Moment moment)
{
    for (std::optional<ToolRun>& tool : moment.tools)
        if (tool) {
            tool->meanForce.setZero();
            tool->meanTorque.setZero();
        }
    moment.accounts.energy.turnover = 0; // moments that were kept before it was do not tell
    moment.watch.unsolved = 0;
    moment.watch.unsolvedInRow = 0;
    moment.watch.isPlacedInside = false;
    moment.accounts.placed = 0;
    moment.scheme.reason = {};
    moment.watch.health.message = {};
    return checksumOf(momentContent(moment));
}

} // namespace knead
