#include "io/recipe/recipe_values.h"

#include "core/message/message.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace knead {

namespace fs = std::filesystem;

Vec3 readVector(const JsonNode& node, double limit)
{
    const std::vector<double> numbers = node.numbers(3);
    for (const double number : numbers)
        if (std::abs(number) > limit)
            node.failExpecting(Message("Recipe", "must hold 3 numbers no larger than %1").with(std::lround(limit)));
    return {numbers[0], numbers[1], numbers[2]};
}

Vec3 readMillimeters(const JsonNode& node, double limit)
{
    readVector(node, limit);
    const std::vector<double> meters = node.thousandths(3);
    return {meters[0], meters[1], meters[2]};
}

Vec3 readPlace(const JsonNode& node)
{
    return readMillimeters(node, farAway);
}

Box readBox(const JsonNode& node)
{
    const std::vector<double> m = node.thousandths(6);
    const Box box(Vec3(m[0], m[1], m[2]), Vec3(m[3], m[4], m[5]));
    if (box.isEmpty())
        node.failExpecting(Message("Recipe", "must hold the lowest x, y, z and then the highest x, y, z"));
    return box;
}

Quaternion readRotation(const JsonNode& node)
{
    const Vec3 angles = radiansPerDegree * readVector(node, 3600);
    return Quaternion(Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
                      Eigen::AngleAxisd(angles.x(), Vec3::UnitX()));
}

Quaternion readQuaternion(const JsonNode& node)
{
    const std::vector<double> n = node.numbers(4);
    const Quaternion rotation(n[0], n[1], n[2], n[3]);
    if (!(std::abs(rotation.norm() - 1) < 1e-6))
        node.failExpecting(Message("Recipe", "must hold w, x, y, z of a quaternion of length 1"));
    return rotation;
}

Pose readPose(const JsonNode& node, Pose pose)
{
    if (const auto position = node.find("position_mm"))
        pose.position = readPlace(*position);
    const auto rotation = node.find("rotation_deg");
    const auto exact = node.find("rotation_wxyz");
    if (rotation && exact)
        node.fail(Message("Recipe", "must have only one of the keys rotation_deg and rotation_wxyz."));
    if (rotation)
        pose.rotation = readRotation(*rotation);
    if (exact)
        pose.rotation = readQuaternion(*exact);
    return pose;
}

std::vector<double> readLengths(const JsonNode& node, std::size_t count)
{
    const std::vector<double> lengths = node.numbers(count);
    const auto usable = [](double number) { return number > 0 && number <= farAway; };
    if (!std::all_of(lengths.begin(), lengths.end(), usable))
        node.failExpecting(Message("Recipe", "must hold %1 positive numbers").with(count));
    return node.thousandths(count);
}

std::string readFilePath(const JsonNode& node, const std::string& recipePath)
{
    const fs::path path = fs::path(recipePath).parent_path() / node.text();
    std::error_code error;
    if (!fs::is_regular_file(path, error))
        node.fail(
            Message("Recipe", "names a file that does not exist: %1. The path is taken from the folder of the recipe.")
                .with(path.lexically_normal().string()));
    return path.lexically_normal().string();
}

} // namespace knead
