#pragma once

#include "core/aggregate/connection_id.h"
#include "core/geometry/surface_distance.h"
#include "core/mechanics/object_strain.h"
#include "core/skin/skin.h"
#include "core/skin/skin_stress.h"

#include <cstdint>
#include <span>
#include <vector>

namespace knead {

/// What can be shown as colors on the surface of a body.
enum class SurfaceQuantity : std::uint8_t {
    displacement,   ///< length of the way from rest [m]
    strain,         ///< see equivalentStrain(), plastic flow included
    vonMisesStress, ///< see SkinStress [Pa]
    plasticStrain,  ///< the equivalent strain between the relaxed material of the start and that of now
    contactForce,   ///< what presses, per object [N]
    distance        ///< from the original surface, negative inside [m]
};
inline constexpr std::size_t surfaceQuantityCount = 6;

/// A body at one moment. What is not known is left out; surfaceValues() then has nothing to tell.
struct SurfaceState {
    const Aggregate& aggregate;
    const Skin& skin;
    std::span<const Vec3> displacements;           ///< per object, from rest [m]
    std::span<const BrokenConnection> broken = {}; ///< connections
    const SkinStress* stress =
        nullptr; ///< of the points of the skin; null: made for once, with no surface known as free
    std::span<const ObjectIndex> loaded = {};    ///< objects that something holds or presses on
    const RelaxedState* relaxed = nullptr;       ///< for stress and plastic strain
    const std::vector<Vec3>* pressing = nullptr; ///< per object, for the contact force [N]
    const SurfaceDistance* original = nullptr;   ///< for the distance
    std::span<const Vec3> places = {};           ///< of the points of the skin, for the distance [m]
    std::span<const Vec3> opened = {};           ///< where they were in the opened part, for the displacement [m]
};

/// Whether the state tells a quantity.
bool isKnown(SurfaceQuantity quantity, const SurfaceState& state);

/// A quantity at the points of the skin: strain and stress by SkinStress; others are those of the objects, tensors and vectors
/// each with its weight in the skin, and the number made of what that gives. Any thread; uses several.
/// @pre isKnown(quantity, state)
std::vector<float> surfaceValues(SurfaceQuantity quantity, const SurfaceState& state);

/// The von Mises stress with the estimate of its error. Any thread; uses several.
/// @pre isKnown(SurfaceQuantity::vonMisesStress, state)
SkinStresses surfaceStresses(const SurfaceState& state);

} // namespace knead
