#pragma once

#include "core/aggregate/material.h"
#include "core/aggregate/spacing_choice.h"
#include "core/deformation/physical_deformation.h"
#include "core/document/recipe_deformation.h"
#include "core/geometry/vec3.h"
#include "core/mechanics/manipulator.h"
#include "core/model/export_options.h"
#include "core/model/import_options.h"
#include "core/session/part_filling.h"
#include "core/simulation/pace.h"
#include "core/simulation/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace knead {

/// A material as a recipe states it: a preset, or numbers that replace those of another material, or both.
struct RecipeMaterial {
    std::optional<Material> preset;
    std::vector<std::pair<double Material::*, double>> overrides;

    /// The preset, or `base` without one, with the overrides.
    Material on(const Material& base) const;
};

/// Another part than the first one, placed in the world.
struct RecipeExtraPart {
    std::string file; ///< ready to open
    std::string name; ///< of its body, or the first step of the path of its bodies; empty: as in the file
    Pose pose;        ///< of the origin of the file
};

/// How a body takes part and how it starts.
struct RecipeBody {
    std::string name;
    BodyKind kind = BodyKind::deformable;
    Vec3 velocity = Vec3::Zero();        ///< [m/s]
    Vec3 angularVelocity = Vec3::Zero(); ///< about the center of mass [rad/s]
};

/// Objects of a body by their numbers, which mean something in one filling of it only.
struct RecipeObjects {
    std::vector<ObjectIndex> numbers; ///< ascending
    std::size_t of = 0;               ///< how many objects the body has in that filling
    bool isFilledAnew = false;        ///< it is the one that the body has by then, not its first
};

/// A region of bodies: at CAD faces, everything in a box, or objects one by one.
struct RecipeRegion {
    std::string name;
    std::string body;                 ///< empty: the only one for faces and objects, every one for a box
    std::vector<std::uint32_t> faces; ///< indices into Part::faces
    std::optional<Box> box;           ///< [m]
    std::optional<RecipeObjects> objects;
};

/// Held in place, or by a grip that moves.
struct RecipeFixture : RecipeRegion {
    Vec3 velocity = Vec3::Zero(); ///< [m/s]
    GripTurn turn = {};
    std::optional<Vec3> momentCenter =
        std::nullopt; ///< about which its moment is reported [m]; none: the middle of its objects
};

/// A load on CAD faces, or on what of the surface of a body lies in a box.
struct RecipeLoad : RecipeRegion {
    LoadAmount amount = {};
    double ramp = 0; ///< [s]
};

/// A region made of something else than its body.
struct RecipeMaterialRegion : RecipeRegion {
    RecipeMaterial material; ///< on top of that of the body
};

struct RecipeManipulator : Manipulator {
    std::string partFile;                  ///< for ToolKind::part; its part and size are known when it is opened
    std::optional<std::size_t> partNumber; ///< which tool of a project, when that is the file
};

struct RecipeFloor {
    double height = 0; ///< z [m]
    double friction = 0.4;
    double adhesion = 0; ///< [Pa]
};

/// Things that can happen at a time of the run.
struct ChangeMaterial {
    std::string body;       ///< empty: every one
    std::optional<Box> box; ///< only the objects that began in here [m]
    std::optional<RecipeObjects> objects;
    RecipeMaterial material; ///< on top of what the body started with
};
struct RenormalizeBodies {
    std::string body;       ///< empty: every one
    std::optional<Box> box; ///< only the objects that began in here [m]
    std::optional<RecipeObjects> objects;
    double duration = 0; ///< [s]; 0: at once
};
struct ChangeBodyKind {
    std::string body;
    BodyKind kind = BodyKind::deformable;
};
struct ReleaseFixture {
    std::string fixture;
};
struct TakeManipulatorAway {
    std::string manipulator;
};
struct ChangeGravity {
    Vec3 gravity = Vec3::Zero(); ///< [m/s^2]
};
struct ChangeFloor {
    std::optional<double> height; ///< z [m]; none: there is no floor
    double friction = 0.4;
    double adhesion = 0; ///< [Pa]
};
struct ChangeIntegrator {
    Integrator integrator = Integrator::semiImplicitEuler;
};
struct ChangePace {
    Pace pace = Pace::full;
};
struct AddRecipeFixture {
    RecipeFixture fixture;
};
struct MoveRecipeFixture {
    std::string fixture;
    Vec3 velocity = Vec3::Zero(); ///< [m/s]
    GripTurn turn = {};
};
struct AddRecipeLoad {
    RecipeLoad load;
};
struct ChangeRecipeLoad {
    std::string load;
    LoadAmount amount;
    double ramp = 0; ///< [s]
};
struct TakeLoadAway {
    std::string load;
};
struct AddRecipeManipulator {
    RecipeManipulator manipulator;
};
struct MoveRecipeManipulator {
    std::string manipulator;
    Motion motion;
};
struct PlaceRecipeManipulator {
    std::string manipulator;
    Pose pose;
};
struct ReshapeRecipeManipulator {
    RecipeManipulator manipulator; ///< its name, form and limits
};
struct SettleScene {     ///< FindBalance
    double duration = 0; ///< [s]
};
struct RefillBodies {   ///< Refill
    std::string body;   ///< empty: all that yield
    double spacing = 0; ///< [m]; 0: as it is
};
struct CutBodies {               ///< Cut
    std::string body;            ///< empty: all that deform
    Vec3 point = Vec3::Zero();   ///< [m]
    Vec3 normal = Vec3::UnitZ(); ///< not 0
};
struct DeformByPhysics { ///< grips at both ends go their way from now on, see PhysicalDeformation
    std::string body;    ///< empty: all that deform
    PhysicalDeformation what;
};
struct StartAgain {}; ///< Reset: steps and times count anew
struct MarkMoment {   ///< KeepMoment, at the end of what a person did at one go
    std::string name;
};
using RecipeAction =
    std::variant<ChangeMaterial, RenormalizeBodies, ChangeBodyKind, ReleaseFixture, TakeManipulatorAway, ChangeGravity,
                 ChangeFloor, ChangeIntegrator, ChangePace, AddRecipeFixture, MoveRecipeFixture, AddRecipeManipulator,
                 MoveRecipeManipulator, PlaceRecipeManipulator, ReshapeRecipeManipulator, StartAgain, MarkMoment,
                 AddRecipeLoad, ChangeRecipeLoad, TakeLoadAway, SettleScene, RefillBodies, CutBodies, DeformByPhysics>;

/// Events take place in the order of the recipe. Steps and times count from the last StartAgain.
struct RecipeEvent {
    double time = 0;                   ///< [s]
    std::optional<std::uint64_t> step; ///< before this one, whatever the time
    RecipeAction action;
    std::size_t item = 0; ///< which of the events of the file it is; a path in the file is several events
};

/// A place of the skin that is read while time runs.
struct RecipeProbe {
    std::string name;
    std::string body;          ///< empty: whichever is nearest
    Vec3 place = Vec3::Zero(); ///< the nearest point of the skin at rest is meant [m]
};

/// A file to write at the end. All but the name is for pictures.
struct RecipeExport {
    std::string file; ///< relative to the output folder
    int width = 1280;
    int height = 800;
    std::optional<Vec3> viewDirection; ///< from the eye to the part; the picture writer's own without one
    Vec3 up = Vec3::UnitZ();
    bool showTools = true;    ///< draw the manipulators too
    ExportOptions options;    ///< of what is no picture
    bool wantsReport = false; ///< as a JSON file beside it

    bool isPicture() const;
};

/// What a run finds.
enum class Analysis {
    dynamic,    ///< motion in time
    equilibrium ///< balance without inertia, load step after load step
};

/// A session that runs without a window: a part, its material, tools with their motions, events and exports. SI units.
struct Recipe {
    std::string file;                            ///< where it was read from
    std::string part;                            ///< path of the CAD or mesh file, or of a project, ready to open
    std::vector<std::string> partsBeside;        ///< opened together with it, as one assembly
    ImportOptions import;                        ///< of all of these
    bool fillsOpenParts = false;                 ///< tries winding numbers on surfaces that are not closed
    std::vector<RecipeDeformation> deformations; ///< of the parts of the file, one after the other
    std::vector<RecipeExtraPart> extraParts;
    SpacingChoice spacing; ///< of all parts of the file together
    Arrangement arrangement = Arrangement::cutCells;
    Material material;                                           ///< of every body that has none of its own
    std::vector<std::pair<std::string, Material>> bodyMaterials; ///< body name and its material
    std::vector<RecipeMaterialRegion> regions;
    std::vector<RecipeBody> bodies; ///< those that differ from a deformable body at rest
    double structuralFriction = 0;  ///< within every body
    std::vector<RecipeFixture> fixtures;
    std::vector<RecipeLoad> loads;
    std::vector<RecipeManipulator> manipulators;
    Vec3 gravity = Vec3::Zero(); ///< [m/s^2]
    std::optional<RecipeFloor> floor;
    Touching touching = Touching::separate;
    Integrator integrator = Integrator::automatic;
    VicinityMethod vicinity = VicinityMethod::uniformGrid;
    bool refilling = true;                     ///< see Scene::refilling
    std::optional<double> timeStep;            ///< [s]
    std::optional<double> massScalingTimeStep; ///< [s]
    Analysis analysis = Analysis::dynamic;
    int loadSteps = 10;                         ///< that the duration is divided into, for equilibrium
    double duration = 0;                        ///< simulated [s]; since the last StartAgain
    std::optional<std::uint64_t> durationSteps; ///< so many steps, whatever the time
    std::vector<RecipeEvent> events;
    std::vector<RecipeProbe> probes;
    std::vector<RecipeExport> exports;
};

} // namespace knead
