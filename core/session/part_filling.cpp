#include "core/session/part_filling.h"

#include "core/aggregate/published_fill.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr double wantedObjects = 3000;      // soft rubber of so many runs about in real time on a small machine
constexpr double mostObjects = 8000;        // unasked, for the sake of thin walls that bend and twist well
constexpr double mostObjectsAtAll = 20'000; // unasked, for walls that would be much too stiff otherwise

/// To two digits: a number a person can read and type.
double roundedDown(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::floor(value / unit) * unit;
}

} // namespace

std::vector<std::size_t> partsToFill(const Model& model, bool fillsOpenParts)
{
    std::vector<std::size_t> parts;
    for (std::size_t p = 0; p < model.parts.size(); ++p)
        if (const Part& part = model.parts[p]; part.canBeFilled() || (fillsOpenParts && !part.mesh.empty()))
            parts.push_back(p);
    return parts;
}

FillingSizes fillingSizes(const Model& model, std::span<const std::size_t> parts,
                          const std::optional<SpacingChoice>& choice, TaskControl& control)
{
    const bool isByWalls = choice && choice->kind == SpacingChoice::Kind::CellsAcrossWall;
    FillingSizes sizes;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        TaskPortion portion = TaskPortion::ofItem(control, i, parts.size());
        const Part& part = model.parts[parts[i]];
        const FillingSize size =
            part.canBeFilled() || isByWalls ? sizeWithWalls(part.mesh, portion) : sizeOf(part.mesh);
        if (i == 0 || size.volume > sizes.largest.volume)
            sizes.largest = size;
        sizes.all.add(size);
    }
    return sizes;
}

double automaticSpacing(const FillingSizes& sizes)
{
    const FillingSize& all = sizes.all;
    const FillingSize& largest = sizes.largest;
    const double share = all.volume > 0 ? largest.volume / all.volume : 1;
    const double usual = spacingFor({SpacingChoice::Kind::Objects, std::max(500.0, wantedObjects * share)}, largest);
    const auto forWalls = [&all](double cells, double objects) {
        return std::max(spacingFor({SpacingChoice::Kind::CellsAcrossWall, cells}, all),
                        spacingFor({SpacingChoice::Kind::Objects, objects}, all));
    };
    return roundedDown(std::min(
        {usual, forWalls(goodCellsAcrossWall, mostObjects), forWalls(advisedCellsAcrossWall, mostObjectsAtAll)}));
}

double spacingOf(const std::optional<SpacingChoice>& choice, const FillingSizes& sizes)
{
    const double chosen = choice && choice->value > 0 ? spacingFor(*choice, sizes.all) : 0;
    return chosen > 0 ? chosen : automaticSpacing(sizes);
}

std::shared_ptr<const Aggregate> fillPart(const Part& part, double spacing, Arrangement arrangement,
                                          TaskControl& control)
{
    if (arrangement == Arrangement::published)
        return std::make_shared<const Aggregate>(fillAsPublished(part.mesh, spacing));
    const DirtySurface dirty = part.canBeFilled() ? DirtySurface::refuse : DirtySurface::windingNumber;
    return std::make_shared<const Aggregate>(fill(part.mesh, {.spacing = spacing, .dirty = dirty}, control));
}

Material startMaterial(std::span<const MaterialPreset> presets)
{
    const auto found = std::ranges::find(presets, startMaterialId, &MaterialPreset::id);
    return found == presets.end() ? Material{} : found->material;
}

} // namespace knead
