#include "core/session/body_maps.h"

#include "core/session/part_pairs.h"
#include "core/task/parallel.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

constexpr std::size_t pairsPerReport = 16;
constexpr std::size_t placesPerReport = 2048;
constexpr std::size_t placesAtOnce = 16; // between looks at whether to go on; each may ask all bodies

std::vector<const Part*> pointersTo(std::span<const Part> parts)
{
    std::vector<const Part*> pointers;
    for (const Part& part : parts)
        pointers.push_back(&part);
    return pointers;
}

/// Does so many things at a time, with progress in between.
template <class Do>
void inSlices(std::size_t all, std::size_t slice, TaskControl& control, const Do& doSome)
{
    for (std::size_t first = 0; first < all; first += slice) {
        control.throwIfCancelled();
        control.report(static_cast<double>(first) / static_cast<double>(all), "finding the faces again");
        doSome(first, std::min(slice, all - first));
    }
}

BodyMap mapOfBodies(const Part& from, const Part& to, const AffineMap& base, const TaskControl& control)
{
    const std::vector<FaceLook> looksBefore = faceLooks(from, control);
    const std::vector<FaceLook> looksAfter = faceLooks(to, control);
    BodyMap map;
    map.box = boxOfPlaces(from.mesh.vertices);
    map.matches = matchFaces(looksBefore, map.box, looksAfter, boxOfPlaces(to.mesh.vertices), base, control);
    map.places = std::make_shared<const PlaceMap>(from, looksBefore, looksAfter, map.matches, base, control);
    control.throwIfCancelled();
    map.surface = std::make_shared<const SurfaceDistance>(from.mesh);
    return map;
}

} // namespace

std::optional<std::uint32_t> BodyMap::faceAfter(std::uint32_t face) const
{
    const auto found = std::ranges::lower_bound(matches, face, {}, &FaceMatch::before);
    return found == matches.end() || found->before != face ? std::nullopt : std::optional(found->after);
}

std::vector<BodyMap> mapBodies(std::span<const Part> before, std::span<const Part> after, const AffineMap& base,
                               TaskControl& control)
{
    const std::vector<const Part*> originals = pointersTo(before);
    const std::vector<const Part*> others = pointersTo(after);
    const std::vector<PartPair> pairs = pairsOfParts(originals, others);
    std::vector<BodyMap> maps(pairs.size());
    inSlices(pairs.size(), pairsPerReport, control, [&](std::size_t first, std::size_t count) {
        forEachBlock(count, 1, control, [&](std::size_t i, std::size_t) {
            const PartPair& pair = pairs[first + i];
            maps[first + i] = mapOfBodies(before[pair.before], after[pair.after], base, control);
            maps[first + i].before = static_cast<BodyId>(pair.before);
            maps[first + i].after = static_cast<BodyId>(pair.after);
        });
    });
    std::ranges::sort(maps, {}, &BodyMap::before);
    return maps;
}

NearestBody nearestBody(std::span<const BodyMap> bodies, const Vec3& place)
{
    NearestBody nearest;
    for (const BodyMap& body : bodies) {
        // Outside of its box it is farther away than that.
        if (nearest.body != nullptr && !body.box.contains(place) &&
            body.box.exteriorDistance(place) >= nearest.hit.signedDistance)
            continue;
        const SurfaceDistance::Hit hit = body.surface->nearest(place);
        if (nearest.body == nullptr || hit.signedDistance < nearest.hit.signedDistance)
            nearest = {&body, hit};
    }
    return nearest;
}

Vec3 placeOnPart(std::span<const BodyMap> bodies, const Vec3& place)
{
    return nearestBody(bodies, place).body->places->at(place);
}

std::vector<Vec3> placesOnPart(std::span<const BodyMap> bodies, std::span<const Vec3> places, TaskControl& control)
{
    std::vector<Vec3> result(places.size());
    inSlices(places.size(), placesPerReport, control, [&](std::size_t first, std::size_t count) {
        forEachBlock(count, placesAtOnce, control, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = first + begin; i < first + end; ++i)
                result[i] = placeOnPart(bodies, places[i]);
        });
    });
    return result;
}

} // namespace knead
