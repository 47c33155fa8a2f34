#pragma once

#include "core/geometry/smooth_map.h"

#include <gp_Pnt.hxx>

#include <vector>

namespace knead {

/// A map in metres for geometry in millimetres.
class MillimetreMap final : public SmoothMap {
public:
    /// `map` must outlive it.
    explicit MillimetreMap(const SmoothMap& map)
        : m_map(map)
    {
    }

    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override;
    double featureSize() const override { return 1e3 * m_map.featureSize(); }

    /// As SmoothMap::ofFace().
    /// @param places of the face [mm]
    MillimetreMap forFace(std::vector<Vec3> places) const;

private:
    const SmoothMap& m_map;
};

inline Vec3 toVec3(const gp_XYZ& p)
{
    return {p.X(), p.Y(), p.Z()};
}

inline gp_Pnt toPoint(const Vec3& p)
{
    return {p.x(), p.y(), p.z()};
}

} // namespace knead
