#include "core/deformation/number_words.h"
#include "io/recipe/recipe_deformations.h"
#include "io/recipe/recipe_physics.h"
#include "support/recipe_texts.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace knead;
using namespace knead::recipe_texts;

class RecipeDeformTest : public QObject {
    Q_OBJECT

private slots:
    void partsAreBentByNumber();
    void bendsMayBeSaidByTheirRadius();
    void fieldsOfFilesAreNamed();
    void whatIsWrittenIsReadToTheBit();
    void deformingByPhysicsIsAnEvent();
    void whatGripsCannotDoIsNamed_data();
    void whatGripsCannotDoIsNamed();
    void whatIsWrongIsNamed_data();
    void whatIsWrongIsNamed();
};

namespace {

json deforming(const std::string& item)
{
    return with("deform", "[" + item + "]");
}

/// With the digits as they are written.
RecipeDeformation only(const std::string& item)
{
    const std::string text =
        R"({"version": 1, "part": {"file": "bar.stl"}, "objects": 500, "duration_s": 2, "deform": [)";
    return readText(text + item + "]}").deformations.at(0);
}

std::string written(const RecipeDeformation& deformation)
{
    return recipe_keys::DeformationWords{recipe_keys::nowhere()}.text(deformation);
}

} // namespace

void RecipeDeformTest::partsAreBentByNumber()
{
    const RecipeDeformation read = only(
        R"({"kind": "bend", "body": "Bar", "origin_mm": [1, 2, 3], "axis": [2, 0, 0], "side": [1, 0, 2], "from_mm": 10,
                 "to_mm": 40, "angle_deg": 90, "neutral_mm": -1.5, "stays": 0.5, "eases": true})");
    QCOMPARE(read.bodies, std::vector<std::string>{"Bar"});
    QVERIFY(!read.kFactor && !read.isApart);
    const auto& bend = std::get<NumberDeformation>(read.what);
    QVERIFY(bend.kind == NumberKind::bend);
    QVERIFY((bend.origin - Vec3(0.001, 0.002, 0.003)).norm() < 1e-15);
    QCOMPARE(bend.axis, Vec3(Vec3::UnitX()));
    QCOMPARE(bend.side, Vec3(Vec3::UnitZ())); // what is along the axis does not matter
    QCOMPARE(bend.from, 0.01);
    QCOMPARE(bend.to, 0.04);
    QVERIFY(std::abs(bend.angle - std::numbers::pi / 2) < 1e-15);
    QCOMPARE(bend.neutral, -0.0015);
    QCOMPARE(bend.stays, 0.5);
    QVERIFY(bend.eases);
    QVERIFY(parse(smallest()).deformations.empty());
}

void RecipeDeformTest::bendsMayBeSaidByTheirRadius()
{
    const RecipeDeformation read =
        only(R"({"kind": "bend", "axis": [1, 0, 0], "side": [0, 0, 1], "from_mm": 0, "to_mm": 50, "radius_mm": 25})");
    QVERIFY(std::abs(std::get<NumberDeformation>(read.what).angle - 2) < 1e-15);
}

void RecipeDeformTest::fieldsOfFilesAreNamed()
{
    const RecipeDeformation read =
        only(R"({"field": "bar.stl", "body": "Bar", "step": 3, "name": "U", "unit": "inch", "factor": -1,
                 "kept_faces": [4, 5], "fade_mm": 8, "locked": ["y"]})");
    const auto& field = std::get<RecipeField>(read.what);
    QVERIFY(QString::fromStdString(field.file).endsWith("/bar.stl"));
    QCOMPARE(field.choice.step, std::optional<std::size_t>(3));
    QCOMPARE(field.choice.name, std::string("U"));
    QCOMPARE(field.choice.unit, std::string("inch"));
    QCOMPARE(field.factor, -1.0);
    QCOMPARE(field.kept.size(), std::size_t{1});
    QVERIFY(field.kept[0].body.empty());
    QCOMPARE(field.kept[0].faces, (std::vector<std::uint32_t>{4, 5}));
    QCOMPARE(field.fade, 0.008);
    QVERIFY(!field.locked[0] && field.locked[1] && !field.locked[2]);
}

void RecipeDeformTest::whatIsWrittenIsReadToTheBit()
{
    for (const NumberKindWords& words : numberKindWords()) {
        NumberDeformation wanted{.kind = words.kind,
                                 .origin = Vec3(0.1, -0.02, 1.0 / 3),
                                 .axis = Vec3(0.6, 0, 0.8),
                                 .side = Vec3(-0.8, 0, 0.6),
                                 .from = -0.0123456789,
                                 .to = 1.0 / 7,
                                 .stays = 1.0 / 3,
                                 .eases = true};
        for (const NumberParameter& parameter : words.parameters)
            wanted.*parameter.value = 0.7312345678901234;
        if (!words.hasSide)
            wanted.side = wanted.axis.unitOrthogonal();
        const std::string text = written({.bodies = {"Bar"}, .what = wanted});
        const RecipeDeformation back = only(text);
        QCOMPARE(back.bodies, std::vector<std::string>{"Bar"});
        QVERIFY2(std::get<NumberDeformation>(back.what) == wanted, text.c_str());
    }
    const NumberDeformation bend{.kind = NumberKind::bend, .to = 1.0 / 7, .angle = 0.3};
    const RecipeDeformation sheet =
        only(written({.bodies = {"Bar", "a/Bar"}, .what = bend, .kFactor = 1.0 / 3, .isApart = true}));
    QCOMPARE(sheet.bodies, (std::vector<std::string>{"Bar", "a/Bar"}));
    QCOMPARE(sheet.kFactor, std::optional(1.0 / 3));
    QVERIFY(sheet.isApart && std::get<NumberDeformation>(sheet.what) == bend);
    RecipeField field{
        .file = "bar.stl", .choice = {.step = 2, .name = "U", .unit = "mm", .isInPlace = true}, .factor = -0.3};
    field.fade = 0.0033;
    field.locked = {true, false, true};
    for (const std::vector<KeptFaces>& kept :
         {std::vector<KeptFaces>{{"", {1, 7}}}, std::vector<KeptFaces>{{"Lid", {1}}, {"Bar", {0, 2}}}}) {
        field.kept = kept;
        const RecipeDeformation read = only(written({.bodies = {}, .what = field, .isApart = true}));
        const auto& back = std::get<RecipeField>(read.what);
        QVERIFY(read.isApart && back.choice.isInPlace);
        QVERIFY(back.choice.step == field.choice.step && back.choice.name == field.choice.name);
        QVERIFY(back.factor == field.factor && back.fade == field.fade && back.locked == field.locked);
        QVERIFY(std::ranges::equal(back.kept, kept, [](const KeptFaces& a, const KeptFaces& b) {
            return a.body == b.body && a.faces == b.faces;
        }));
    }
}

void RecipeDeformTest::deformingByPhysicsIsAnEvent()
{
    DeformByPhysics wanted{.body = "Bar",
                           .what = {.numbers = {.kind = NumberKind::bend,
                                                .origin = Vec3(0.1, -0.02, 1.0 / 3),
                                                .axis = Vec3(0.6, 0, 0.8),
                                                .side = Vec3(-0.8, 0, 0.6),
                                                .from = -0.0123456789,
                                                .to = 1.0 / 7,
                                                .angle = 0.7312345678901234,
                                                .neutral = 1e-3 / 3,
                                                .stays = 1.0 / 3},
                                    .duration = 1.0 / 3,
                                    .letsGo = true,
                                    .name = "hand"}};
    const std::string event =
        R"([{"time_s": 0.5, "deform_by_physics": )" + recipe_keys::PhysicsWords::text(wanted) + "}]";
    const Recipe recipe = readText(
        R"({"version": 1, "part": {"file": "bar.stl"}, "objects": 500, "duration_s": 2, "events": )" + event + "}");
    QCOMPARE(recipe.events.size(), std::size_t{1});
    QCOMPARE(recipe.events[0].time, 0.5);
    const auto& read = std::get<DeformByPhysics>(recipe.events[0].action);
    QCOMPARE(read.body, wanted.body);
    QVERIFY2(read.what.numbers == wanted.what.numbers, event.c_str());
    QVERIFY(read.what.duration == wanted.what.duration && read.what.letsGo && read.what.name == "hand");
}

void RecipeDeformTest::whatGripsCannotDoIsNamed_data()
{
    QTest::addColumn<QString>("item");
    QTest::addColumn<QString>("says");
    const QString planes = R"("axis": [1, 0, 0], "from_mm": 0, "to_mm": 9)";
    const QString twist = R"({"time_s": 0, "deform_by_physics": {"kind": "twist", "angle_deg": 9, )" + planes;
    QTest::newRow("taper") << R"({"time_s": 0, "deform_by_physics": {"kind": "taper", "factor": 2, )" + planes + "}}"
                           << "events[0].deform_by_physics.kind cannot be done by physics";
    QTest::newRow("eased") << twist + R"(, "eases": true}})"
                           << "eases";
    QTest::newRow("no time") << twist + R"(, "duration_s": 0}})"
                             << "duration_s must be a number between 0.01 and 3600";
    QTest::newRow("twice") << twist + "}}, " + twist + "}}"
                           << "is used twice: \"twist: first end\"";
}

void RecipeDeformTest::whatGripsCannotDoIsNamed()
{
    QFETCH(QString, item);
    QFETCH(QString, says);
    const std::string message = messageFor(with("events", "[" + item.toStdString() + "]"));
    QVERIFY2(message.find(says.toStdString()) != std::string::npos, message.c_str());
}

void RecipeDeformTest::whatIsWrongIsNamed_data()
{
    QTest::addColumn<QString>("item");
    QTest::addColumn<QString>("says");
    const QString planes = R"("axis": [1, 0, 0], "from_mm": 0, "to_mm": 9)";
    const auto row = [&](const char* name, const QString& item, const char* says) {
        QTest::newRow(name) << "{" + item + "}" << QString(says);
    };
    row("neither", planes, "deform[0] must have the key \"kind\".");
    row("unknown", R"("kind": "fold", )" + planes,
        "deform[0].kind must be one of bend, twist, taper, stretch, shear, scale");
    row("no angle", R"("kind": "twist", )" + planes,
        "deform[0] must have exactly one of the keys angle_deg and angle_rad.");
    row("two angles", R"("kind": "twist", "angle_deg": 1, "angle_rad": 1, )" + planes,
        "deform[0] must have exactly one of the keys angle_deg and angle_rad.");
    row("a radius of a twist", R"("kind": "twist", "angle_deg": 1, "radius_mm": 1, )" + planes,
        "deform[0].radius_mm does not belong to the kind twist.");
    row("a factor of a bend", R"("kind": "bend", "side": [0, 0, 1], "angle_deg": 1, "factor": 1, )" + planes,
        "deform[0].factor does not belong to the kind bend.");
    row("no side", R"("kind": "bend", "angle_deg": 1, )" + planes, "deform[0] must have the key \"side\".");
    row("a side along the axis", R"("kind": "bend", "side": [3, 0, 0], "angle_deg": 1, )" + planes,
        "deform[0].side must point across the axis.");
    row("planes", R"("kind": "twist", "angle_deg": 1, "axis": [1, 0, 0], "from_mm": 9, "to_mm": 9)",
        "deform[0].to_mm must be larger than from_mm.");
    row("a gentle fold", R"("kind": "stretch", "factor": 0.3, "eases": true, )" + planes,
        "deform[0] cannot be: A gentle stretch cannot shorten to less than 0.47");
    row("a k factor of a twist", R"("kind": "twist", "angle_deg": 1, "k_factor": 0.4, )" + planes,
        "deform[0].k_factor does not belong to the kind twist.");
    row("a neutral plane twice",
        R"("kind": "bend", "side": [0, 0, 1], "angle_deg": 1, "k_factor": 0.4, "neutral_mm": 1, )" + planes,
        "deform[0] must have one of the keys neutral_mm and k_factor, or none.");
    row("a large k factor", R"("kind": "bend", "side": [0, 0, 1], "angle_deg": 1, "k_factor": 1.4, )" + planes,
        "deform[0].k_factor must be a number between 0 and 1, got 1.4");
    row("no bodies", R"("kind": "twist", "body": [], "angle_deg": 1, )" + planes,
        "deform[0].body must name at least one body.");
    row("kept without fading", R"("field": "bar.stl", "kept_faces": [1])",
        "deform[0] must have both of the keys kept_faces and fade_mm, or none.");
    row("no such file", R"("field": "no.frd")", "deform[0].field names a file that does not exist");
}

void RecipeDeformTest::whatIsWrongIsNamed()
{
    QFETCH(QString, item);
    QFETCH(QString, says);
    const std::string message = messageFor(deforming(item.toStdString()));
    QVERIFY2(message.find(says.toStdString()) != std::string::npos, message.c_str());
}

QTEST_GUILESS_MAIN(RecipeDeformTest)
#include "recipe_deform_test.moc"
