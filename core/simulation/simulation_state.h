#pragma once

#include "core/aggregate/cell_shapes.h"
#include "core/integration/implicit_euler.h"
#include "core/mechanics/object_state.h"
#include "core/mechanics/object_strain.h"
#include "core/mechanics/structural_connections.h"
#include "core/simulation/moment.h"
#include "core/simulation/pieces_of_body.h"
#include "core/simulation/rest_watch.h"
#include "core/simulation/simulation.h"
#include "core/simulation/simulation_loads.h"
#include "core/simulation/stage_clock.h"
#include "core/skin/carried_cracks.h"
#include "core/skin/enclosed_volume.h"
#include "core/skin/new_filling.h"

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace knead {

/// A body while it is simulated.
struct BodyRun {
    explicit BodyRun(const Body& body);

    MaterialMap materials;
    ObjectState state;
    StructuralConnections connections;
    BodyKind kind;
    std::optional<RigidMotion> rigid; ///< of a rigid body that is not held
    bool anchored = false;            ///< some object is held
    std::vector<FixtureId> gripOf;    ///< per object: the grip that moves it, if any does
    PiecesOfBody pieces;
    KnownFittings fittings;                         ///< of its filling, for the next one
    std::unique_ptr<const CellShapes> cells;        ///< null: not looked at yet
    std::size_t brokenInCells = 0;                  ///< connections that had broken then
    bool knowsEnclosed = false;                     ///< it has been looked for
    std::unique_ptr<const EnclosedVolume> enclosed; ///< by its surface; null: not known
    std::shared_ptr<const std::vector<BrokenConnection>>
        published;                               ///< what was broken in the snapshot before; null: none
    std::shared_ptr<const RelaxedState> relaxed; ///< in the snapshot before; null: there was none
    std::uint64_t relaxedVersion = 0;            ///< of the lengths in that

    bool deforms() const { return kind == BodyKind::deformable; }
    std::vector<Vec3> displacements() const; ///< of its objects since it was filled [m]
};

/// Objects that are held or moved, and what they feel. All per fixture; removed ones leave a gap.
struct Grips {
    std::vector<std::optional<Fixture>> fixtures;
    std::vector<GripProgress> progress;
    std::vector<Vec3> forces;  ///< of the material on it in the last step [N]
    std::vector<Vec3> moments; ///< the same about the center [N m]
    std::vector<Vec3> centers; ///< of its objects at rest [m]

    bool turns(FixtureId id) const { return fixtures[id] && fixtures[id]->turn.turns(); }
    double turnInStep(FixtureId id, double duration) const; ///< by which it turns in a step that begins now [rad]
    void endTurns(double duration);                         ///< a step is over
    void findCenters(const std::vector<Body>& bodies);
};

/// What a scene says once and for all.
struct SceneChoices {
    Touching touching = Touching::separate;
    VicinityMethod vicinity = VicinityMethod::uniformGrid;
    std::optional<double> timeStep; ///< [s]
};

/// See Scene::massScalingTimeStep.
struct MassScaling {
    std::optional<double> timeStep; ///< [s]
    double added = 0;               ///< [kg]
};

/// How fast things move and have moved. Moments do not keep it: it begins anew from there.
struct Travel {
    double largest = 0;       ///< of any object in the last step [m]
    double ofSurfaces = 0;    ///< of any tool [m]
    double strayed = 0;       ///< of tools in the last implicit step from where candidates were listed for [m]
    double fastestDriven = 0; ///< of tools and fixtures so far, since the start or going to a moment [m/s]
    double lastKick = 0; ///< by which velocities were changed last [s]; 0: the forces that did are not known any more
    double recentCrowding = 0; ///< contacts at a time that an object had since the time step was looked at
    bool wasOverdrawn = false; ///< energy came from nowhere at the last look
};

/// Bodies are filled anew where their cells go bad.
struct Refilling {
    bool isOn = true;
    std::vector<std::shared_ptr<const Aggregate>> first; ///< fillings per body: as it was opened
    std::uint64_t count = 0;                             ///< carried out since the start or going to a moment
};

/// What breaking leads to.
struct Cracks {
    bool areNew = false;                       ///< their sides do not touch yet
    std::size_t components = 0;                ///< pieces of material
    std::uint64_t version = ~std::uint64_t{0}; ///< of connections and joints when these were counted
};

/// What was told to do, and what was done.
struct CommandLog {
    std::deque<Command> pending;
    std::vector<RecordedCommand> recording;
    std::uint32_t resets = 0; ///< carried out since the last goTo()
};

/// For those who look at a run; nothing in it depends on them.
struct Outputs {
    Message notice;             ///< about the last command, empty when it was carried out
    double penetration = 0;     ///< see Snapshot
    bool showsPressing = false; ///< in snapshots
    StageClock clock;
};

struct Simulation::State {
    explicit State(Scene scene);

    // Stages of a step: simulation.cpp.
    std::vector<RigidSurface> surfaces() const;
    void turnTool(ToolRun& tool, const Quaternion& next) const;
    void moveManipulators();
    void updateVicinity();
    void touchWhereBroken();
    void bookTornSkin();
    std::size_t breakConnections();
    void changeConnections();
    void anneal();
    void computeForces();
    void bookContacts();
    void loadFixtures();
    void tellFrictionApart();
    double brakeShape(BodyId body, double duration);
    void limitTravel(double speed);
    void chooseNextStep(double speed);
    void integrate();

    // Steps of the implicit scheme, how long they are, and when they are taken: simulation_implicit.cpp.
    void chooseIntegrator();
    void setIntegrator(Integrator wanted);
    double handStiffness(const Manipulator& manipulator) const;
    Pose wantedPose(const ToolRun& tool, double duration) const;
    double fastestSurface() const;
    std::vector<ToolHand> beginHands();
    void endHands(const std::vector<ToolHand>& hands);
    double frameStep() const;
    double longestImplicitStep() const;
    void makeImplicit();
    void countSolved(bool isSolved);
    void stepImplicitly();

    // Load steps without inertia: simulation_static.cpp.
    bool balance(double duration, TaskControl& control, StaticReport& report);
    StaticReport findBalance(double duration, TaskControl& control);
    StaticReport settle(double duration, TaskControl& control);

    // Steps in which nothing moves: simulation_rest.cpp.
    std::vector<Pose> wantedPoses() const;
    bool isDriven() const;
    void watchRest();
    bool stepAtRest();

    // Loads: simulation_loads.cpp.
    double addLoads(double at);
    void bookLoadsBefore();
    void bookLoadsAfter();

    // Grips that turn: simulation_grips.cpp.
    bool isMovedBy(FixtureId fixture, ObjectIndex object) const;
    void turnGrips();
    void forgetTurns(Moment& moment) const;
    Vec3 centripetal(FixtureId fixture, const Vec3& place) const;

    // Knives and planes: simulation_cutting.cpp.
    void cutWithKnives();
    std::size_t cutAlong(BodyId body, const Vec3& point, const Vec3& normal);

    // Filling bodies anew: simulation_refill.cpp.
    Message whyNotRefilled(BodyId body) const;
    bool isFirstFilling(BodyId body) const;
    std::unique_ptr<BodyRun> replaceRun(BodyId body, std::shared_ptr<const Aggregate> aggregate);
    void carryObjects(BodyId body, const BodyRun& before, bool wasFirst, const std::vector<ObjectIndex>& oldOfNew);
    void takeContacts(const Contacts::Memory& memory);
    std::unique_ptr<BodyRun> takeFilling(BodyId body, const NewFilling& filling,
                                         StructuralConnections::Changes changes);
    void takeLoads(BodyId body);
    Contacts::Report lookAtContacts();
    void refill(BodyId body, double spacing);
    void refillWhereBad();
    bool keepsVolume(BodyId body) const;
    void keepVolumes();
    void takeFirstFilling(BodyId body);

    // Commands: simulation_commands.cpp.
    void setKind(BodyId body, BodyKind kind);
    void carryOut(const Command& command);
    void applyCommands();

    // The start: masses, fixtures, the stable step: simulation_setup.cpp.
    void requireDamping(const MaterialMap& materials, Integrator integrator) const;
    void setMasses();
    void setMass(std::size_t body);
    void scaleMasses(BodyRun& run);
    void holdFixtures();
    double boundTimeStep();
    void updateTimeStep();
    std::vector<Contacts::BodyView> contactBodies();
    void placeAtStart();

    // Moments: simulation_moment.cpp.
    Moment moment() const;
    bool isOfThisScene(const Moment& moment) const;
    void restore(const Moment& moment);
    void restoreBodies(const Moment& moment);
    void keepMoment();
    void goTo(MomentPointer moment);

    // What goes wrong is found, named and undone: simulation_health.cpp.
    void stop(const Message& cause, Trouble trouble);
    Message squashedBody();
    std::pair<Trouble, Message> lookClosely();
    std::pair<Trouble, Message> findTrouble();
    void findTimeStep();
    void checkHealth();
    const Pieces& piecesOf(BodyId body);
    std::size_t components();

    // What a run is measured by: simulation_watch.cpp.
    Message runawayCause() const;
    Message energyCause();
    Message unsolvedCause() const;
    Message remedy() const;
    double deepestOverlap() const;
    void noteToolsInside();
    void bookToolsInside();
    void bookPlaced(const Contacts::Report& report);

    // What is told of it: simulation_snapshot.cpp.
    EnergyLedger storedEnergy();
    void addPressing(Snapshot& shot) const;

    std::uint64_t every(std::uint64_t interval) const { return isImplicit() ? 1 : interval; }
    bool isImplicit() const { return scheme.isImplicit(); }

    // What there is, and what acts on it.
    std::vector<Body> bodies;                   ///< present materials and fillings
    std::vector<std::unique_ptr<BodyRun>> runs; ///< per body; addresses stay
    std::vector<std::optional<ToolRun>> tools;
    Grips grips;
    ActingLoads loads;
    std::vector<Annealing> annealings;
    Surroundings around;
    std::unique_ptr<Contacts> contacts;
    Contacts::Report contactReport; ///< of the last step, whose frictions are gone once told apart

    // How it goes on.
    SceneChoices chosen;
    Scheme scheme;
    std::unique_ptr<ImplicitEuler> implicit; ///< made anew when bodies or grips change by command
    StepTimes steps;
    Travel travel;
    MassScaling massScaling;
    Refilling refilling;
    Cracks cracks;
    RestWatch rest;

    // What is made of it.
    Accounts accounts;
    RunWatch watch;
    CommandLog commands;
    Outputs out;
    MomentPointer lastGood; ///< to go back to in trouble; never null
};

/// Why a body cannot be simulated; empty when it can.
std::vector<Message> bodyProblems(const Body& body);

/// 1 for each of `objects`, 0 for the others; empty when there are none.
std::vector<std::uint8_t> marksOf(const std::vector<ObjectIndex>& objects, std::size_t count);

} // namespace knead
