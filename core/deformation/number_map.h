#pragma once

#include "core/deformation/number_deformation.h"

#include <array>
#include <memory>

namespace knead {

/// Carries space as a NumberDeformation says. Before, between and behind the planes it is smooth; across them the slope may change
/// where it does not ease, so faces are carried by the zone that they lie in (ofFace), which goes on smoothly beyond its planes.
class NumberMap final : public SmoothMap {
public:
    enum class Zone : std::uint8_t { before, between, behind };

    /// @throws Problem where planes, directions or numbers make no map
    explicit NumberMap(const NumberDeformation& deformation);

    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override;
    double featureSize() const override { return m_featureSize; }
    const SmoothMap& ofFace(std::span<const Vec3> places) const override;

    const NumberDeformation& deformation() const { return m_deformation; }

    /// Where a place goes as one of a zone does, wherever it lies.
    Vec3 placeAs(Zone zone, const Vec3& point) const { return place(point, zone); }

    /// Where a place is along the axis from the origin [m].
    double along(const Vec3& place) const { return m_deformation.axis.dot(place - m_deformation.origin); }

private:
    class OfZone;

    /// @param zone whose formula it is, wherever the place is
    Vec3 place(const Vec3& point, Zone zone) const;
    Zone zoneOf(double along) const;

    NumberDeformation m_deformation;
    Vec3 m_across = Vec3::UnitY(); ///< axis x side
    double m_featureSize = 0;
    std::array<std::shared_ptr<const SmoothMap>, 3> m_zones;
};

/// How much of a deformation a cross-section has between the planes, at a share of the way: 0 at the first plane, 1 at the second one.
double profileOf(const NumberDeformation& deformation, double share);

/// @throws Problem as NumberMap
std::shared_ptr<const NumberMap> numberMap(const NumberDeformation& deformation);

} // namespace knead
