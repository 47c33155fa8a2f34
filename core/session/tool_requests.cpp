#include "core/session/tool_requests.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double poseTolerance = 1e-9; // [m], and of components of the rotation

bool isThere(const ToolState& tool, const Pose& goal)
{
    return (tool.pose.position - goal.position).norm() < poseTolerance &&
           tool.pose.rotation.angularDistance(goal.rotation) < poseTolerance;
}

} // namespace

void ToolRequests::posted(const Command& command, std::uint64_t request)
{
    const auto place = [&](ToolId tool, const std::optional<Pose>& pose, bool isGoing) {
        Asked& asked = m_asked[tool];
        asked.pose = pose;
        asked.isGoing = isGoing;
        asked.poseRequest = request;
    };
    if (const auto* placed = std::get_if<PlaceManipulator>(&command)) {
        place(placed->tool, placed->pose, false);
    } else if (const auto* moved = std::get_if<SetManipulatorMotion>(&command)) {
        const auto* goal = std::get_if<GoTo>(&moved->motion);
        place(moved->tool, goal != nullptr ? std::optional(goal->target) : std::nullopt, goal != nullptr);
    } else if (const auto* shaped = std::get_if<ReshapeManipulator>(&command)) {
        m_asked[shaped->tool].shape = *shaped;
        m_asked[shaped->tool].shapeRequest = request;
    } else if (const auto* removed = std::get_if<RemoveManipulator>(&command)) {
        m_asked.erase(removed->tool);
    } else if (std::holds_alternative<Reset>(command)) {
        forget();
    }
}

void ToolRequests::seen(const Snapshot& snapshot)
{
    for (auto& [id, asked] : m_asked) {
        if (asked.shape && snapshot.requests >= asked.shapeRequest)
            asked.shape.reset();
        if (!asked.pose || snapshot.requests < asked.poseRequest)
            continue;
        const auto tool = std::ranges::find(snapshot.tools, id, &ToolState::id);
        const bool isUnderWay =
            asked.isGoing && snapshot.playing && tool != snapshot.tools.end() && !isThere(*tool, *asked.pose);
        if (!isUnderWay)
            asked.pose.reset();
    }
    std::erase_if(m_asked, [](const auto& one) { return !one.second.pose && !one.second.shape; });
}

bool ToolRequests::isOnItsWay(ToolId tool, const Snapshot& snapshot) const
{
    const auto found = m_asked.find(tool);
    if (found == m_asked.end())
        return false;
    const Asked& asked = found->second;
    return (asked.shape && snapshot.requests < asked.shapeRequest) ||
           (asked.pose && snapshot.requests < asked.poseRequest);
}

std::optional<Pose> ToolRequests::placed(ToolId tool, const Snapshot& snapshot) const
{
    const auto found = m_asked.find(tool);
    const bool isPut =
        found != m_asked.end() && !found->second.isGoing && snapshot.requests < found->second.poseRequest;
    return isPut ? found->second.pose : std::nullopt;
}

ToolState ToolRequests::asked(const ToolState& tool) const
{
    ToolState result = tool;
    const auto found = m_asked.find(tool.id);
    if (found == m_asked.end())
        return result;
    if (found->second.pose)
        result.pose = *found->second.pose;
    if (const std::optional<ReshapeManipulator>& shape = found->second.shape) {
        result.kind = shape->kind;
        result.part = shape->part;
        result.size = shape->size;
        result.friction = shape->friction;
        result.speedLimit = shape->speedLimit;
        result.forceLimit = shape->forceLimit;
        result.adhesion = shape->adhesion;
        result.rollsFreely = shape->rollsFreely;
    }
    return result;
}

} // namespace knead
