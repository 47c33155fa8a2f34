#include "core/session/skin_place.h"

#include "core/geometry/shape_fit.h"
#include "core/geometry/surface_distance.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace knead {

namespace {

Vec3 blend(const std::array<Vec3, 3>& corners, const Vec3& shares)
{
    return shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2];
}

/// The place that was nearest to another one so far.
struct Nearest {
    std::optional<SkinPlace> place;
    double distance = std::numeric_limits<double>::max(); ///< squared [m^2]
};

/// @param face of it only; none: all of the body
void lookForNearest(BodyId id, const FilledBody& body, const std::optional<std::uint32_t>& face, const Vec3& at,
                    Nearest& nearest)
{
    for (std::uint32_t t = 0; t < body.mesh.triangles.size(); ++t) {
        if (face && body.mesh.faceOfTriangle[t] != *face)
            continue;
        const auto corners = cornersOf(body.mesh.vertices, body.mesh.triangles[t]);
        const Vec3 shares = nearestShares(corners, at);
        if (const double distance = (blend(corners, shares) - at).squaredNorm(); distance < nearest.distance)
            nearest = {SkinPlace{id, t, shares}, distance};
    }
}

} // namespace

Vec3 placeOf(const SkinPlace& place, const FilledBody& body, std::span<const Vec3> places)
{
    return blend(cornersOf(places, body.mesh.triangles[place.triangle]), place.shares);
}

std::optional<Vec3> seenPlace(const SkinPlace& place, const FilledModel& content, const Frame& frame,
                              const std::set<std::size_t>& hiddenParts)
{
    if (place.body >= content.bodies.size() || place.body >= frame.bodies.size())
        return std::nullopt;
    const FilledBody& body = *content.bodies[place.body];
    const std::vector<Vec3>& places = frame.bodies[place.body]->places;
    const bool isOfThisBody = place.triangle < body.mesh.triangles.size() && places.size() == body.mesh.vertices.size();
    if (!isOfThisBody || hiddenParts.contains(body.part))
        return std::nullopt;
    return placeOf(place, body, places);
}

std::optional<SkinPlace> nearestPlace(const Vec3& point, const FilledBodies& bodies)
{
    constexpr double farthest = 0.1; // of the size
    std::optional<SkinPlace> nearest;
    double least = std::numeric_limits<double>::infinity();
    Box box;
    for (BodyId b = 0; b < bodies.size(); ++b) {
        if (!bodies[b])
            continue;
        const TriangleMesh& mesh = bodies[b]->mesh;
        box.extend(boxOfPlaces(mesh.vertices));
        const SurfaceDistance::Hit hit = SurfaceDistance(mesh).nearest(point);
        if (hit.distance >= least)
            continue;
        least = hit.distance;
        nearest = {b, hit.triangle, nearestShares(cornersOf(mesh.vertices, mesh.triangles[hit.triangle]), hit.point)};
    }
    return nearest && least <= farthest * box.diagonal().norm() ? nearest : std::nullopt;
}

std::optional<std::uint32_t> faceOf(const SkinPlace& place, const FilledBody& body)
{
    if (body.mesh.faceOfTriangle.empty())
        return std::nullopt;
    return body.mesh.faceOfTriangle[place.triangle];
}

std::vector<std::uint32_t> trianglesOfFace(const SkinPlace& place, const FilledBody& body)
{
    std::vector<std::uint32_t> triangles(body.mesh.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0U);
    if (const auto face = faceOf(place, body))
        std::erase_if(triangles, [&](std::uint32_t t) { return body.mesh.faceOfTriangle[t] != *face; });
    return triangles;
}

std::size_t trueVertices(const FilledModel& content, const FilledBody& body)
{
    return body.whole ? body.mesh.vertices.size() : content.model->parts[body.part].mesh.vertices.size();
}

RestPlace restPlace(const SkinPlace& place, const FilledBodies& bodies)
{
    const FilledBody& body = *bodies[place.body];
    return {body.part, faceOf(place, body), placeOf(place, body, body.mesh.vertices)};
}

std::optional<SkinPlace> placeNear(const RestPlace& place, const FilledBodies& bodies)
{
    Nearest nearest;
    const auto found = std::ranges::find_if(bodies, [&](const auto& body) { return body->part == place.part; });
    if (found != bodies.end())
        lookForNearest(static_cast<BodyId>(found - bodies.begin()), **found, place.face, place.at, nearest);
    return nearest.place;
}

std::optional<SkinPlace> carriedOver(const SkinPlace& place, const FilledBodies& before, const FilledBodies& after)
{
    return placeNear(restPlace(place, before), after);
}

std::optional<SkinPlace> carriedOver(const SkinPlace& place, const FilledBodies& before, const CarriedSurfaces& carried,
                                     const FilledBodies& after)
{
    const FilledBody& old = *before[place.body];
    Nearest nearest;
    const std::vector<Vec3>& places = carried.places.at(place.body);
    if (places.size() != old.mesh.vertices.size())
        return std::nullopt; // it came apart in the meantime
    const Vec3 at = placeOf(place, old, places);
    for (BodyId body = 0; body < after.size(); ++body)
        if (carried.origin[after[body]->part] == old.part)
            lookForNearest(body, *after[body], std::nullopt, at, nearest);
    return nearest.place;
}

std::vector<ObjectShare> objectShares(const SkinPlace& place, const FilledBody& body)
{
    std::map<ObjectIndex, double> shares;
    for (int corner = 0; corner < 3; ++corner)
        for (const Skin::Influence& influence :
             body.skin->influences(body.mesh.triangles[place.triangle][static_cast<std::size_t>(corner)]))
            shares[influence.object] += place.shares[corner] * static_cast<double>(influence.weight);
    std::vector<ObjectShare> result;
    result.reserve(shares.size());
    for (const auto& [object, share] : shares)
        result.push_back({object, share});
    return result;
}

} // namespace knead
