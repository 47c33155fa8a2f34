#pragma once

#include "core/session/frame.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace knead {

/// A place on the skin of a body, which goes along with it.
struct SkinPlace {
    BodyId body = 0;
    std::uint32_t triangle = 0; ///< of FilledBody::mesh
    Vec3 shares = {1, 0, 0};    ///< of its corners, 0 .. 1; they add up to 1
};

/// @param places of the body's vertices: BodyFrame::places, or those of the mesh at rest [m]
Vec3 placeOf(const SkinPlace& place, const FilledBody& body, std::span<const Vec3> places);

/// Where a place is seen in a frame of `content` [m]; none when its part is hidden, or when it belongs to a content that was shown
/// before: whoever hears of another one later than the view still has places of that.
/// @param hiddenParts by index into Model::parts
std::optional<Vec3> seenPlace(const SkinPlace& place, const FilledModel& content, const Frame& frame,
                              const std::set<std::size_t>& hiddenParts);

/// The place of bodies at rest that is nearest to a point [m]; null ones are left out. None where there is none, and where the
/// point is farther away than a tenth of the size of the bodies: somebody took other units or another origin.
std::optional<SkinPlace> nearestPlace(const Vec3& point, const FilledBodies& bodies);

/// CAD face that the place lies on; none on plain meshes.
std::optional<std::uint32_t> faceOf(const SkinPlace& place, const FilledBody& body);

/// Triangles of the face that the place lies on; all of a plain mesh.
std::vector<std::uint32_t> trianglesOfFace(const SkinPlace& place, const FilledBody& body);

/// How many vertices of the body lie on the surface as imported: the first ones. The others are middles of split edges. All of them
/// where the body came apart, since they are mixed there.
std::size_t trueVertices(const FilledModel& content, const FilledBody& body);

/// A place of a part at rest, whatever its body is filled with.
struct RestPlace {
    std::size_t part = 0;              ///< index into Model::parts
    std::optional<std::uint32_t> face; ///< CAD face that it lies on; none on plain meshes
    Vec3 at = Vec3::Zero();            ///< [m]
};
RestPlace restPlace(const SkinPlace& place, const FilledBodies& bodies);

/// The place of bodies that is nearest to one of a part, on its face; none when its part is not among them.
std::optional<SkinPlace> placeNear(const RestPlace& place, const FilledBodies& bodies);

/// The same place on bodies that were filled anew; none when its part is no longer among them.
std::optional<SkinPlace> carriedOver(const SkinPlace& place, const FilledBodies& before, const FilledBodies& after);

/// Where the surfaces of bodies were taken when their parts were deformed, or others came beside them.
struct CarriedSurfaces {
    std::vector<std::vector<Vec3>> places; ///< per body: of the vertices of its mesh as it was shown [m]
    std::vector<std::size_t> origin;       ///< per part after it: as PartsInstead::origin
};

/// The place of deformed bodies that a place has become: the nearest one of what its part has become; none when that has no bodies.
std::optional<SkinPlace> carriedOver(const SkinPlace& place, const FilledBodies& before, const CarriedSurfaces& carried,
                                     const FilledBodies& after);

/// How much an object moves the place; they add up to 1.
struct ObjectShare {
    ObjectIndex object = 0;
    double share = 0;
};
/// By object. @pre the body has a skin
std::vector<ObjectShare> objectShares(const SkinPlace& place, const FilledBody& body);

} // namespace knead
