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
    KnownFittings fittings;                  ///< of its filling, for the next one
    std::unique_ptr<const CellShapes> cells; ///< null: not looked at yet
    std::size_t brokenInCells = 0;           ///< connections that had broken then
    std::shared_ptr<const std::vector<BrokenConnection>>
        published;                               ///< what was broken in the snapshot before; null: none
    std::shared_ptr<const RelaxedState> relaxed; ///< in the snapshot before; null: there was none
    std::uint64_t relaxedVersion = 0;            ///< of the lengths in that

    bool deforms() const { return kind == BodyKind::deformable; }
};

struct Simulation::State {
    explicit State(Scene scene);

    // The stages of a step, in order.
    void applyCommands();
    void moveManipulators();
    void updateVicinity();
    void touchWhereBroken();
    void bookTornSkin();
    std::size_t breakConnections();
    void cutWithKnives();
    std::size_t cutAlong(BodyId body, const Vec3& point, const Vec3& normal);
    void changeConnections();
    static double workOfFlow(const StructuralConnections& connections);
    void computeForces();
    void integrate();
    void limitTravel(double speed);
    void chooseNextStep(double speed);
    void stepImplicitly();
    std::vector<Pose> wantedPoses() const;
    bool isDriven() const;
    void watchRest();
    bool stepAtRest();
    StaticReport findBalance(double duration, TaskControl& control);
    bool balance(double duration, TaskControl& control, StaticReport& report);
    StaticReport settle(double duration, TaskControl& control);
    void countSolved(bool isSolved);
    void checkHealth();

    void carryOut(const Command& command);
    void holdFixtures();
    void bookContacts();
    void loadFixtures();
    void turnGrips();
    void endTurns();
    void forgetTurns(Moment& moment) const;
    bool isMovedBy(FixtureId fixture, ObjectIndex object) const;
    double turnInStep(FixtureId fixture) const;
    Vec3 centripetal(FixtureId fixture, const Vec3& place) const;
    void findFixtureCenters();
    double addLoads(double at);
    void bookLoadsBefore();
    void bookLoadsAfter();
    void chooseIntegrator();
    void setIntegrator(Integrator chosen);
    double frameStep() const;
    double longestImplicitStep() const;
    double handStiffness(const Manipulator& manipulator) const;
    Pose wantedPose(const ToolRun& tool, double duration) const;
    static bool isStalled(const ToolRun& tool, const Vec3& way);
    double fastestSurface() const;
    void turnTool(ToolRun& tool, const Quaternion& next) const;
    Box materialBox() const;
    struct ToolPlace;
    std::vector<ToolPlace> toolPlaces() const;
    std::vector<ToolHand> beginHands();
    void endHands(const std::vector<ToolHand>& hands);
    std::size_t limitedTools() const;
    void makeImplicit();
    std::uint64_t every(std::uint64_t steps) const { return isImplicit() ? 1 : steps; }
    bool isImplicit() const { return integrator == Integrator::implicitEuler; }
    void tellFrictionApart();
    void setMasses();
    void setMass(std::size_t body);
    void scaleMasses(BodyRun& run);
    void requireDamping(const MaterialMap& materials, Integrator chosen) const;
    void updateTimeStep();
    void placeAtStart();
    void setKind(BodyId body, BodyKind kind);
    void anneal();
    std::vector<RigidSurface> surfaces() const;
    EnergyLedger storedEnergy();
    std::vector<Contacts::BodyView> contactBodies();
    void addPressing(Snapshot& shot) const;
    Moment moment() const;
    bool isOfThisScene(const Moment& moment) const;
    void restore(const Moment& moment);
    Message whyNotRefilled(BodyId body) const;
    void carryObjects(BodyId body, const BodyRun& before, bool wasFirst, const std::vector<ObjectIndex>& oldOfNew);
    void takeContacts(const Contacts::Memory& memory);
    std::unique_ptr<BodyRun> takeFilling(BodyId body, const NewFilling& filling,
                                         StructuralConnections::Changes changes);
    std::vector<GrownTogether> grownTogether(BodyId body) const;
    std::vector<Vec3> displacementsOf(BodyId body) const;
    double gapingVolume(BodyId body) const;
    bool isFirstFilling(BodyId body) const;
    std::unique_ptr<BodyRun> replaceRun(BodyId body, std::shared_ptr<const Aggregate> aggregate);
    void takeLoads(BodyId body);
    Contacts::Report lookAtContacts();
    MovePlaces outOfTools(BodyId body) const;
    void refill(BodyId body, double spacing);
    void refillWhereBad();
    void takeFirstFilling(BodyId body);
    void restoreBodies(const Moment& moment);
    void restoreContacts(const Moment& moment);
    void keepMoment();
    void goTo(MomentPointer moment);
    void stop(const Message& cause, Trouble trouble);
    Message squashedBody();
    double releasedSpeed(const BodyRun& run) const;
    double fastestSensible(BodyId body) const;
    Message runawayCause() const;
    Message energyCause();
    Message unsolvedCause() const;
    Message remedy() const;
    struct Overlap {
        double depth = 0; ///< [m]; 0: none
        ToolId tool = 0;
        BodyId body = 0;
    };
    double depthOf(const RigidSurface& surface, BodyId body) const;
    Overlap deepestTool() const;
    double deepestOverlap() const;
    void noteToolsInside();
    void bookToolsInside();
    void bookPlaced(const Contacts::Report& report);
    void findTimeStep();
    std::pair<Trouble, Message> lookClosely();
    std::pair<Trouble, Message> findTrouble();
    std::size_t components();
    const Pieces& piecesOf(BodyId body);
    double brakeShape(BodyId body, double duration);

    std::vector<Body> bodies;                                    ///< present materials and fillings
    std::vector<std::shared_ptr<const Aggregate>> firstFillings; ///< per body: as it was opened
    bool refilling = true;                                       ///< bodies are filled anew where their cells go bad
    std::uint64_t refills = 0;                                   ///< carried out since the start or going to a moment
    Vec3 gravity = Vec3::Zero();
    std::optional<double> floorHeight;
    double floorFriction = 0;
    double floorAdhesion = 0;
    Touching touching = Touching::separate;
    Integrator wantedIntegrator = Integrator::semiImplicitEuler;
    Integrator integrator = Integrator::semiImplicitEuler; ///< in use; never automatic
    Message integratorReason;
    std::unique_ptr<ImplicitEuler> implicit; ///< made anew when bodies or grips change by command
    int solverIterations = 0;                ///< of the last implicit step
    Pace pace = Pace::full;
    VicinityMethod vicinity = VicinityMethod::uniformGrid;
    std::optional<double> wantedTimeStep;
    std::optional<double> massScalingTimeStep;
    std::vector<std::unique_ptr<BodyRun>> runs; ///< per body; addresses stay
    std::vector<std::optional<ToolRun>> tools;
    std::vector<std::optional<Fixture>> fixtures;
    std::vector<Vec3> fixtureForces;  ///< per fixture: of the material on it in the last step [N]
    std::vector<Vec3> fixtureMoments; ///< the same about the center of its objects at rest [N m]
    std::vector<Vec3> fixtureCenters; ///< per fixture: of its objects at rest, about which that moment is [m]
    std::vector<GripProgress> gripProgress;
    ActingLoads loads;
    std::vector<Annealing> annealings;
    std::unique_ptr<Contacts> contacts;
    Contacts::Report contactReport;

    std::deque<Command> pending;
    std::vector<RecordedCommand> recording;
    std::uint32_t resets = 0; ///< carried out since the last goTo()
    std::uint64_t step = 0;
    double time = 0;
    double timeStep = 0;
    double lastStep = 0;   ///< by which positions moved last [s]; 0 at the start
    double lastKick = 0;   ///< by which velocities were changed last [s]; 0: the forces that did are not known any more
    double stableStep = 0; ///< largest stable one at the last look [s]
    double crowding = 1;   ///< contacts at a time that the time step allows an object
    double recentCrowding = 0;       ///< contacts at a time that an object had since the time step was looked at
    double fastestDriven = 0;        ///< of tools and fixtures so far, since the start or going to a moment [m/s]
    std::uint64_t unsolvedSteps = 0; ///< implicit ones so far
    std::uint32_t unsolvedInRow = 0; ///< the last ones
    double penetration = 0;          ///< see Snapshot
    bool isPlacedInside = false;     ///< a tool or the floor was put into material, and that is not booked yet
    double placedEnergy = 0;         ///< stored in contacts by that so far [J]
    double largestTravel = 0;        ///< of any object in the last step [m]
    double surfaceTravel = 0;
    double strayed = 0;     ///< of tools in the last implicit step from where candidates were listed for [m]
    double addedMass = 0;   ///< by mass scaling [kg]
    double startEnergy = 0; ///< stored at the start [J]
    /// What of the stored energy is not known right after going to a moment, since the forces of the last step are gone [J]:
    /// the ledger counts it until the next step.
    double unknownEnergy = 0;
    EnergyLedger energy; ///< what came in and went out is kept up to date
    bool newlyBroken = false;
    bool wasSquashed = false;  ///< at the last look
    bool wasOverdrawn = false; ///< energy came from nowhere at the last look; begins anew from a moment
    std::size_t knownComponents = 0;
    std::uint64_t componentsVersion = ~std::uint64_t{0};
    Health health;
    RestWatch rest;
    StageClock clock;
    bool showsPressing = false; ///< in snapshots
    Message notice;             ///< about the last command, empty when it was carried out
    MomentPointer lastGood;     ///< to go back to in trouble; never null
};

/// Why a body cannot be simulated; empty when it can.
std::vector<Message> bodyProblems(const Body& body);

/// 1 for each of `objects`, 0 for the others; empty when there are none.
std::vector<std::uint8_t> marksOf(const std::vector<ObjectIndex>& objects, std::size_t count);

} // namespace knead
