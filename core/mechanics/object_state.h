#pragma once

#include "core/aggregate/aggregate.h"
#include "core/geometry/vec3.h"

#include <cstddef>
#include <vector>

namespace knead {

/// A vector per object, stored by component so that loops over objects vectorize.
struct VectorArray {
    std::vector<double> x, y, z;

    void resize(std::size_t size)
    {
        x.resize(size);
        y.resize(size);
        z.resize(size);
    }
    std::size_t size() const { return x.size(); }
    Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, const Vec3& v)
    {
        x[i] = v.x();
        y[i] = v.y();
        z[i] = v.z();
    }
    void add(std::size_t i, const Vec3& v)
    {
        x[i] += v.x();
        y[i] += v.y();
        z[i] += v.z();
    }
};

/// The moving state of the objects of one body.
struct ObjectState {
    VectorArray position;            ///< [m]
    VectorArray velocity;            ///< [m/s]
    VectorArray force;               ///< conservative, of connections; gravity apart [N]
    VectorArray damping;             ///< of dampers and friction; apart, so that what they dissipate is known [N]
    std::vector<double> mass;        ///< [kg]
    std::vector<double> inverseMass; ///< [1/kg]; 0 for objects held by a fixture

    std::size_t size() const { return mass.size(); }
};

/// Objects of `aggregate` at rest on their lattice, masses and velocities zero.
ObjectState objectsAtRest(const Aggregate& aggregate);

} // namespace knead
