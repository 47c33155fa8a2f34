#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/aggregate/material_map.h"
#include "core/mechanics/stress_law.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace knead {

/// What the material of a body would be without load: what it is made of, and how long its connections would like to be.
struct RelaxedState {
    MaterialMap materials;

    /// Per object, the metric C of its relaxed material: uu vv ww uv uw vw, in lattice axes; what of it is volume included.
    /// Empty: the identity for all, as at the start.
    std::array<std::vector<float>, 6> metric{};

    /// Per object, the sum of all flow. Empty: none.
    std::vector<float> equivalentStrain{};

    bool hasFlowed() const { return !metric[0].empty(); }

    friend bool operator==(const RelaxedState&, const RelaxedState&) = default;
};

/// How the material around an object is deformed and what it bears.
struct ObjectStrain {
    Mat3 strain = Mat3::Zero(); ///< Hencky, ln sqrt(F F^T), plastic flow included; in world axes
    Mat3 stress = Mat3::Zero(); ///< Cauchy [Pa], of what is elastic in it
    /// Hencky, ln sqrt(C): how the relaxed material differs from that at the start; in the axes at rest.
    Mat3 flow = Mat3::Zero();
};

class ObjectSurroundings; ///< the live connections of objects

/// Strain and stress at single objects.
///
/// F is the deformation gradient that fits the connections of an object best, each by its cut-cell weight; broken ones do not
/// count. Where they lie in a plane or on a line, nothing is known across it, and F neither stretches nor shears there.
///
/// Flow and re-normalization change the metric C of the relaxed material. The stress is cauchyStress() of F and C, and never more
/// than flow has left the material able to bear.
class ObjectStrains {
public:
    /// All that is given must outlive it. Its members may be called from any thread.
    /// @param displacements per object, from rest [m]
    ObjectStrains(const Aggregate& aggregate, std::span<const Vec3> displacements, const RelaxedState& relaxed,
                  std::span<const BrokenConnection> broken = {});
    ~ObjectStrains();
    ObjectStrains(const ObjectStrains&) = delete;
    ObjectStrains& operator=(const ObjectStrains&) = delete;

    ObjectStrain of(ObjectIndex object) const;

    /// F, and Hencky strain ln sqrt(F C^-1 F^T) of what is elastic in it, both in world axes.
    struct Elastic {
        Mat3 gradient = Mat3::Identity();
        Mat3 strain = Mat3::Zero();
    };
    Elastic elastic(ObjectIndex object) const;

    /// C, symmetric and positive. All who want to know how the material has flowed ask here or flow().
    Mat3 relaxedMetric(ObjectIndex object) const;

    /// Hencky, ln sqrt(C), in the axes at rest.
    Mat3 flow(ObjectIndex object) const;

    /// Equivalent plastic strain, of which material gets harder: the sum of all flow, there and back.
    double plasticStrain(ObjectIndex object) const;

    bool hasBroken(ObjectIndex object) const; ///< a connection
    bool hasBroken() const;                   ///< any connection
    bool hasFlowed() const { return m_relaxed.hasFlowed(); }
    std::span<const Vec3> displacements() const { return m_displacements; }
    const MaterialMap& materials() const { return m_relaxed.materials; }

private:
    std::unique_ptr<const ObjectSurroundings> m_surroundings;
    std::span<const Vec3> m_displacements;
    const RelaxedState& m_relaxed;
    Mat3 m_axes;
};

/// Strain and stress at all objects. Any thread; uses several.
std::vector<ObjectStrain> objectStrains(const Aggregate& aggregate, std::span<const Vec3> displacements,
                                        const RelaxedState& relaxed, std::span<const BrokenConnection> broken = {});

/// ln sqrt(b) of a symmetric b; of one that is nearly flat a finite one.
Mat3 halfLogarithm(const Mat3& b);

} // namespace knead
