#include "core/session/added_start.h"

#include "core/geometry/mass_properties.h"
#include "core/message/message.h"
#include "core/session/room_for_parts.h"
#include "support/material_scenes.h"

#include <QtTest>

#include <algorithm>

using namespace knead;

namespace {

constexpr double side = 0.012; // of the cubes [m]

Part cube(const std::string& name, const Vec3& place)
{
    Part part;
    part.name = part.path = name;
    part.mesh = shapes::moved(shapes::box(Vec3::Constant(side)), {.position = place});
    part.faces.resize(6);
    part.solids = part.shells = 1;
    part.watertight = part.valid = true;
    part.volume = massProperties(part.mesh).volume;
    part.box = boxOfPlaces(part.mesh.vertices);
    return part;
}

/// @param file "lump.step" has a lump in it
Model modelOf(const std::string& file, const Vec3& place)
{
    Model model;
    model.file = file;
    model.tree.name = file.substr(0, file.find('.'));
    model.parts.push_back(cube(model.tree.name, place));
    model.tree.children.push_back({model.tree.name, std::size_t{0}, {}});
    return model;
}

PreparedModel filled(const Model& model)
{
    ImportChoices choices{.paths = {model.file}, .options = {}};
    choices.spacing = SpacingChoice{SpacingChoice::Kind::Length, side / 6};
    return prepareModel(std::make_shared<const Model>(model), choices, scenes::clay(), TaskControl::none());
}

WrittenModel writeNothing(const ExportJob& /*job*/, TaskControl& /*control*/)
{
    throw Problem(Message("Deformation", "A mesh was written."));
}

/// Pressed by a quarter from above.
FramePointer pressed(const PreparedModel& prepared, std::vector<Fixture> fixtures = {})
{
    Scene scene = prepared.scene;
    scene.fixtures = std::move(fixtures);
    Manipulator plate{.name = "plate", .size = {2 * side, 2 * side, side / 4}};
    plate.kind = ToolKind::plate;
    const auto at = [](double down) { return Pose{Vec3(0, 0, side / 2 + side / 8 - down), Quaternion::Identity()}; };
    plate.pose = at(0);
    plate.motion = FollowKeyFrames{{{0, at(0)}, {0.1, at(side / 4)}}};
    scene.manipulators.push_back(plate);
    Simulation simulation(scene);
    while (simulation.health().ok && simulation.time() < 0.1)
        simulation.step();
    return prepareFrame(prepared.content.bodies, simulation.snapshot(), nullptr);
}

Box boxOf(const Part& part)
{
    return boxOfPlaces(part.mesh.vertices);
}

} // namespace

class AddedStartTest : public QObject {
    Q_OBJECT

    PreparedModel m_before = filled(modelOf("lump.step", Vec3::Zero()));
    std::vector<Vec3> m_shifts; ///< that bricks were read with

    /// Bricks, each from a file of its own. One at 1 m cannot be read.
    PreparedAddition added(const FramePointer& shown, const std::vector<Vec3>& places,
                           const std::vector<FaceFixture>& fixtures = {})
    {
        AdditionRequest request{.paths = {}, .options = {}, .material = {}};
        request.material.density = 2345;
        for (std::size_t i = 0; i < places.size(); ++i)
            request.paths.push_back("brick" + std::to_string(i) + ".step");
        m_shifts.clear();
        const auto import = [&](const std::vector<std::string>& paths, const ImportOptions& options, TaskControl&) {
            const Vec3& place = places.at(static_cast<std::size_t>(paths.front()[5] - '0'));
            if (place.x() == 1)
                throw Problem(Message::verbatim("It is damaged."));
            m_shifts.push_back(options.shift);
            return modelOf(paths.front(), place + options.shift);
        };
        return prepareAddition(m_before.content, shown, fixtures, request, import, writeNothing, TaskControl::none());
    }

    /// Of a scene whose gravity or tools are others.
    static FramePointer frameOf(const PreparedModel& prepared, const Scene& scene)
    {
        return prepareFrame(prepared.content.bodies, Simulation(scene).snapshot(), nullptr);
    }

private slots:
    void aPartThatLiesApartStaysWhereItsFileHasIt()
    {
        const Vec3 apart(0, 1.5 * side, 0);
        const PreparedAddition addition = added(m_before.frame, {apart});
        QVERIFY(addition.moved.empty() && addition.missing.empty());
        QCOMPARE(m_shifts, std::vector<Vec3>{Vec3::Zero()});
        QCOMPARE(addition.first, std::size_t{1});
        const FilledModel& content = addition.done.prepared.content;
        QCOMPARE(content.bodies.size(), std::size_t{2});
        QCOMPARE(content.spacing, m_before.content.spacing);
        QVERIFY(content.model->parts[0].mesh.vertices == m_before.content.model->parts[0].mesh.vertices);
        QVERIFY((boxOf(content.model->parts[1]).center() - apart).norm() < 1e-15);
        QCOMPARE(content.model->parts[1].path, std::string("brick0/brick0"));
        QCOMPARE(content.model->parts[0].path, std::string("lump"));
        QCOMPARE(content.model->tree.children.size(), std::size_t{2});
        QCOMPARE(*content.model->tree.children[1].children[0].part, std::size_t{1});
        QCOMPARE(content.model->file, std::string("lump.step"));
        const std::vector<Body>& bodies = addition.done.prepared.scene.bodies;
        QCOMPARE(bodies[0].material, m_before.scene.bodies[0].material);
        QCOMPARE(bodies[1].material.density, 2345.0);
    }

    /// They touch, which is no reason to move one: parts of an assembly do.
    void aPartMayTouchOthers() { QVERIFY(added(m_before.frame, {Vec3(side, 0, 0)}).moved.empty()); }

    /// Also where all of its surface lies on that of the other.
    void aPartThatLiesInOthersIsPutBesideThemOnTheFloor()
    {
        for (const Vec3& place : {Vec3(0, 0, 0), Vec3(0.9 * side, 0.9 * side, 0.9 * side), Vec3(0, 0, -0.8 * side)}) {
            const PreparedAddition addition = added(m_before.frame, {place});
            QCOMPARE(addition.moved, std::vector<std::string>{"brick0.step"});
            const PreparedModel& prepared = addition.done.prepared;
            const Box lump = boxOf(prepared.content.model->parts[0]);
            const Box brick = boxOf(prepared.content.model->parts[1]);
            QVERIFY(brick.min().x() > lump.max().x() + 0.05 * side);
            QVERIFY(std::abs(brick.min().z() - *prepared.scene.floorHeight) < 1e-12);
            QCOMPARE(prepared.scene.floorHeight, m_before.scene.floorHeight);
            QCOMPARE(m_shifts.size(), std::size_t{2});
        }
    }

    void severalThatLieInEachOtherAreParted()
    {
        const PreparedAddition addition = added(m_before.frame, {Vec3::Zero(), Vec3(0, 3 * side, 0), Vec3::Zero()});
        QCOMPARE(addition.moved, (std::vector<std::string>{"brick0.step", "brick2.step"}));
        const std::vector<Part>& parts = addition.done.prepared.content.model->parts;
        QCOMPARE(parts.size(), std::size_t{4});
        for (std::size_t a = 0; a < parts.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                QVERIFY(boxOf(parts[a]).intersection(boxOf(parts[b])).isEmpty());
    }

    /// It would be thrown out when time runs.
    void noPartBeginsInATool()
    {
        Scene scene = m_before.scene;
        Manipulator block{.name = "block", .size = Vec3(4 * side, side, side)};
        block.pose.position = Vec3(0, 2 * side, 0);
        scene.manipulators.push_back(block);
        const FramePointer shown = frameOf(m_before, scene);
        for (const Vec3& place : {Vec3(0, 2.2 * side, 0), Vec3(0, 1.3 * side, 0), Vec3(0, 0, 0)}) {
            const PreparedAddition addition = added(shown, {place});
            QCOMPARE(addition.moved.size(), std::size_t{1});
            const Box brick = boxOf(addition.done.prepared.content.model->parts[1]);
            const Box tool(block.pose.position - block.size / 2, block.pose.position + block.size / 2);
            QVERIFY(brick.intersection(tool).isEmpty());
        }
        QVERIFY(added(shown, {Vec3(0, 3.5 * side, 0)}).moved.empty());
    }

    /// What lies on it would hang in the air otherwise. Without gravity nothing falls, and an assembly stays one.
    void aPartIsPutOnTheFloorWhereGravityPulls()
    {
        const Vec3 below(0, 2 * side, -0.4 * side);
        Scene scene = m_before.scene;
        const PreparedAddition apart = added(frameOf(m_before, scene), {below});
        QVERIFY(apart.moved.empty());
        QVERIFY(std::abs(*apart.done.prepared.scene.floorHeight - (below.z() - side / 2)) < 1e-12);
        scene.gravity = Vec3(0, 0, -9.81);
        const PreparedAddition onFloor = added(frameOf(m_before, scene), {below});
        QCOMPARE(onFloor.moved.size(), std::size_t{1});
        QCOMPARE(onFloor.done.prepared.scene.floorHeight, m_before.scene.floorHeight);
        const Box brick = boxOf(onFloor.done.prepared.content.model->parts[1]);
        QVERIFY(std::abs(brick.min().z() - *m_before.scene.floorHeight) < 1e-12);
        QCOMPARE(brick.center().y(), below.y());
    }

    void whatCannotBeReadIsSaid()
    {
        const PreparedAddition addition = added(m_before.frame, {Vec3(1, 0, 0), Vec3(0, 2 * side, 0)});
        QCOMPARE(addition.done.prepared.content.bodies.size(), std::size_t{2});
        QCOMPARE(addition.missing.size(), std::size_t{1});
        QCOMPARE(addition.missing[0].english(), std::string("It is damaged."));
        QVERIFY_EXCEPTION_THROWN(added(m_before.frame, {Vec3(1, 0, 0)}), Problem);
        QVERIFY_EXCEPTION_THROWN(added(m_before.frame, {Vec3(1, 0, 0), Vec3(1, 0, 0)}), Problem);
    }

    /// With its fixture, the tool that pressed it, and no stress.
    void whatWasKneadedKeepsItsShape()
    {
        const FramePointer shown = pressed(m_before);
        const double height = boxOfPlaces(shown->bodies[0]->places).sizes().z();
        QVERIFY(height < 0.8 * side);
        const FaceFixture fixture{.key = 1, .name = "Fixture 1", .body = 0, .faces = {4}, .id = {}}; // -z
        const PreparedAddition addition = added(shown, {Vec3::Zero()}, {fixture});
        const PreparedModel& prepared = addition.done.prepared;
        const Part& lump = prepared.content.model->parts[0];
        QVERIFY(std::abs(boxOf(lump).sizes().z() - height) < 1e-2 * side);
        QVERIFY(std::abs(lump.volume / std::pow(side, 3) - 1) < 1e-2);
        QVERIFY(boxOf(prepared.content.model->parts[1]).min().x() > boxOf(lump).max().x());
        QCOMPARE(prepared.scene.manipulators.size(), std::size_t{1});
        QVERIFY(prepared.frame->snapshot->energy.elastic < 1e-15);
        QCOMPARE(prepared.fixtures.size(), std::size_t{1});
        QCOMPARE(prepared.fixtures[0].body, BodyId{0});
        const double low = boxOf(lump).min().z();
        for (const ObjectIndex object : prepared.scene.fixtures[0].objects)
            QVERIFY(prepared.content.bodies[0]->aggregate->lattice.position(object).z() < low + side / 4);
    }

    /// Thinner than parts may reach into each other. A tray has hardly any material in the middle of its box.
    void thinPartsHaveRoomOfTheirOwn()
    {
        for (const TriangleMesh& mesh :
             {shapes::box({side, side, 0.03 * side}),
              shapes::hollowBox({6 * side, 5 * side, 4 * side}, {5.95 * side, 4.95 * side, 3.95 * side})}) {
            Model model = modelOf("thin.step", Vec3::Zero());
            model.parts[0].mesh = mesh;
            RoomForParts room({}, side / 24);
            room.add(model);
            QVERIFY(!room.wayFor(model).isZero(0));
            Model above = model;
            for (Vec3& vertex : above.parts[0].mesh.vertices)
                vertex.z() += boxOfPlaces(mesh.vertices).sizes().z(); // upon it
            QVERIFY(room.wayFor(above).isZero(0));
        }
    }

    void itCanBeCancelled()
    {
        struct Stop final : TaskControl {
            void report(double /*fraction*/, std::string_view /*stage*/) override {}
            bool isCancelled() const override { return true; }
        } stop;
        const auto import = [](const std::vector<std::string>&, const ImportOptions&, TaskControl& control) {
            control.throwIfCancelled();
            return Model();
        };
        const AdditionRequest request{.paths = {"a", "b"}, .options = {}, .material = {}};
        QVERIFY_EXCEPTION_THROWN(
            prepareAddition(m_before.content, m_before.frame, {}, request, import, writeNothing, stop), Cancelled);
    }

    /// Those of a part that is as it was; others are named.
    void fixturesOfObjectsAreKept()
    {
        Scene scene = m_before.scene;
        scene.fixtures.push_back({"Held", 0, {3, 5, 8}});
        const PreparedAddition addition = added(frameOf(m_before, scene), {Vec3(0, 2 * side, 0)});
        const std::vector<Fixture>& kept = addition.done.prepared.scene.fixtures;
        QCOMPARE(kept.size(), std::size_t{1});
        QCOMPARE(kept[0].name, std::string("Held"));
        QCOMPARE(kept[0].body, BodyId{0});
        QCOMPARE(kept[0].objects, (std::vector<ObjectIndex>{3, 5, 8}));
        QVERIFY(addition.freed.empty());
        const FramePointer shown = pressed(m_before, {{"Held", 0, {3, 5, 8}}});
        const PreparedAddition other = added(shown, {Vec3(0, 3 * side, 0)});
        QVERIFY(other.done.prepared.scene.fixtures.empty());
        QCOMPARE(other.freed, std::vector<std::string>{"Held"});
    }

    void placesOfNewPartsComeOfNone()
    {
        const PreparedAddition addition = added(m_before.frame, {Vec3(0, 2 * side, 0)});
        const CarriedSurfaces& carried = addition.done.carried;
        QCOMPARE(carried.origin, (std::vector<std::size_t>{0, PartsInstead::none}));
        QVERIFY(carried.places[0] == m_before.frame->bodies[0]->places);
    }
};

QTEST_GUILESS_MAIN(AddedStartTest)
#include "added_start_test.moc"
