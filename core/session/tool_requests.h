#pragma once

#include "core/simulation/command.h"
#include "core/simulation/snapshot.h"

#include <cstdint>
#include <map>
#include <optional>

namespace knead {

/// What was asked of tools and no frame shows yet: edits on their way to the simulation, and where tools are going. An edit that
/// changes one number of a tool goes by this, or it would take back what was typed just before.
class ToolRequests {
public:
    /// A command goes to the simulation. @param request how many requests there are with it
    void posted(const Command& command, std::uint64_t request);
    /// A snapshot is shown: what it has is asked for no longer.
    void seen(const Snapshot& snapshot);
    void forget() { m_asked.clear(); }

    /// Some edit of the tool is in no snapshot yet.
    bool isOnItsWay(ToolId tool, const Snapshot& snapshot) const;
    /// Where it was put, which is in no snapshot yet; a goal that it is on its way to does not count.
    std::optional<Pose> placed(ToolId tool, const Snapshot& snapshot) const;
    /// The tool as it will be when all that was asked of it is done. @param tool as the newest snapshot has it
    ToolState asked(const ToolState& tool) const;

private:
    struct Asked {
        std::optional<Pose> pose; ///< put there, or going there
        bool isGoing = false;
        std::uint64_t poseRequest = 0;
        std::optional<ReshapeManipulator> shape;
        std::uint64_t shapeRequest = 0;
    };

    std::map<ToolId, Asked> m_asked;
};

} // namespace knead
