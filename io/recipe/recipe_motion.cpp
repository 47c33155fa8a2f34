// How manipulators of a recipe move: what a session says exactly, and a person may write too.
#include "core/message/message.h"
#include "io/recipe/recipe_sections.h"
#include "io/recipe/recipe_values.h"

#include <algorithm>

namespace knead {

namespace {

constexpr double fastestDrive = 1e7; // [mm/s]; the simulation says what is too fast for a tool
constexpr double fastestTurn = 1e5;  // [rad/s]

DriveAt readDrive(const JsonNode& node)
{
    DriveAt drive{readMillimeters(node.at("velocity_mm_s"), fastestDrive), Vec3::Zero()};
    if (const auto turn = node.find("angular_velocity_rad_s"))
        drive.angularVelocity = readVector(*turn, fastestTurn);
    return drive;
}

GoTo readTarget(const JsonNode& node)
{
    node.allowOnly(withPoseKeys({}));
    node.at("position_mm");
    return {readPose(node, {})};
}

FollowKeyFrames readFrames(const JsonNode& node)
{
    FollowKeyFrames motion;
    for (const JsonNode& item : node.items()) {
        item.allowOnly(withPoseKeys({"time_s"}));
        const Pose before = motion.frames.empty() ? Pose{} : motion.frames.back().pose;
        if (motion.frames.empty())
            item.at("position_mm");
        const KeyFrame frame{item.at("time_s").number(0, 3600), readPose(item, before)};
        if (!motion.frames.empty() && frame.time <= motion.frames.back().time)
            item.at("time_s").failExpecting(Message("Recipe", "must be later than the frame before it"));
        motion.frames.push_back(frame);
    }
    if (motion.frames.empty())
        node.fail(Message("Recipe", "must hold at least one frame."));
    return motion;
}

/// The kinds of motion; angular_velocity_rad_s goes with velocity_mm_s.
const std::vector<std::string>& kindKeys()
{
    static const std::vector<std::string> keys{"hold", "velocity_mm_s", "go_to", "keyframes"};
    return keys;
}

} // namespace

const std::vector<std::string>& motionKeys()
{
    static const std::vector<std::string> keys{"hold", "velocity_mm_s", "angular_velocity_rad_s", "go_to", "keyframes"};
    return keys;
}

Motion readMotion(const JsonNode& node)
{
    const auto isThere = [&](const std::string& key) { return node.find(key).has_value(); };
    if (std::count_if(kindKeys().begin(), kindKeys().end(), isThere) != 1)
        node.fail(
            Message("Recipe", "must have exactly one of the keys %1.").with(listed(kindKeys(), [](const auto& key) {
                return key;
            })));
    if (const auto turn = node.find("angular_velocity_rad_s"); turn && !isThere("velocity_mm_s"))
        turn->fail(Message("Recipe", "belongs to velocity_mm_s."));
    if (const auto hold = node.find("hold"); hold && !hold->boolean())
        hold->fail(Message("Recipe", "must be true; leave it out to say another motion."));
    if (isThere("velocity_mm_s"))
        return readDrive(node);
    if (const auto target = node.find("go_to"))
        return readTarget(*target);
    if (const auto frames = node.find("keyframes"))
        return readFrames(*frames);
    return HoldStill{};
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

} // namespace knead
