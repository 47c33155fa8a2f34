#include "io/json/json_value.h"
#include "io/recipe/recipe_override.h"
#include "support/recipe_texts.h"

#include <QtTest>

using namespace knead;
using namespace knead::recipe_texts;

/// Changes to recipes before they are checked. The oracle is the pointer of another JSON library.
class RecipeOverrideTest : public QObject {
    Q_OBJECT

private slots:
    void everyPlaceCanBeSet();
    void valuesAreJsonOrTexts_data();
    void oneWayOfFillingTakesThePlaceOfAnother();
    void valuesAreJsonOrTexts();
    void placesAreFoundByName_data();
    void placesAreFoundByName();
    void wrongChangesAreRefusedWithTheirPath_data();
    void wrongChangesAreRefusedWithTheirPath();
    void changesReachTheRecipe();
};

namespace {

struct ToJson {
    json operator()(std::monostate) const { return nullptr; }
    json operator()(bool value) const { return value; }
    json operator()(const JsonNumber& number) const { return number.value; }
    json operator()(const std::string& value) const { return value; }
    json operator()(const JsonValue::List& list) const
    {
        json result = json::array();
        for (const JsonValue& item : list)
            result.push_back(std::visit(*this, item.content));
        return result;
    }
    json operator()(const JsonValue::Object& object) const
    {
        json result = json::object();
        for (const auto& [key, value] : object)
            result[key] = std::visit(*this, value.content);
        return result;
    }
};

json changed(const json& recipe, const std::vector<RecipeOverride>& changes)
{
    JsonValue value = parseJson(recipe.dump(), "bend.recipe.json");
    applyOverrides(value, changes, "bend.recipe.json");
    return std::visit(ToJson{}, value.content);
}

json full()
{
    return json::parse(R"({"version": 1, "part": {"file": "bar.stl"}, "objects": 500, "duration_s": 2,
        "material": {"preset": "clay", "friction": 0.5}, "gravity_m_s2": [0, 0, -9.8],
        "body_materials": {"lid": "rubber", "lid.1": {"preset": "clay"}},
        "fixtures": [{"name": "end", "faces": [1, 2]}, {"name": "end.left", "box_mm": [0, 0, 0, 1, 1, 1]}],
        "manipulators": [{"name": "press", "size_mm": [1, 2, 3], "position_mm": [0, 0, 0],
                          "keyframes": [{"time_s": 1}, {"time_s": 2}]}],
        "events": [{"time_s": 1, "material": "rubber"}]})");
}

/// A pointer of the other library as a path: "/fixtures/0/faces" -> "fixtures.0.faces".
std::string pathOf(const json::json_pointer& place)
{
    std::string path = place.to_string().substr(1);
    std::replace(path.begin(), path.end(), '/', '.');
    return path;
}

} // namespace

void RecipeOverrideTest::everyPlaceCanBeSet()
{
    const json flat = full().flatten();
    QVERIFY(flat.size() > 30);
    for (const auto& [text, value] : flat.items()) {
        const json::json_pointer place(text);
        QCOMPARE(changed(full(), {{pathOf(place), value.dump()}}), full());
        json expected = full();
        expected[place] = "other";
        QCOMPARE(changed(full(), {{pathOf(place), "other"}}), expected);
    }
}

void RecipeOverrideTest::valuesAreJsonOrTexts_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("value");
    QTest::newRow("number") << "objects=20"
                            << "20";
    QTest::newRow("exponent") << "objects=2e3"
                              << "2000";
    QTest::newRow("text") << "objects=clay"
                          << "\"clay\"";
    QTest::newRow("quoted") << "objects=\"20\""
                            << "\"20\"";
    QTest::newRow("no JSON number") << "objects=.5"
                                    << "\".5\"";
    QTest::newRow("list") << "objects=[1, 2]"
                          << "[1, 2]";
    QTest::newRow("object") << "objects={\"a\": true}"
                            << "{\"a\": true}";
    QTest::newRow("equals sign") << "objects=a=b"
                                 << "\"a=b\"";
    QTest::newRow("nothing") << "objects="
                             << "\"\"";
}

/// A recipe says in one way how finely parts are filled.
void RecipeOverrideTest::oneWayOfFillingTakesThePlaceOfAnother()
{
    json recipe = full();
    const json objects = recipe.at("objects");
    const json result = changed(recipe, {parseOverride("spacing_mm=3")});
    QVERIFY(!result.contains("objects"));
    QCOMPARE(result.at("spacing_mm"), json(3));
    QCOMPARE(changed(result, {parseOverride("objects=" + objects.dump())}), recipe);
}

void RecipeOverrideTest::valuesAreJsonOrTexts()
{
    QFETCH(QString, text);
    QFETCH(QString, value);
    json expected = full();
    expected["objects"] = json::parse(value.toStdString());
    QCOMPARE(changed(full(), {parseOverride(text.toStdString())}), expected);
}

void RecipeOverrideTest::placesAreFoundByName_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("patch"); // RFC 6902
    const auto row = [](const char* path, const char* value, const char* patch) {
        QTest::newRow(path) << path << value << patch;
    };
    row("manipulators.press.size_mm.1", "9", R"([{"op": "replace", "path": "/manipulators/0/size_mm/1", "value": 9}])");
    row("fixtures.end.faces", "[7]", R"([{"op": "replace", "path": "/fixtures/0/faces", "value": [7]}])");
    row("fixtures.end.left.box_mm.0", "-1", R"([{"op": "replace", "path": "/fixtures/1/box_mm/0", "value": -1}])");
    row("fixtures.end.left", "null", R"([{"op": "remove", "path": "/fixtures/1"}])");
    row("body_materials.lid.1.preset", "rubber",
        R"([{"op": "replace", "path": "/body_materials/lid.1/preset", "value": "rubber"}])");
    row("body_materials.lid.friction", "1",
        R"([{"op": "replace", "path": "/body_materials/lid", "value": {"preset": "rubber", "friction": 1}}])");
    row("events.0.material.friction", "1",
        R"([{"op": "replace", "path": "/events/0/material", "value": {"preset": "rubber", "friction": 1}}])");
    row("floor.height_mm", "-3", R"([{"op": "add", "path": "/floor", "value": {"height_mm": -3}}])");
    row("material.friction", "null", R"([{"op": "remove", "path": "/material/friction"}])");
    row("time_step_s", "null", "[]");
}

void RecipeOverrideTest::placesAreFoundByName()
{
    QFETCH(QString, path);
    QFETCH(QString, value);
    QFETCH(QString, patch);
    QCOMPARE(changed(full(), {{path.toStdString(), value.toStdString()}}),
             full().patch(json::parse(patch.toStdString())));
}

void RecipeOverrideTest::wrongChangesAreRefusedWithTheirPath_data()
{
    QTest::addColumn<QString>("change");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* change, const char* message) { QTest::newRow(change) << change << message; };
    row("duration_s", R"("duration_s" sets nothing; write PATH=VALUE, for example spacing_mm=3.)");
    row("=3", R"("=3" sets nothing; write PATH=VALUE, for example spacing_mm=3.)");
    row("manipulators.pres.size_mm.0=1",
        "bend.recipe.json: manipulators.pres.size_mm.0 cannot be set: manipulators has no "
        "item \"pres\"; allowed here: the number 0 and the names press.");
    row("manipulators.press.size_mm.3=1",
        "bend.recipe.json: manipulators.press.size_mm.3 cannot be set: "
        "manipulators.press.size_mm has no item \"3\"; allowed here: the numbers 0 to 2.");
    row("duration_s.x=1",
        "bend.recipe.json: duration_s.x cannot be set: duration_s is 2, which has nothing in it to set.");
    row("part..file=a",
        "bend.recipe.json: part..file cannot be set: the path has an empty step; between two dots there must "
        "be a key, a name or a number.");
    row("part.=a", "bend.recipe.json: part. cannot be set: the path ends with a dot; name what is to be set after it.");
    row("part={\"file\"", "the value of part: line 1, column 7: unexpected end of input; expected ':'.");
    row("part={\"file\": 1, \"file\": 2}", "the value of part: the key \"file\" is given twice in the same object.");
    row("part.fil=a",
        "bend.recipe.json with --set: part.fil is not a known key; allowed here: file, files, parts, unit, heal, "
        "cap_flat_openings, deflection_mm, relative_deflection, angular_deflection_rad, fills_open_parts.");
    row("floor.height=1", "bend.recipe.json with --set: floor.height is not a known key; allowed here: height_mm, "
                          "friction, adhesion_pa.");
    row("duration_s=long", "bend.recipe.json with --set: duration_s must be a positive number, got \"long\".");
    row("version=null", "bend.recipe.json with --set: the file must have the key \"version\".");
}

void RecipeOverrideTest::wrongChangesAreRefusedWithTheirPath()
{
    QFETCH(QString, change);
    QFETCH(QString, message);
    QString said = "accepted";
    try {
        parse(full(), {parseOverride(change.toStdString())});
    } catch (const std::runtime_error& error) {
        said = error.what();
    }
    QCOMPARE(said, message);
}

void RecipeOverrideTest::changesReachTheRecipe()
{
    const Recipe recipe = parse(full(), {{"material.youngs_modulus_pa", "2e5"},
                                         {"manipulators.press.size_mm.2", "12"},
                                         {"objects", "null"},
                                         {"spacing_mm", "3"},
                                         {"duration_s", "3"},
                                         {"duration_s", "4"}});
    QCOMPARE(recipe.material.youngsModulus, 2e5);
    QCOMPARE(recipe.material.density, presets[0].material.density);
    QCOMPARE(recipe.manipulators[0].size, Vec3(1e-3, 2e-3, 12e-3));
    QVERIFY(recipe.spacing.kind == SpacingChoice::Kind::Length);
    QVERIFY2(recipe.duration == 4, "the last one counts");
}

QTEST_GUILESS_MAIN(RecipeOverrideTest)
#include "recipe_override_test.moc"
