#include "io/recipe_values.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace knead {

namespace fs = std::filesystem;

namespace {

constexpr double degree = std::numbers::pi / 180;

} // namespace

Vec3 readVector(const JsonNode& node, double limit)
{
    const std::vector<double> numbers = node.numbers(3);
    for (const double number : numbers)
        if (std::abs(number) > limit)
            node.failExpecting("must hold 3 numbers no larger than " + std::to_string(std::lround(limit)));
    return {numbers[0], numbers[1], numbers[2]};
}

Vec3 readPlace(const JsonNode& node)
{
    return millimeter * readVector(node, farAway);
}

Box readBox(const JsonNode& node)
{
    const std::vector<double> n = node.numbers(6);
    const Box box(millimeter * Vec3(n[0], n[1], n[2]), millimeter * Vec3(n[3], n[4], n[5]));
    if (box.isEmpty())
        node.failExpecting("must hold the lowest x, y, z and then the highest x, y, z");
    return box;
}

Quaternion readRotation(const JsonNode& node)
{
    const Vec3 angles = degree * readVector(node, 3600);
    return Quaternion(Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
                      Eigen::AngleAxisd(angles.x(), Vec3::UnitX()));
}

std::vector<double> readLengths(const JsonNode& node, std::size_t count)
{
    std::vector<double> lengths = node.numbers(count);
    const auto usable = [](double number) { return number > 0 && number <= farAway; };
    if (!std::all_of(lengths.begin(), lengths.end(), usable))
        node.failExpecting("must hold " + std::to_string(count) + " positive numbers");
    for (double& length : lengths)
        length *= millimeter;
    return lengths;
}

std::string readFilePath(const JsonNode& node, const std::string& recipePath)
{
    const fs::path path = fs::path(recipePath).parent_path() / node.text();
    std::error_code error;
    if (!fs::is_regular_file(path, error))
        node.fail("names a file that does not exist: " + path.lexically_normal().string() +
                  ". The path is taken from the folder of the recipe.");
    return path.lexically_normal().string();
}

} // namespace knead
