// The fingers of a stroke: rigid tools that go over the surface as it was.
#include "core/geometry/turn.h"
#include "core/session/sculpting.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double gapShare = 0.1;     // between a finger and the surface before and after, in radii
constexpr double levelingRadius = 3; // of the ball that smooths, in those of the brush
constexpr double arrived = 0.02;     // a lifted finger has, so near, in its radii
constexpr double lingering = 0.5;    // with a finger that something holds, beyond what its way takes [s]
constexpr double worthFinger = 0.02; // of its radius: a finger is told no smaller step

ReshapeManipulator withLimit(const ToolState& tool, double limit)
{
    return {.tool = tool.id,
            .size = tool.size,
            .friction = tool.friction,
            .speedLimit = tool.speedLimit,
            .forceLimit = limit,
            .kind = tool.kind,
            .part = tool.part,
            .adhesion = tool.adhesion,
            .rollsFreely = tool.rollsFreely};
}

} // namespace

/// What a finger is, without its name and its place.
Manipulator SculptStroke::finger() const
{
    const double radius = m_choice.radius;
    Manipulator finger{.friction = 0.3, .speedLimit = m_choice.speed, .kind = ToolKind::ball};
    finger.size = Vec3::Constant(2 * radius);
    finger.forceLimit = thumbForce(m_material, radius);
    switch (m_choice.brush) {
    case SculptBrush::smooth:
        finger.size *= levelingRadius;
        finger.friction = 0.1;
        finger.rollsFreely = true;
        finger.forceLimit = thumbForce(m_material, levelingRadius * radius) / levelingRadius;
        break;
    case SculptBrush::flatten:
        finger.kind = ToolKind::cylinder;
        finger.size.z() = radius;
        finger.friction = 0.1;
        break;
    case SculptBrush::smear:
        finger.friction = 1.5;
        finger.forceLimit *= 3;
        break;
    default:
        break;
    }
    finger.forceLimit *= m_choice.strength;
    return finger;
}

/// Where a finger is to be, above the surface as it was. It flattens to the plane around the first place, and levels what stands out;
/// away it is above what stands out, too.
Pose SculptStroke::poseOf(const Touch& touch, bool isAway) const
{
    const bool isFlat = m_choice.brush == SculptBrush::flatten;
    const bool isLevel = isFlat || m_choice.brush == SculptBrush::smooth;
    const Vec3 normal = isFlat ? m_start.normal : m_spot.normal;
    Vec3 place = m_spot.place;
    if (isLevel) {
        const double depth = ((isFlat ? m_start.level : m_spot.level) - place).dot(normal);
        place += (isAway ? std::max(0.0, depth) : depth) * normal;
    }
    const double above = isAway ? gapShare * m_choice.radius : height();
    const double reach =
        isFlat ? 0.5 * m_choice.radius : (m_choice.brush == SculptBrush::smooth ? levelingRadius : 1) * m_choice.radius;
    const Vec3 outward = touch.mirror.cwiseProduct(normal);
    Pose pose;
    pose.position = mirrored(place, touch.mirror) + (reach + above) * outward;
    if (isFlat)
        pose.rotation = turnOnto(Vec3::UnitZ(), outward);
    return pose;
}

/// Above the surface as it was when the stroke began [m].
double SculptStroke::height() const
{
    switch (m_choice.brush) {
    case SculptBrush::thumb:
        return -m_choice.radius; // until its limit holds it
    case SculptBrush::smear:
        return -m_choice.radius / 3;
    default:
        return 0;
    }
}

const ToolState* SculptStroke::toolOf(const Touch& touch, const Snapshot& now) const
{
    const auto found = std::ranges::find(now.tools, touch.name, &ToolState::name);
    return found == now.tools.end() ? nullptr : &*found;
}

void SculptStroke::moveFinger(Touch& touch, const Snapshot& now, bool hasAll, std::vector<Command>& commands)
{
    const ToolState* tool = toolOf(touch, now);
    if (tool == nullptr) { // not there yet, or refused, or removed by somebody
        touch.isGone = hasAll;
        return;
    }
    if (!m_isReleased) {
        if (touch.limit != touch.toldLimit) {
            touch.toldLimit = touch.limit;
            commands.emplace_back(withLimit(*tool, touch.limit));
        }
        const Pose pose = poseOf(touch, false);
        if ((pose.position - touch.told).norm() > worthFinger * m_choice.radius) {
            touch.told = pose.position;
            commands.emplace_back(SetManipulatorMotion{tool->id, GoTo{pose}});
        }
        return;
    }
    if (!touch.leaveBy) {
        const Pose away = poseOf(touch, true);
        touch.told = away.position;
        touch.leaveBy = now.time + 2 * (away.position - tool->pose.position).norm() / tool->speedLimit + lingering;
        commands.emplace_back(SetManipulatorMotion{tool->id, GoTo{away}});
    } else if ((tool->pose.position - touch.told).norm() < arrived * m_choice.radius || now.time > *touch.leaveBy) {
        touch.isGone = true;
        commands.emplace_back(RemoveManipulator{tool->id});
    }
}

} // namespace knead
