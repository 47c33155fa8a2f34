#include "core/session/region.h"
#include "ui/selection/region_words.h"

#include "core/aggregate/fill.h"
#include "core/session/edge_chains.h"
#include "core/session/region_contents.h"
#include "support/shapes.h"
#include "ui/document/model_notes.h"
#include "ui/viewport/projector.h"
#include "ui/viewport/region_view.h"

#include <QtTest>

#include <cmath>
#include <random>
#include <set>

using namespace knead;

namespace {

Part boxPart(const Vec3& size)
{
    Part part;
    part.name = "box";
    part.mesh = shapes::box(size);
    part.faces.resize(6);
    part.faces[2].name = "seat %2";
    part.solids = part.shells = 1;
    part.watertight = part.valid = true;
    return part;
}

struct Filled {
    FilledModel content;
    FramePointer frame;
};

Filled filledBox(const Vec3& size)
{
    auto model = std::make_shared<Model>();
    model->file = "box.step";
    model->parts = {boxPart(size)};
    PreparedModel prepared = prepareModel(model, {{"box.step"}, {}}, {}, TaskControl::none());
    return {std::move(prepared.content), prepared.frame};
}

} // namespace

class RegionTest : public QObject {
    Q_OBJECT
private slots:
    void regionsCombineAsSets()
    {
        std::mt19937 random(7);
        for (int round = 0; round < 200; ++round) {
            std::set<std::pair<BodyId, Region::Item>> a;
            std::set<std::pair<BodyId, Region::Item>> b;
            Region first;
            Region second;
            for (int i = 0; i < 8; ++i) {
                const auto body = static_cast<BodyId>(random() % 3);
                const Region::Item item = random() % 6;
                (i % 2 == 0 ? a : b).insert({body, item});
                (i % 2 == 0 ? first : second).add(body, item);
            }
            for (BodyId body = 0; body < 3; ++body)
                for (Region::Item item = 0; item < 6; ++item) {
                    const bool isInA = a.contains({body, item});
                    const bool isInB = b.contains({body, item});
                    QCOMPARE(united(first, second).contains(body, item), isInA || isInB);
                    QCOMPARE(without(first, second).contains(body, item), isInA && !isInB);
                    QCOMPARE(toggled(first, second).contains(body, item), isInA != isInB);
                }
            QCOMPARE(first.count(), a.size());
            for (const auto& [body, items] : without(first, second).items)
                QVERIFY(!items.empty());
        }
    }

    void aBoxHasTwelveEdgesOfTheirLengths()
    {
        const Vec3 size(0.02, 0.03, 0.05);
        const Filled box = filledBox(size);
        const RenderMesh& mesh = box.content.bodies[0]->render;
        QCOMPARE(mesh.chains, 12U);
        std::multiset<int> lengths; // [mm]
        for (std::uint32_t chain = 0; chain < mesh.chains; ++chain)
            lengths.insert(static_cast<int>(
                std::lround(1000 * sizeOf(regionOf(Level::Edge, 0, {chain}), box.content, *box.frame).length)));
        QCOMPARE(lengths, (std::multiset<int>{20, 20, 20, 20, 30, 30, 30, 30, 50, 50, 50, 50}));
    }

    void aFaceIsCalledByItsName()
    {
        const Filled box = filledBox({0.02, 0.03, 0.05});
        const auto words = [&](const Region& region) {
            return wordsFor(region, sizeOf(region, box.content, *box.frame));
        };
        QVERIFY(words(regionOf(Level::Face, 0, {2})).startsWith("Face \"seat %2\", "));
        QVERIFY(words(regionOf(Level::Face, 0, {3})).startsWith("1 face, "));
        QVERIFY(words(regionOf(Level::Face, 0, {2, 3})).startsWith("2 faces, "));
        QVERIFY(words(regionOf(Level::Part, 0, {0})).startsWith("1 part, "));
        // What all faces are called tells none of them.
        Model same = *box.content.model;
        for (PartFace& face : same.parts[0].faces)
            face.name = "PartBody";
        FilledModel content = box.content;
        content.model = std::make_shared<const Model>(same);
        QVERIFY(nameOfFace(content, 0, 2).empty());
        FaceFixtures fixtures;
        fixtures.toggle(box.content, 0, 2, 0);
        fixtures.add(box.content, 0, {2});
        fixtures.add(box.content, 0, {3});
        QCOMPARE(fixtures.list().at(0).name, std::string("seat %2"));
        QCOMPARE(fixtures.list().at(1).name, std::string("Fixture 2"));
        QCOMPARE(fixtures.list().at(2).name, std::string("Fixture 3"));
    }

    void sizesAreThoseOfTheShape()
    {
        const Vec3 size(0.02, 0.03, 0.05);
        const Filled box = filledBox(size);
        double area = 0;
        for (std::uint32_t face = 0; face < 6; ++face)
            area += sizeOf(regionOf(Level::Face, 0, {face}), box.content, *box.frame).area;
        QVERIFY(std::abs(area - 2 * (0.0006 + 0.001 + 0.0015)) < 1e-9);
        const RegionSize part = sizeOf(regionOf(Level::Part, 0, {0}), box.content, *box.frame);
        QVERIFY(std::abs(part.volume - 3e-5) < 1e-10);
        Region::Items all;
        for (ObjectIndex object = 0; object < box.content.bodies[0]->aggregate->size(); ++object)
            all.push_back(object);
        const RegionSize objects = sizeOf(regionOf(Level::Object, 0, all), box.content, *box.frame);
        QVERIFY(std::abs(objects.volume - 3e-5) < 1e-8);
        QVERIFY2(wordsFor(regionOf(Level::Part, 0, {0}), part).contains("1 part"), "in words");
        QVERIFY(wordsFor(regionOf(Level::Part, 0, {0}), part).contains("30"));
    }

    void objectsWithinADistanceAreThoseOfBruteForce()
    {
        const Filled box = filledBox({0.03, 0.03, 0.06});
        const std::vector<Vec3>& places = box.frame->snapshot->bodies[0].positions;
        const Region seed = regionOf(Level::Object, 0, {3, 40});
        for (const double cells : {0.0, 0.5, 1.0, 1.5, 2.3, 5.0}) {
            const double distance = cells * box.content.spacing;
            const Region found = objectsWithin(seed, distance, box.content, *box.frame);
            for (ObjectIndex object = 0; object < places.size(); ++object) {
                const double nearest =
                    std::min((places[object] - places[3]).norm(), (places[object] - places[40]).norm());
                if (std::abs(nearest - distance) > 1e-6 * distance || distance == 0)
                    QCOMPARE(found.contains(0, object), nearest <= distance);
            }
            QVERIFY(found.contains(0, 3) && found.contains(0, 40));
        }
    }

    void everyConnectionHasTwoEndsAndIsFoundAgain()
    {
        const Filled box = filledBox({0.02, 0.02, 0.04});
        const Aggregate& aggregate = *box.content.bodies[0]->aggregate;
        const std::vector<ConnectionId> all = allConnections(aggregate);
        QCOMPARE(all.size(), aggregate.connectionCount());
        for (const ConnectionId& connection : all) {
            const auto [lower, upper] = endsOf(aggregate, connection);
            QVERIFY(upper < aggregate.size() && lower != upper);
            QVERIFY(connectionOf(connectionItem(connection)) == connection);
            QVERIFY(isConnection(aggregate, connectionItem(connection)));
        }
        QVERIFY(!isConnection(aggregate, connectionItem({12, 0})));
        QVERIFY(!isConnection(aggregate, ~Region::Item{0}));
    }

    void edgesHoldTheObjectsAlongThem()
    {
        const Filled box = filledBox({0.02, 0.02, 0.06});
        const Lattice& lattice = box.content.bodies[0]->aggregate->lattice;
        Region::Items all;
        for (std::uint32_t chain = 0; chain < 12; ++chain)
            all.push_back(chain);
        for (const auto& [body, objects] : objectsOf(regionOf(Level::Edge, 0, all), box.content))
            for (const ObjectIndex object : objects) { // near two faces of the box at once
                const Vec3 depth = Vec3(0.01, 0.01, 0.03) - lattice.position(object).cwiseAbs();
                const int near = static_cast<int>((depth.array() < 0.87 * lattice.spacing).count());
                QVERIFY(near >= 2);
            }
        QVERIFY(!objectsOf(regionOf(Level::Edge, 0, {0}), box.content).empty());
    }

    void shapesOnTheScreenContainWhatLiesInThem()
    {
        const ScreenShape box = boxShape({10, 20}, {30, 5});
        QVERIFY(contains(box, {20, 10}));
        QVERIFY(!contains(box, {20, 21}) && !contains(box, {9, 10}));
        const ScreenShape disk = strokeShape({50, 50}, {50, 50}, 10);
        QVERIFY(contains(disk, {56, 56}) && !contains(disk, {58, 58}));
        const ScreenShape stroke = strokeShape({10, 50}, {90, 50}, 10);
        QVERIFY(contains(stroke, {50, 58}) && contains(stroke, {2, 50}) && contains(stroke, {98, 50}));
        QVERIFY(!contains(stroke, {50, 62}) && !contains(stroke, {2, 58}) && !contains(stroke, {98, 42}));
        const ScreenShape horseshoe{{0, 0}, {30, 0}, {30, 30}, {20, 30}, {20, 10}, {10, 10}, {10, 30}, {0, 30}};
        QVERIFY(contains(horseshoe, {5, 20}) && contains(horseshoe, {25, 20}) && !contains(horseshoe, {15, 20}));
    }

    void projectorAgreesWithCamera()
    {
        Camera camera;
        camera.distance = 0.3;
        std::mt19937 random(3);
        std::uniform_real_distribution<double> number(-0.2, 0.2);
        for (const bool perspective : {true, false})
            for (int i = 0; i < 100; ++i) {
                camera.perspective = perspective;
                camera.yaw = 10 * number(random);
                const WindowSize window{800, 600};
                const Vec3 place(number(random), number(random), number(random));
                const auto expected = camera.project(place, window);
                const auto found = Projector(camera, window)(place);
                QCOMPARE(found.has_value(), expected.has_value());
                if (found)
                    QVERIFY(std::hypot(found->x - expected->x, found->y - expected->y) < 1e-6);
            }
    }

    void notesComeBackFromAProject()
    {
        ModelNotes notes;
        notes.addGroup("pins \"a\"", {1, 3});
        notes.addGroup("Größe", {2});
        notes.setLocked("tool Block 1", true);
        notes.putSet({"foot", Level::Face, 0, {{1, {3, 4, 5, 9}}}});
        notes.putSet({"bonds", Level::Connection, 2, {{0, {connectionItem({3, 7}), connectionItem({3, 8})}}}});
        notes.noteExport("/tmp/a.step", 1.7e9);
        ModelNotes other;
        other.remember(notes.memory());
        QCOMPARE(other.memory(), notes.memory());
        QCOMPARE(other.sets(), notes.sets());
        QCOMPARE(other.groups().size(), std::size_t{2});
        QVERIFY(other.isLocked("tool Block 1"));
        QCOMPARE(other.exports().front().file, std::string("/tmp/a.step"));
    }

    void damagedNotesAreNone()
    {
        for (const char* text : {"", "{", "[]", "{\"groups\": 3, \"sets\": [{\"name\": \"x\"}], \"locks\": {}}",
                                 "{\"sets\": [{\"name\": \"x\", \"level\": \"faces\", \"parts\": [{\"part\": 0, "
                                 "\"items\": [[0, 5, 1]]}]}]}"}) {
            ModelNotes notes;
            notes.setLocked("part 0", true);
            notes.remember(text);
            QVERIFY(notes.sets().empty() && notes.groups().empty() && !notes.isLocked("part 0"));
        }
    }

    void aPartIsInOneGroupAtMost()
    {
        ModelNotes notes;
        notes.addGroup("a", {1, 2});
        notes.addGroup("b", {2, 3});
        QCOMPARE(notes.groupOf(2)->name, std::string("b"));
        notes.renameGroup("a", "b"); // joins them
        QCOMPARE(notes.groups().size(), std::size_t{1});
        QCOMPARE(notes.groupOf(1)->name, std::string("b"));
        notes.takeOutOfGroup({1, 3});
        QVERIFY(notes.groupOf(1) == nullptr && notes.groupOf(2) != nullptr);
    }
};

QTEST_GUILESS_MAIN(RegionTest)
#include "region_test.moc"
