#pragma once

#include "core/mechanics/connection_flow.h"
#include "core/mechanics/connection_forces.h"
#include "core/mechanics/connection_fracture.h"
#include "core/mechanics/connection_frequency.h"
#include "core/mechanics/connection_parameters.h"
#include "core/mechanics/connection_stress.h"
#include "core/mechanics/connection_volume.h"

#include <algorithm>
#include <utility>

namespace knead {

/// The structural connections of one body: parameters by direction, and the forces they give.
///
/// Force on an object o from the connection to p (eqs 2, 3 and 5 of the paper, with the sign that attracts when stretched):
///     F = [k (|d| - l) + b (v_p - v_o).n] n,   d = x_p - x_o,  n = d / |d|
/// There is no friction in structural connections: it would brake a rigid rotation. The published form, eq 7 on every
/// connection, can be switched on to reproduce published scenes.
///
/// Calibration (18 neighbors, spacing a, cut-cell weight w, shear modulus mu): k = mu a w. Central forces alone give
/// Poisson's ratio 1/4; the rest is a volumetric energy per object, 1/2 (lambda - mu) V theta^2 with
/// theta = ln det F, F the least-squares deformation gradient over the object's connections. It is absent at 1/4.
///
/// Where a material of the body yields or is rubberlike, its objects have the law of tensor_law.h instead: neo-Hooke and J2 flow
/// of a tensor per object, which the nominal lengths follow. Those that are rubberlike have that of hyperelastic_law.h.
///
/// Nominal lengths change by plastic flow and re-normalization, connections are taken away by fracture; all of that is
/// `Changes`, and going back to an earlier moment means putting earlier changes back.
///
/// Objects are worked on in blocks that depend on the lattice only. A block computes the connections that begin in it; what they
/// give to objects beyond its end goes to a margin of its own, which is added afterwards. So no two threads write to one
/// place, and the bits do not depend on their number.
class StructuralConnections {
public:
    using Changes = ConnectionChanges;

    /// `materials` must outlive it.
    StructuralConnections(std::shared_ptr<const Aggregate> aggregate, const MaterialMap& materials)
        : m_data(std::move(aggregate), materials)
    {
    }

    /// Takes over changed materials; nominal lengths stay as they are, broken connections stay broken.
    void updateMaterials() { knead::updateMaterials(m_data); }

    /// Friction u of eq 7 in every connection, as published; 0, as at first, for none.
    void setStructuralFriction(double friction) { m_data.structuralFriction = friction; }
    double structuralFriction() const { return m_data.structuralFriction; }

    const Changes& changes() const { return m_data.changes; }
    void restore(Changes changes) { restoreChanges(m_data, std::move(changes)); }

    /// Rises whenever nominal lengths have changed; 0 as long as all are what they were at rest.
    std::uint64_t lengthVersion() const { return m_data.lengthVersion; }

    /// Writes state.force and state.damping. Reads positions and velocities.
    /// @param dt limits structural friction, which must not turn motion around [s]
    /// @param flowTime plastic flow over so much time at the present positions comes first, and the forces are those after it
    /// [s]; 0: none. It begins at changes(), and is kept by acceptFlow() only: a trial may follow another.
    void computeForces(ObjectState& state, double dt = 0, double flowTime = 0)
    {
        findForces(m_data, state, dt, flowTime);
    }

    /// The flow of the last forces takes place. @return energy that went with it [J]; 0 when there was none
    double acceptFlow() { return knead::acceptFlow(m_data); }

    /// What acceptFlow() would return.
    double flowedEnergy() const { return m_data.hasTrial ? m_data.tensors->dissipatedEnergy : 0; }

    /// Of that, what the stress afterwards does on the flow [J]. In a long step the stress before it is far beyond yield: its
    /// energy is more by G |plastic strain|^2, which no material turns into heat but the scheme takes back.
    double flowWork() const { return m_data.hasTrial ? m_data.tensors->flowWork : 0; }

    /// Forgets the flow of the last forces.
    void rejectFlow() { knead::rejectFlow(m_data); }

    /// Breaking of connections that bear too much, at present positions.
    /// @param step of the integrator [s]: velocities lag half of it behind, and so does the energy that a connection had
    BreakReport breakOverloaded(const ObjectState& state, double step)
    {
        return knead::breakOverloaded(m_data, state, step);
    }

    /// Takes live connections away that a knife went through. @return energy that they had [J] @param step see breakOverloaded()
    double cut(const ObjectState& state, const std::vector<BrokenConnection>& connections, double step)
    {
        return breakAll(m_data, state, connections, step);
    }

    /// How clay keeps its volume, see connection_volume.h.
    double flowedShare() const { return knead::flowedShare(m_data); }
    double keepVolume(const VectorArray& position, double enclosed)
    {
        return knead::keepVolume(m_data, position, enclosed);
    }
    /// V0 of the body without pressure [m^3].
    double keptVolume() const { return knead::keptVolume(m_data); }

    bool yields() const { return m_data.laws.anyYields(); }
    bool stiffensWhenSquashed() const { return m_data.tensors != nullptr; }
    bool breaks() const { return m_data.laws.anyBreaks(); }

    /// Re-normalization: nominal lengths approach present lengths, and rest dilatations present ones.
    /// @param marks per object, 1 where it takes part; a connection does when both its objects do. Empty: all.
    /// @param share of the way, 0 .. 1; 1 leaves no stress behind
    /// @return energy taken out [J]
    double renormalize(const ObjectState& state, const std::vector<std::uint8_t>& marks, double share)
    {
        return knead::renormalize(m_data, state, marks, share);
    }

    /// What healing materials have flowed towards breaking is forgotten by and by [s of time].
    void recover(double dt) { knead::recover(m_data, dt); }

    /// Elastic energy at positions, volumetric part included [J]. Asked again for the same positions, it is not found again.
    double energy(const VectorArray& position) { return storedEnergy(m_data, position); }
    double energy(const ObjectState& state) { return energy(state.position); }

    /// Largest angular frequency of the body about its present shape [rad/s], with a stiffness added to every
    /// object (of contacts on it). At Poisson's ratio 1/4 and below it is the bound of bounds per object,
    /// omega^2 <= max 2 lambda_max(K_ii) / m_i; above, where that would cost a factor in the time step, a power iteration
    /// with a margin. The iteration starts from the mode found last time.
    /// @param added per object [N/m]
    double largestFrequency(ObjectState& state, const std::vector<double>& added)
    {
        return knead::largestFrequency(m_data, state, added);
    }

    /// The mode of the largest frequency as it was found last, in 127ths of its largest component, three an object: as much
    /// as a later search needs to begin with. Empty: not known.
    std::vector<std::int8_t> fastestMode() const { return knead::fastestMode(m_data); }

    /// Begins the next search with what fastestMode() gave.
    /// @param mode three an object, or none
    void setFastestMode(const std::vector<std::int8_t>& mode) { knead::setFastestMode(m_data, mode); }

    /// Stiffness that bounds each object's share in any mode from above: omega^2 <= max of it by mass [N/m]. Of connections
    /// in their present places, of the volumetric term, and what is added.
    std::vector<double> stiffnessBounds(const ObjectState& state, const std::vector<double>& added) const
    {
        return knead::stiffnessBounds(m_data, state, added);
    }

    /// Objects with all 18 connections whose surroundings are flat or inside out: det F <= 0.
    std::size_t countInverted(const ObjectState& state) { return knead::countInverted(m_data, state); }

    const Aggregate& aggregate() const { return *m_data.aggregate; }
    const DirectionArray& stiffness() const { return m_data.stiffness; } ///< k [N/m] at the lower object; 0: none
    double nominalLength(const ConnectionId& connection) const { return m_data.nominalLength(connection); } ///< l [m]
    std::size_t count() const { return m_data.count; }                      ///< connections of stiffness > 0
    double dampingTime() const { return m_data.laws.largestDampingTime(); } ///< largest b / k [s]

    /// What the operator of the implicit scheme is made of.
    const ConnectionLaws& laws() const { return m_data.laws; }
    bool hasBulk() const { return m_data.hasBulk; }
    const LaneVector<double>& bulk() const { return m_data.bulk; }
    const std::array<LaneVector<double>, 6>& inverseShape() const { return m_data.inverseShape; }
    std::size_t blockSize() const { return m_data.blockSize; }

    /// Nominal lengths of `count` connections from `lower` on; `buffer` has room for them [m].
    const double* nominalLengths(std::size_t d, std::size_t lower, std::size_t count, double* buffer) const
    {
        const kernels::ObjectNumber lengths = m_data.nominalLengths(d);
        if (lengths.each != nullptr)
            return lengths.each + lower;
        std::fill_n(buffer, count, lengths.all);
        return buffer;
    }

    /// Least b / k of any motion of the body: the volumetric term is not damped [s].
    double leastDampingTime() const { return knead::leastDampingTime(m_data); }

    /// The two objects of a connection that was made, the lower one first.
    std::array<ObjectIndex, 2> endsOf(const ConnectionId& connection) const { return m_data.endsOf(connection); }

    /// Calls visit(neighbor, connection) for the live connections of an object, forward and backward by direction.
    template <typename Visit>
    void forEachConnection(ObjectIndex object, Visit&& visit) const
    {
        m_data.forEachConnection(object, visit);
    }

    /// The same for all connections that were made, broken ones among them.
    template <typename Visit>
    void forEachConnectionMade(ObjectIndex object, Visit&& visit) const
    {
        m_data.forEachConnectionMade(object, visit);
    }

    /// Calls visit(lower, upper) with the two objects of every live connection. Goes along the lattice, which is many times as
    /// fast as asking each object.
    template <typename Visit>
    void forEachConnection(Visit&& visit) const
    {
        for (std::size_t d = 0; d < Lattice::directionCount; ++d)
            forEachPair(aggregate().lattice, d, 0, aggregate().size(), [&](ObjectIndex lower, ObjectIndex upper) {
                if (m_data.stiffness[d][lower] > 0)
                    visit(lower, upper);
            });
    }

    /// Stiffness for contacts of an object [N/m]: as much as adds a half or so to omega^2. 0 <= k <= 6 mu a.
    double contactStiffness(ObjectIndex object) const { return knead::contactStiffness(m_data, object); }

private:
    ConnectionData m_data;
};

} // namespace knead
