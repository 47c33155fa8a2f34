#pragma once

#include "core/aggregate/aggregate.h"
#include "core/geometry/triangle_mesh.h"
#include "core/mechanics/vector_array.h"
#include "core/message/message.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace knead {

using LoadId = std::uint32_t;

/// How much a load is. All of it may act at once.
struct LoadAmount {
    Vec3 force = Vec3::Zero();  ///< [N], in the world, wherever the surface goes; up to 1e12 N
    Vec3 moment = Vec3::Zero(); ///< [N m], in the world, wherever the surface goes; up to 1e12 N m
    double pressure = 0; ///< [Pa], against the outward normal of the deformed surface, which it follows; up to 1e12

    bool isZero() const { return force.isZero(0) && moment.isZero(0) && pressure == 0; }
    friend bool operator==(const LoadAmount&, const LoadAmount&) = default;
};

/// from + share (to - from)
LoadAmount between(const LoadAmount& from, const LoadAmount& to, double share);

/// A piece of a body's surface as its objects carry it, at rest.
///
/// A traction t on the surface gives object i the force integral of phi_i t dA, where phi_i are the trilinear functions of the
/// lattice cells that the surface runs through. With sum phi_i = 1 and sum phi_i X_i = X, force and moment are those of the
/// surface itself, not of objects somewhere near it.
struct LoadPatch {
    std::vector<ObjectIndex> objects; ///< ascending
    std::vector<double> share;        ///< integral of phi_i dA [m^2]
    std::vector<Vec3> area;           ///< integral of phi_i n dA, n outward [m^2]

    bool empty() const { return objects.empty(); }
};

/// The patch of some CAD faces, or of what of the surface lies in a box. Empty when there is nothing.
/// @param faces indices into Part::faces; none: by the box
LoadPatch loadPatch(const Aggregate& aggregate, const TriangleMesh& mesh, const std::vector<std::uint32_t>& faces,
                    const std::optional<Box>& box);

/// A load on a piece of the surface of a body. It rises evenly from nothing, or from what it was, to its amount.
struct Load {
    std::string name;
    std::uint32_t body = 0;
    std::vector<std::uint32_t> faces; ///< what the patch was made of; none: of the box
    std::optional<Box> box;           ///< [m]
    LoadPatch patch;
    LoadAmount amount;
    double ramp = 0; ///< [s] 0 .. 3600; 0: at once
};

/// A sentence on why a load cannot be simulated; empty when it can.
Message loadProblem(const Load& load, std::size_t objects);
Message amountProblem(const LoadAmount& amount, double ramp);

/// What a load does to the objects of its patch where they are now.
///     force:     f_i = F s_i / sum s                     acts at the center of the surface, which goes along
///     moment:    f_i = m_i (theta x r_i), J theta = M    m_i = |s_i|, r_i from their center, J their inertia
///     pressure:  f_i = -p cof(G_i) A_i                   G_i the deformation gradient around the object
/// The sum of force and moment over the objects is exactly F and M; a pressure on a surface that is not deformed gives
/// exactly -p times its vector area.
class LoadForces {
public:
    LoadForces(const LoadPatch& patch, const Aggregate& aggregate);

    /// One force per object of the patch [N].
    const std::vector<Vec3>& at(const VectorArray& position, const LoadAmount& amount);

    const std::vector<ObjectIndex>& objects() const { return m_objects; }
    const Vec3& center() const { return m_center; } ///< of the surface at rest [m]

private:
    void addMoment(const VectorArray& position, const Vec3& moment);
    void addPressure(const VectorArray& position, double pressure);

    struct Neighbor {
        ObjectIndex object;
        Vec3 reference; ///< K^-1 o, so that G = sum d reference^T [1/m]
    };

    std::vector<ObjectIndex> m_objects;
    std::vector<double> m_share; ///< sum 1
    std::vector<Vec3> m_area;
    std::vector<std::vector<Neighbor>> m_neighbors; ///< per object of the patch
    std::vector<Vec3> m_forces;
    Vec3 m_center = Vec3::Zero();
};

} // namespace knead
