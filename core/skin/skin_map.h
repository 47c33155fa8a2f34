#pragma once

#include "core/aggregate/aggregate.h"
#include "core/geometry/smooth_map.h"
#include <memory>
#include <vector>

namespace knead {

class NeighborhoodCache;
struct Neighborhood;

/// The map x(X) that carries the skin (see skin.h), at any place and in double precision: what takes exact shapes to the
/// deformed body. Where no object has moved, points stay exactly where they are. Of an aggregate that was filled anew, points of the
/// opened part go through its former shape first.
class SkinMap final : public SmoothMap {
public:
    /// The aggregate must outlive it.
    /// @param displacements one per object, from rest [m]
    /// @param mostBytes kept for points that are near each other, but asked for in other calls
    /// @throws std::invalid_argument for an aggregate without objects
    SkinMap(const Aggregate& aggregate, std::vector<Vec3> displacements,
            std::size_t mostBytes = std::size_t{128} << 20);

    ~SkinMap() override;

    /// Uses several threads for many points.
    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override;

    /// The spacing of the objects, as long as it was in the opened part: the map knows nothing finer [m].
    double featureSize() const override { return m_featureSize; }

    const std::vector<Vec3>& displacements() const { return m_displacements; }

private:
    /// @param around the objects that may carry the point
    Vec3 place(const Vec3& point, const Neighborhood& around) const;

    const Aggregate& m_aggregate;
    std::unique_ptr<NeighborhoodCache> m_neighborhoods; // of use to many calls for a few points each
    std::vector<Vec3> m_displacements;
    double m_featureSize = 0;
};

} // namespace knead
