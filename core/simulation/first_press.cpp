#include "core/simulation/first_press.h"

#include "core/message/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace knead {

namespace {

constexpr double pressTime = 0.8; // [s]
constexpr double endTime = 1.0;   // [s]; the rest shows the material at rest
constexpr int fewObjects = 3000;
constexpr double manyObjects = 20'000;

constexpr double heldShare = 0.12;    // of an extent
constexpr double longShare = 2;       // times as long as thick: what is bent
constexpr double bendShare = 0.07;    // of the length
constexpr double squeezeShare = 0.12; // of the height
constexpr double thinWallShare =
    0.55;                          // of that, where walls are too thin for the objects: gaps as thin would close unseen
constexpr double breakShare = 0.5; // of the strain that the material bears

Box boxOfClosedParts(const Model& model)
{
    Box box;
    for (const Part& part : model.parts)
        if (part.canBeFilled())
            box.extend(part.box);
    if (box.isEmpty())
        throw Problem(
            Message("Filling", "%1: no closed body found. Close the surfaces in the CAD program and export again.")
                .with(std::filesystem::path(model.file).filename().string()));
    return box;
}

/// How a model is filled.
struct Filling {
    int objects = 0;
    double cells = 0; ///< across the thinnest wall, in the mean of its part, at most those that are wanted
};

/// Fine enough for two cells across the wall of every part, as far as a run of some seconds allows.
Filling suitableFilling(const Model& model)
{
    double volume = 0;
    double spacing = std::numeric_limits<double>::infinity();
    for (const Part& part : model.parts) {
        if (!part.canBeFilled() || !(part.volume > 0) || !(part.area > 0))
            continue;
        volume += part.volume;
        spacing = std::min(spacing, part.volume / part.area); // half the thickness of a plate
    }
    constexpr double wantedCells = 2;
    const double objects = volume / (spacing * spacing * spacing);
    return {objects > fewObjects ? static_cast<int>(std::min(objects, manyObjects)) : fewObjects,
            wantedCells * std::min(1.0, std::cbrt(manyObjects / objects))};
}

/// The axes of a box by its extent.
struct Axes {
    Eigen::Index longest = 0;
    Eigen::Index middle = 1;
    Eigen::Index shortest = 2;
};

Axes axesOf(const Box& box)
{
    std::array<Eigen::Index, 3> order{0, 1, 2};
    const Vec3 sizes = box.sizes();
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return sizes[a] > sizes[b]; });
    return {order[0], order[1], order[2]};
}

/// How much of an extent, from its low end, has the lowest tenth of the surface: a thin rim holds nothing.
double lowestTenth(const Model& model, const Box& box, Eigen::Index axis)
{
    constexpr double share = 0.1;
    constexpr int slices = 100;
    std::array<double, slices> areas{};
    double total = 0;
    const auto place = [&](double coordinate) { return slices * (coordinate - box.min()[axis]) / box.sizes()[axis]; };
    for (const Part& part : model.parts) {
        if (!part.canBeFilled())
            continue;
        for (const auto& [a, b, c] : part.mesh.triangles) {
            const Vec3& first = part.mesh.vertices[a];
            const Vec3& second = part.mesh.vertices[b];
            const Vec3& third = part.mesh.vertices[c];
            const double area = 0.5 * (second - first).cross(third - first).norm();
            const auto [low, high] = std::minmax({place(first[axis]), place(second[axis]), place(third[axis])});
            const int begin = std::clamp(static_cast<int>(low), 0, slices - 1);
            const int end = std::clamp(static_cast<int>(high), begin, slices - 1);
            for (int slice = begin; slice <= end; ++slice)
                areas.at(static_cast<std::size_t>(slice)) += area / (end - begin + 1);
            total += area;
        }
    }
    double sum = 0;
    for (int slice = 0; slice < slices; ++slice)
        if ((sum += areas.at(static_cast<std::size_t>(slice))) >= share * total)
            return static_cast<double>(slice + 1) / slices;
    return 1;
}

/// A slice of the model at the low end of an axis, with room around it so that rounding leaves nothing out.
Box lowEnd(const Model& model, const Box& box, Eigen::Index axis)
{
    const double room = 0.1 * box.diagonal().norm();
    const Vec3 low = box.min() - Vec3::Constant(room);
    Vec3 high = box.max() + Vec3::Constant(room);
    constexpr double most = 2.5 * heldShare; // the rest is to move
    high[axis] = box.min()[axis] + std::clamp(lowestTenth(model, box, axis), heldShare, most) * box.sizes()[axis];
    return {low, high};
}

/// How far up the model reaches along an axis, between two places of another one [m]; none where nothing is.
std::optional<double> topBetween(const Model& model, Eigen::Index along, double low, double high, Eigen::Index up)
{
    std::optional<double> top;
    const auto take = [&](const Vec3& point) { top = std::max(top.value_or(point[up]), point[up]); };
    for (const Part& part : model.parts) {
        if (!part.canBeFilled())
            continue;
        for (const TriangleMesh::Triangle& triangle : part.mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3& a = part.mesh.vertices[triangle[i]];
                const Vec3& b = part.mesh.vertices[triangle[(i + 1) % 3]];
                if (a[along] >= low && a[along] <= high)
                    take(a);
                for (const double place : {low, high})
                    if ((a[along] - place) * (b[along] - place) < 0)
                        take(a + (place - a[along]) / (b[along] - a[along]) * (b - a));
            }
    }
    return top;
}

/// A block that goes down along an axis by a stroke, after a small gap.
/// @param middle of the block across that axis; its coordinate along it is where the material begins [m]
Manipulator blockGoingDown(Vec3 middle, const Vec3& size, Eigen::Index down, double gap, double stroke)
{
    middle[down] += size[down] / 2;
    Vec3 start = middle;
    start[down] += gap;
    Vec3 end = middle;
    end[down] -= stroke;
    Manipulator block;
    block.name = "block";
    block.size = size;
    block.pose.position = start;
    block.speedLimit = 2 * (gap + stroke) / pressTime;
    block.motion = FollowKeyFrames{{{0, Pose{start}}, {pressTime, Pose{end}}}};
    return block;
}

/// Bends what is long or flat: the block goes down near the end that is free.
/// @param held where what is held ends, along the longest axis [m] @param share of what would be its stroke
Manipulator bendingBlock(const Model& model, const Box& box, const Axes& axes, double held, double share,
                         double bearableStrain)
{
    const double length = box.sizes()[axes.longest];
    const double place = box.min()[axes.longest] + 0.82 * length;
    Vec3 size;
    size[axes.longest] = 0.2 * length;
    size[axes.middle] = 1.2 * box.sizes()[axes.middle];
    size[axes.shortest] = std::max(0.25 * box.sizes()[axes.shortest], 0.05 * length);
    const double half = size[axes.longest] / 2;
    Vec3 middle = box.center();
    middle[axes.longest] = place;
    middle[axes.shortest] =
        topBetween(model, axes.longest, place - half, place + half, axes.shortest).value_or(box.max()[axes.shortest]);
    // Strain at the skin of a clamped bar, its end moved by d: e = 3 t d / (2 l^2).
    const double arm = place - held;
    const double mostStroke = breakShare * bearableStrain * 2 * arm * arm / (3 * box.sizes()[axes.shortest]);
    return blockGoingDown(middle, size, axes.shortest, 0.01 * length, std::min(share * bendShare * length, mostStroke));
}

/// Whether material is less than half of the box.
bool isHollow(const Model& model, const Box& box)
{
    double volume = 0;
    for (const Part& part : model.parts)
        volume += part.canBeFilled() ? part.volume : 0;
    return volume < 0.5 * box.sizes().prod();
}

/// Squeezes what is compact, along its shortest extent: a block over part of a solid body, all over a hollow one, whose walls an
/// edge would fold.
Manipulator squeezingBlock(const Model& model, const Box& box, const Axes& axes, double share, double bearableStrain)
{
    const double height = box.sizes()[axes.shortest];
    Vec3 size = (isHollow(model, box) ? 1.2 : 0.6) * box.sizes();
    size[axes.middle] = 1.2 * box.sizes()[axes.middle];
    size[axes.shortest] = 0.25 * height;
    Vec3 middle = box.center();
    const double half = size[axes.longest] / 2;
    middle[axes.shortest] =
        topBetween(model, axes.longest, middle[axes.longest] - half, middle[axes.longest] + half, axes.shortest)
            .value_or(box.max()[axes.shortest]);
    const double stroke = std::min(share * squeezeShare, breakShare * bearableStrain);
    return blockGoingDown(middle, size, axes.shortest, 0.02 * height, stroke * height);
}

} // namespace

double strainAtBreak(const Material& material)
{
    if (!material.breaks())
        return std::numeric_limits<double>::infinity();
    if (material.yields() && material.elongationAtBreak > 0)
        return material.elongationAtBreak;
    return material.tensileStrength / material.youngsModulus;
}

FirstPress firstPress(const Model& model, double bearableStrain)
{
    const Box box = boxOfClosedParts(model);
    const Axes axes = axesOf(box);
    const bool isLong = box.sizes()[axes.longest] >= longShare * box.sizes()[axes.shortest];
    const auto bodies =
        std::count_if(model.parts.begin(), model.parts.end(), [](const Part& one) { return one.canBeFilled(); });
    FirstPress press;
    press.held = lowEnd(model, box, isLong ? axes.longest : axes.shortest);
    const Filling filling = suitableFilling(model);
    // Two cells across a wall show what it does.
    const double share = std::max(thinWallShare, std::min(1.0, 0.5 * filling.cells));
    press.block = isLong ? bendingBlock(model, box, axes, press.held.max()[axes.longest], share, bearableStrain)
                         : squeezingBlock(model, box, axes, share, bearableStrain);
    press.bends = isLong;
    press.duration = endTime;
    press.hasBodies = bodies > 1;
    press.objects = filling.objects;
    return press;
}

} // namespace knead
