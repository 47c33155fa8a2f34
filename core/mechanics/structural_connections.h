#pragma once

#include "core/aggregate/aggregate.h"
#include "core/aggregate/connection_id.h"
#include "core/aggregate/lattice_runs.h"
#include "core/aggregate/material_map.h"
#include "core/mechanics/connection_law.h"
#include "core/mechanics/lattice_kernels.h"
#include "core/mechanics/object_state.h"
#include "core/mechanics/plastic_state.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

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
    using DirectionArray = knead::DirectionArray;

    /// What has become of the connections since the body was made. Arrays are empty until they are needed.
    struct Changes {
        PlasticState plastic;
        LaneVector<double> restDilatation;    ///< per object: theta of no pressure
        std::vector<BrokenConnection> broken; ///< in the order of breaking
    };

    /// `materials` must outlive it.
    StructuralConnections(std::shared_ptr<const Aggregate> aggregate, const MaterialMap& materials);

    /// Takes over changed materials; nominal lengths stay as they are, broken connections stay broken.
    void updateMaterials();

    /// Friction u of eq 7 in every connection, as published; 0, as at first, for none.
    void setStructuralFriction(double friction) { m_structuralFriction = friction; }
    double structuralFriction() const { return m_structuralFriction; }

    const Changes& changes() const { return m_changes; }
    void restore(Changes changes);

    /// Rises whenever nominal lengths have changed; 0 as long as all are what they were at rest.
    std::uint64_t lengthVersion() const { return m_lengthVersion; }

    /// Writes state.force and state.damping. Reads positions and velocities.
    /// @param dt limits structural friction, which must not turn motion around [s]
    /// @param flowTime plastic flow over so much time at the present positions comes first, and the forces are those after it
    /// [s]; 0: none. It begins at changes(), and is kept by acceptFlow() only: a trial may follow another.
    void computeForces(ObjectState& state, double dt = 0, double flowTime = 0);

    /// The flow of the last forces takes place. @return energy that went with it [J]; 0 when there was none
    double acceptFlow();

    /// What acceptFlow() would return.
    double flowedEnergy() const { return m_hasTrial ? m_tensors->dissipatedEnergy : 0; }

    /// Of that, what the stress afterwards does on the flow [J]. In a long step the stress before it is far beyond yield: its
    /// energy is more by G |plastic strain|^2, which no material turns into heat but the scheme takes back.
    double flowWork() const { return m_hasTrial ? m_tensors->flowWork : 0; }

    /// Forgets the flow of the last forces.
    void rejectFlow()
    {
        m_hasTrial = false;
        forgetEnergy();
    }

    /// Breaking of connections that bear too much, at present positions.
    /// @param step of the integrator [s]: velocities lag half of it behind, and so does the energy that a connection had
    struct BreakReport {
        double released = 0; ///< energy of connections that broke [J]
        std::size_t broken = 0;
    };
    BreakReport breakOverloaded(const ObjectState& state, double step);

    /// Takes live connections away that a knife went through. @return energy that they had [J] @param step see breakOverloaded()
    double cut(const ObjectState& state, const std::vector<BrokenConnection>& connections, double step)
    {
        return breakAll(state, connections, step);
    }

    bool yields() const { return m_laws.anyYields(); }
    bool stiffensWhenSquashed() const { return m_tensors != nullptr; }
    bool breaks() const { return m_laws.anyBreaks(); }

    /// Re-normalization: nominal lengths approach present lengths, and rest dilatations present ones.
    /// @param marks per object, 1 where it takes part; a connection does when both its objects do. Empty: all.
    /// @param share of the way, 0 .. 1; 1 leaves no stress behind
    /// @return energy taken out [J]
    double renormalize(const ObjectState& state, const std::vector<std::uint8_t>& marks, double share);

    /// What healing materials have flowed towards breaking is forgotten by and by [s of time].
    void recover(double dt);

    /// Elastic energy at positions, volumetric part included [J]. Asked again for the same positions, it is not found again.
    double energy(const VectorArray& position);
    double energy(const ObjectState& state) { return energy(state.position); }

    /// Largest angular frequency of the body about its present shape [rad/s], with a stiffness added to every
    /// object (of contacts on it). At Poisson's ratio 1/4 and below it is the bound of bounds per object,
    /// omega^2 <= max 2 lambda_max(K_ii) / m_i; above, where that would cost a factor in the time step, a power iteration
    /// with a margin. The iteration starts from the mode found last time.
    /// @param added per object [N/m]
    double largestFrequency(ObjectState& state, const std::vector<double>& added);

    /// The mode of the largest frequency as it was found last, in 127ths of its largest component, three an object: as much
    /// as a later search needs to begin with. Empty: not known.
    std::vector<std::int8_t> fastestMode() const;

    /// Begins the next search with what fastestMode() gave.
    /// @param mode three an object, or none
    void setFastestMode(const std::vector<std::int8_t>& mode);

    /// Stiffness that bounds each object's share in any mode from above: omega^2 <= max of it by mass [N/m]. Of connections
    /// in their present places, of the volumetric term, and what is added.
    std::vector<double> stiffnessBounds(const ObjectState& state, const std::vector<double>& added) const;

    /// Objects with all 18 connections whose surroundings are flat or inside out: det F <= 0.
    std::size_t countInverted(const ObjectState& state);

    const Aggregate& aggregate() const { return *m_aggregate; }
    const DirectionArray& stiffness() const { return m_stiffness; }    ///< k [N/m] at the lower object; 0: none
    double nominalLength(const ConnectionId& connection) const;        ///< l [m]
    std::size_t count() const { return m_count; }                      ///< connections of stiffness > 0
    double dampingTime() const { return m_laws.largestDampingTime(); } ///< largest b / k [s]

    /// What the operator of the implicit scheme is made of.
    const ConnectionLaws& laws() const { return m_laws; }
    bool hasBulk() const { return m_hasBulk; }
    const LaneVector<double>& bulk() const { return m_bulk; }
    const std::array<LaneVector<double>, 6>& inverseShape() const { return m_inverseShape; }
    std::size_t blockSize() const { return m_blockSize; }

    /// Nominal lengths of `count` connections from `lower` on; `buffer` has room for them [m].
    const double* nominalLengths(std::size_t d, std::size_t lower, std::size_t count, double* buffer) const;

    /// Least b / k of any motion of the body: the volumetric term is not damped [s].
    double leastDampingTime() const;

    /// The two objects of a connection that was made, the lower one first.
    std::array<ObjectIndex, 2> endsOf(const ConnectionId& connection) const;

    /// Calls visit(neighbor, connection) for the live connections of an object, forward and backward by direction.
    template <typename Visit>
    void forEachConnection(ObjectIndex object, Visit&& visit) const;

    /// The same for all connections that were made, broken ones among them.
    template <typename Visit>
    void forEachConnectionMade(ObjectIndex object, Visit&& visit) const;

    /// Calls visit(lower, upper) with the two objects of every live connection. Goes along the lattice, which is many times as
    /// fast as asking each object.
    template <typename Visit>
    void forEachConnection(Visit&& visit) const;

    /// Stiffness for contacts of an object [N/m]: as much as adds a half or so to omega^2. 0 <= k <= 6 mu a.
    double contactStiffness(ObjectIndex object) const;

private:
    /// What the connections of a block give to the objects from `begin` on: the last ones of the block and those behind it.
    struct Margin {
        std::size_t begin = 0;
        VectorArray force;
        VectorArray damping;
    };
    struct Shape;
    struct Overloaded {
        ConnectionId id;
        double load; ///< strain by what it bears, > 1
    };

    void findStiffness();
    void findDampingTimes();
    void findInverseShapes();
    void setInverseShape(ObjectIndex object, const Mat3& shape);
    void forEachSurroundings(const VectorArray& position,
                             const std::function<void(const kernels::Surroundings&)>& run) const;
    std::array<double*, 9> stressColumns(std::size_t objects);
    void computeStress(const VectorArray& position, bool withEnergy = true);
    double objectEnergy(std::size_t object) const; ///< besides that of connections, at the stress computed last [J]
    void findTensorNumbers();
    kernels::TensorLawNumbers tensorNumbers() const;
    void applyTensorLaw(const VectorArray& position, const kernels::FlowResult* flow, bool withEnergy);
    void applyHyperelasticLaw(const VectorArray& position, bool withEnergy);
    void findRubber();
    void findSprings();
    RubberBody* rubber() const { return m_tensors ? m_tensors->rubber.get() : nullptr; }
    bool isRubber(std::size_t object) const { return rubber() != nullptr && rubber()->isRubber[object] > 0; }
    bool anyTensorial() const;
    double springEnergy(std::size_t i, std::size_t j, double stiffness, double length, double nominal) const;
    void stiffenByStretch(const ObjectState& state, std::vector<double>& bounds) const;
    void findStrains(const VectorArray& position);
    std::pair<double, double> lengthen(const VectorArray& position);
    void flow(const VectorArray& position, double duration);
    double findEnergy(const VectorArray& position);
    void forgetEnergy() { m_energyAt.resize(0); }
    const PlasticState& plasticState() const { return m_hasTrial ? m_tensors->flowed : m_changes.plastic; }
    void findMetric();
    kernels::ForceDirection forceDirection(std::size_t d) const;
    void addForcesOfBlock(ObjectState& state, std::size_t begin, std::size_t end);
    void addMargins(ObjectState& state, std::size_t begin, std::size_t end) const;
    void addFriction(ObjectState& state, double dt) const;
    void makeLengthsOwn();
    std::vector<BrokenConnection> overloaded(const ObjectState& state) const;
    void markBroken(const ConnectionId& connection);
    void findSpent(std::size_t lower, std::size_t upper, std::size_t count, const double* strength,
                   double* spent) const;
    void weakenBesideCracks(std::size_t d, std::size_t lower, std::size_t upper, std::size_t count,
                            double* limit) const;
    void findOverloaded(const ObjectState& state, std::size_t begin, std::size_t end,
                        std::vector<Overloaded>& found) const;
    double breakAll(const ObjectState& state, const std::vector<BrokenConnection>& connections, double step);
    void findLiveShape(ObjectIndex object);
    double energyAround(const ObjectState& state, const std::vector<ObjectIndex>& objects, double back) const;
    Shape shapeAround(const ObjectState& state, ObjectIndex object, double back = 0) const;
    std::vector<double> bondBounds(const ObjectState& state, const std::vector<double>& added) const;
    double iteratedFrequency(ObjectState& state, const std::vector<double>& added);

    std::shared_ptr<const Aggregate> m_aggregate;
    const MaterialMap* m_materials;
    ConnectionLaws m_laws;
    DirectionArray m_stiffness; ///< k [N/m] at the lower object; 0 = no connection
    Changes m_changes;
    std::uint64_t m_lengthVersion = 0;
    std::size_t m_count = 0;
    std::vector<LatticeRun> m_runs;            ///< for forces
    std::vector<LatticeRun> m_stressRuns;      ///< for the volumetric stress
    LaneVector<std::uint32_t> m_hasBehind;     ///< see neighborsBehind()
    std::size_t m_blockSize = 0;               ///< objects per block
    std::vector<Margin> m_margins;             ///< per block
    DirectionArray m_dampingTime;              ///< b / k [s] at the lower object; empty: the same for all
    std::vector<std::uint32_t> m_brokenAround; ///< per object: bit d for a broken forward connection, bit
                                               ///< directionCount + d for a backward one; empty: none broken
    double m_structuralFriction = 0;
    bool m_hasBulk = false;
    LaneVector<double> m_bulk;                        ///< (lambda - mu) V [J]; 0 where surroundings are too thin
    std::vector<ObjectIndex> m_flat;                  ///< those: they have no dilatation
    std::array<LaneVector<double>, 6> m_inverseShape; ///< (sum k o o^T)^-1 in lattice axes: uu vv ww uv uw vw [m/N]
    std::array<VectorArray, 3> m_stress;              ///< by lattice column, see kernels::StressArguments
    LaneVector<double> m_theta;                       ///< ln det F less its rest value
    std::unique_ptr<TensorBody> m_tensors;            ///< null where none yields or is rubberlike
    bool m_hasTrial = false;                          ///< a flow that is not accepted yet is in m_tensors
    VectorArray m_mode;                               ///< of the largest frequency, as found last
    VectorArray m_energyAt;                           ///< positions of the energy found last; none: it is not known
    double m_energy = 0;                              ///< that [J]
};

template <typename Visit>
void StructuralConnections::forEachConnection(ObjectIndex object, Visit&& visit) const
{
    forEachConnectionMade(object, [&](ObjectIndex neighbor, const ConnectionId& connection) {
        if (m_stiffness[connection.direction][connection.lower] > 0)
            visit(neighbor, connection);
    });
}

template <typename Visit>
void StructuralConnections::forEachConnectionMade(ObjectIndex object, Visit&& visit) const
{
    const Lattice& lattice = m_aggregate->lattice;
    for (std::uint32_t d = 0; d < Lattice::directionCount; ++d) {
        const auto& segments = lattice.segments[d];
        const auto forward =
            std::partition_point(segments.begin(), segments.end(), [&](const auto& s) { return s.end <= object; });
        if (forward != segments.end() && forward->begin <= object && m_aggregate->weight[d][object] > 0)
            visit(object + static_cast<ObjectIndex>(forward->offset), ConnectionId{d, object});
        const auto backward = std::partition_point(segments.begin(), segments.end(), [&](const auto& s) {
            return s.end + static_cast<ObjectIndex>(s.offset) <= object;
        });
        if (backward == segments.end() || backward->begin + static_cast<ObjectIndex>(backward->offset) > object)
            continue;
        const ObjectIndex lower = object - static_cast<ObjectIndex>(backward->offset);
        if (m_aggregate->weight[d][lower] > 0)
            visit(lower, ConnectionId{d, lower});
    }
}

template <typename Visit>
void StructuralConnections::forEachConnection(Visit&& visit) const
{
    for (std::size_t d = 0; d < Lattice::directionCount; ++d)
        for (const Lattice::Segment& segment : m_aggregate->lattice.segments[d])
            for (ObjectIndex lower = segment.begin; lower < segment.end; ++lower)
                if (m_stiffness[d][lower] > 0)
                    visit(lower, lower + static_cast<ObjectIndex>(segment.offset));
}

} // namespace knead
