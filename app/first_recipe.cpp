#include "app/first_recipe.h"

#include "core/simulation/first_press.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace knead {

namespace {

using Json = nlohmann::ordered_json;

/// Millimetres with four digits, or as many as tell a thousandth of a size: nobody wants to edit 17.299999999999997.
/// @param size of the part [m]: it may lie far away
double readable(double metres, double size)
{
    if (metres == 0)
        return 0;
    const double millimetres = metres * 1000;
    const double smaller = std::min(std::abs(millimetres), 1000 * size);
    const double step = std::pow(10, std::floor(std::log10(smaller)) - 3);
    // The nearest double of the decimal, not of a product of it.
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.12g", std::round(millimetres / step) * step);
    return std::strtod(text.data(), nullptr);
}

Json readable(const Vec3& v, double size)
{
    return {readable(v.x(), size), readable(v.y(), size), readable(v.z(), size)};
}

Json readable(const Box& box, double size)
{
    Json corners = readable(box.min(), size);
    for (const Json& number : readable(box.max(), size))
        corners.push_back(number);
    return corners;
}

Json words(const Manipulator& block, double size)
{
    const KeyFrame& last = std::get<FollowKeyFrames>(block.motion).frames.back();
    return {{"name", block.name},
            {"size_mm", readable(block.size, size)},
            {"position_mm", readable(block.pose.position, size)},
            {"speed_limit_mm_s", readable(block.speedLimit, size)},
            {"keyframes", {{{"time_s", last.time}, {"position_mm", readable(last.pose.position, size)}}}}};
}

} // namespace

std::string firstRecipe(const Model& model, const std::string& part)
{
    const FirstPress press = firstPress(model);
    const double size = press.held.diagonal().norm();
    const std::string name = std::filesystem::path(part).stem().string();
    Json recipe{
        {"version", 1},
        {"part", {{"file", part}}},
        {"objects", press.objects},
        {"material", {{"preset", "silicone-rubber"}, {"poisson_ratio", 0.35}}},
        {"integrator", "automatic"},
        {"fixtures", Json::array({{{"name", "end"}, {"box_mm", readable(press.held, size)}}})},
        {"manipulators", Json::array({words(press.block, size)})},
        {"duration_s", press.duration},
        {"exports", Json::array({{{"file", name + "-pressed.step"}},
                                 {{"file", name + "-pressed.stl"}},
                                 {{"file", name + "-pressed.png"}}})},
    };
    if (press.hasBodies)
        recipe["touching"] = "glued";
    return recipe.dump(2) + "\n";
}

} // namespace knead
