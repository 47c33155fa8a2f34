#include "core/simulation/snapshot.h"

#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>

namespace knead {

double EnergyLedger::imbalanceShare() const
{
    constexpr double nothing = 1e-18; // rounding of a body at rest [J]: a share of that says nothing
    if (std::abs(imbalance) < nothing && created() < nothing)
        return 0;
    const double most = std::max({turnover, std::abs(toolWork), std::abs(imbalance)});
    return most > 0 ? std::max(std::abs(imbalance), created()) / std::max(most, created()) : 0;
}

Vec3 Snapshot::BodyState::displacement(ObjectIndex object) const
{
    return positions[object] - aggregate->lattice.position(object);
}

std::vector<Vec3> Snapshot::BodyState::displacements() const
{
    std::vector<Vec3> all(positions.size());
    forEachBlock(all.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            all[i] = displacement(static_cast<ObjectIndex>(i));
    });
    return all;
}

std::vector<ObjectIndex> loadedObjects(const Snapshot& snapshot, BodyId body)
{
    std::vector<ObjectIndex> loaded;
    for (const Fixture& fixture : snapshot.fixtures)
        if (fixture.body == body)
            loaded.insert(loaded.end(), fixture.objects.begin(), fixture.objects.end());
    if (const auto& pressing = snapshot.bodies[body].pressing)
        for (std::size_t i = 0; i < pressing->size(); ++i)
            if (!(*pressing)[i].isZero(0))
                loaded.push_back(static_cast<ObjectIndex>(i));
    std::sort(loaded.begin(), loaded.end());
    loaded.erase(std::unique(loaded.begin(), loaded.end()), loaded.end());
    return loaded;
}

} // namespace knead
