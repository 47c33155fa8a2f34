#pragma once

#include "core/aggregate/aggregate.h"
#include "core/mechanics/vector_array.h"

#include <cstddef>
#include <vector>

namespace knead {

/// The moving state of the objects of one body.
struct ObjectState {
    VectorArray position;           ///< [m]
    VectorArray velocity;           ///< [m/s]
    VectorArray force;              ///< conservative, of connections; gravity apart [N]
    VectorArray damping;            ///< of dampers and friction; apart, so that what they dissipate is known [N]
    LaneVector<double> mass;        ///< of inertia: what mass scaling added is in it [kg]
    LaneVector<double> inverseMass; ///< [1/kg]; 0 for objects held by a fixture
    LaneVector<double> trueMass;    ///< of the material, which gravity pulls at [kg]; empty: as `mass`

    std::size_t size() const { return mass.size(); }

    const LaneVector<double>& weighedMass() const { return trueMass.empty() ? mass : trueMass; }

    /// Share of gravity that an object falls with: less than 1 where it got heavier, and its weight did not.
    double gravityShare(std::size_t i) const { return trueMass.empty() ? 1 : trueMass[i] / mass[i]; }
};

/// Of the fastest object [m/s]; infinite when a velocity is not finite. On all threads.
double largestSpeed(const ObjectState& state);

/// Objects of `aggregate` at rest on their lattice, masses and velocities zero.
ObjectState objectsAtRest(const Aggregate& aggregate);

} // namespace knead
