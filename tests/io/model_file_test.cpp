#include "core/geometry/triangle_mesh.h"
#include "io/worker/model_file.h"
#include "support/shapes.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace knead;

namespace {

/// A model in which every field differs from its default.
Model fullModel()
{
    Part part;
    part.name = "Würfel 立方体";
    part.path = "root/a \"quoted\" name/Würfel 立方体";
    part.color = Color{0.25F, 0.5F, 1};
    part.faces = {{std::nullopt}, {Color{1, 0, 0}, "seat \u00e4"}};
    part.mesh = shapes::box({0.01, 0.02, 0.03});
    part.mesh.faceOfTriangle.assign(part.mesh.triangles.size(), 1);
    part.solids = 1;
    part.shells = 2;
    part.edges = 12;
    part.volume = 6e-6;
    part.area = 1.0 / 3;
    part.box = Box(Vec3(-0.1, 0, 0), Vec3(0.01, 0.02, 0.03));
    part.watertight = part.valid = true;
    part.maxTolerance = 1e-7;
    part.visible = false;
    part.layer = "layer 7";
    part.repairs = {knead::Message("Repair", "%1 faces were sewn.").with(45)};
    part.openEdges = {{Vec3(0, 0, 0), Vec3(1, 0, 0)}, {}, {Vec3(0.1, 0.2, 0.3)}};
    part.warnings = {knead::Message::verbatim("is odd.")};

    Model model;
    model.file = "/home/ann/part.step";
    model.format = "STEP AP242";
    model.unit = "inch";
    model.unitRemark = UnitRemark{knead::Message("Unit", "It is large."), "mm"};
    model.warnings = {knead::Message::verbatim("one"),
                      knead::Message("Import", "%1 two").with(knead::Message("Import", "of"))};
    model.missing = {knead::Message("Import", "\"%1\" is missing.").with("lid")};
    model.parts = {part, Part{}};
    model.tree = {"root", std::nullopt, {{"a", std::nullopt, {{"one", 0, {}}, {"two", 1, {}}}}, {"b", 1, {}}}};
    return model;
}

/// One part, so many levels deep.
Model nested(int levels)
{
    Model model;
    model.parts.resize(1);
    PartNode* node = &model.tree;
    for (int level = 0; level < levels; ++level)
        node = &node->children.emplace_back(PartNode{std::to_string(level), std::nullopt, {}});
    node->part = 0;
    return model;
}

bool sameTree(const PartNode& a, const PartNode& b)
{
    return a.name == b.name && a.part == b.part &&
           std::equal(a.children.begin(), a.children.end(), b.children.begin(), b.children.end(), sameTree);
}

/// Nothing in it could hurt whoever uses it.
bool isSound(const Model& model)
{
    return std::all_of(model.parts.begin(), model.parts.end(), [](const Part& part) {
        const TriangleMesh& mesh = part.mesh;
        const bool areFinite = std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                                           [](const Vec3& vertex) { return vertex.allFinite(); });
        const bool areThere = std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
            return std::all_of(triangle.begin(), triangle.end(),
                               [&](std::uint32_t vertex) { return vertex < mesh.vertices.size(); });
        });
        return areFinite && areThere && std::isfinite(part.volume);
    });
}

} // namespace

class ModelFileTest : public QObject {
    Q_OBJECT
private slots:
    void everythingArrivesAsItWas()
    {
        const Model sent = fullModel();
        const Model model = modelFromBytes(modelToBytes(sent));
        QCOMPARE(model.file, sent.file);
        QCOMPARE(model.format, sent.format);
        QCOMPARE(model.unit, sent.unit);
        QCOMPARE(model.unitRemark.value().sentence, sent.unitRemark->sentence);
        QCOMPARE(model.unitRemark.value().unit, sent.unitRemark->unit);
        QCOMPARE(model.warnings, sent.warnings);
        QCOMPARE(model.missing, sent.missing);
        QVERIFY(sameTree(model.tree, sent.tree));
        QCOMPARE(model.parts.size(), std::size_t{2});
        const Part& part = model.parts[0];
        const Part& expected = sent.parts[0];
        QCOMPARE(part.name, expected.name);
        QCOMPARE(part.path, expected.path);
        QVERIFY(part.color == expected.color);
        QVERIFY(part.faces == expected.faces);
        QVERIFY(part.mesh.vertices == expected.mesh.vertices);
        QVERIFY(part.mesh.triangles == expected.mesh.triangles);
        QVERIFY(part.mesh.faceOfTriangle == expected.mesh.faceOfTriangle);
        QCOMPARE(part.solids, 1);
        QCOMPARE(part.shells, 2);
        QCOMPARE(part.edges, 12);
        QVERIFY(part.volume == expected.volume && part.area == expected.area);
        QVERIFY(part.box.min() == expected.box.min() && part.box.max() == expected.box.max());
        QVERIFY(part.watertight && part.valid && !part.visible);
        QVERIFY(part.maxTolerance == expected.maxTolerance);
        QCOMPARE(part.layer, expected.layer);
        QCOMPARE(part.repairs, expected.repairs);
        QVERIFY(part.openEdges == expected.openEdges);
        QCOMPARE(part.warnings, expected.warnings);
        QVERIFY(model.parts[1].box.isEmpty());
    }

    void aTreeOfThousandsOfLevelsArrives()
    {
        const Model model = nested(4000);
        QVERIFY(sameTree(modelFromBytes(modelToBytes(model)).tree, model.tree));
    }

    /// Whoever goes down it would use up the stack.
    void aTreeDeeperThanFilesHaveIsRefused()
    {
        QVERIFY_EXCEPTION_THROWN(modelFromBytes(modelToBytes(nested(6000))), Problem);
    }

    void aFailureIsToldFromAModel()
    {
        const knead::Message failure = knead::Message("Import", "%1: no.").with("bad.step");
        QCOMPARE(failureIn(failureToBytes(failure)), failure);
        QCOMPARE(failureIn(failureToBytes(failure)).english(), std::string("bad.step: no."));
        const knead::Message unreadable = knead::Message("Import", "%1: no.").with("bad\xFF.step");
        QCOMPARE(failureIn(failureToBytes(unreadable)).english(), unreadable.english());
        QVERIFY(failureIn(modelToBytes(fullModel())).empty());
        QVERIFY(failureIn({}).empty());
    }

    void cutOffBytesAreRefusedAtAnyPlace()
    {
        const std::string bytes = modelToBytes(fullModel());
        for (std::size_t length = 0; length + 8 < bytes.size(); length += 7) // the last words may be padding
            QVERIFY_EXCEPTION_THROWN(modelFromBytes(std::string_view(bytes).substr(0, length)), std::runtime_error);
    }

    /// Whatever a process that went astray may leave: it is refused, or it is sound.
    void damagedBytesNeverGiveAnUnsoundModel()
    {
        const std::string bytes = modelToBytes(fullModel());
        std::mt19937 random(5);
        int refused = 0;
        for (int trial = 0; trial < 20'000; ++trial) {
            std::string damaged = bytes;
            for (std::uint32_t i = 0; i <= random() % 4; ++i)
                damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
            try {
                QVERIFY(isSound(modelFromBytes(damaged)));
            } catch (const std::runtime_error&) {
                ++refused;
            }
        }
        QVERIFY(refused > 1000);
    }

    void wrongIndicesAreNamed()
    {
        Model model = fullModel();
        model.parts[0].mesh.triangles[3][1] = 8;
        QVERIFY_EXCEPTION_THROWN(modelFromBytes(modelToBytes(model)), std::runtime_error);
        model = fullModel();
        model.parts[0].mesh.faceOfTriangle[0] = 2;
        QVERIFY_EXCEPTION_THROWN(modelFromBytes(modelToBytes(model)), std::runtime_error);
        model = fullModel();
        model.parts[0].mesh.vertices[0].x() = std::nan("");
        QVERIFY_EXCEPTION_THROWN(modelFromBytes(modelToBytes(model)), std::runtime_error);
        model = fullModel();
        model.tree.children[1].part = 2;
        QVERIFY_EXCEPTION_THROWN(modelFromBytes(modelToBytes(model)), std::runtime_error);
        model = fullModel();
        model.parts[0].volume = std::numeric_limits<double>::infinity();
        QVERIFY_EXCEPTION_THROWN(modelFromBytes(modelToBytes(model)), std::runtime_error);
    }
};

QTEST_GUILESS_MAIN(ModelFileTest)
#include "model_file_test.moc"
