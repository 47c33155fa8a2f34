#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/geometry/smooth_map.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// A flat cut that ends within a part, or leaves it in one piece as that of a ring does: a rectangle at rest, from a straight tip in
/// the material, or from beyond it, to beyond the skin.
struct KnifeSlit {
    Vec3 origin = Vec3::Zero();            ///< middle of the tip, or of the end where there is none [m]
    Vec3 opening = Vec3::UnitX();          ///< from there to the mouth, length 1
    Vec3 along = Vec3::UnitY();            ///< along the tip, length 1
    double length = 0;                     ///< along `opening` [m]
    double halfTip = 0;                    ///< to either side along `along` [m]
    bool hasTip = true;                    ///< else it goes through at both ends
    double spacing = 0;                    ///< of the objects [m]
    std::vector<std::uint8_t> lipOfObject; ///< 1: below its plane, 2: above, where the normal points

    Vec3 normal() const { return opening.cross(along); }
};

/// None where anything tore, where knives went along more than one plane or the tip is not straight, and where the body has come apart.
std::optional<KnifeSlit> findKnifeSlit(const Aggregate& aggregate, std::span<const BrokenConnection> broken);

/// Carries what is beside a slit by the objects on its own side, so that its sides part; by one spacing from the tip that goes over
/// into the map of the whole, and so it does beyond a few spacings from the plane, where they are the same. A place on the plane
/// is above. Faces that are on one side are carried by that side alone, wherever they may be looked at.
class SlitMap final : public SmoothMap {
public:
    /// @param aggregate of the body, with all its connections and not filled anew
    /// @param displacements per object, from rest [m]
    SlitMap(const Aggregate& aggregate, const KnifeSlit& slit, const std::vector<Vec3>& displacements);
    ~SlitMap() override;

    void evaluate(std::span<const Vec3> points, std::span<Vec3> places) const override;
    double featureSize() const override { return m_slit.spacing; }
    const SmoothMap& ofFace(std::span<const Vec3> places) const override;

private:
    struct Part;
    class Side;

    /// @param lip of all points, or 0: that which each is of
    void evaluate(std::span<const Vec3> points, std::span<Vec3> places, std::size_t lip) const;

    double heightOf(const Vec3& place) const { return m_slit.normal().dot(place - m_slit.origin); } ///< [m]

    /// How much a place is carried by one lip alone, 0 .. 1.
    double shareOfLip(const Vec3& place, std::size_t lip) const;

    KnifeSlit m_slit;
    std::array<std::unique_ptr<const Side>, 3> m_sides; ///< of lips
    std::array<std::unique_ptr<const Part>, 3> m_parts; ///< the whole without broken connections, then the lips
};

} // namespace knead
