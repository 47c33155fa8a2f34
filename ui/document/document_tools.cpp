// Numbers of a tool, typed one by one.
#include "ui/document/document.h"

#include "core/mechanics/tool_shape.h"

#include <utility>

namespace knead {

std::optional<ToolState> Document::toolWithEdits(ToolId id) const
{
    const ToolState* found = tool(id);
    if (found == nullptr)
        return {};
    return m_toolRequests.isOnItsWay(id, *m_frame->snapshot) ? m_toolRequests.asked(*found) : *found;
}

Pose Document::poseToMoveFrom(ToolId id) const
{
    return m_toolRequests.placed(id, *m_frame->snapshot).value_or(tool(id)->pose);
}

void Document::moveTool(ToolId id, std::function<Pose(const Pose&)> move)
{
    if (tool(id) == nullptr || later([this, id, move] { moveTool(id, move); }))
        return;
    post(PlaceManipulator{id, move(poseToMoveFrom(id))});
}

void Document::placeTool(ToolId id, int axis, double coordinate)
{
    const ToolState* found = tool(id);
    if (found == nullptr || later([=, this] { placeTool(id, axis, coordinate); }))
        return;
    Pose pose = m_toolRequests.asked(*found).pose;
    pose.position[axis] = coordinate;
    if (m_isPlaying)
        post(SetManipulatorMotion{id, GoTo{pose}});
    else
        post(PlaceManipulator{id, pose});
}

void Document::reshapeTool(ToolId id, std::function<void(ToolState&)> change)
{
    const ToolState* found = tool(id);
    if (found == nullptr || later([this, id, change] { reshapeTool(id, change); }))
        return;
    ToolState state = m_toolRequests.asked(*found);
    change(state);
    post(ReshapeManipulator{id, fittingSize(state.kind, state.size, state.part.get()), state.friction, state.speedLimit,
                            state.forceLimit, state.kind, state.part, state.adhesion, state.rollsFreely});
}

} // namespace knead
