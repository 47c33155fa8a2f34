#include "core/mechanics/tool_shape.h"
#include "core/model/file_formats.h"
#include "support/recipe_texts.h"

#include <QtTest>

#include <QDir>
#include <QProcess>
#include <QRegularExpression>

#include <algorithm>
#include <set>

using namespace knead;
using namespace knead::recipe_texts;

/// The schema that editors check recipes with says the same as the reader, who is asked.
class RecipeSchemaTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void keysAreThoseOfTheReader_data();
    void keysAreThoseOfTheReader();
    void everyObjectIsCompared();
    void keysAreDocumented();
    void examplesFit();
    void verdictsAreThoseOfTheReader();

private:
    /// Whether documents fit; empty when there is no validator.
    std::vector<bool> verdictsOn(const std::vector<std::string>& documents);

    json m_schema;
    std::string m_readme;
};

namespace {

using Place = json::json_pointer;
using Keys = std::set<std::string>;

/// As sessions are told.
json session()
{
    return json::parse(R"({"version": 1, "part": {"files": ["bar.stl", "bar.stl"], "parts": ["a/b"], "unit": "inch",
        "heal": false, "cap_flat_openings": true, "deflection_mm": 0.1, "relative_deflection": 0.001,
        "angular_deflection_rad": 0.3, "fills_open_parts": true}, "spacing_mm": 3,
        "deform": [{"kind": "bend", "axis": [1, 0, 0], "side": [0, 1, 0], "from_mm": 0, "to_mm": 9, "radius_mm": 20},
                   {"kind": "twist", "axis": [1, 0, 0], "from_mm": 0, "to_mm": 9, "angle_rad": 1},
                   {"kind": "scale", "axis": [1, 0, 0], "from_mm": 0, "to_mm": 9, "factor": 2},
                   {"kind": "shear", "axis": [1, 0, 0], "side": [0, 1, 0], "from_mm": 0, "to_mm": 9, "shift_mm": 2},
                   {"kind": "bend", "body": ["Bar", "lid"], "axis": [1, 0, 0], "side": [0, 1, 0], "from_mm": 0, "to_mm": 9,
                    "angle_deg": 3, "k_factor": 0.4, "separately": true},
                   {"field": "bar.stl", "in_place": true, "kept_faces": [{"body": "Bar", "faces": [1]}], "fade_mm": 5,
                    "separately": true}], "duration_steps": 500,
        "bodies": {"lid": {"angular_velocity_rad_s": [0, 0, 1]}},
        "fixtures": [{"name": "end", "body": "lid", "objects": [3, [7, 9]], "objects_in_body": 20,
                      "velocity_mm_s": [0, 0, 1],
                      "turn": {"center_mm": [0, 0, 0], "angular_velocity_rad_s": [0, 0, 1], "angle_rad": 1}}],
        "manipulators": [{"name": "a", "size_mm": [1, 2, 3], "position_mm": [0, 0, 0], "rotation_wxyz": [1, 0, 0, 0],
                          "motion": {"velocity_mm_s": [0, 0, 1], "angular_velocity_rad_s": [0, 0, 1]}},
                         {"name": "b", "kind": "part", "part_file": "bar.stl", "part_number": 1, "position_mm": [0, 0, 0]}],
        "events": [{"step": 0, "material": "clay", "body": "lid", "objects": [1], "objects_in_body": 20},
                   {"step": 0, "renormalize": {"body": "lid", "objects": [1], "objects_in_body": 20}},
                   {"step": 1, "floor": {"height_mm": -1, "friction": 0.3}}, {"step": 1, "integrator": "implicit-euler"},
                   {"step": 2, "add_fixture": {"name": "grip", "faces": [1]}},
                   {"step": 2, "move_fixture": {"name": "grip", "velocity_mm_s": [1, 0, 0]}},
                   {"step": 2, "move_fixture": {"name": "grip", "turn": {"center_mm": [1, 2, 3], "axis": [0, 0, 1],
                    "speed_deg_s": 90, "angle_deg": 45}}},
                   {"step": 2, "add_load": {"name": "push", "body": "lid", "faces": [1, 2], "force_n": [0, 0, -5],
                    "moment_nm": [0, 1, 0], "pressure_pa": 1e5, "ramp_s": 1}},
                   {"step": 2, "change_load": {"name": "push", "force_n": [0, 0, -5], "moment_nm": [0, 1, 0],
                    "pressure_pa": 1e5, "ramp_s": 1}},
                   {"step": 2, "remove_load": "push"},
                   {"step": 3, "add_manipulator": {"name": "c", "kind": "ball", "size_mm": 3, "position_mm": [0, 0, 0],
                    "motion": {"go_to": {"position_mm": [0, 0, 1], "rotation_wxyz": [0, 1, 0, 0]}}}},
                   {"step": 4, "move_manipulator": {"name": "c", "path": [[0, 1, 2, 3], [2, 1, 2, 4, 0, 1, 0, 0]]}},
                   {"step": 9, "move_manipulator": {"name": "c", "velocity_mm_s": [0, 0, 1],
                    "angular_velocity_rad_s": [0, 1, 0]}},
                   {"step": 9, "move_manipulator": {"name": "c", "hold": true}},
                   {"step": 9, "move_manipulator": {"name": "c", "keyframes": [{"time_s": 0, "position_mm": [0, 0, 0],
                    "rotation_wxyz": [1, 0, 0, 0]}, {"time_s": 1, "rotation_deg": [1, 2, 3]}]}},
                   {"step": 9, "place_manipulator": {"name": "c", "position_mm": [0, 0, 9], "rotation_deg": [0, 0, 9]}},
                   {"step": 9, "reshape_manipulator": {"name": "c", "kind": "cylinder", "size_mm": [3, 4], "friction": 1,
                    "speed_limit_mm_s": 9, "force_limit_n": 9, "rolls_freely": false}},
                   {"step": 9, "keep_moment": ""}, {"step": 9, "reset": true},
                   {"step": 1, "renormalize": {"body": "lid", "objects": [1], "objects_in_body": 22, "filled_anew": true}},
                   {"step": 1, "material": "clay", "body": "lid", "objects": [1], "objects_in_body": 22, "filled_anew": true},
                   {"step": 1, "add_fixture": {"name": "late", "body": "lid", "objects": [1], "objects_in_body": 22,
                    "filled_anew": true}}]})");
}

/// Recipes that together have everything in them.
std::vector<json> fullRecipes()
{
    json recipe = json::parse(R"({"version": 1, "part": {"file": "bar.stl"}, "objects": 500, "duration_s": 2,
        "deform": [{"kind": "bend", "body": "Bar", "origin_mm": [0, 0, 5], "axis": [2, 0, 0], "side": [0, 0, 1], "from_mm": 10,
                    "to_mm": 40, "stays": 0.5, "eases": true, "angle_deg": 30, "neutral_mm": 1},
                   {"field": "bar.stl", "body": "Bar", "step": 2, "name": "U", "unit": "mm", "factor": -1, "kept_faces": [1],
                    "fade_mm": 5, "locked": ["z"]}],
        "extra_parts": [{"file": "bar.stl", "name": "lid", "position_mm": [1, 2, 3], "rotation_deg": [0, 0, 90]}],
        "arrangement": "cut-cells", "material": {"preset": "clay", "friction": 1}, "body_materials": {"lid": "rubber"},
        "regions": [{"name": "hard", "body": "lid", "faces": [0, 3], "material": {"youngs_modulus_pa": 1e6}}],
        "bodies": {"lid": {"kind": "rigid", "velocity_mm_s": [0, 0, 1], "angular_velocity_deg_s": [0, 0, 1]}},
        "touching": "glued", "structural_friction": 1, "gravity_m_s2": [0, 0, -9.8],
        "fixtures": [{"name": "end", "body": "lid", "box_mm": [0, 0, 0, 1, 1, 1], "moment_center_mm": [1, 2, 3]}],
        "loads": [{"name": "wind", "box_mm": [0, 0, 0, 1, 1, 1], "pressure_pa": 100}],
        "probes": [{"name": "tip", "body": "lid", "place_mm": [1, 2, 3]}], "analysis": "dynamic",
        "manipulators": [{"name": "a", "size_mm": [1, 2, 3], "position_mm": [0, 0, 0], "rotation_deg": [1, 2, 3],
                          "friction": 1, "speed_limit_mm_s": 1e9, "force_limit_n": 5,
                          "keyframes": [{"time_s": 1, "position_mm": [1, 2, 3], "rotation_deg": [1, 2, 3]}]},
                         {"name": "b", "kind": "ball", "size_mm": 3, "position_mm": [0, 0, 0]},
                         {"name": "c", "kind": "cylinder", "size_mm": [3, 4], "position_mm": [0, 0, 0], "rolls_freely": true},
                         {"name": "d", "kind": "part", "part_file": "bar.stl", "position_mm": [0, 0, 0]}],
        "floor": {"height_mm": -1, "friction": 1}, "integrator": "automatic", "vicinity": "brute-force", "refilling": true,
        "time_step_s": 1e-4, "mass_scaling_time_step_s": 1e-4,
        "events": [{"time_s": 0, "material": {"preset": "clay"}, "body": "lid", "box_mm": [0, 0, 0, 1, 1, 1]},
                   {"time_s": 0, "remove_fixture": "end"}, {"time_s": 0, "remove_manipulator": "a"},
                   {"time_s": 0, "gravity_m_s2": [0, 0, 0]},
                   {"time_s": 0, "renormalize": {"body": "lid", "box_mm": [0, 0, 0, 1, 1, 1], "duration_s": 1}},
                   {"time_s": 0, "body_kind": {"body": "lid", "kind": "glue"}},
                   {"time_s": 0, "find_balance_s": 0.1}, {"time_s": 0, "refill": {"body": "lid", "spacing_mm": 2}},
                   {"time_s": 0, "cut": {"body": "lid", "point_mm": [1, 2, 3], "normal": [0, 0, 1]}}],
        "exports": [{"file": "a.step", "unit": "mm", "tolerance_mm": 0.1, "ap214": true, "report": false},
                    {"file": "b.PNG", "width": 20, "height": 20, "view": "front", "show_tools": false},
                    {"file": "c/d.png", "view": [0, 1, 0]}]})");
    for (const MaterialField& field : materialFields())
        recipe["material"][field.key] = field.maximum;
    std::vector<json> recipes{recipe, session()};
    for (const char* key : {"spacing_mm", "cells_across", "cells_across_wall"}) {
        recipes.push_back(smallest());
        recipes.back().erase("objects");
        recipes.back()[key] = 3;
    }
    recipes[2]["arrangement"] = "published";
    recipes[3]["analysis"] = "static";
    recipes[3]["load_steps"] = 5;
    return recipes;
}

/// What the reader says is allowed at a place of a recipe, by its refusal of a key that is not.
/// @param place in the first full recipe, or in the second after a "~"
Keys allowedAt(const std::string& where)
{
    const bool isSecond = where.starts_with('~');
    const Place place(where.substr(isSecond ? 1 : 0));
    json recipe = fullRecipes()[isSecond ? 1 : 0];
    recipe[place]["no such key"] = 1;
    QString list = QString::fromStdString(messageFor(recipe)).section("allowed here: ", 1);
    list.chop(1);
    Keys keys;
    for (const QString& key : list.split(", "))
        keys.insert(key.toStdString());
    return keys;
}

Keys keysOf(const json& object)
{
    Keys keys;
    for (const auto& [key, value] : object.items())
        keys.insert(key);
    return keys;
}

/// Objects of the schema that have keys of their own, and where a recipe has one of them.
const std::vector<std::pair<std::string, std::string>>& objects()
{
    static const std::vector<std::pair<std::string, std::string>> all{
        {"", ""},
        {"/properties/part", "/part"},
        {"/properties/floor", "/floor"},
        {"/$defs/materialNumbers", "/material"},
        {"/$defs/deformByNumber", "/deform/0"},
        {"/$defs/deformByField", "/deform/1"},
        {"/$defs/keptFaces", "~/deform/5/kept_faces/0"},
        {"/$defs/extraPart", "/extra_parts/0"},
        {"/$defs/body", "/bodies/lid"},
        {"/$defs/fixture", "/fixtures/0"},
        {"/$defs/materialRegion", "/regions/0"},
        {"/$defs/manipulator", "/manipulators/0"},
        {"/$defs/keyframe", "/manipulators/0/keyframes/0"},
        {"/$defs/turn", "~/fixtures/0/turn"},
        {"/$defs/load", "/loads/0"},
        {"/$defs/probe", "/probes/0"},
        {"/$defs/changeOfLoad", "~/events/8/change_load"},
        {"/$defs/pose", "~/events/10/add_manipulator/motion/go_to"},
        {"/$defs/frame", "~/events/14/move_manipulator/keyframes/1"},
        {"/$defs/motion", "~/manipulators/0/motion"},
        {"/$defs/move", "~/events/11/move_manipulator"},
        {"/$defs/placing", "~/events/15/place_manipulator"},
        {"/$defs/reshaping", "~/events/16/reshape_manipulator"},
        {"/$defs/moveOfFixture", "~/events/5/move_fixture"},
        {"/$defs/changeOfFloor", "~/events/2/floor"},
        {"/$defs/event", "/events/0"},
        {"/$defs/renormalize", "/events/4/renormalize"},
        {"/$defs/changeOfKind", "/events/5/body_kind"},
        {"/$defs/refill", "/events/7/refill"},
        {"/$defs/cut", "/events/8/cut"},
        {"/$defs/exportedFile", "/exports/0"},
        {"/$defs/picture", "/exports/1"},
    };
    return all;
}

/// Every value within a value, itself included.
std::vector<Place> placesIn(const json& value, const Place& place = Place())
{
    std::vector<Place> places{place};
    if (!value.is_structured())
        return places;
    for (const auto& [key, member] : value.items()) {
        const Place at = value.is_array() ? place / static_cast<std::size_t>(std::stoul(key)) : place / key;
        const std::vector<Place> more = placesIn(member, at);
        places.insert(places.end(), more.begin(), more.end());
    }
    return places;
}

/// What a person could write instead of a value, right or wrong.
std::vector<json> otherValues()
{
    std::vector<json> values =
        json::parse(R"([null, true, "", "x", "clay", "box", "part", "rigid", "top", "published", "a.stl",
        "../a.stl", "/a.stl", "a.Png", "a.xyz", -1e7, -1, 0, 1e-10, 0.3, 1, 2.5, 15, 2000, 4e3, 1e6, 2e12, [], {}, [0, 0, 0],
        [1, 2], [1, 2, 3], [1, 2, "3"], [1, 2, 1e7], [0, 0, 0, 1, 1, 1], [-1], [0.5], {"preset": "clay"},
        {"file": "bar.stl"}, {"name": "x", "faces": [1]}])");
    for (const ToolKind kind : toolKinds)
        values.emplace_back(nameOf(kind));
    for (const FileFormat& format : fileFormats)
        for (const std::string& ending : format.endings)
            values.push_back("a." + ending);
    return values;
}

/// The bounds of the numbers of materials, from inside and from outside.
std::vector<std::string> boundsOfMaterials()
{
    std::vector<std::string> recipes;
    for (const MaterialField& field : materialFields())
        for (const double bound : {field.minimum, field.maximum})
            for (const double factor : {1 - 1e-9, 1.0, 1 + 1e-9}) {
                json recipe = smallest();
                recipe["material"][field.key] = bound == 0 ? factor - 1 : bound * factor;
                recipes.push_back(recipe.dump());
            }
    return recipes;
}

/// Of a list of numbers one is enough.
bool isAnotherItem(const json& recipe, const Place& place)
{
    return !place.empty() && recipe.at(place.parent_pointer()).is_array() && recipe.at(place).is_number() &&
           place.back() != "0";
}

/// All recipes that differ from a full one in one place: another value, nothing, or one key more. Texts, since tens of thousands of
/// trees take more time than all that is asked of them.
std::vector<std::string> variantsOf(json recipe)
{
    std::vector<std::string> variants;
    for (const Place& place : placesIn(recipe)) {
        if (isAnotherItem(recipe, place))
            continue;
        const json was = recipe.at(place);
        for (json& value : otherValues()) {
            recipe[place] = std::move(value);
            variants.push_back(recipe.dump());
        }
        recipe[place] = was;
        if (!place.empty() && recipe.at(place.parent_pointer()).is_object()) {
            recipe.at(place.parent_pointer()).erase(place.back());
            variants.push_back(recipe.dump());
            recipe[place] = was;
        }
        for (const char* key : {"no_such_key", "box_mm", "faces", "part_file", "gravity_m_s2"})
            if (was.is_object() && !was.contains(key)) {
                recipe[place][key] = {0, 0, 0, 1, 1, 1};
                variants.push_back(recipe.dump());
                recipe[place].erase(key);
            }
    }
    return variants;
}

/// What no schema can know: which names and files there are, and how values go together.
bool isBeyondSchemas(const std::string& message)
{
    const std::vector<std::string> words{"names a file that does not exist",
                                         "names the unknown material",
                                         "which is not in the recipe",
                                         "is used twice",
                                         "is written twice",
                                         "must hold the lowest x, y, z",
                                         "asks for a speed",
                                         "must be one of mm, ",
                                         "must not be earlier than",
                                         "must not be less than",
                                         "must go on upwards",
                                         "must be larger than from_mm",
                                         "must point across the axis",
                                         "goes around more than ten times",
                                         "must be later than",
                                         "of length 1",
                                         "needs an event with a step"};
    static const QRegularExpression afterTheEnd("events\\[.\\].time_s must be a number between 0 and [0-9.]+, ");
    return afterTheEnd.match(QString::fromStdString(message)).hasMatch() ||
           std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return message.find(word) != std::string::npos; });
}

} // namespace

void RecipeSchemaTest::initTestCase()
{
    m_schema = json::parse(std::ifstream(KNEAD_RESOURCES "/recipe.schema.json"));
    std::ifstream file(KNEAD_RESOURCES "/examples/README.md");
    m_readme = {std::istreambuf_iterator<char>(file), {}};
    for (const json& recipe : fullRecipes())
        QCOMPARE(messageFor(recipe), std::string("accepted"));
}

std::vector<bool> RecipeSchemaTest::verdictsOn(const std::vector<std::string>& documents)
{
    QProcess process;
    process.start("/usr/bin/python3", {KNEAD_TEST_DATA "/../support/validate_json.py"});
    process.write(QByteArray::fromStdString("{\"schema\": " + m_schema.dump() + ", \"documents\": ["));
    for (const std::string& document : documents)
        process.write(QByteArray::fromStdString((&document == documents.data() ? "" : ", ") + document));
    process.write("]}");
    process.closeWriteChannel();
    process.waitForFinished(300'000);
    const json verdicts = json::parse(process.readAllStandardOutput().toStdString(), nullptr, false);
    return verdicts.is_array() ? verdicts.get<std::vector<bool>>() : std::vector<bool>{};
}

void RecipeSchemaTest::keysAreThoseOfTheReader_data()
{
    QTest::addColumn<QString>("place");
    for (const auto& [definition, place] : objects())
        QTest::newRow(definition.c_str()) << QString::fromStdString(place);
}

void RecipeSchemaTest::keysAreThoseOfTheReader()
{
    QFETCH(QString, place);
    const Keys keys = keysOf(m_schema.at(Place(QTest::currentDataTag())).at("properties"));
    QVERIFY2(keys == allowedAt(place.toStdString()), json(allowedAt(place.toStdString())).dump().c_str());
}

void RecipeSchemaTest::everyObjectIsCompared()
{
    std::size_t strict = 0;
    for (const Place& place : placesIn(m_schema))
        strict +=
            m_schema.at(place).is_object() && m_schema.at(place).value("additionalProperties", json(true)) == false ? 1
                                                                                                                    : 0;
    QCOMPARE(strict, objects().size());
}

void RecipeSchemaTest::keysAreDocumented()
{
    for (const auto& [definition, place] : objects())
        for (const std::string& key : keysOf(m_schema.at(Place(definition)).at("properties")))
            QVERIFY2(m_readme.find("`" + key + "`") != std::string::npos ||
                         m_readme.find("\"" + key + "\"") != std::string::npos,
                     key.c_str());
    for (const ToolKind kind : toolKinds)
        QVERIFY(m_readme.find("\"" + std::string(nameOf(kind)) + "\"") != std::string::npos);
    for (const FileFormat& format : fileFormats)
        for (const std::string& ending : format.endings)
            QVERIFY2(m_readme.find("." + ending) != std::string::npos, ending.c_str());
}

void RecipeSchemaTest::examplesFit()
{
    const QDir folder(KNEAD_RESOURCES "/examples");
    std::vector<std::string> examples;
    for (const json& recipe : fullRecipes())
        examples.push_back(recipe.dump());
    for (const QString& name : folder.entryList({"*.recipe.json"}))
        examples.push_back(json::parse(std::ifstream(folder.filePath(name).toStdString())).dump());
    QVERIFY(examples.size() > 8);
    const std::vector<bool> verdicts = verdictsOn(examples);
    if (verdicts.empty())
        QSKIP("There is no validator: install python3-jsonschema.");
    QCOMPARE(verdicts, std::vector<bool>(examples.size(), true));
}

void RecipeSchemaTest::verdictsAreThoseOfTheReader()
{
    std::vector<std::string> variants = boundsOfMaterials();
    for (const json& recipe : fullRecipes()) {
        const std::vector<std::string> more = variantsOf(recipe);
        variants.insert(variants.end(), more.begin(), more.end());
    }
    const std::vector<bool> verdicts = verdictsOn(variants);
    if (verdicts.empty())
        QSKIP("There is no validator: install python3-jsonschema.");
    QCOMPARE(verdicts.size(), variants.size());
    std::size_t good = 0;
    int different = 0;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        const std::string message = messageForText(variants[i]);
        const bool isGood = message == "accepted";
        good += isGood ? 1 : 0;
        if (verdicts[i] != isGood && !isBeyondSchemas(message))
            qWarning("%s %s", message.c_str(),
                     json::diff(fullRecipes()[0], json::parse(variants[i])).dump().substr(0, 300).c_str());
        different += verdicts[i] != isGood && !isBeyondSchemas(message) ? 1 : 0;
    }
    QCOMPARE(different, 0);
    QVERIFY(good > 500 && good < variants.size() / 2);
}

QTEST_GUILESS_MAIN(RecipeSchemaTest)
#include "recipe_schema_test.moc"
