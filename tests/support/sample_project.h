#pragma once

#include "core/aggregate/fill.h"
#include "core/aggregate/published_fill.h"
#include "core/document/project.h"
#include "support/fuzz_random.h"
#include "support/shapes.h"

#include <cmath>
#include <limits>
#include <memory>
#include <string>

/// Projects in which every member differs from its default.
namespace knead::sample {

/// Numbers that text can spoil.
inline constexpr double third = 1.0 / 3;
inline const double tiny = std::numeric_limits<double>::denorm_min();
inline constexpr double huge = 1.7976931348623157e308;

inline std::shared_ptr<const std::vector<std::byte>> moment(std::size_t bytes, std::uint64_t seed)
{
    fuzz::Random random(seed);
    std::vector<std::byte> result(bytes);
    for (std::byte& byte : result)
        byte = static_cast<std::byte>(random.next());
    return std::make_shared<const std::vector<std::byte>>(std::move(result));
}

inline Model model()
{
    Part part;
    part.name = "Würfel 立方体";
    part.path = "root/a \"quoted\"\n name/Würfel 立方体";
    part.color = Color{0.25F, 0.1F, 1};
    part.faces = {{std::nullopt}, {Color{1, 0, 0}, "seat \u00e4"}};
    part.mesh = shapes::moved(shapes::box({0.01, 0.02, 0.03}), shapes::tilt(0.3));
    part.mesh.faceOfTriangle.assign(part.mesh.triangles.size(), 1);
    part.exact = ExactShape{std::make_shared<const std::string>("exact\0bytes", 11), 1, 0.0254};
    part.solids = 1;
    part.shells = 2;
    part.edges = 12;
    part.volume = 6e-6 * third;
    part.area = third;
    part.box = Box(Vec3(-0.1, 0, -0.0), Vec3(0.01, 0.02, third));
    part.watertight = part.valid = true;
    part.maxTolerance = 1e-7;
    part.visible = false;
    part.layer = "layer 7";
    part.repairs = {Message("Repair", "%1 faces were sewn.").with(45)};
    part.openEdges = {{Vec3(0, 0, 0), Vec3(1, 0, third)}, {}};
    part.warnings = {Message::verbatim("is odd.")};
    Part other;
    other.exact = part.exact;
    other.exact->number = 2;

    Model model;
    model.file = "/home/ann/part.step";
    model.format = "STEP AP242";
    model.unit = "inch";
    model.unitRemark = UnitRemark{Message("Unit", "It is large."), "mm"};
    model.warnings = {Message::verbatim("one"), Message("Import", "%1 two").with(Message("Import", "of"))};
    model.missing = {Message("Import", "\"%1\" is missing.").with("lid")};
    model.parts = {part, other};
    model.tree = {"root", std::nullopt, {{"a", std::nullopt, {{"one", 0, {}}, {"two", 1, {}}}}, {"b", 1, {}}}};
    return model;
}

/// Differs from others in every number.
inline Material material(double some)
{
    Material material;
    double factor = 1;
    for (const MaterialField& field : materialFields())
        material.*field.value = field.minimum + (field.maximum - field.minimum) * 0.01 * some * (factor += third);
    return material;
}

inline Pose pose(double some)
{
    return shapes::tilt(some, Vec3(some * third, -0.0, -some));
}

inline std::shared_ptr<const ToolPart> toolPart(double size)
{
    return std::make_shared<const ToolPart>(
        shapes::moved(shapes::box(Vec3(size, size * third, 0.3 * size)), shapes::tilt(0.4, Vec3(0.1, 0.7, -third))));
}

inline Manipulator manipulator(const std::string& name, Motion motion)
{
    return {.name = name,
            .size = Vec3(0.01, third, 0.3),
            .pose = pose(0.7),
            .friction = 0.1,
            .speedLimit = 0.7,
            .forceLimit = 1e3 * third,
            .motion = std::move(motion),
            .kind = ToolKind::wedge};
}

inline Manipulator partManipulator(const std::shared_ptr<const ToolPart>& part)
{
    Manipulator manipulator = sample::manipulator("part", HoldStill{});
    manipulator.kind = ToolKind::part;
    manipulator.part = part;
    manipulator.size = part->size();
    manipulator.forceLimit = std::numeric_limits<double>::infinity();
    manipulator.adhesion = 250.5;
    manipulator.rollsFreely = true;
    return manipulator;
}

inline Load load(const std::string& name)
{
    Load load{.name = name, .body = 0, .faces = {0, 2}, .box = Box(Vec3(-1, -third, 0), Vec3(1, 1, tiny))};
    load.patch = {
        .objects = {1, 2, 5}, .share = {third, 1, tiny}, .area = {Vec3(1, -third, 0), Vec3(0, tiny, 1), Vec3::Zero()}};
    load.amount = {.force = Vec3(1, third, -2), .moment = Vec3(0, 0, third), .pressure = 1e5};
    load.ramp = third;
    return load;
}

/// Each command there is, with part as a tool.
inline std::vector<RecordedCommand> commands(const std::shared_ptr<const ToolPart>& part)
{
    const Motion frames = FollowKeyFrames{{{0, pose(0.1)}, {third, pose(0.2)}}};
    const std::vector<Command> all{
        SetMaterial{0, material(1), {1, 2, 3, 7, 9, 10}},
        SetMaterial{0, material(2), {}},
        SetBodyKind{0, BodyKind::glue},
        Renormalize{1, {5}, third},
        SetGravity{Vec3(-0.0, tiny, -huge)},
        SetFloor{-0.1, 0.2, 1e4 * third},
        SetFloor{std::nullopt, 0.3},
        AddManipulator{manipulator("turning", DriveAt{Vec3(1, 2, third), Vec3(3, 2, 1)})},
        AddManipulator{partManipulator(part)},
        RemoveManipulator{3},
        SetManipulatorMotion{1, GoTo{pose(0.5)}},
        SetManipulatorMotion{1, frames},
        ReshapeManipulator{.tool = 2, .size = Vec3(1, 2, 3), .friction = 0.1, .speedLimit = 0.3},
        ReshapeManipulator{.tool = 2,
                           .size = part->size(),
                           .friction = 0.1,
                           .speedLimit = 0.3,
                           .forceLimit = 7,
                           .kind = ToolKind::part,
                           .part = part,
                           .adhesion = 12.5,
                           .rollsFreely = true},
        PlaceManipulator{1, pose(0.9)},
        AddFixture{{"grip \"a\"", 0, {0, 4, 5, 6}, Vec3(0.1, 0, -0.0)}},
        RemoveFixture{1},
        SetIntegrator{Integrator::implicitEuler},
        SetPace{Pace::rough},
        MoveFixture{2, Vec3(0, third, 0)},
        Reset{},
        KeepMoment{},
        RenameManipulator{2, "left jaw"},
        RenameFixture{1, "Fuß"},
        AddFixture{{"turning", 0, {1, 2}, Vec3::Zero(), {Vec3(third, 0, 1), Vec3(0, -third, 0), 7}}},
        MoveFixture{2, Vec3::Zero(), {.center = Vec3(1, 2, third), .angularVelocity = Vec3(0, 0, tiny)}},
        AddLoad{load("Zug")},
        SetLoad{0, {.force = Vec3(third, -0.0, huge), .moment = Vec3(0, tiny, 0), .pressure = -third}, third},
        RemoveLoad{0},
        FindBalance{third},
        Refill{1, third},
        Cut{1, Vec3(third, -0.0, huge), Vec3(0, tiny, third)},
        SetPartLook{1, "Grüße \"2\"", "#12ab00"},
    };
    std::vector<RecordedCommand> recorded;
    for (const Command& command : all)
        recorded.push_back({1000 * recorded.size(), command});
    recorded.front().objectsInBody = 77;
    recorded.back().step = (1ULL << 53U) - 1;
    return recorded;
}

inline ProjectStart start(const std::shared_ptr<const ToolPart>& part)
{
    ProjectStart start;
    Scene& scene = start.scene;
    scene.bodies.resize(2);
    Body& body = scene.bodies[0];
    body.name = "Würfel";
    body.aggregate = std::make_shared<const Aggregate>(
        fill(shapes::moved(shapes::box({0.01, 0.02, 0.03}), shapes::tilt(0.3)), {.spacing = 0.005}));
    body.material = material(3);
    body.velocity = Vec3(1, third, 0);
    body.angularVelocity = Vec3(0, -third, 2);
    body.kind = BodyKind::rigid;
    body.regions = {{"soft", {1, 2, 3, 8}, material(4)}, {"", {5}, material(5)}};
    body.structuralFriction = 0.25;
    scene.bodies[1].name = "as published";
    scene.bodies[1].aggregate =
        std::make_shared<const Aggregate>(fillAsPublished(shapes::box({0.01, 0.01, 0.03}), 0.003));
    scene.fixtures = {{"foot", 1, {0, 1, 5}, Vec3(third, 0, 0)}};
    scene.manipulators = {manipulator("block", GoTo{pose(0.3)}), partManipulator(part)};
    scene.gravity = Vec3(0, -0.0, -9.81);
    scene.floorHeight = -third;
    scene.floorFriction = 0.7;
    scene.floorAdhesion = 1e3 / 3.0;
    scene.touching = Touching::glued;
    scene.integrator = Integrator::automatic;
    scene.vicinity = VicinityMethod::medianPartition;
    scene.timeStep = 1e-4 * third;
    scene.massScalingTimeStep = 2e-4;
    start.partOfBody = {1, 0};
    return start;
}

/// As reading a project does.
inline void giveSurfaces(ProjectStart& start, const std::shared_ptr<const Model>& model)
{
    for (std::size_t b = 0; b < start.scene.bodies.size(); ++b)
        start.scene.bodies[b].surface = surfaceOf(model, start.partOfBody[b]);
}

inline HistoryRecord entry(std::uint32_t parent, const std::string& name)
{
    return {.parent = parent, .name = name, .wallTime = 1.7e9 + third, .step = 12, .time = 0.1 * third, .hash = 3};
}

inline Project project()
{
    const auto ball = toolPart(0.02);
    Project project;
    project.model = std::make_shared<const Model>(model());
    project.import = {.paths = {"/home/ann/part.step", "b.igs"},
                      .options = {.linearDeflection = 1e-4,
                                  .angularDeflection = 0.1,
                                  .relativeDeflection = third,
                                  .heal = false,
                                  .capsFlatOpenings = true,
                                  .unit = "inch",
                                  .parts = {"a/b", "c"},
                                  .memoryLimit = 1e10,
                                  .timeLimit = 60},
                      .spacing = SpacingChoice{SpacingChoice::Kind::CellsAcrossWall, 4.5},
                      .touching = Touching::glued,
                      .fillsOpenParts = true};
    project.starts = {start(ball), start(ball)};
    for (ProjectStart& each : project.starts)
        giveSurfaces(each, project.model);
    project.starts[1].scene.bodies[0].aggregate = project.starts[0].scene.bodies[0].aggregate;
    project.entries = {entry(0, "Start"), entry(0, "Push with Block \"1\""), entry(1, ""), entry(0, "Another try")};
    project.entries[0].moment = moment(3000, 1);
    project.entries[1].commands = commands(ball);
    project.entries[1].hash = 0xffff'ffff'ffff'fffeU;
    project.entries[2].moment = moment(0, 2);
    project.entries[2].isKey = true;
    project.entries[3].start = 1;
    project.entries[3].commands = commands(toolPart(0.01));
    project.entries[3].moment = moment(5000, 3);
    project.current = 2;
    project.marks = {{1, "good"}, {3, "Ümläut"}};
    project.view = {.camera = {.position = Vec3(1, 2, third),
                               .focalPoint = Vec3(0, third, 0),
                               .up = Vec3(0, 0.6, 0.8),
                               .parallelScale = 0.1 * third,
                               .perspective = false},
                    .hiddenParts = {1},
                    .thumbnail = *moment(300, 4)};
    project.panels = {{"material", R"({"open": true})"}, {"tool", "[1, 2]"}};
    return project;
}

} // namespace knead::sample
