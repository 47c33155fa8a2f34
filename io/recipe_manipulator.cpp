// Manipulators of a recipe: their forms and motions.
#include "io/recipe_sections.h"
#include "io/recipe_values.h"
#include "io/scene_words.h"

#include <cmath>

namespace knead {

namespace {

/// The measures a form has: one for a ball, two for a cylinder, else three.
Vec3 readSize(const JsonNode& node, ToolKind kind)
{
    if (kind == ToolKind::ball)
        return Vec3::Constant(millimeter * node.positive());
    if (kind == ToolKind::cylinder) {
        const std::vector<double> lengths = readLengths(node, 2);
        return {lengths[0], lengths[0], lengths[1]};
    }
    const std::vector<double> lengths = readLengths(node, 3);
    return {lengths[0], lengths[1], lengths[2]};
}

/// A part brings its size in its file; other forms state it.
void readForm(const JsonNode& node, const std::string& recipePath, RecipeManipulator& manipulator)
{
    if (const auto kind = node.find("kind"))
        manipulator.kind = readChoice(*kind, toolKindWords());
    const auto size = node.find("size_mm");
    const auto file = node.find("part_file");
    if (manipulator.kind != ToolKind::part) {
        if (file)
            file->fail("belongs to manipulators of the kind part only.");
        manipulator.size = readSize(node.at("size_mm"), manipulator.kind);
        return;
    }
    if (size)
        size->fail("does not belong to the kind part; its file says how large it is.");
    manipulator.partFile = readFilePath(node.at("part_file"), recipePath);
}

/// What a frame does not say stays as it was in the frame before.
KeyFrame readKeyFrame(const JsonNode& node, const Pose& before)
{
    node.allowOnly({"time_s", "position_mm", "rotation_deg"});
    KeyFrame frame{node.at("time_s").number(0, 3600), before};
    if (const auto position = node.find("position_mm"))
        frame.pose.position = readPlace(*position);
    if (const auto rotation = node.find("rotation_deg"))
        frame.pose.rotation = readRotation(*rotation);
    return frame;
}

/// A frame is reached from the one before it at a speed the manipulator is allowed to have.
void checkSpeed(const JsonNode& node, const KeyFrame& before, const KeyFrame& frame, double limit)
{
    const double time = frame.time - before.time;
    if (time <= 0)
        node.at("time_s").failExpecting("must be later than the frame before it");
    const double speed = (frame.pose.position - before.pose.position).norm() / time;
    if (speed > limit * (1 + 1e-9))
        node.fail("asks for a speed of " + std::to_string(std::lround(speed / millimeter)) +
                  " mm/s; speed_limit_mm_s allows " + std::to_string(std::lround(limit / millimeter)) + ".");
}

/// The motion starts at time 0 in the given pose.
FollowKeyFrames readKeyFrames(const JsonNode& node, const Pose& start, double speedLimit)
{
    FollowKeyFrames motion{{KeyFrame{0, start}}};
    for (const JsonNode& item : node.items()) {
        const KeyFrame frame = readKeyFrame(item, motion.frames.back().pose);
        checkSpeed(item, motion.frames.back(), frame, speedLimit);
        motion.frames.push_back(frame);
    }
    return motion;
}

} // namespace

RecipeManipulator readRecipeManipulator(const JsonNode& node, const std::string& recipePath)
{
    node.allowOnly({"name", "kind", "size_mm", "part_file", "position_mm", "rotation_deg", "friction",
                    "speed_limit_mm_s", "force_limit_n", "keyframes"});
    RecipeManipulator manipulator;
    manipulator.name = node.at("name").text();
    readForm(node, recipePath, manipulator);
    manipulator.pose.position = readPlace(node.at("position_mm"));
    if (const auto rotation = node.find("rotation_deg"))
        manipulator.pose.rotation = readRotation(*rotation);
    if (const auto friction = node.find("friction"))
        manipulator.friction = friction->number(0, 2);
    if (const auto limit = node.find("speed_limit_mm_s"))
        manipulator.speedLimit = limit->positive() * millimeter;
    if (const auto limit = node.find("force_limit_n"))
        manipulator.forceLimit = limit->positive();
    if (const auto frames = node.find("keyframes"))
        manipulator.motion = readKeyFrames(*frames, manipulator.pose, manipulator.speedLimit);
    return manipulator;
}

} // namespace knead
