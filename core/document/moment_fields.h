#pragma once

#include "core/document/moment_bytes.h"
#include "core/message/message.h"

#include <algorithm>
#include <optional>
#include <variant>

/// What a person has put around the bodies, as bytes of a moment: tools, fixtures, loads.
///
/// One description serves a ByteWriter and a ByteReader, see Of. A change of anything here is a new version of what momentToBytes()
/// gives.
namespace knead::moment_fields {

inline std::uint64_t fingerprintOf(const ToolPart& part)
{
    ByteWriter bytes;
    for (const TriangleMesh::Triangle& triangle : part.mesh().triangles)
        for (const std::uint32_t corner : triangle)
            bytes(corner);
    for (const Vec3& vertex : part.mesh().vertices)
        bytes(vertex);
    return checksumOf(bytes.take());
}

/// A part by its fingerprint, 0 for none.
inline void toolPart(ByteWriter& bytes, const std::shared_ptr<const ToolPart>& part, const ToolParts& /*parts*/)
{
    bytes(part ? fingerprintOf(*part) : 0);
}

inline void toolPart(ByteReader& bytes, std::shared_ptr<const ToolPart>& part, const ToolParts& parts)
{
    std::uint64_t fingerprint = 0;
    bytes(fingerprint);
    part = nullptr;
    if (fingerprint == 0)
        return;
    const auto found =
        std::ranges::find_if(parts, [&](const auto& candidate) { return fingerprintOf(*candidate) == fingerprint; });
    if (found == parts.end())
        throw Problem(Message("History", "a tool is made of a part that the document does not have"));
    part = *found;
}

template <typename Stream>
void pose(Stream& bytes, Of<Stream, Pose>& pose)
{
    bytes(pose.position);
    bytes(pose.rotation);
}

/// Writes which alternative it is; reads it and makes it so.
inline void alternative(ByteWriter& bytes, const Motion& motion)
{
    bytes(static_cast<std::uint8_t>(motion.index()));
}

inline void alternative(ByteReader& bytes, Motion& motion)
{
    static const Motion motions[] = {HoldStill{}, DriveAt{}, GoTo{}, FollowKeyFrames{}};
    static_assert(std::size(motions) == std::variant_size_v<Motion>);
    std::uint8_t index = 0;
    bytes(index);
    if (index >= std::size(motions))
        throw Problem(Message("History", "a motion is none of those there are"));
    motion = motions[index];
}

template <typename Stream>
void motion(Stream& bytes, Of<Stream, Motion>& motion)
{
    alternative(bytes, motion);
    if (auto* drive = std::get_if<DriveAt>(&motion)) {
        bytes(drive->velocity);
        bytes(drive->angularVelocity);
    } else if (auto* goTo = std::get_if<GoTo>(&motion)) {
        pose(bytes, goTo->target);
    } else if (auto* follow = std::get_if<FollowKeyFrames>(&motion)) {
        bytes.list(follow->frames, [&](auto& frame) {
            bytes(frame.time);
            pose(bytes, frame.pose);
        });
    }
}

template <typename Stream>
void manipulator(Stream& bytes, Of<Stream, Manipulator>& tool, const ToolParts& parts, std::uint32_t version)
{
    bytes(tool.name);
    bytes(tool.size);
    pose(bytes, tool.pose);
    bytes(tool.friction);
    bytes(tool.speedLimit);
    bytes(tool.forceLimit);
    motion(bytes, tool.motion);
    bytes(tool.kind, lastToolKind);
    toolPart(bytes, tool.part, parts);
    if (version >= 8)
        bytes(tool.adhesion);
    if (version >= 11)
        bytes(tool.rollsFreely);
}

template <typename Stream>
void toolRun(Stream& bytes, Of<Stream, ToolRun>& tool, const ToolParts& parts, std::uint32_t version)
{
    manipulator(bytes, tool.manipulator, parts, version);
    manipulator(bytes, tool.start, parts, version);
    for (auto* vector : {&tool.force, &tool.meanForce, &tool.meanTorque})
        bytes(*vector);
    if constexpr (Stream::isReader)
        if (version < 5) {
            double resistance = 0; // tools at their limit follow their hands now
            bytes(resistance);
        }
    bytes(tool.peakForce);
}

inline void box(ByteWriter& bytes, const std::optional<Box>& box)
{
    bytes(box.has_value());
    if (box) {
        bytes(Vec3(box->min()));
        bytes(Vec3(box->max()));
    }
}

inline void box(ByteReader& bytes, std::optional<Box>& box)
{
    bool isThere = false;
    Vec3 low = Vec3::Zero();
    Vec3 high = Vec3::Zero();
    bytes(isThere);
    box.reset();
    if (isThere) {
        bytes(low);
        bytes(high);
        box = Box(low, high);
    }
}

template <typename Stream>
void fixture(Stream& bytes, Of<Stream, Fixture>& fixture, std::uint32_t version)
{
    bytes(fixture.name);
    bytes(fixture.body);
    bytes.plainList(fixture.objects);
    bytes(fixture.velocity);
    if (version >= 6)
        bytes.plainList(fixture.whenOpened);
}

template <typename Stream>
void amount(Stream& bytes, Of<Stream, LoadAmount>& amount)
{
    bytes(amount.force);
    bytes(amount.moment);
    bytes(amount.pressure);
}

template <typename Stream>
void load(Stream& bytes, Of<Stream, Load>& load)
{
    bytes(load.name);
    bytes(load.body);
    bytes.plainList(load.faces);
    box(bytes, load.box);
    bytes.plainList(load.patch.objects);
    bytes.plainList(load.patch.share);
    bytes.plainList(load.patch.area);
    amount(bytes, load.amount);
    bytes(load.ramp);
}

/// Loads, and grips that turn: what moments of before have nothing of.
template <typename Stream>
void loadsAndTurns(Stream& bytes, Of<Stream, Moment>& moment)
{
    bytes.list(moment.loads, [&](auto& each) {
        bytes.optional(each, [&](auto& run) {
            load(bytes, run.load);
            amount(bytes, run.from);
            bytes(run.begin);
        });
    });
    bytes.list(moment.gripProgress, [&](auto& progress) {
        bytes(progress.way);
        bytes(progress.angle);
    });
    for (auto& fixture : moment.fixtures) {
        if (!fixture)
            continue;
        bytes(fixture->turn.center);
        bytes(fixture->turn.angularVelocity);
        bytes(fixture->turn.angle);
    }
}

inline bool hasLoadsOrTurns(const Moment& moment)
{
    return !moment.loads.empty() ||
           std::ranges::any_of(moment.fixtures, [](const auto& fixture) { return fixture && fixture->turn.turns(); });
}

} // namespace knead::moment_fields
