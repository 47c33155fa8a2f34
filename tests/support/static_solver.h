#pragma once

#include "core/mechanics/structural_connections.h"

#include <cmath>
#include <functional>
#include <vector>

namespace knead {

/// A body for tests of statics: small displacements, some of their components prescribed.
class StaticBody {
public:
    StaticBody(std::shared_ptr<const Aggregate> aggregate, const Material& material)
        : m_aggregate(std::move(aggregate))
        , m_materials(material, m_aggregate->size())
        , m_connections(m_aggregate, m_materials)
        , m_rest(objectsAtRest(*m_aggregate))
        , m_probe(m_rest)
        , m_displacement(m_aggregate->size(), Vec3::Zero())
        , m_free(m_aggregate->size(), Vec3::Ones())
    {
    }

    std::size_t size() const { return m_displacement.size(); }
    Vec3 place(std::size_t i) const { return m_rest.position.at(i); } ///< at rest
    const Vec3& displacement(std::size_t i) const { return m_displacement[i]; }
    const Aggregate& aggregate() const { return *m_aggregate; }

    /// Prescribes the components of a displacement along the marked world axes.
    void prescribe(std::size_t i, const Vec3& displacement, const Vec3& axes = Vec3::Ones())
    {
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            if (axes[axis] != 0) {
                m_displacement[i][axis] = displacement[axis];
                m_free[i][axis] = 0;
            }
    }

    /// Prescribes the part of a displacement along a unit direction only, by a stiff spring of the given stiffness [N/m].
    void pullTowards(std::size_t i, const Vec3& direction, double displacement, double stiffness)
    {
        m_springs.push_back({i, direction, displacement, stiffness});
    }

    /// Forces that hold the prescribed places, per object [N]: what the material lacks for balance.
    std::vector<Vec3> reactions() { return residual(m_displacement, true); }

    /// Conjugate gradients with the body's own linear response until the residual is `tolerance` of the first one.
    /// @return iterations
    int solve(double tolerance = 1e-8)
    {
        std::vector<Vec3> r = residual(m_displacement, false);
        std::vector<Vec3> p = r;
        double squared = dot(r, r);
        const double goal = squared * tolerance * tolerance;
        int iterations = 0;
        for (; squared > goal && iterations < 20'000; ++iterations) {
            const std::vector<Vec3> Ap = times(p);
            const double step = squared / dot(p, Ap);
            for (std::size_t i = 0; i < size(); ++i) {
                m_displacement[i] += step * p[i];
                r[i] -= step * Ap[i];
            }
            const double next = dot(r, r);
            for (std::size_t i = 0; i < size(); ++i)
                p[i] = r[i] + next / squared * p[i];
            squared = next;
        }
        return iterations;
    }

    std::vector<Vec3> loads; ///< per object [N]; empty: none

private:
    struct Spring {
        std::size_t object;
        Vec3 direction;
        double displacement;
        double stiffness;
    };

    static double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
    {
        double sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            sum += a[i].dot(b[i]);
        return sum;
    }

    /// Force of the connections at a displacement, in the linear range: by a central difference small against the spacing.
    std::vector<Vec3> force(const std::vector<Vec3>& displacement)
    {
        double largest = 0;
        for (const Vec3& d : displacement)
            largest = std::max(largest, d.cwiseAbs().maxCoeff());
        std::vector<Vec3> result(size(), Vec3::Zero());
        if (largest == 0)
            return result;
        const double scale = 1e-5 * m_aggregate->lattice.spacing / largest;
        for (const double way : {1.0, -1.0}) {
            for (std::size_t i = 0; i < size(); ++i)
                m_probe.position.set(i, place(i) + way * scale * displacement[i]);
            m_connections.computeForces(m_probe);
            for (std::size_t i = 0; i < size(); ++i)
                result[i] += way / (2 * scale) * m_probe.force.at(i);
        }
        return result;
    }

    std::vector<Vec3> times(const std::vector<Vec3>& direction)
    {
        std::vector<Vec3> product = force(direction);
        for (Vec3& f : product)
            f = -f;
        for (const Spring& spring : m_springs)
            product[spring.object] +=
                spring.stiffness * spring.direction.dot(direction[spring.object]) * spring.direction;
        for (std::size_t i = 0; i < size(); ++i)
            product[i] = product[i].cwiseProduct(m_free[i]);
        return product;
    }

    /// What is left over at every object; with `reactions`, what springs and supports must give instead.
    std::vector<Vec3> residual(const std::vector<Vec3>& displacement, bool reactions)
    {
        std::vector<Vec3> left = force(displacement);
        if (!loads.empty())
            for (std::size_t i = 0; i < size(); ++i)
                left[i] += loads[i];
        if (reactions) {
            for (Vec3& f : left)
                f = -f;
            return left;
        }
        for (const Spring& spring : m_springs)
            left[spring.object] += spring.stiffness *
                                   (spring.displacement - spring.direction.dot(displacement[spring.object])) *
                                   spring.direction;
        for (std::size_t i = 0; i < size(); ++i)
            left[i] = left[i].cwiseProduct(m_free[i]);
        return left;
    }

    std::shared_ptr<const Aggregate> m_aggregate;
    MaterialMap m_materials;
    StructuralConnections m_connections;
    ObjectState m_rest;
    ObjectState m_probe;
    std::vector<Vec3> m_displacement;
    std::vector<Vec3> m_free;
    std::vector<Spring> m_springs;
};

} // namespace knead
