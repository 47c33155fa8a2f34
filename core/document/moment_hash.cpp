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
    moment.energy.turnover = 0; // moments that were kept before it was do not tell
    moment.unsolvedSteps = 0;
    moment.unsolvedInRow = 0;
    moment.isPlacedInside = false;
    moment.placedEnergy = 0;
    moment.integratorReason = {};
    moment.health.message = {};
    return checksumOf(momentContent(moment));
}

} // namespace knead
