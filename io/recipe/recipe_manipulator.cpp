// Manipulators of a recipe: their forms and motions.
#include "core/message/message.h"
#include "io/recipe/recipe_sections.h"
#include "io/recipe/recipe_values.h"
#include "io/recipe/scene_words.h"

#include <cmath>

namespace knead {

namespace {

constexpr int mostToolParts = 1'000'000; // of a project

/// The measures a form has: one for a ball, two for a cylinder, else three.
Vec3 readSize(const JsonNode& node, ToolKind kind)
{
    if (kind == ToolKind::ball)
        return Vec3::Constant(node.positiveThousandth());
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
    if (manipulator.kind != ToolKind::part) {
        for (const char* key : {"part_file", "part_number"})
            if (const auto found = node.find(key))
                found->fail(Message("Recipe", "belongs to manipulators of the kind part only."));
        manipulator.size = readSize(node.at("size_mm"), manipulator.kind);
        return;
    }
    if (size)
        size->fail(Message("Recipe", "does not belong to the kind part; its file says how large it is."));
    manipulator.partFile = readFilePath(node.at("part_file"), recipePath);
    if (const auto number = node.find("part_number"))
        manipulator.partNumber = static_cast<std::size_t>(number->integer(0, mostToolParts));
}

/// What a frame does not say stays as it was in the frame before.
KeyFrame readKeyFrame(const JsonNode& node, const Pose& before)
{
    node.allowOnly(withPoseKeys({"time_s"}));
    return {node.at("time_s").number(0, 3600), readPose(node, before)};
}

/// A frame is reached from the one before it at a speed the manipulator is allowed to have.
void checkSpeed(const JsonNode& node, const KeyFrame& before, const KeyFrame& frame, double limit)
{
    const double time = frame.time - before.time;
    if (time <= 0)
        node.at("time_s").failExpecting(Message("Recipe", "must be later than the frame before it"));
    const double speed = (frame.pose.position - before.pose.position).norm() / time;
    if (speed > limit * (1 + 1e-9))
        node.fail(Message("Recipe", "asks for a speed of %1 mm/s; speed_limit_mm_s allows %2.")
                      .with(std::lround(1000 * speed), std::lround(1000 * limit)));
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

/// What is felt of it, and how far it goes.
void readLimits(const JsonNode& node, RecipeManipulator& manipulator)
{
    if (const auto friction = node.find("friction"))
        manipulator.friction = friction->number(0, 2);
    if (const auto limit = node.find("speed_limit_mm_s"))
        manipulator.speedLimit = limit->positiveThousandth();
    if (const auto limit = node.find("force_limit_n"))
        manipulator.forceLimit = limit->positive();
    if (const auto adhesion = node.find("adhesion_pa"))
        manipulator.adhesion = adhesion->number(0, 1e9);
    if (const auto rolls = node.find("rolls_freely")) {
        manipulator.rollsFreely = rolls->boolean();
        if (manipulator.rollsFreely && !canRoll(manipulator.kind))
            rolls->failExpecting(Message("Recipe", "must be false where the tool is neither a ball nor a cylinder"));
    }
}

const std::vector<std::string>& formKeys()
{
    static const std::vector<std::string> keys{"name",        "kind",        "size_mm",          "part_file",
                                               "part_number", "friction",    "speed_limit_mm_s", "force_limit_n",
                                               "adhesion_pa", "rolls_freely"};
    return keys;
}

} // namespace

RecipeManipulator readReshaping(const JsonNode& node, const std::string& recipePath)
{
    node.allowOnly(formKeys());
    RecipeManipulator manipulator;
    manipulator.name = node.at("name").text();
    readForm(node, recipePath, manipulator);
    readLimits(node, manipulator);
    return manipulator;
}

RecipeManipulator readRecipeManipulator(const JsonNode& node, const std::string& recipePath)
{
    std::vector<std::string> allowed = withPoseKeys(formKeys());
    allowed.insert(allowed.end(), {"keyframes", "motion"});
    node.allowOnly(allowed);
    RecipeManipulator manipulator;
    manipulator.name = node.at("name").text();
    readForm(node, recipePath, manipulator);
    node.at("position_mm");
    manipulator.pose = readPose(node, {});
    readLimits(node, manipulator);
    const auto frames = node.find("keyframes");
    const auto motion = node.find("motion");
    if (frames && motion)
        node.fail(Message("Recipe", "must have only one of the keys keyframes and motion."));
    if (frames)
        manipulator.motion = readKeyFrames(*frames, manipulator.pose, manipulator.speedLimit);
    if (motion) {
        motion->allowOnly(motionKeys());
        manipulator.motion = readMotion(*motion);
    }
    return manipulator;
}

} // namespace knead
