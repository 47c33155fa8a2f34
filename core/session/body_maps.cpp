#include "core/session/body_maps.h"

#include "core/session/part_pairs.h"

#include <algorithm>
#include <cmath>

namespace knead {

namespace {

std::vector<const Part*> pointersTo(std::span<const Part> parts)
{
    std::vector<const Part*> pointers;
    for (const Part& part : parts)
        pointers.push_back(&part);
    return pointers;
}

} // namespace

std::optional<std::uint32_t> BodyMap::faceAfter(std::uint32_t face) const
{
    const auto found = std::ranges::find(matches, face, &FaceMatch::before);
    return found == matches.end() ? std::nullopt : std::optional(found->after);
}

std::vector<BodyMap> mapBodies(std::span<const Part> before, std::span<const Part> after, const AffineMap& base)
{
    const std::vector<const Part*> originals = pointersTo(before);
    const std::vector<const Part*> others = pointersTo(after);
    std::vector<BodyMap> maps;
    for (const PartPair& pair : pairsOfParts(originals, others)) {
        const Part& from = before[pair.before];
        const Part& to = after[pair.after];
        const std::vector<FaceLook> looksBefore = faceLooks(from);
        const std::vector<FaceLook> looksAfter = faceLooks(to);
        BodyMap map{.before = static_cast<BodyId>(pair.before), .after = static_cast<BodyId>(pair.after)};
        map.matches =
            matchFaces(looksBefore, boxOfPlaces(from.mesh.vertices), looksAfter, boxOfPlaces(to.mesh.vertices), base);
        map.places = std::make_shared<const PlaceMap>(from, looksBefore, looksAfter, map.matches, base);
        map.surface = std::make_shared<const SurfaceDistance>(from.mesh);
        maps.push_back(std::move(map));
    }
    std::ranges::sort(maps, {}, &BodyMap::before);
    return maps;
}

NearestBody nearestBody(std::span<const BodyMap> bodies, const Vec3& place)
{
    NearestBody nearest;
    for (const BodyMap& body : bodies) {
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

} // namespace knead
