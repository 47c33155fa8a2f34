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
    LaneVector<double> mass;        ///< [kg]
    LaneVector<double> inverseMass; ///< [1/kg]; 0 for objects held by a fixture

    std::size_t size() const { return mass.size(); }
};

/// Objects of `aggregate` at rest on their lattice, masses and velocities zero.
ObjectState objectsAtRest(const Aggregate& aggregate);

} // namespace knead
