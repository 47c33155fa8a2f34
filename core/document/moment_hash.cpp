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
    moment.integratorReason.clear();
    moment.health.message.clear();
    return checksumOf(momentContent(moment));
}

} // namespace knead
