#include "core/simulation/snapshot.h"

#include "core/task/parallel.h"

namespace knead {

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

} // namespace knead
