#include "app/first_recipe.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace knead {

namespace {

using Json = nlohmann::ordered_json;

constexpr double pressTime = 0.8; // [s]
constexpr double endTime = 1.0;   // [s]; the rest shows the material at rest
constexpr int fewObjects = 3000;
constexpr double manyObjects = 20'000;

Box boxOfClosedParts(const Model& model)
{
    Box box;
    for (const Part& part : model.parts)
        if (part.canBeFilled())
            box.extend(part.box);
    if (box.isEmpty())
        throw std::runtime_error(std::filesystem::path(model.file).filename().string() +
                                 ": no closed body found. Close the surfaces in the CAD program and export again.");
    return box;
}

/// Fine enough for two cells across the wall of every part, as far as a run of some seconds allows.
int suitableObjects(const Model& model)
{
    double volume = 0;
    double spacing = std::numeric_limits<double>::infinity();
    for (const Part& part : model.parts) {
        if (!part.canBeFilled() || !(part.volume > 0) || !(part.area > 0))
            continue;
        volume += part.volume;
        spacing = std::min(spacing, part.volume / part.area); // half the thickness of a plate
    }
    const double objects = volume / (spacing * spacing * spacing);
    return objects > fewObjects ? static_cast<int>(std::min(objects, manyObjects)) : fewObjects;
}

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

/// Everything up to a tenth of the height, with room around it so that rounding leaves nothing out.
Json lowestTenth(const Box& box)
{
    const double room = 0.1 * box.diagonal().norm();
    const Vec3 low = box.min() - Vec3::Constant(room);
    const Vec3 high(box.max().x() + room, box.max().y() + room, box.min().z() + 0.1 * box.sizes().z());
    return {readable(low.x()),  readable(low.y()),  readable(low.z()),
            readable(high.x()), readable(high.y()), readable(high.z())};
}

/// Where the block goes down [x in m]: over the top of the part, which need not be the middle of its box.
double placeOfTop(const Model& model, const Box& box)
{
    const double nearTop = box.max().z() - 0.02 * box.sizes().z();
    const double middle = box.center().x();
    double place = std::numeric_limits<double>::infinity();
    for (const Part& part : model.parts)
        for (const Vec3& vertex : part.mesh.vertices)
            if (part.canBeFilled() && vertex.z() >= nearTop && std::abs(vertex.x() - middle) < std::abs(place - middle))
                place = vertex.x();
    return std::isfinite(place) ? place : middle;
}

Json pressingBlock(const Model& model, const Box& box)
{
    const Vec3 part = box.sizes();
    const Vec3 size(0.35 * part.x(), 1.2 * part.y(), 0.25 * part.z());
    const double gap = 0.02 * box.diagonal().norm();
    const double depth = 0.25 * part.z();
    const Vec3 top(placeOfTop(model, box), box.center().y(), box.max().z());
    const Vec3 start = top + Vec3(0, 0, gap + size.z() / 2);
    const Vec3 end = top + Vec3(0, 0, size.z() / 2 - depth);
    return {{"name", "block"},
            {"size_mm", readable(size)},
            {"position_mm", readable(start)},
            {"speed_limit_mm_s", readable(2 * (gap + depth) / pressTime)},
            {"keyframes", {{{"time_s", pressTime}, {"position_mm", readable(end)}}}}};
}

} // namespace

std::string firstRecipe(const Model& model, const std::string& part)
{
    const Box box = boxOfClosedParts(model);
    const std::string name = std::filesystem::path(part).stem().string();
    const Json recipe{
        {"version", 1},
        {"part", {{"file", part}}},
        {"objects", suitableObjects(model)},
        {"material", {{"preset", "silicone-rubber"}, {"poisson_ratio", 0.35}}},
        {"fixtures", Json::array({{{"name", "bottom"}, {"box_mm", lowestTenth(box)}}})},
        {"manipulators", Json::array({pressingBlock(model, box)})},
        {"duration_s", endTime},
        {"exports", Json::array({{{"file", name + "-pressed.step"}},
                                 {{"file", name + "-pressed.stl"}},
                                 {{"file", name + "-pressed.png"}}})},
    };
    return recipe.dump(2) + "\n";
}

} // namespace knead
