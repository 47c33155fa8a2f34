#pragma once

#include "core/mechanics/contacts.h"
#include "core/mechanics/rigid_motion.h"
#include "core/mechanics/structural_connections.h"
#include "core/simulation/run_groups.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace knead {

/// A tool while it is simulated. Its id is its place in the list; removed tools leave a gap.
struct ToolRun {
    explicit ToolRun(Manipulator tool = {})
        : manipulator(tool)
        , start(std::move(tool))
    {
    }

    /// Of what was summed up since the last call, if anything.
    void findMeans();

    Manipulator manipulator;
    Manipulator start;            ///< what Reset makes of it
    Vec3 velocity = Vec3::Zero(); ///< over the last step [m/s]
    Vec3 angularVelocity = Vec3::Zero();
    Vec3 force = Vec3::Zero();    ///< of the material on it in the last step [N]
    Vec3 torque = Vec3::Zero();   ///< the same about its center [N m]
    Vec3 forceSum = Vec3::Zero(); ///< over the steps since the last snapshot
    Vec3 torqueSum = Vec3::Zero();
    int stepsInSum = 0;
    Vec3 meanForce = Vec3::Zero(); ///< over the last frame that had steps [N]
    Vec3 meanTorque = Vec3::Zero();
    double peakForce = 0;
};

/// A re-normalization under way.
struct Annealing {
    BodyId body = 0;
    std::vector<std::uint8_t> marks; ///< per object; empty: all
    double rate = 0;                 ///< [1/s]
    double end = 0;                  ///< [s]
};

/// How far a grip has gone since its turn began.
struct GripProgress {
    Vec3 way = Vec3::Zero(); ///< of its center [m]
    double angle = 0;        ///< [rad]
};

/// A load while it acts.
struct LoadRun {
    Load load;        ///< its amount is the one that it rises to
    LoadAmount from;  ///< and this what it rises from
    double begin = 0; ///< when [s]

    LoadAmount at(double time) const;
};

/// The state of a simulation at one moment: everything that its future depends on, and what a window shows of its past. What
/// follows from that is left out and found again: lists of contact candidates, forces, factors of the implicit scheme. So is
/// what no command changes: aggregates, names, what was chosen for the scene.
///
/// A simulation that keeps a moment goes on from what is found again as well (see KeepMoment). So it takes the same way, bit
/// for bit, as one that goes back to the moment.
struct Moment {
    struct BodyMoment {
        MaterialMap materials;
        BodyKind kind = BodyKind::deformable;
        std::optional<RigidMotion::Memory> rigid; ///< of a rigid body that is not held
        VectorArray position;                     ///< [m]; empty where `rigid` tells
        VectorArray velocity;                     ///< [m/s]; the same
        LaneVector<double> mass; ///< with mass scaling, which goes by the shape of its time [kg]; else empty
        StructuralConnections::Changes changes;
        std::vector<std::int8_t> fastestMode;                ///< see StructuralConnections
        std::shared_ptr<const Aggregate> refilled = nullptr; ///< its objects; null: those of the first filling
    };

    std::vector<BodyMoment> bodies;
    std::vector<std::optional<ToolRun>> tools; ///< sums of forces apart
    std::vector<std::optional<Fixture>> fixtures;
    std::vector<Vec3> fixtureForces;        ///< per fixture [N]
    std::vector<GripProgress> gripProgress; ///< per fixture
    std::vector<std::optional<LoadRun>> loads;
    std::vector<Annealing> annealings;
    Contacts::Memory contacts;
    double contactEnergy = 0;     ///< [J]
    std::size_t contactCount = 0; ///< contacts that touched in the last step
    Surroundings around;
    Scheme scheme;
    StepTimes steps;
    Accounts accounts;
    RunWatch watch;
    double addedMass = 0; ///< by mass scaling [kg]
};

} // namespace knead
