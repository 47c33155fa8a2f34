#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/aggregate/material_map.h"

#include <array>
#include <span>
#include <vector>

namespace knead {

/// What the material of a body would be without load: what it is made of, and how long its connections would like to be.
struct RelaxedState {
    MaterialMap materials;

    /// Per object, the metric C of its relaxed material: uu vv ww uv uw vw, in lattice axes; what of it is volume included.
    /// Empty: the identity for all, as at the start.
    std::array<std::vector<float>, 6> metric{};

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

/// C of an object, in world axes; the identity where nothing has flowed.
Mat3 relaxedMetric(const RelaxedState& relaxed, const Lattice& lattice, ObjectIndex object);

/// Strain and stress at all objects.
///
/// F is the deformation gradient that fits the connections of an object best, each by its cut-cell weight; broken ones do not
/// count. Where they lie in a plane or on a line, nothing is known across it, and F neither stretches nor shears there.
///
/// Flow and re-normalization change the metric C of the relaxed material. What is elastic is ln sqrt(F C^-1 F^T), and the
/// stress (lambda tr(e) I + 2 mu e) / sqrt(det F C^-1 F^T) with mu and lambda of the object's material: what the connections
/// and the volumetric term add up to where the strain is even.
/// Any thread; uses several.
/// @param displacements per object, from rest [m]
std::vector<ObjectStrain> objectStrains(const Aggregate& aggregate, std::span<const Vec3> displacements,
                                        const RelaxedState& relaxed, std::span<const ConnectionId> broken = {});

/// sqrt(2/3 e:e) of the deviator e: the strain of a bar that is stretched as much at constant volume.
double equivalentStrain(const Mat3& strain);

/// sqrt(3/2 s:s) of the deviator s [Pa]: the tension of a bar that is as near to yielding.
double vonMisesStress(const Mat3& stress);

} // namespace knead
