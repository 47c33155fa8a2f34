#include "core/session/moved_tools.h"

#include <cmath>

namespace knead {

MovedTools::MovedTools(const TransferGround& ground, TransferReport& report)
    : m_ground(ground)
    , m_vectors(ground.base.linear)
    , m_report(report)
{
}

bool MovedTools::move(RecipeManipulator& tool)
{
    if (!canBe(tool))
        return false;
    m_gone.erase(tool.name);
    m_beyond.erase(tool.name);
    const Pose before = tool.pose;
    tool.pose = moved(tool.name, before);
    m_report.moved.push_back(
        {Message("Transfer", "the tool \"%1\"").with(tool.name), tool.pose.position - before.position});
    move(tool.name, tool.motion);
    resize(tool);
    return true;
}

bool MovedTools::move(const std::string& name, Motion& motion)
{
    if (auto* drive = std::get_if<DriveAt>(&motion)) {
        drive->velocity = m_vectors.carried(drive->velocity);
        drive->angularVelocity = m_vectors.spun(drive->angularVelocity);
    }
    if (auto* goTo = std::get_if<GoTo>(&motion))
        goTo->target = moved(name, goTo->target);
    if (auto* follow = std::get_if<FollowKeyFrames>(&motion))
        for (KeyFrame& frame : follow->frames)
            frame.pose = moved(name, frame.pose);
    return true;
}

bool MovedTools::reshape(RecipeManipulator& form)
{
    if (!isThere(form.name) || !canBe(form))
        return false;
    resize(form);
    return true;
}

Pose MovedTools::moved(const std::string& name, const Pose& pose)
{
    const NearestBody nearest = nearestBody(m_ground.bodies, pose.position);
    if (nearest.hit.signedDistance >= 0 || !m_beyond.contains(name))
        m_beyond[name] = nearest.body->places->beyond(nearest.hit.point);
    return {m_ground.base.at(pose.position) + m_beyond[name], turned(pose.rotation)};
}

/// R Q K, where K = diag(-1, 1, 1) turns a mirror image back into a turn: all forms of tools but imported parts are the same behind
/// that mirror.
Quaternion MovedTools::turned(const Quaternion& rotation) const
{
    if (m_vectors.turn() == Mat3::Identity())
        return rotation;
    Mat3 turn = m_vectors.turn() * rotation.toRotationMatrix();
    if (m_vectors.mirrors())
        turn.col(0) = -turn.col(0);
    return Quaternion(turn).normalized();
}

/// As much larger as the part; what presses with the same stress has a force as large as an area.
void MovedTools::resize(RecipeManipulator& tool) const
{
    const double scale = m_vectors.scale();
    if (scale == 1)
        return;
    tool.size *= scale;
    tool.speedLimit *= scale;
    tool.forceLimit *= scale * scale;
}

bool MovedTools::canBe(const RecipeManipulator& tool)
{
    if (tool.kind != ToolKind::part)
        return true;
    if (m_vectors.mirrors()) {
        m_report.leftOut.push_back(
            Message("Transfer", "The tool \"%1\" is left out: it is an imported part, which has no mirror image.")
                .with(tool.name));
        m_gone.insert(tool.name);
        return false;
    }
    if (m_vectors.scale() != 1)
        m_report.leftOut.push_back(
            Message("Transfer", "The tool \"%1\" keeps its size: it is an imported part.").with(tool.name));
    return true;
}

} // namespace knead
