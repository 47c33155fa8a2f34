#include "core/skin/surface_values.h"

#include "core/task/parallel.h"

#include <algorithm>

#include <utility>

namespace knead {

namespace {

constexpr std::size_t pointsPerBlock = 512;

template <typename ValueAt>
std::vector<float> atAllPoints(const Skin& skin, ValueAt&& valueAt)
{
    std::vector<float> values(skin.size());
    forEachBlock(skin.size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t point = begin; point < end; ++point)
            values[point] = static_cast<float>(valueAt(point));
    });
    return values;
}

/// Of vectors or tensors of objects.
template <typename Value, typename Of, typename Number>
std::vector<float> carried(const Skin& skin, Of&& of, Number&& number)
{
    return atAllPoints(skin, [&](std::size_t point) {
        Value sum = Value::Zero();
        for (const Skin::Influence& influence : skin.influences(point))
            sum += static_cast<double>(influence.weight) * of(influence.object);
        return number(sum);
    });
}

std::vector<float> lengths(const Skin& skin, std::span<const Vec3> vectors)
{
    return carried<Vec3>(
        skin, [&](ObjectIndex object) { return vectors[object]; }, [](const Vec3& sum) { return sum.norm(); });
}

/// Calls of(skin, objects) for strain or stress.
template <typename Of>
auto ofMaterial(const SurfaceState& state, Of&& of)
{
    const RelaxedState nothing{.materials = MaterialMap(Material{}, state.aggregate.size())};
    const ObjectStrains objects(state.aggregate, state.displacements,
                                state.relaxed != nullptr ? *state.relaxed : nothing, state.broken);
    if (state.stress != nullptr)
        return of(*state.stress, objects);
    std::vector<FreeSurface> surfaces(state.skin.size());
    return of(SkinStress(state.aggregate, state.skin.points(), std::move(surfaces)), objects);
}

std::vector<float> plasticStrains(const SurfaceState& state)
{
    const ObjectStrains objects(state.aggregate, state.displacements, *state.relaxed, state.broken);
    if (state.aggregate.former) // C tells what was elastic when it was filled; the flow of before is a number
        return atAllPoints(state.skin, [&](std::size_t point) {
            double sum = 0;
            for (const Skin::Influence& influence : state.skin.influences(point))
                sum += static_cast<double>(influence.weight) * objects.plasticStrain(influence.object);
            return std::max(0.0, sum);
        });
    if (!objects.hasFlowed())
        return std::vector<float>(state.skin.size(), 0);
    std::vector<Mat3> flow(state.aggregate.size());
    forEachBlock(flow.size(), pointsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            flow[i] = objects.flow(static_cast<ObjectIndex>(i));
    });
    return carried<Mat3>(
        state.skin, [&](ObjectIndex object) -> const Mat3& { return flow[object]; }, &equivalentStrain);
}

} // namespace

bool isKnown(SurfaceQuantity quantity, const SurfaceState& state)
{
    switch (quantity) {
    case SurfaceQuantity::displacement:
    case SurfaceQuantity::strain:
        return true;
    case SurfaceQuantity::vonMisesStress:
    case SurfaceQuantity::plasticStrain:
        return state.relaxed != nullptr;
    case SurfaceQuantity::contactForce:
        return state.pressing != nullptr;
    case SurfaceQuantity::distance:
        return state.original != nullptr && state.places.size() == state.skin.size();
    }
    return false;
}

std::vector<float> surfaceValues(SurfaceQuantity quantity, const SurfaceState& state)
{
    switch (quantity) {
    case SurfaceQuantity::displacement:
        if (state.aggregate.former && state.places.size() == state.opened.size()) // objects move since they were filled
            return atAllPoints(state.skin,
                               [&](std::size_t point) { return (state.places[point] - state.opened[point]).norm(); });
        return lengths(state.skin, state.displacements);
    case SurfaceQuantity::strain:
        return ofMaterial(state,
                          [](const SkinStress& skin, const ObjectStrains& objects) { return skin.strains(objects); });
    case SurfaceQuantity::vonMisesStress:
        return ofMaterial(state, [&](const SkinStress& skin, const ObjectStrains& objects) {
            return skin.stresses(objects, state.loaded, false).vonMises;
        });
    case SurfaceQuantity::plasticStrain:
        return plasticStrains(state);
    case SurfaceQuantity::contactForce:
        return lengths(state.skin, *state.pressing);
    case SurfaceQuantity::distance:
        break;
    }
    return atAllPoints(state.skin,
                       [&](std::size_t point) { return state.original->nearest(state.places[point]).signedDistance; });
}

SkinStresses surfaceStresses(const SurfaceState& state)
{
    return ofMaterial(state, [&](const SkinStress& skin, const ObjectStrains& objects) {
        return skin.stresses(objects, state.loaded, true);
    });
}

} // namespace knead
