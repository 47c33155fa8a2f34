#pragma once

#include "core/mechanics/contacts.h"
#include "core/mechanics/object_state.h"
#include "core/mechanics/structural_connections.h"
#include "core/simulation/simulation.h"

#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace knead {

/// A body while it is simulated.
struct BodyRun {
    explicit BodyRun(const Body& body);

    ObjectState state;
    StructuralConnections connections;
    std::vector<double> heldMass; ///< inverse masses without fixtures [1/kg]
    bool anchored = false;        ///< some object is held
};

/// A tool while it is simulated. Its id is its place in the list; removed tools leave a gap.
struct ToolRun {
    explicit ToolRun(Manipulator tool)
        : manipulator(tool)
        , start(std::move(tool))
    {
    }

    Manipulator manipulator;
    Manipulator start;            ///< what reset() makes of it
    Vec3 velocity = Vec3::Zero(); ///< over the last step [m/s]
    Vec3 angularVelocity = Vec3::Zero();
    Vec3 force = Vec3::Zero();    ///< of the material on it in the last step [N]
    Vec3 forceSum = Vec3::Zero(); ///< over the steps since the last snapshot
    Vec3 torqueSum = Vec3::Zero();
    int stepsInSum = 0;
    Vec3 meanForce = Vec3::Zero(); ///< over the last frame that had steps
    Vec3 meanTorque = Vec3::Zero();
    double peakForce = 0;
};

/// Enough to go back to a moment.
struct Checkpoint {
    std::uint64_t step = 0;
    double time = 0;
    EnergyLedger energy;
    std::vector<VectorArray> positions;
    std::vector<VectorArray> velocities;
    std::vector<Pose> toolPoses;
};

struct Simulation::State {
    explicit State(Scene scene);

    // The stages of a step, in order.
    void applyCommands();
    void moveManipulators();
    void updateVicinity();
    void computeForces();
    void integrate();
    void checkHealth();

    void carryOut(const Command& command);
    void holdFixtures();
    void setMasses();
    void updateTimeStep();
    void placeAtStart();
    std::vector<RigidSurface> surfaces() const;
    EnergyLedger storedEnergy();
    Checkpoint checkpoint() const;
    void goBack(const Checkpoint& moment);
    void stop(const std::string& cause);

    std::vector<Body> bodies; ///< present materials
    Vec3 gravity = Vec3::Zero();
    std::optional<double> floorHeight;
    double floorFriction = 0;
    std::vector<std::unique_ptr<BodyRun>> runs; ///< per body; addresses stay
    std::vector<std::optional<ToolRun>> tools;
    std::vector<std::optional<Fixture>> fixtures;
    std::unique_ptr<Contacts> contacts;
    Contacts::Report contactReport;

    std::deque<Command> pending;
    std::vector<RecordedCommand> recording;
    std::uint64_t step = 0;
    double time = 0;
    double timeStep = 0;
    double largestTravel = 0; ///< of any object in the last step [m]
    double surfaceTravel = 0;
    double startEnergy = 0; ///< stored at the start [J]
    EnergyLedger energy;    ///< toolWork and dissipated are kept up to date
    Health health;
    std::string notice; ///< about the last command, empty when it was carried out
    Checkpoint lastGood;
};

/// Why a body cannot be simulated; empty when it can.
std::vector<std::string> bodyProblems(const Body& body);

} // namespace knead
