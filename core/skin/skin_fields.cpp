#include "core/skin/skin_fields.h"

#include "core/task/parallel.h"

#include <utility>

namespace knead {

namespace {

constexpr std::size_t pointsPerBlock = 512;

} // namespace

SkinFields skinFields(const Skin& skin, const SkinStress& stress, std::span<const Vec3> displacement,
                      const ObjectStrains& body, std::span<const ObjectIndex> loaded)
{
    SkinStresses stresses = stress.stresses(body, loaded, true);
    SkinFields fields{.displacement = std::vector<Vec3>(skin.size(), Vec3::Zero()),
                      .strain = stress.strains(body),
                      .vonMisesStress = std::move(stresses.vonMises),
                      .stressError = std::move(stresses.error),
                      .stressErrorShare = stresses.errorShare};
    forEachBlock(skin.size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t point = begin; point < end; ++point)
            for (const Skin::Influence& influence : skin.influences(point))
                fields.displacement[point] += static_cast<double>(influence.weight) * displacement[influence.object];
    });
    return fields;
}

} // namespace knead
