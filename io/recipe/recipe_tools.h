#pragma once

#include "core/session/recipe.h"
#include "io/recipe/recipe_kinds.h"

#include <cstdint>
#include <limits>

namespace knead::recipe_keys {

// The keys of manipulators and of how they move, see recipe_fields.h.

constexpr double fastestDrive = 1e7; // [mm/s]; the simulation says what is too fast for a tool
constexpr double fastestTurn = 1e5;  // [rad/s]

/// Puts place and, where it is turned, rotation.
void putPose(ObjectText& text, const Pose& pose);

/// Kind, and size or file.
void readForm(const JsonNode& node, const Context& context, RecipeManipulator& tool);
void putForm(ObjectText& text, const RecipeManipulator& tool);

/// How a manipulator moves, by exactly one of the keys of a motion.
Motion readMotion(const JsonNode& node, const Context& context);
void putMotion(ObjectText& text, const Motion& motion, const Context& context);

/// Frames that follow those of the motion, each reached at a speed that is allowed [m/s]. What a frame does not say stays as it
/// was in the frame before.
FollowKeyFrames readFrames(const JsonNode& list, const Context& context, FollowKeyFrames motion = {},
                           double speedLimit = std::numeric_limits<double>::infinity());

/// A place of a path: a manipulator sets out for it so many steps after the event.
struct PathRow {
    std::uint64_t step = 0;
    Pose target;
};
std::vector<PathRow> readPath(const JsonNode& node);

template <class Fields>
void describePose(Fields& fields, Pose& pose)
{
    fields.together(
        {"position_mm", "rotation_deg", "rotation_wxyz"},
        [&](const JsonNode& node) {
            node.at("position_mm");
            pose = readPose(node, pose);
        },
        [&](ObjectText& text) { putPose(text, pose); });
}

template <class Fields>
void describeKeys(Fields& fields, KeyFrame& frame)
{
    fields.needed("time_s", frame.time, Number{0, 3600});
    fields.together(
        {"position_mm", "rotation_deg", "rotation_wxyz"},
        [&](const JsonNode& node) { frame.pose = readPose(node, frame.pose); },
        [&](ObjectText& text) {
            text.put("position_mm", VectorInMillimeters::text(frame.pose.position))
                .numbers("rotation_wxyz", frame.pose.rotation);
        });
}

template <class Fields>
void describeKeys(Fields& fields, DriveAt& drive)
{
    fields.needed("velocity_mm_s", drive.velocity, VectorInMillimeters{fastestDrive});
    fields.optional("angular_velocity_rad_s", drive.angularVelocity, Vector{fastestTurn},
                    drive.angularVelocity != Vec3::Zero());
}

template <class Fields>
void describeKeys(Fields& fields, GoTo& goTo)
{
    describePose(fields, goTo.target);
}

template <class Fields>
void describeKeys(Fields& fields, Motion& motion)
{
    fields.together(
        {"hold", "velocity_mm_s", "angular_velocity_rad_s", "go_to", "keyframes"},
        [&](const JsonNode& node) { motion = readMotion(node, fields.context); },
        [&](ObjectText& text) { putMotion(text, motion, fields.context); });
}

/// Name, form and limits, as an event changes them.
template <class Fields>
void describeForm(Fields& fields, RecipeManipulator& tool)
{
    fields.needed("name", tool.name, Text{});
    fields.together(
        {"kind", "size_mm", "part_file", "part_number"},
        [&](const JsonNode& node) { readForm(node, fields.context, tool); },
        [&](ObjectText& text) { putForm(text, tool); });
    fields.optional("friction", tool.friction, Number{0, 2});
    fields.optional("speed_limit_mm_s", tool.speedLimit, PositiveMillimeters{});
    fields.optional("force_limit_n", tool.forceLimit, Positive{}, std::isfinite(tool.forceLimit));
    fields.optional("adhesion_pa", tool.adhesion, Number{0, 1e9}, tool.adhesion > 0);
    fields.optional("rolls_freely", tool.rollsFreely, Flag{}, tool.rolls());
    fields.check([&](const JsonNode& node) {
        if (tool.rollsFreely && !canRoll(tool.kind))
            node.at("rolls_freely")
                .failExpecting(Message("Recipe", "must be false where the tool is neither a ball nor a cylinder"));
    });
}

template <class Fields>
void describeKeys(Fields& fields, RecipeManipulator& tool)
{
    describeForm(fields, tool);
    describePose(fields, tool.pose);
    fields.together(
        {"keyframes", "motion"},
        [&](const JsonNode& node) {
            const auto frames = node.find("keyframes");
            const auto motion = node.find("motion");
            if (frames && motion)
                node.fail(Message("Recipe", "must have only one of the keys keyframes and motion."));
            if (frames) // it is there at time 0
                tool.motion = readFrames(*frames, fields.context, {{KeyFrame{0, tool.pose}}}, tool.speedLimit);
            if (motion)
                tool.motion = Object<Motion>{fields.context}.read(*motion);
        },
        [&](ObjectText& text) {
            if (!std::holds_alternative<HoldStill>(tool.motion))
                text.put("motion", Object<Motion>{fields.context}.text(tool.motion));
        });
}

} // namespace knead::recipe_keys
