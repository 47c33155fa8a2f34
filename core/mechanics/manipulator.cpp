#include "core/mechanics/manipulator.h"

#include "core/geometry/turn.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

Pose goTowards(const Manipulator& manipulator, const Pose& target, double dt)
{
    Pose pose = manipulator.pose;
    const double reach = manipulator.speedLimit * dt;
    const Vec3 way = target.position - pose.position;
    const double distance = way.norm();
    pose.position = distance <= reach ? target.position : Vec3(pose.position + way * (reach / distance));
    // The speed limit holds for the corners too, the points that move fastest when the box turns.
    const double angle = pose.rotation.angularDistance(target.rotation);
    const double turn = reach / (0.5 * manipulator.size.norm());
    pose.rotation = angle <= turn ? target.rotation : pose.rotation.slerp(turn / angle, target.rotation);
    return pose;
}

Pose poseAt(const std::vector<KeyFrame>& frames, double time)
{
    const auto next = std::upper_bound(frames.begin(), frames.end(), time,
                                       [](double t, const KeyFrame& frame) { return t < frame.time; });
    if (next == frames.begin())
        return frames.front().pose;
    if (next == frames.end())
        return frames.back().pose;
    const KeyFrame& before = *(next - 1);
    const double part = (time - before.time) / (next->time - before.time);
    return {before.pose.position + part * (next->pose.position - before.pose.position),
            before.pose.rotation.slerp(part, next->pose.rotation)};
}

struct Advance {
    const Manipulator& manipulator;
    double time;
    double dt;

    Pose operator()(const HoldStill&) const { return manipulator.pose; }
    Pose operator()(const DriveAt& drive) const
    {
        Pose pose = manipulator.pose;
        const double speed = drive.velocity.norm();
        const double allowed = speed > manipulator.speedLimit ? manipulator.speedLimit / speed : 1;
        pose.position += allowed * dt * drive.velocity;
        if (const double angle = drive.angularVelocity.norm() * dt; angle > 0)
            pose.rotation =
                (Quaternion(Eigen::AngleAxisd(angle, drive.angularVelocity.normalized())) * pose.rotation).normalized();
        return pose;
    }
    Pose operator()(const GoTo& goTo) const { return goTowards(manipulator, goTo.target, dt); }
    Pose operator()(const FollowKeyFrames& follow) const
    {
        return follow.frames.empty() ? manipulator.pose : poseAt(follow.frames, time + dt);
    }
};

} // namespace

Pose advance(const Manipulator& manipulator, double time, double dt)
{
    Pose pose = std::visit(Advance{manipulator, time, dt}, manipulator.motion);
    if (manipulator.rolls()) {
        const Quaternion& now = manipulator.pose.rotation;
        pose.rotation = manipulator.kind == ToolKind::ball
                            ? now
                            : (turnOnto(now * Vec3::UnitZ(), pose.rotation * Vec3::UnitZ()) * now).normalized();
    }
    return pose;
}

Vec3 rollingRate(const Manipulator& manipulator, const Vec3& velocity, const Vec3& force)
{
    if (!manipulator.rolls())
        return Vec3::Zero();
    const double radius = 0.5 * manipulator.size.x();
    if (manipulator.kind == ToolKind::ball)
        return force.stableNormalized().cross(velocity) / radius;
    const Vec3 axis = manipulator.pose.rotation * Vec3::UnitZ();
    const Vec3 across = force - force.dot(axis) * axis;
    return axis.dot(across.stableNormalized().cross(velocity)) / radius * axis;
}

Pose yieldTo(const Vec3& force, const Manipulator& manipulator, const Pose& next, double dt, bool goesBack)
{
    constexpr double yielding = 0.05; // within this share of its limit a tool gets slower, and beyond it goes back
    if (!std::isfinite(manipulator.forceLimit))
        return next;
    const Vec3 way = next.position - manipulator.pose.position;
    if (way.dot(force) <= 0 && force.norm() > (goesBack ? 1 - yielding : 1) * manipulator.forceLimit) {
        if (!goesBack)
            return manipulator.pose;
        const double share = std::max(-1.0, (1 - force.norm() / manipulator.forceLimit) / yielding);
        Pose pose = manipulator.pose;
        pose.rotation = pose.rotation.slerp(std::clamp(share, 0.0, 1.0), next.rotation);
        pose.position += share * std::min(1.0, manipulator.speedLimit * dt / way.norm()) * way;
        return pose;
    }
    return way.norm() > manipulator.speedLimit * dt ? goTowards(manipulator, next, dt) : next;
}

namespace {

/// Within what a workbench may be; false for what is no number.
bool isNear(const Vec3& place)
{
    return place.norm() <= 1e4;
}

bool isTurn(const Quaternion& rotation)
{
    return std::abs(rotation.norm() - 1) < 1e-6;
}

} // namespace

std::vector<Message> manipulatorProblems(const Manipulator& manipulator)
{
    std::vector<Message> problems;
    const auto require = [&](bool holds, const Message& sentence) {
        if (!holds)
            problems.push_back(Message("Tool", "Tool \"%1\": %2").with(manipulator.name, sentence));
    };
    const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
    require(manipulator.size.allFinite() && within(manipulator.size.minCoeff(), 1e-6, 1e3) &&
                within(manipulator.size.maxCoeff(), 1e-6, 1e3),
            Message("Tool", "each edge must be between 0.001 mm and 1000 m long."));
    require(manipulator.kind != ToolKind::part || manipulator.part,
            Message("Tool", "it is to be a part, but has none."));
    require(!((fittingSize(manipulator.kind, manipulator.size, manipulator.part.get()) - manipulator.size).norm() >
              1e-9 * manipulator.size.norm()),
            Message("Tool", "its measures do not fit together: a ball has one, a cylinder a diameter and a length."));
    require(isNear(manipulator.pose.position) && isTurn(manipulator.pose.rotation),
            Message("Tool", "its place must be numbers, within 10 km."));
    require(within(manipulator.friction, 0, 2), Message("Tool", "friction must lie between 0 and 2."));
    require(within(manipulator.speedLimit, 1e-6, 100),
            Message("Tool", "the speed limit must lie between 0.001 mm/s and 100 m/s."));
    require(manipulator.adhesion >= 0 && manipulator.adhesion <= 1e9,
            Message("Tool", "the adhesion must lie between 0 and 1e9 Pa."));
    require(manipulator.forceLimit > 0, Message("Tool", "the force limit must be greater than 0 N."));
    if (const auto* follow = std::get_if<FollowKeyFrames>(&manipulator.motion)) {
        require(!follow->frames.empty(), Message("Tool", "a key-framed motion needs at least one frame."));
        require(std::adjacent_find(follow->frames.begin(), follow->frames.end(),
                                   [](const KeyFrame& a, const KeyFrame& b) { return !(a.time < b.time); }) ==
                    follow->frames.end(),
                Message("Tool", "the times of key frames must ascend."));
        require(std::all_of(follow->frames.begin(), follow->frames.end(),
                            [](const KeyFrame& f) {
                                return std::isfinite(f.time) && isNear(f.pose.position) && isTurn(f.pose.rotation);
                            }),
                Message("Tool", "key frames must be numbers, within 10 km."));
    }
    if (const auto* drive = std::get_if<DriveAt>(&manipulator.motion))
        require(drive->velocity.norm() <= 1e4 && drive->angularVelocity.norm() <= 1e5,
                Message("Tool", "it must not go faster than 10000 m/s or 100000 rad/s."));
    if (const auto* goTo = std::get_if<GoTo>(&manipulator.motion))
        require(isNear(goTo->target.position) && isTurn(goTo->target.rotation),
                Message("Tool", "its target must be numbers, within 10 km."));
    return problems;
}

} // namespace knead
