#pragma once

#include "core/aggregate/pieces.h"
#include "core/mechanics/object_state.h"

#include <vector>

namespace knead {

/// Momenta of a connected piece of material.
struct PieceMomenta {
    std::size_t objects = 0;
    double mass = 0;             ///< of inertia [kg]
    double weighed = 0;          ///< that gravity pulls at [kg]
    Vec3 center = Vec3::Zero();  ///< of mass [m]
    Vec3 linear = Vec3::Zero();  ///< [kg m/s]
    Vec3 angular = Vec3::Zero(); ///< about the center [kg m^2/s]
    Mat3 inertia = Mat3::Zero(); ///< about the center [kg m^2]

    /// W with inertia * W = L; no turn about an axis on which all objects lie, since nothing is known of that.
    Vec3 spinOf(const Vec3& angularMomentum) const;

    /// Whether it has a spin about every axis: not all objects lie on one.
    bool canTurn() const;
};

/// Of all pieces, with places and velocities that need not be those of the state. Summed up in the order of the objects.
std::vector<PieceMomenta> momentaOf(const ObjectState& state, const VectorArray& position, const VectorArray& velocity,
                                    const Pieces& pieces);

} // namespace knead
