#pragma once

#include "core/mechanics/structural_connections.h"
#include "support/scenes.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace knead {

/// A box of objects that are put where a test wants them.
struct Block {
    static constexpr double spacing = 2e-3; ///< [m]

    Block(const Material& material, const Eigen::Vector3i& cells)
        : body(scenes::box(cells, spacing, material))
        , materials(material, body.aggregate->size())
        , connections(std::make_unique<StructuralConnections>(body.aggregate, materials))
        , state(objectsAtRest(*body.aggregate))
    {
        for (ObjectIndex i = 0; i < state.size(); ++i)
            state.mass[i] = material.density * body.aggregate->volume[i];
        for (const double one : body.aggregate->volume)
            volume += one;
    }

    Vec3 rest(ObjectIndex i) const { return body.aggregate->lattice.position(i); }

    /// All objects at F X.
    void follow(const Mat3& f)
    {
        place(f);
        connections->computeForces(state);
    }

    /// The same with flow over a time [s], taken for good. @return energy that it took [J]
    double flow(const Mat3& f, double flowTime = 1)
    {
        place(f);
        connections->computeForces(state, 0, flowTime);
        return connections->acceptFlow();
    }

    void shake(double size, unsigned seed)
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> part(-1, 1);
        for (ObjectIndex i = 0; i < state.size(); ++i)
            state.position.add(i, size * spacing * Vec3(part(random), part(random), part(random)));
    }

    /// First Piola-Kirchhoff stress by the virial of the forces [Pa].
    Mat3 firstPiolaStress() const
    {
        Mat3 sum = Mat3::Zero();
        for (ObjectIndex i = 0; i < state.size(); ++i)
            sum -= state.force.at(i) * rest(i).transpose();
        return sum / volume;
    }

    /// Cauchy stress at F, the same way [Pa].
    Mat3 stress(const Mat3& f) const { return firstPiolaStress() * f.transpose() / f.determinant(); }

    /// Largest difference between forces and slopes of the energy, by the largest force.
    double forceError()
    {
        connections->computeForces(state);
        const VectorArray force = state.force;
        double largest = 0;
        for (std::size_t i = 0; i < force.size(); ++i)
            largest = std::max(largest, force.at(i).norm());
        double error = 0;
        const double h = 1e-5 * spacing;
        for (ObjectIndex i = 0; i < state.size(); i += 3)
            for (int c = 0; c < 3; ++c) {
                VectorArray moved = state.position;
                moved.add(i, h * Vec3::Unit(c));
                const double ahead = connections->energy(moved);
                moved.add(i, -2 * h * Vec3::Unit(c));
                const double behind = connections->energy(moved);
                error = std::max(error, std::abs(force.at(i)[c] + (ahead - behind) / (2 * h)));
            }
        return error / largest;
    }

    /// Changes of the forces with the places, by the roots of the masses: its largest value is the square of the highest
    /// frequency.
    Eigen::MatrixXd dynamicMatrix()
    {
        const auto size = static_cast<Eigen::Index>(3 * state.size());
        Eigen::MatrixXd matrix(size, size);
        const double h = 1e-5 * spacing;
        for (ObjectIndex i = 0; i < state.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                VectorArray difference;
                for (const double way : {1.0, -2.0}) {
                    state.position.add(i, way * h * Vec3::Unit(c));
                    connections->computeForces(state);
                    if (way > 0)
                        difference = state.force;
                }
                state.position.add(i, h * Vec3::Unit(c));
                for (ObjectIndex j = 0; j < state.size(); ++j)
                    matrix.block<3, 1>(3 * j, 3 * i + c) =
                        (state.force.at(j) - difference.at(j)) / (2 * h) / std::sqrt(state.mass[i] * state.mass[j]);
            }
        return 0.5 * (matrix + matrix.transpose());
    }

    void place(const Mat3& f)
    {
        for (ObjectIndex i = 0; i < state.size(); ++i)
            state.position.set(i, f * rest(i));
    }

    Body body;
    MaterialMap materials;
    std::unique_ptr<StructuralConnections> connections;
    ObjectState state;
    double volume = 0;
};

} // namespace knead
