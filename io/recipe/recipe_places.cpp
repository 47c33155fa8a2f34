#include "io/recipe/recipe_places.h"

#include "core/message/message.h"

#include <algorithm>
#include <optional>
#include <set>

namespace knead {

namespace {

constexpr std::size_t mostFaces = 200; // that are looked at
constexpr double boxMargin = 0.25;     // [a] around objects, so that rounding leaves none out
constexpr double readableStep = 1e-6;  // [m]: a thousandth of a millimeter

/// As the simulation takes them: each once, and none that is not there.
std::vector<ObjectIndex> inOrder(std::vector<ObjectIndex> objects, std::size_t count)
{
    std::sort(objects.begin(), objects.end());
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    std::erase_if(objects, [&](ObjectIndex object) { return object >= count; });
    if (objects.empty())
        throw Problem(Message("Recipe", "a fixture holds no object of its body."));
    return objects;
}

/// The faces whose objects these are, if there are any.
std::vector<std::uint32_t> facesOf(const Aggregate& aggregate, const TriangleMesh& mesh,
                                   const std::vector<ObjectIndex>& objects)
{
    std::set<std::uint32_t> near;
    for (const ObjectIndex object : objects)
        if (object < aggregate.face.size())
            near.insert(aggregate.face[object]);
    if (mesh.faceOfTriangle.empty() || near.size() > mostFaces)
        return {};
    std::vector<std::uint32_t> faces;
    for (const std::uint32_t face : near) {
        const std::vector<ObjectIndex> held = objectsAtFaces(aggregate, mesh, {face});
        if (!held.empty() && std::includes(objects.begin(), objects.end(), held.begin(), held.end()))
            faces.push_back(face);
    }
    return !faces.empty() && objectsAtFaces(aggregate, mesh, faces) == objects ? faces : std::vector<std::uint32_t>{};
}

Vec3 rounded(const Vec3& place)
{
    return (place / readableStep).array().round() * readableStep;
}

std::optional<Box> boxOf(const Aggregate& aggregate, const std::vector<ObjectIndex>& objects)
{
    Box box;
    for (const ObjectIndex object : objects)
        box.extend(aggregate.lattice.position(object));
    const Vec3 around = Vec3::Constant(boxMargin * aggregate.lattice.spacing);
    box = Box(rounded(box.min() - around), rounded(box.max() + around));
    return objectsInBox(aggregate, box) == objects ? std::optional(box) : std::nullopt;
}

} // namespace

RecipeRegion placeOf(const Aggregate& aggregate, const TriangleMesh* mesh, std::vector<ObjectIndex> objects)
{
    objects = inOrder(std::move(objects), aggregate.size());
    RecipeRegion place;
    if (mesh != nullptr)
        place.faces = facesOf(aggregate, *mesh, objects);
    if (place.faces.empty())
        place.box = boxOf(aggregate, objects);
    if (place.faces.empty() && !place.box)
        place.objects = {std::move(objects), aggregate.size()};
    return place;
}

RecipeRegion laterPlaceOf(std::uint32_t count, std::vector<ObjectIndex> objects)
{
    RecipeRegion place;
    place.objects = {inOrder(std::move(objects), count), count, true};
    return place;
}

} // namespace knead
