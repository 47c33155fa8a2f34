#include "io/recipe/recipe_tools.h"

#include "core/message/message.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace knead::recipe_keys {

namespace {

constexpr int mostToolParts = 1'000'000; // of a project

/// The kinds of motion; angular_velocity_rad_s goes with velocity_mm_s.
constexpr std::array<const char*, 4> motionKinds{"hold", "velocity_mm_s", "go_to", "keyframes"};

bool isTurned(const Quaternion& rotation)
{
    return rotation.w() != 1 || rotation.vec() != Vec3::Zero();
}

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

std::string sizeText(const Vec3& size, ToolKind kind)
{
    if (kind == ToolKind::ball)
        return exactThousandfold(size.x());
    if (kind == ToolKind::cylinder)
        return listText(std::array{size.x(), size.z()}, exactThousandfold);
    return listText(size, exactThousandfold);
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

struct MotionText {
    ObjectText& text;
    const Context& context;

    void operator()(const HoldStill&) const { text.put("hold", "true"); }
    void operator()(const DriveAt& drive) const { putInto(text, drive, context); }
    void operator()(const GoTo& goTo) const { text.put("go_to", Object<GoTo>{context}.text(goTo)); }
    void operator()(const FollowKeyFrames& follow) const
    {
        text.put("keyframes", ListOf{Object<KeyFrame>{context}}.text(follow.frames));
    }
};

} // namespace

void putPose(ObjectText& text, const Pose& pose)
{
    text.put("position_mm", VectorInMillimeters::text(pose.position));
    if (isTurned(pose.rotation))
        text.numbers("rotation_wxyz", pose.rotation);
}

/// A part brings its size in its file; other forms state it.
void readForm(const JsonNode& node, const Context& context, RecipeManipulator& tool)
{
    if (const auto kind = node.find("kind"))
        tool.kind = readChoice(*kind, toolKindWords());
    const auto size = node.find("size_mm");
    if (tool.kind != ToolKind::part) {
        for (const char* key : {"part_file", "part_number"})
            if (const auto found = node.find(key))
                found->fail(Message("Recipe", "belongs to manipulators of the kind part only."));
        tool.size = readSize(node.at("size_mm"), tool.kind);
        return;
    }
    if (size)
        size->fail(Message("Recipe", "does not belong to the kind part; its file says how large it is."));
    tool.partFile = readFilePath(node.at("part_file"), context.recipePath);
    if (const auto number = node.find("part_number"))
        tool.partNumber = static_cast<std::size_t>(number->integer(0, mostToolParts));
}

void putForm(ObjectText& text, const RecipeManipulator& tool)
{
    text.text("kind", std::string(nameOf(tool.kind)));
    if (tool.kind != ToolKind::part)
        text.put("size_mm", sizeText(tool.size, tool.kind));
    else
        text.text("part_file", tool.partFile).put("part_number", std::to_string(tool.partNumber.value_or(0)));
}

FollowKeyFrames readFrames(const JsonNode& list, const Context& context, FollowKeyFrames motion, double speedLimit)
{
    for (const JsonNode& item : list.items()) {
        const bool isFirst = motion.frames.empty();
        const KeyFrame before = isFirst ? KeyFrame{} : motion.frames.back();
        const KeyFrame frame = Object<KeyFrame>{context}.read(item, before);
        if (isFirst)
            item.at("position_mm");
        else
            checkSpeed(item, before, frame, speedLimit);
        motion.frames.push_back(frame);
    }
    if (motion.frames.empty())
        list.fail(Message("Recipe", "must hold at least one frame."));
    return motion;
}

Motion readMotion(const JsonNode& node, const Context& context)
{
    const auto isThere = [&](const char* key) { return node.find(key).has_value(); };
    if (std::ranges::count_if(motionKinds, isThere) != 1)
        node.fail(
            Message("Recipe", "must have exactly one of the keys %1.").with(listed(motionKinds, [](const char* key) {
                return std::string(key);
            })));
    if (const auto turn = node.find("angular_velocity_rad_s"); turn && !isThere("velocity_mm_s"))
        turn->fail(Message("Recipe", "belongs to velocity_mm_s."));
    if (const auto hold = node.find("hold"); hold && !hold->boolean())
        hold->fail(Message("Recipe", "must be true; leave it out to say another motion."));
    if (isThere("velocity_mm_s")) {
        DriveAt drive;
        readInto(node, drive, context);
        return drive;
    }
    if (const auto target = node.find("go_to"))
        return Object<GoTo>{context}.read(*target);
    if (const auto frames = node.find("keyframes"))
        return readFrames(*frames, context);
    return HoldStill{};
}

void putMotion(ObjectText& text, const Motion& motion, const Context& context)
{
    std::visit(MotionText{text, context}, motion);
}

/// `[step, x, y, z]` or `[step, x, y, z, qw, qx, qy, qz]`; a row without a rotation keeps that of the row before.
std::vector<PathRow> readPath(const JsonNode& node)
{
    std::vector<PathRow> rows;
    for (const JsonNode& item : node.items()) {
        const std::vector<JsonNode> columns = item.items();
        if (columns.size() != 4 && columns.size() != 8)
            item.failExpecting(
                Message("Recipe", "must hold a step and x, y, z, perhaps with w, x, y, z of a rotation"));
        PathRow row{columns[0].count(mostSteps), rows.empty() ? Pose{} : rows.back().target};
        if (!rows.empty() && row.step < rows.back().step)
            columns[0].failExpecting(Message("Recipe", "must not be less than in the row before it"));
        const std::vector<double> meters = item.thousandths(columns.size());
        const std::vector<double> numbers = item.numbers(columns.size());
        row.target.position = {meters[1], meters[2], meters[3]};
        if (!(row.target.position.cwiseAbs().maxCoeff() <= farAway / 1000))
            item.fail(Message("Recipe", "lies further than a kilometer away."));
        if (columns.size() == 8)
            row.target.rotation = Quaternion(numbers[4], numbers[5], numbers[6], numbers[7]);
        if (!(std::abs(row.target.rotation.norm() - 1) < 1e-6))
            item.failExpecting(Message("Recipe", "must end with a quaternion of length 1"));
        rows.push_back(row);
    }
    if (rows.empty())
        node.fail(Message("Recipe", "must hold at least one row."));
    return rows;
}

} // namespace knead::recipe_keys
