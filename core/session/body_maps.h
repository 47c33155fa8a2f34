#pragma once

#include "core/session/face_matching.h"
#include "core/session/place_map.h"
#include "core/simulation/scene.h"
#include "core/task/task_control.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace knead {

/// A body and the one of another part that it is there.
struct BodyMap {
    BodyId before = 0;
    BodyId after = 0;
    std::vector<FaceMatch> matches;
    std::shared_ptr<const PlaceMap> places;
    std::shared_ptr<const SurfaceDistance> surface; ///< of the body before
    Box box;                                        ///< of that [m]

    std::optional<std::uint32_t> faceAfter(std::uint32_t before) const;
};

/// Bodies by their names, else in their order, and their faces: see matchFaces(). On all threads.
/// @param before outlive the result
/// @throws Cancelled
std::vector<BodyMap> mapBodies(std::span<const Part> before, std::span<const Part> after, const AffineMap& base,
                               TaskControl& control = TaskControl::none());

/// The body whose surface is nearest to a place, and where that is on it. @pre there is a body
struct NearestBody {
    const BodyMap* body = nullptr;
    SurfaceDistance::Hit hit;
};
NearestBody nearestBody(std::span<const BodyMap> bodies, const Vec3& place);

/// Where a place is on the other part, by the body that is nearest. @pre there is a body
Vec3 placeOnPart(std::span<const BodyMap> bodies, const Vec3& place);
/// The same of many, on all threads. @throws Cancelled
std::vector<Vec3> placesOnPart(std::span<const BodyMap> bodies, std::span<const Vec3> places,
                               TaskControl& control = TaskControl::none());

} // namespace knead
