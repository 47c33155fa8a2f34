#include "core/skin/carried_fragments.h"

#include "core/aggregate/pieces.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/rigid_fit.h"
#include "core/skin/skin.h"

#include <cmath>
#include <utility>

namespace knead {

namespace {

constexpr double volumeSlack = 0.01;
constexpr int firmlyConnected = 6; // live connections of an object that does not dangle
constexpr int wellConnected = 9;   // live connections of an object whose surroundings say how it is deformed

/// Live connections per object.
std::vector<int> degrees(const Aggregate& part)
{
    std::vector<int> count(part.size(), 0);
    part.forEachConnection([&](std::uint32_t, ObjectIndex lower, ObjectIndex upper) {
        ++count[lower];
        ++count[upper];
    });
    return count;
}

/// By how much the well connected objects of a part have grown, on the mean; 0 when there are none.
/// @param numbers of its objects in the body
double volumeRatio(const Aggregate& part, const ObjectStrains& body, const std::vector<ObjectIndex>& numbers)
{
    const std::vector<int> degree = degrees(part);
    double before = 0;
    double after = 0;
    for (std::size_t i = 0; i < part.size(); ++i)
        if (degree[i] >= wellConnected) {
            before += part.volume[i];
            after += part.volume[i] * std::exp(body.of(numbers[i]).strain.trace());
        }
    return before > 0 ? after / before : 0;
}

double volumeAt(const TriangleMesh& rest, const std::vector<Vec3>& places)
{
    return massProperties({.vertices = places, .triangles = rest.triangles, .faceOfTriangle = {}}).volume;
}

/// Where the objects have gone on the whole.
void moveRigidly(const Fragment& fragment, const Aggregate& part, std::span<const Vec3> moved, CarriedFragment& carried)
{
    const std::vector<Vec3> before = part.lattice.positions();
    std::vector<Vec3> after = before;
    for (ObjectIndex i = 0; i < part.size(); ++i)
        after[i] += moved[i];
    const RigidFit fit = fitRigidMotion(before, after);
    for (std::size_t v = 0; v < carried.places.size(); ++v)
        carried.places[v] = fit.turn * (fragment.mesh.vertices[v] - fit.from) + fit.to;
    carried.isRigid = true;
}

/// What the fields of fragments are made of.
struct FieldSource {
    const ObjectStrains& body;
    std::span<const ObjectIndex> loaded;
    bool isWanted;
};

/// @param numbers of the part's objects in the body
CarriedFragment carriedBy(const Aggregate& part, const Fragment& fragment, std::span<const Vec3> moved,
                          const std::vector<ObjectIndex>& numbers, const FieldSource& source, TaskControl& control)
{
    CarriedFragment result;
    result.places.resize(fragment.mesh.vertices.size());
    TaskPortion placing(control, 0, 0.5);
    const Skin skin(part, fragment.mesh.vertices, placing);
    skin.evaluate(moved, result.places);
    TaskPortion straining(control, 0.5, 1);
    if (source.isWanted)
        result.fields =
            skinFields(skin, SkinStress(part, fragment.mesh, numbers, straining), moved, source.body, source.loaded);
    const double expected = volumeRatio(part, source.body, numbers) * fragment.volume;
    if (std::abs(volumeAt(fragment.mesh, result.places) - expected) <= volumeSlack * expected)
        return result;
    moveRigidly(fragment, part, moved, result);
    for (std::size_t v = 0; v < result.fields.displacement.size(); ++v)
        result.fields.displacement[v] = result.places[v] - fragment.mesh.vertices[v];
    return result;
}

} // namespace

std::vector<ObjectIndex> carriersOf(const Aggregate& aggregate, const Fragment& fragment,
                                    std::span<const std::uint16_t> isBroken)
{
    return firmOf(aggregate, fragment.objects, isBroken);
}

std::vector<ObjectIndex> firmOf(const Aggregate& aggregate, const std::vector<ObjectIndex>& objects,
                                std::span<const std::uint16_t> isBroken)
{
    std::vector<ObjectIndex> carriers = objects;
    for (std::size_t before = 0; before != carriers.size();) {
        before = carriers.size();
        const std::vector<int> degree = degrees(extract(aggregate, carriers, isBroken));
        std::vector<ObjectIndex> firm;
        for (std::size_t i = 0; i < carriers.size(); ++i)
            if (degree[i] >= firmlyConnected)
                firm.push_back(carriers[i]);
        carriers = std::move(firm);
    }
    return 2 * carriers.size() > objects.size() ? carriers : objects;
}

std::vector<CarriedFragment> carried(const Aggregate& aggregate, std::span<const Fragment> fragments,
                                     std::span<const BrokenConnection> broken, std::span<const Vec3> displacement,
                                     const RelaxedState* relaxed, std::span<const ObjectIndex> loaded,
                                     TaskControl& control)
{
    const std::vector<std::uint16_t> isBroken = brokenDirections(aggregate, broken);
    const RelaxedState unknown{.materials = MaterialMap({}, aggregate.size())};
    const ObjectStrains body(aggregate, displacement, relaxed != nullptr ? *relaxed : unknown, broken);
    const FieldSource source{.body = body, .loaded = loaded, .isWanted = relaxed != nullptr};
    std::vector<CarriedFragment> result;
    for (const Fragment& fragment : fragments) {
        TaskPortion portion = TaskPortion::ofItem(control, result.size(), fragments.size());
        const std::vector<ObjectIndex> carriers = carriersOf(aggregate, fragment, isBroken);
        const Aggregate part = extract(aggregate, carriers, isBroken);
        result.push_back(carriedBy(part, fragment, pickedOf(displacement, carriers), carriers, source, portion));
    }
    return result;
}

} // namespace knead
