#include "core/skin/surface_values.h"

#include "core/task/parallel.h"

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

std::vector<float> tensorNumbers(const SurfaceState& state, const Mat3 ObjectStrain::*tensor,
                                 double (*number)(const Mat3&))
{
    const RelaxedState nothing{.materials = MaterialMap(Material{}, state.aggregate.size())};
    const std::vector<ObjectStrain> strains = objectStrains(
        state.aggregate, state.displacements, state.relaxed != nullptr ? *state.relaxed : nothing, state.broken);
    return carried<Mat3>(
        state.skin, [&](ObjectIndex object) { return strains[object].*tensor; }, number);
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
        return lengths(state.skin, state.displacements);
    case SurfaceQuantity::strain:
        return tensorNumbers(state, &ObjectStrain::strain, &equivalentStrain);
    case SurfaceQuantity::vonMisesStress:
        return tensorNumbers(state, &ObjectStrain::stress, &vonMisesStress);
    case SurfaceQuantity::plasticStrain:
        return tensorNumbers(state, &ObjectStrain::flow, &equivalentStrain);
    case SurfaceQuantity::contactForce:
        return lengths(state.skin, *state.pressing);
    case SurfaceQuantity::distance:
        break;
    }
    return atAllPoints(state.skin,
                       [&](std::size_t point) { return state.original->nearest(state.places[point]).signedDistance; });
}

} // namespace knead
