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

/// A point that touched a surface before.
struct Touched {
    Touch touch;
    Vec3 place;   ///< [m]
    double depth; ///< that its spring feels [m]
};

std::vector<Touched> touchedBefore(std::span<const Touch> old, const Aggregate& before, const VectorArray& position,
                                   const RigidSurface& surface)
{
    std::vector<Touched> touched;
    for (const Touch& touch : old)
        if (const auto spread = spreadOf(before.lattice, before.skin[touch.point].place)) {
            const Vec3 place = spread->at(position);
            touched.push_back({touch, place, std::max(0.0, -surface.nearest(place).distance - touch.kept)});
        }
    return touched;
}

/// Those of one surface.
std::vector<Touch> carriedOnes(std::span<const Touched> touched, std::uint32_t body, const Aggregate& before,
                               const Aggregate& after, std::span<const Vec3> skin, const RigidSurface& surface)
{
    VectorArray places(touched.size());
    for (std::size_t n = 0; n < touched.size(); ++n)
        places.set(n, touched[n].place);
    const double a = after.lattice.spacing;
    const PointGrid grid(places, a);
    const Box reach = surface.reach(nearTouch * a);
    std::vector<Touch> carried;
    std::vector<PointGrid::Found> nearest;
    double was = 0;
    double is = 0;
    for (const Touched& each : touched)
        was += each.touch.friction.pressure;
    for (std::uint32_t p = 0; p < after.skin.size(); ++p) {
        const Vec3& place = skin[p];
        if (!reach.contains(place))
            continue;
        const double distance = surface.nearest(place).distance;
        if (distance > nearSurface * a)
            continue;
        Touch touch{.surface = surface.id, .body = body, .point = p, .kept = std::max(0.0, -distance)};
        nearest.clear();
        if (!touched.empty())
            grid.nearest(place, 1, nearest);
        if (!nearest.empty() && nearest.front().squared <= nearTouch * nearTouch * a * a) {
            const Touched& from = touched[nearest.front().point];
            const double share = after.skin[p].area / before.skin[from.touch.point].area;
            const FrictionMemory& friction = from.touch.friction;
            touch.friction = {share * friction.hold, share * friction.pressure, friction.sticks};
            touch.kept = std::max(0.0, touch.kept - from.depth);
            is += touch.friction.pressure;
        }
        if (touch.kept > 0 || !touch.friction.isEmpty())
            carried.push_back(touch);
    }
    const double factor = was > 0 && is > 0 ? std::clamp(was / is, 1 / mostCorrected, mostCorrected) : 1;
    for (Touch& touch : carried) {
        touch.friction.hold *= factor;
        touch.friction.pressure *= factor;
    }
    const auto count = static_cast<std::uint32_t>(after.skin.size());
    for (ObjectIndex i = 0; i < after.size(); ++i) {
        const Vec3 place = after.lattice.position(i);
        if (!reach.contains(place))
            continue;
        if (const double distance = surface.nearest(place).distance; distance < 0)
            carried.push_back(
                {.surface = surface.id, .body = body, .point = count + i, .friction = {}, .kept = -distance});
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
        const std::vector<Touch> carried =
            carriedOnes(touchedBefore(old, before, position, surface), body, before, after, skin, surface);
        all.insert(all.end(), carried.begin(), carried.end());
    }
    return all;
}

} // namespace knead
