#pragma once

#include "core/aggregate/connection_id.h"
#include "core/mechanics/object_strain.h"
#include "core/message/message.h"
#include "core/simulation/pace.h"
#include "core/simulation/scene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace knead {

/// Where the energy is and where it went [J].
struct EnergyLedger {
    double kinetic = 0;
    double elastic = 0;  ///< in connections, volumetric term included
    double gravity = 0;  ///< potential, zero at the origin
    double contact = 0;  ///< stored in contact connections
    double toolWork = 0; ///< done on the material by manipulators, grips and loads since the start

    // Where energy went since the start.
    double viscous = 0;  ///< in dampers and shape damping
    double friction = 0; ///< of contacts
    double plastic = 0;  ///< flow and re-normalization
    double fracture = 0; ///< of connections that broke
    double numerical =
        0; ///< taken out by implicit Euler itself: of motion that is fast against its steps, and of impacts

    double dissipated() const { return viscous + friction + plastic + fracture + numerical; }

    /// What is stored less what came in, plus what went out, since the start; zero but for the error of the scheme [J].
    double imbalance = 0;

    /// What there was to go round: the most so far of all that is stored and went out, or came in, height apart [J]. An
    /// imbalance is small or large against this.
    double turnover = 0;

    /// What came from nowhere [J]: the imbalance, and what the implicit scheme added where it should take out.
    double created() const { return imbalance - (numerical < 0 ? numerical : 0); }

    double imbalanceShare() const; ///< of the turnover, 0 .. 1
};

/// What a step consists of, in order.
enum class Stage : std::uint8_t {
    tools,       ///< commands and the motion of tools
    vicinity,    ///< who may touch whom
    material,    ///< plastic flow, breaking, annealing
    connections, ///< forces of structural connections; of an implicit step: its equations and their solution
    contacts,    ///< forces of contacts, joints and fixtures
    motion,      ///< integration
    checks       ///< health, checkpoints, the stable step
};
inline constexpr std::size_t stageCount = 7;

/// Wall time per stage [s].
using StageSeconds = std::array<double, stageCount>;

/// Why a simulation was stopped.
enum class Trouble : std::uint8_t {
    none,
    notANumber, ///< a position is none
    runaway,    ///< objects faster than anything sensible
    energy,     ///< more of it than came in
    unsolved,   ///< equations of the implicit scheme, many steps in a row
    failed,     ///< something else than the numbers: memory, a file
    squashed,   ///< material flat or inside out
    longStep    ///< a chosen time step is longer than the stable one
};

/// Numerical trouble, with its remedy.
struct Health {
    bool ok = true;
    Message message;                 ///< a sentence naming the cause and the remedy; empty when ok
    Trouble trouble = Trouble::none; ///< for buttons; files keep the message only, and have none
};

/// What a tool feels.
struct ToolState {
    ToolId id = 0;
    std::string name;
    ToolKind kind = ToolKind::box;
    std::shared_ptr<const ToolPart> part;
    Vec3 size = Vec3::Zero(); ///< [m]
    Pose pose;
    double friction = 0;
    double speedLimit = 0; ///< [m/s]
    double forceLimit = 0; ///< [N]; infinite: none
    double adhesion = 0;   ///< [Pa]; 0: nothing sticks to it
    bool rollsFreely = false;
    Vec3 force = Vec3::Zero();  ///< of the material on the tool, mean over the frame [N]
    Vec3 torque = Vec3::Zero(); ///< about its center [N m]
    double peakForce = 0;       ///< largest force since the start [N]
};

/// The state of a simulation at one moment, as the window and the exporters see it. Immutable, shared by pointer.
struct Snapshot {
    struct BodyState {
        std::vector<Vec3> positions; ///< per object [m]
        BodyKind kind = BodyKind::deformable;
        std::shared_ptr<const Aggregate> aggregate;

        /// Structural connections that broke so far, in the order of breaking; snapshots share them until the next one
        /// breaks. Null: none.
        std::shared_ptr<const std::vector<BrokenConnection>> broken = nullptr;

        /// What strain and stress are relative to, see objectStrains(); snapshots share it until the next flow. Never null in
        /// those of a simulation.
        std::shared_ptr<const RelaxedState> relaxed = nullptr;

        /// What presses on each object [N], see Contacts::pressingForces(). Null unless Simulation::showPressing() asked for it.
        std::shared_ptr<const std::vector<Vec3>> pressing = nullptr;

        /// From rest [m].
        Vec3 displacement(ObjectIndex object) const;

        /// Of all objects, from rest [m]. On all threads.
        std::vector<Vec3> displacements() const;
    };

    std::uint32_t resets =
        0; ///< carried out since the simulation began or last went to a moment: steps count from the last
    std::uint64_t step = 0;
    double time = 0;                                             ///< simulated [s]
    double timeStep = 0;                                         ///< [s]
    double stableStep = 0;                                       ///< longest that an explicit scheme could take [s]
    Integrator integrator = Integrator::semiImplicitEuler;       ///< in use; never automatic
    Integrator wantedIntegrator = Integrator::semiImplicitEuler; ///< as chosen
    Message integratorReason;                                    ///< a sentence on which one is in use and why
    Pace pace = Pace::full;                                      ///< of implicit steps
    int solverIterations = 0;                                    ///< of the last implicit step
    std::vector<BodyState> bodies;
    std::vector<Material> materials; ///< per body
    std::vector<ToolState> tools;
    std::vector<Fixture> fixtures;
    std::vector<FixtureId> fixtureIds; ///< of fixtures, same order
    FixtureId nextFixture = 0;         ///< that the next one gets
    ToolId nextTool = 0;               ///< that the next one gets
    std::vector<Vec3> fixtureForces;   ///< of the material on them, same order, in the last step [N]
    std::vector<Vec3> fixtureMoments;  ///< the same about fixtureCenters [N m]
    std::vector<Vec3> fixtureCenters;  ///< of their objects at rest, same order [m]
    Vec3 gravity = Vec3::Zero();
    std::optional<double> floorHeight;
    double floorFriction = 0;
    double floorAdhesion = 0; ///< [Pa]
    EnergyLedger energy;
    Vec3 momentum = Vec3::Zero();        ///< [kg m/s]
    Vec3 angularMomentum = Vec3::Zero(); ///< about the origin [kg m^2/s]
    Health health;
    Message notice; ///< why the last command was not carried out, or what a person should know of what it did
    std::size_t objects = 0;
    std::size_t connections = 0;     ///< structural
    std::size_t contacts = 0;        ///< contact connections now
    std::size_t broken = 0;          ///< structural connections that broke so far
    std::size_t joints = 0;          ///< sticking or healed together now
    std::size_t components = 0;      ///< connected pieces of material
    double addedMass = 0;            ///< by mass scaling, as a share of all mass
    double penetration = 0;          ///< largest so far of tools and the floor into material [spacings]
    std::uint64_t refills = 0;       ///< bodies filled anew since the start, or going to a moment
    std::uint64_t unsolvedSteps = 0; ///< implicit ones so far whose equations were not solved as well as they must be
    StageSeconds stages{};           ///< mean per step since the snapshot before; of the machine, not of the scene

    // Time keeping, filled in by SimulationThread.
    bool playing = false;
    std::uint64_t rest =
        0;            ///< the how manieth time nothing moves; those of the same show the same places. 0: something may
    double ratio = 0; ///< simulated per wall time, over the last half second
    double updatesPerSecond = 0;
    int stepsPerFrame = 0;
    double snapshotSeconds = 0;   ///< that taking this one took
    std::uint64_t arrivals = 0;   ///< how often SimulationThread::goTo() was carried out before
    std::uint64_t requests = 0;   ///< how many requests were, see SimulationThread::requests()
    std::uint64_t scriptEnds = 0; ///< how often time stood still at the end of the script
};

using SnapshotPointer = std::shared_ptr<const Snapshot>;

/// Objects of a body that a fixture holds, or that something presses on where the snapshot tells that, ascending.
std::vector<ObjectIndex> loadedObjects(const Snapshot& snapshot, BodyId body);

} // namespace knead
