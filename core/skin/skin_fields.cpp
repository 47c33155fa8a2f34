#include "core/skin/skin_fields.h"

#include "core/task/parallel.h"

namespace knead {

namespace {

constexpr std::size_t pointsPerBlock = 512;

} // namespace

SkinFields skinFields(const Skin& skin, std::span<const Vec3> displacement, std::span<const ObjectStrain> strains)
{
    SkinFields fields;
    fields.displacement.resize(skin.size());
    fields.strain.resize(skin.size());
    fields.vonMisesStress.resize(skin.size());
    forEachBlock(skin.size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t point = begin; point < end; ++point) {
            ObjectStrain here;
            Vec3 moved = Vec3::Zero();
            for (const Skin::Influence& influence : skin.influences(point)) {
                const auto weight = static_cast<double>(influence.weight);
                moved += weight * displacement[influence.object];
                here.strain += weight * strains[influence.object].strain;
                here.stress += weight * strains[influence.object].stress;
            }
            fields.displacement[point] = moved;
            fields.strain[point] = static_cast<float>(equivalentStrain(here.strain));
            fields.vonMisesStress[point] = static_cast<float>(vonMisesStress(here.stress));
        }
    });
    return fields;
}

} // namespace knead
