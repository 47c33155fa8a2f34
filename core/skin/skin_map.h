#pragma once

#include "core/aggregate/aggregate.h"
#include "core/geometry/smooth_map.h"
#include "core/skin/neighborhood_cache.h"

#include <vector>

namespace knead {

/// The map x(X) that carries the skin (see skin.h), at any place and in double precision: what takes exact shapes to the
/// deformed body. Where no object has moved, points stay exactly where they are.
class SkinMap final : public SmoothMap {
public:
    /// The aggregate must outlive it.
    /// @param displacements one per object, from rest [m]
    /// @throws std::invalid_argument for an aggregate without objects
    SkinMap(const Aggregate& aggregate, std::vector<Vec3> displacements);

    /// Uses several threads for many points.
    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override;

    /// The spacing of the objects: the map knows nothing finer [m].
    double featureSize() const override { return m_aggregate.lattice.spacing; }

private:
    /// @param around the objects that may carry the point
    Vec3 place(const Vec3& point, const Neighborhood& around) const;

    const Aggregate& m_aggregate;
    mutable NeighborhoodCache m_neighborhoods; // of use to many calls for a few points each
    std::vector<Vec3> m_displacements;
};

} // namespace knead
