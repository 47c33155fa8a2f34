#include "core/session/face_fixtures.h"
#include "core/session/filled_model.h"

#include "core/geometry/mass_properties.h"
#include "core/simulation/moment.h"
#include "support/shapes.h"
#include "ui/document/face_memory.h"

#include <QtTest>

#include <algorithm>

using namespace knead;

namespace {

Part boxPart(const std::string& name, const Vec3& size, const Vec3& place)
{
    Part part;
    part.name = name;
    part.mesh = shapes::moved(shapes::box(size), {.position = place});
    part.faces.resize(6);
    part.solids = part.shells = 1;
    part.watertight = part.valid = true;
    part.volume = massProperties(part.mesh).volume;
    return part;
}

/// Hands out a given model instead of reading a file.
ImportFiles importOf(const Model& model)
{
    return [model](const std::vector<std::string>& paths, const ImportOptions&, TaskControl&) {
        Model result = model;
        result.file = paths.front();
        return result;
    };
}

PreparedModel prepare(const Model& model)
{
    return prepareFiles(importOf(model), {{"folder/part.step"}, {}}, {}, TaskControl::none());
}

class CancelledControl final : public TaskControl {
public:
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return true; }
};

} // namespace

class FilledModelTest : public QObject {
    Q_OBJECT
private slots:
    void everyClosedPartBecomesABody()
    {
        Model model;
        model.parts = {boxPart("pin", {0.02, 0.02, 0.06}, {0, 0, 0.03}),
                       boxPart("pin", {0.02, 0.02, 0.06}, {0.1, 0, 0.03})};
        PreparedModel prepared = prepare(model);
        const SnapshotPointer start = prepared.simulation.snapshot();
        QCOMPARE(prepared.content.bodies.size(), std::size_t{2});
        QCOMPARE(start->bodies.size(), std::size_t{2});
        QVERIFY(prepared.content.bodies[0]->name != prepared.content.bodies[1]->name);
        QCOMPARE(prepared.content.box.max().x(), 0.11);
        QCOMPARE(*start->floorHeight, prepared.content.box.min().z());
    }

    void theSurfaceIsFineEnoughToBend()
    {
        Model model;
        model.parts = {boxPart("bar", {0.1, 0.02, 0.02}, Vec3::Zero())};
        const PreparedModel prepared = prepare(model);
        const TriangleMesh& mesh = prepared.content.bodies[0]->mesh;
        QVERIFY(isWatertight(mesh));
        for (const auto& t : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                QVERIFY((mesh.vertices[t[i]] - mesh.vertices[t[(i + 1) % 3]]).norm() <=
                        prepared.content.spacing * 1.000001);
    }

    void whatIsNotClosedIsShownAndNotFilled()
    {
        Part open = boxPart("lid", {0.02, 0.02, 0.002}, Vec3::Zero());
        open.watertight = false;
        open.visible = false;
        Model model;
        model.parts = {open, boxPart("pin", {0.02, 0.02, 0.06}, {0.1, 0, 0.03})};
        const PreparedModel both = prepare(model);
        QCOMPARE(both.content.bodies.size(), std::size_t{1});
        QCOMPARE(both.content.surfaces.size(), std::size_t{1});
        QCOMPARE(both.content.hiddenAtFirst(), std::set<std::size_t>{0});
        QCOMPARE(both.content.box.min().x(), -0.01);

        model.parts = {open};
        PreparedModel alone = prepare(model);
        QVERIFY(alone.content.bodies.empty() && !alone.content.isEmpty());
        QVERIFY(std::any_of(alone.content.warnings.begin(), alone.content.warnings.end(), [](const Message& warning) {
            return warning.english().find("\"lid\" is not a closed solid") != std::string::npos;
        }));
        alone.simulation.step();
        QVERIFY(alone.simulation.snapshot()->health.ok);
    }

    void aPartTooSmallForTheSpacingOfTheOthersIsOnlyShown()
    {
        Model model;
        model.parts = {boxPart("house", {10, 10, 10}, Vec3::Zero()), boxPart("screw", {0.002, 0.002, 0.01}, {6, 0, 0})};
        const PreparedModel prepared = prepare(model);
        QCOMPARE(prepared.content.bodies.size(), std::size_t{1});
        QCOMPARE(prepared.content.bodies[0]->name, std::string("house"));
        QCOMPARE(prepared.content.surfaces.size(), std::size_t{1});
        QVERIFY(prepared.content.unfilled.at(1).english().find("too thin") != std::string::npos);
    }

    void aFileWithoutASurfaceIsRefused()
    {
        Model model;
        model.parts = {Part{}};
        QVERIFY_THROWS_EXCEPTION(std::runtime_error, prepare(model));
    }

    void anOpenPartAmongClosedOnesIsLeftOutWithAWarning()
    {
        Model model;
        model.parts = {boxPart("sheet", {0.1, 0.1, 0.01}, Vec3::Zero()),
                       boxPart("pin", {0.02, 0.02, 0.06}, Vec3::Zero())};
        model.parts[0].watertight = false;
        const PreparedModel prepared = prepare(model);
        QCOMPARE(prepared.content.bodies.size(), std::size_t{1});
        QCOMPARE(prepared.content.bodies[0]->part, std::size_t{1});
        QCOMPARE(prepared.content.warnings.size(), std::size_t{1});
        QVERIFY(prepared.content.warnings[0].english().find("sheet") != std::string::npos);
    }

    void thinWallsGetMoreObjectsAndElseAWarning()
    {
        Model model;
        model.parts = {boxPart("plate", {0.1, 0.1, 0.003}, Vec3::Zero())};
        const PreparedModel plate = prepare(model);
        QVERIFY(plate.content.spacing <= 0.0015); // two cells, not the 3 mm of 3000 objects
        QVERIFY(plate.content.bodies[0]->aggregate->size() < 20'000);
        QVERIFY(plate.content.warnings.empty());
        model.parts = {boxPart("sheet", {0.1, 0.1, 0.002}, Vec3::Zero())};
        const PreparedModel sheet = prepare(model);
        QVERIFY(sheet.content.bodies[0]->aggregate->size() < 20'000);
        QCOMPARE(sheet.content.warnings.size(), std::size_t{1});
        QVERIFY(sheet.content.warnings[0].english().find("cells across 2 mm; bending of such walls") !=
                std::string::npos);
        model.parts = {boxPart("block", {0.1, 0.1, 0.03}, Vec3::Zero())};
        QVERIFY(prepare(model).content.warnings.empty());
    }

    void cancelStopsFilling()
    {
        Model model;
        model.parts = {boxPart("bar", {0.1, 0.02, 0.02}, Vec3::Zero())};
        CancelledControl control;
        QVERIFY_THROWS_EXCEPTION(Cancelled, prepareFiles(importOf(model), {{"part.step"}, {}}, {}, control));
    }

    void fixturesFollowEditsAndMoments()
    {
        Model model;
        model.parts = {boxPart("bar", {0.1, 0.02, 0.02}, Vec3::Zero())};
        PreparedModel prepared = prepare(model);
        Simulation& simulation = prepared.simulation;
        FaceFixtures fixtures;
        const auto post = [&](const std::vector<Command>& commands) {
            for (const Command& command : commands) {
                fixtures.posted(command);
                simulation.post(command);
            }
            return commands.size();
        };
        const auto toggle = [&](std::uint32_t face, std::uint32_t active) {
            const FaceFixtures::Edit edit = fixtures.toggle(prepared.content, 0, face, active);
            return std::pair(edit.key, post(edit.commands));
        };
        const auto held = [&] { return simulation.snapshot()->fixtures; };
        const auto [key, count] = toggle(0, 0);
        QCOMPARE(count, std::size_t{1});
        const MomentPointer one = simulation.keepMoment();
        QCOMPARE(toggle(1, key), std::pair(key, std::size_t{2})); // the small one goes, the larger one comes
        QCOMPARE(fixtures.find(key)->faces, (std::vector<std::uint32_t>{0, 1}));
        const MomentPointer two = simulation.keepMoment();
        const std::size_t both = held().at(0).objects.size();
        QCOMPARE(toggle(1, key).first, 0U);
        simulation.applyCommands();
        QCOMPARE(held().size(), std::size_t{1});
        QCOMPARE(held()[0].objects.size(), both / 2);

        simulation.goTo(two);
        fixtures.follow(prepared.content, two->fixtures);
        QCOMPARE(fixtures.find(key)->faces.size(), std::size_t{2});
        simulation.goTo(one);
        fixtures.follow(prepared.content, one->fixtures);
        QCOMPARE(fixtures.list().size(), std::size_t{1});
        QCOMPARE(fixtures.find(key)->faces, std::vector<std::uint32_t>{0});
        post(fixtures.remove(key));
        simulation.applyCommands();
        QVERIFY(held().empty());

        // What is known of faces goes into a project and comes back.
        FaceFixtures later;
        for (const FaceFixture& known : facesRemembered(faceMemory(fixtures.known())))
            later.keepInMind(known);
        QVERIFY(facesRemembered("no such thing").empty());
        later.follow(prepared.content, two->fixtures);
        QCOMPARE(later.list().at(0).key, key);
        QCOMPARE(later.list().at(0).faces, (std::vector<std::uint32_t>{0, 1}));
        FaceFixtures ignorant;
        ignorant.follow(prepared.content, two->fixtures);
        QVERIFY(ignorant.list().at(0).faces.empty());
        QCOMPARE(ignorant.remove(ignorant.list().at(0).key).size(), std::size_t{1});
    }

    void aStartIsShownAgainWithoutFilling()
    {
        Model model;
        model.parts = {boxPart("bar", {0.1, 0.02, 0.02}, Vec3::Zero()),
                       boxPart("lid", {0.1, 0.02, 0.002}, {0, 0, 0.1})};
        model.parts[1].watertight = false;
        const PreparedModel prepared = prepare(model);
        const FilledModel& before = prepared.content;
        const ProjectStart start = startOf(before, prepared.scene);
        const FilledModel again = contentOf(before.model, before.request, start, TaskControl::none());
        QCOMPARE(again.bodies.size(), before.bodies.size());
        QCOMPARE(again.bodies[0]->aggregate, before.bodies[0]->aggregate);
        QCOMPARE(again.bodies[0]->name, before.bodies[0]->name);
        QCOMPARE(again.bodies[0]->mesh.vertices.size(), before.bodies[0]->mesh.vertices.size());
        QCOMPARE(again.surfaces.size(), std::size_t{1});
        QCOMPARE(again.spacing, before.spacing);
        QCOMPARE(again.box.max().z(), before.box.max().z());
    }
};

QTEST_GUILESS_MAIN(FilledModelTest)
#include "filled_model_test.moc"
