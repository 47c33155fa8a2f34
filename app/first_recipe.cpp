#include "app/first_recipe.h"

#include "core/simulation/first_press.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace knead {

namespace {

using Json = nlohmann::ordered_json;

/// Millimetres with four digits: nobody wants to edit 17.299999999999997.
double readable(double metres)
{
    if (metres == 0)
        return 0;
    const double millimetres = metres * 1000;
    const double step = std::pow(10, std::floor(std::log10(std::abs(millimetres))) - 3);
    // The nearest double of the decimal, not of a product of it.
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", std::round(millimetres / step) * step);
    return std::strtod(text.data(), nullptr);
}

Json readable(const Vec3& v)
{
    return {readable(v.x()), readable(v.y()), readable(v.z())};
}

Json readable(const Box& box)
{
    return {readable(box.min().x()), readable(box.min().y()), readable(box.min().z()),
            readable(box.max().x()), readable(box.max().y()), readable(box.max().z())};
}

Json words(const Manipulator& block)
{
    const KeyFrame& last = std::get<FollowKeyFrames>(block.motion).frames.back();
    return {{"name", block.name},
            {"size_mm", readable(block.size)},
            {"position_mm", readable(block.pose.position)},
            {"speed_limit_mm_s", readable(block.speedLimit)},
            {"keyframes", {{{"time_s", last.time}, {"position_mm", readable(last.pose.position)}}}}};
}

} // namespace

std::string firstRecipe(const Model& model, const std::string& part)
{
    const FirstPress press = firstPress(model);
    const std::string name = std::filesystem::path(part).stem().string();
    Json recipe{
        {"version", 1},
        {"part", {{"file", part}}},
        {"objects", press.objects},
        {"material", {{"preset", "silicone-rubber"}, {"poisson_ratio", 0.35}}},
        {"integrator", "automatic"},
        {"fixtures", Json::array({{{"name", "end"}, {"box_mm", readable(press.held)}}})},
        {"manipulators", Json::array({words(press.block)})},
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
