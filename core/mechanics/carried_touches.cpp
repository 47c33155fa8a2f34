#include "core/mechanics/carried_touches.h"

#include "core/vicinity/point_grid.h"

#include <algorithm>

namespace knead {

namespace {

// New points take over from old ones as near as this, and those stick that are as near to their surface as that [spacings].
constexpr double nearTouch = 1;
constexpr double nearSurface = 0.1;
// The pressure of all is set right by no more than this, either way.
constexpr double mostCorrected = 2;

using Touch = SurfaceContacts::Touch;

/// Those of one surface.
std::vector<Touch> carriedOnes(std::span<const Touch> old, const Aggregate& before, const VectorArray& position,
                               const Aggregate& after, std::span<const Vec3> skin, const RigidSurface& surface)
{
    std::vector<Vec3> found;
    std::vector<Touch> touching;
    for (const Touch& touch : old)
        if (const auto spread = spreadOf(before.lattice, before.skin[touch.point].place)) {
            found.push_back(spread->at(position));
            touching.push_back(touch);
        }
    if (touching.empty())
        return {};
    VectorArray places(found.size());
    for (std::size_t n = 0; n < found.size(); ++n)
        places.set(n, found[n]);
    const double a = after.lattice.spacing;
    const PointGrid grid(places, a);
    const Box reach = surface.reach(nearTouch * a);
    std::vector<Touch> carried;
    std::vector<PointGrid::Found> nearest;
    double was = 0;
    double is = 0;
    for (const Touch& touch : touching)
        was += touch.friction.pressure;
    for (std::uint32_t p = 0; p < after.skin.size(); ++p) {
        const Vec3& place = skin[p];
        if (!reach.contains(place))
            continue;
        grid.nearest(place, 1, nearest);
        if (nearest.front().squared > nearTouch * nearTouch * a * a ||
            surface.nearest(place).distance > nearSurface * a)
            continue;
        const Touch& from = touching[nearest.front().point];
        const double share = after.skin[p].area / before.skin[from.point].area;
        const Touch touch{
            .surface = surface.id,
            .body = from.body,
            .point = p,
            .friction = {share * from.friction.hold, share * from.friction.pressure, from.friction.sticks}};
        is += touch.friction.pressure;
        carried.push_back(touch);
    }
    const double factor = was > 0 && is > 0 ? std::clamp(was / is, 1 / mostCorrected, mostCorrected) : 1;
    for (Touch& touch : carried) {
        touch.friction.hold *= factor;
        touch.friction.pressure *= factor;
    }
    return carried;
}

} // namespace

std::vector<Touch> carriedTouches(std::span<const Touch> touches, std::uint32_t body, const Aggregate& before,
                                  const VectorArray& position, const Aggregate& after, std::span<const Vec3> skin,
                                  std::span<const RigidSurface> surfaces)
{
    std::vector<Touch> all;
    for (const RigidSurface& surface : surfaces) {
        std::vector<Touch> old;
        for (const Touch& touch : touches)
            if (touch.body == body && touch.surface == surface.id && touch.point < before.skin.size() &&
                !touch.friction.isEmpty())
                old.push_back(touch);
        const std::vector<Touch> carried = carriedOnes(old, before, position, after, skin, surface);
        all.insert(all.end(), carried.begin(), carried.end());
    }
    return all;
}

} // namespace knead
