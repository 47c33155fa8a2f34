#include "io/recipe.h"

#include <nlohmann/json.hpp>

#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <fstream>
#include <stdexcept>

using namespace knead;
using nlohmann::json;

namespace {

const std::vector<MaterialPreset> presets{{"clay", "Clay", "a pit", {1700, 5e5, 0.45, 0.2, 20, 0.5}},
                                          {"rubber", "Rubber", "a tree", {950, 1e6, 0.49, 0.05, 2, 0.8}}};

/// The smallest recipe; tests add to it.
json smallest()
{
    return json::parse(R"({"version": 1, "part": {"file": "bar.stl"}, "objects": 500, "duration_s": 2})");
}

json withManipulator(const std::string& manipulator)
{
    json recipe = smallest();
    recipe["manipulators"] = json::array({json::parse(manipulator)});
    return recipe;
}

json with(const std::string& key, const std::string& value)
{
    json recipe = smallest();
    recipe[key] = json::parse(value);
    return recipe;
}

/// Reads a recipe that lies beside a part.
Recipe readText(const std::string& text)
{
    const QTemporaryDir folder;
    const std::string path = folder.filePath("bend.recipe.json").toStdString();
    std::ofstream(folder.filePath("bar.stl").toStdString()) << "solid";
    std::ofstream(path) << text;
    return readRecipe(path, presets);
}

Recipe parse(const json& recipe)
{
    return readText(recipe.dump());
}

std::string messageForText(const std::string& text)
{
    try {
        readText(text);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "accepted";
}

std::string messageFor(const json& recipe)
{
    return messageForText(recipe.dump());
}

bool isNear(const Vec3& a, const Vec3& b)
{
    return (a - b).norm() < 1e-12;
}

} // namespace

class RecipeTest : public QObject {
    Q_OBJECT

private slots:
    void smallestRecipeHasDefaults();
    void lengthsBecomeMeters();
    void partIsFoundBesideTheRecipe();
    void materialNumbersReplaceThoseOfThePreset();
    void bodyMaterialsStartFromTheCommonOne();
    void rotationsTurnAboutFixedAxesXThenYThenZ();
    void keyFramesStartAtThePositionAndKeepWhatTheyDoNotSay();
    void fixturesHoldFacesOrBoxes();
    void eventsAreReadInOrder();
    void picturesHaveSizeAndView();
    void wrongRecipesAreRefusedWithTheirPlace_data();
    void wrongRecipesAreRefusedWithTheirPlace();
    void syntaxErrorsNameLineAndColumn();
    void keyGivenTwiceIsRefused();
    void hostileNestingIsRefused();
    void missingFilesAreNamed();
    void everyTruncationIsRefused();
};

void RecipeTest::smallestRecipeHasDefaults()
{
    const Recipe recipe = parse(smallest());
    QCOMPARE(recipe.material, Material{});
    QVERIFY(recipe.resolution.kind == RecipeResolution::Kind::Objects);
    QCOMPARE(recipe.resolution.value, 500.0);
    QCOMPARE(recipe.duration, 2.0);
    QVERIFY(recipe.gravity.isZero());
    QVERIFY(!recipe.floor);
    QVERIFY(recipe.manipulators.empty() && recipe.fixtures.empty() && recipe.events.empty() && recipe.exports.empty());
}

void RecipeTest::lengthsBecomeMeters()
{
    json recipe = withManipulator(R"({"name": "press", "size_mm": [10, 20, 30], "position_mm": [0, 0, 50],
                                      "speed_limit_mm_s": 200})");
    recipe.erase("objects");
    recipe["spacing_mm"] = 2.5;
    recipe["floor"] = {{"height_mm", -4}, {"friction", 0.6}};
    recipe["gravity_m_s2"] = {0, 0, -9.81};
    const Recipe read = parse(recipe);
    QCOMPARE(read.resolution.value, 0.0025);
    QVERIFY(isNear(read.manipulators[0].size, Vec3(0.01, 0.02, 0.03)));
    QVERIFY(isNear(read.manipulators[0].pose.position, Vec3(0, 0, 0.05)));
    QVERIFY(std::abs(read.manipulators[0].speedLimit - 0.2) < 1e-15);
    QCOMPARE(read.floor->height, -0.004);
    QCOMPARE(read.floor->friction, 0.6);
    QVERIFY(isNear(read.gravity, Vec3(0, 0, -9.81)));
}

void RecipeTest::partIsFoundBesideTheRecipe()
{
    const Recipe recipe = parse(smallest());
    QCOMPARE(recipe.part, QFileInfo(QString::fromStdString(recipe.file)).path().toStdString() + "/bar.stl");
}

void RecipeTest::materialNumbersReplaceThoseOfThePreset()
{
    QCOMPARE(parse(with("material", R"("rubber")")).material, presets[1].material);

    Material expected = presets[0].material;
    expected.youngsModulus = 7e5;
    QCOMPARE(parse(with("material", R"({"preset": "clay", "youngs_modulus_pa": 7e5})")).material, expected);

    expected = Material{};
    expected.friction = 0.1;
    QCOMPARE(parse(with("material", R"({"friction": 0.1})")).material, expected);
}

void RecipeTest::bodyMaterialsStartFromTheCommonOne()
{
    json recipe = with("material", R"("clay")");
    recipe["body_materials"] = json::parse(R"({"lid": {"density_kg_m3": 2000}, "box": "rubber"})");
    const Recipe read = parse(recipe);
    QCOMPARE(read.bodyMaterials.size(), std::size_t(2));
    for (const auto& [name, material] : read.bodyMaterials) {
        Material expected = name == "box" ? presets[1].material : presets[0].material;
        if (name == "lid")
            expected.density = 2000;
        QCOMPARE(material, expected);
    }
}

void RecipeTest::rotationsTurnAboutFixedAxesXThenYThenZ()
{
    const Recipe recipe = parse(withManipulator(
        R"({"name": "a", "size_mm": [1, 1, 1], "position_mm": [0, 0, 0], "rotation_deg": [90, 0, 90]})"));
    // y goes to z about x and stays there about z; x goes to y about z.
    const Quaternion& rotation = recipe.manipulators[0].pose.rotation;
    QVERIFY(isNear(rotation * Vec3::UnitY(), Vec3::UnitZ()));
    QVERIFY(isNear(rotation * Vec3::UnitX(), Vec3::UnitY()));
}

void RecipeTest::keyFramesStartAtThePositionAndKeepWhatTheyDoNotSay()
{
    const Recipe recipe = parse(withManipulator(R"({"name": "a", "size_mm": [1, 1, 1], "position_mm": [0, 0, 10],
        "keyframes": [{"time_s": 0.5, "position_mm": [0, 0, 4]}, {"time_s": 1, "rotation_deg": [0, 90, 0]}]})"));
    const auto& frames = std::get<FollowKeyFrames>(recipe.manipulators[0].motion).frames;
    QCOMPARE(frames.size(), std::size_t(3));
    QCOMPARE(frames[0].time, 0.0);
    QVERIFY(isNear(frames[0].pose.position, Vec3(0, 0, 0.01)));
    QVERIFY(isNear(frames[1].pose.position, Vec3(0, 0, 0.004)));
    QVERIFY(isNear(frames[2].pose.position, Vec3(0, 0, 0.004)));
    QVERIFY(isNear(frames[2].pose.rotation * Vec3::UnitZ(), Vec3::UnitX()));
}

void RecipeTest::fixturesHoldFacesOrBoxes()
{
    const Recipe recipe = parse(with("fixtures", R"([{"name": "left", "faces": [3, 0]},
        {"name": "right", "body": "bar", "box_mm": [-1, -2, -3, 4, 5, 6]}])"));
    QCOMPARE(recipe.fixtures[0].faces, (std::vector<std::uint32_t>{3, 0}));
    QVERIFY(!recipe.fixtures[0].box);
    QCOMPARE(recipe.fixtures[1].body, std::string("bar"));
    QVERIFY(isNear(recipe.fixtures[1].box->min(), Vec3(-1, -2, -3) / 1000));
    QVERIFY(isNear(recipe.fixtures[1].box->max(), Vec3(4, 5, 6) / 1000));
}

void RecipeTest::eventsAreReadInOrder()
{
    json recipe = with("fixtures", R"([{"name": "left", "faces": [3]}])");
    recipe["events"] = json::parse(R"([{"time_s": 0.5, "remove_fixture": "left"},
        {"time_s": 0.5, "material": {"youngs_modulus_pa": 1e5}, "body": "bar"},
        {"time_s": 1.5, "gravity_m_s2": [0, 0, -1]}])");
    const Recipe read = parse(recipe);
    QCOMPARE(read.events.size(), std::size_t(3));
    QCOMPARE(std::get<ReleaseFixture>(read.events[0].action).fixture, std::string("left"));
    const auto& change = std::get<ChangeMaterial>(read.events[1].action);
    QCOMPARE(change.body, std::string("bar"));
    Material expected = presets[0].material;
    expected.youngsModulus = 1e5;
    QCOMPARE(change.material.on(presets[0].material), expected);
    QVERIFY(isNear(std::get<ChangeGravity>(read.events[2].action).gravity, -Vec3::UnitZ()));
}

void RecipeTest::picturesHaveSizeAndView()
{
    const Recipe recipe =
        parse(with("exports", R"([{"file": "a.stl"}, {"file": "sub/b.PNG", "width": 640, "height": 480,
        "view": "top"}, {"file": "c.png", "view": [1, 2, -1], "show_tools": false}])"));
    QVERIFY(!recipe.exports[0].isPicture());
    QVERIFY(recipe.exports[1].showTools);
    QVERIFY(!recipe.exports[2].showTools);
    QVERIFY(recipe.exports[1].isPicture());
    QCOMPARE(recipe.exports[1].width, 640);
    QCOMPARE(recipe.exports[1].height, 480);
    QVERIFY(isNear(*recipe.exports[1].viewDirection, -Vec3::UnitZ()));
    QVERIFY(isNear(recipe.exports[1].up, Vec3::UnitY()));
    QVERIFY(isNear(*recipe.exports[2].viewDirection, Vec3(1, 2, -1)));
}

void RecipeTest::wrongRecipesAreRefusedWithTheirPlace_data()
{
    QTest::addColumn<QString>("recipe");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const json& recipe, const char* message) {
        QTest::newRow(name) << QString::fromStdString(recipe.dump()) << QString("bend.recipe.json: ") + message;
    };

    row("negative size", withManipulator(R"({"name": "a", "size_mm": [10, -2, 10], "position_mm": [0, 0, 0]})"),
        "manipulators[0].size_mm must hold 3 positive numbers, got [10, -2, 10].");
    row("two numbers for three", withManipulator(R"({"name": "a", "size_mm": [10, 2], "position_mm": [0, 0, 0]})"),
        "manipulators[0].size_mm must hold 3 numbers, got [10, 2].");
    row("text in numbers", withManipulator(R"({"name": "a", "size_mm": [1, "2", 3], "position_mm": [0, 0, 0]})"),
        "manipulators[0].size_mm must hold 3 numbers, got [1, \"2\", 3].");
    row("no position", withManipulator(R"({"name": "a", "size_mm": [1, 2, 3]})"),
        "manipulators[0] must have the key \"position_mm\".");
    row("unknown key", withManipulator(R"({"name": "a", "size": [1, 2, 3]})"),
        "manipulators[0].size is not a known key; allowed here: name, size_mm, position_mm, rotation_deg, friction, "
        "speed_limit_mm_s, force_limit_n, keyframes.");
    row("friction", withManipulator(R"({"name": "a", "size_mm": [1, 2, 3], "position_mm": [0, 0, 0], "friction": 5})"),
        "manipulators[0].friction must be a number between 0 and 2, got 5.");
    row("frames backwards", withManipulator(R"({"name": "a", "size_mm": [1, 2, 3], "position_mm": [0, 0, 0],
        "keyframes": [{"time_s": 1}, {"time_s": 0.5}]})"),
        "manipulators[0].keyframes[1].time_s must be later than the frame before it, got 0.5.");
    row("too fast", withManipulator(R"({"name": "a", "size_mm": [1, 2, 3], "position_mm": [0, 0, 0],
        "speed_limit_mm_s": 100, "keyframes": [{"time_s": 0.1, "position_mm": [0, 0, 40]}]})"),
        "manipulators[0].keyframes[0] asks for a speed of 400 mm/s; speed_limit_mm_s allows 100.");
    row("manipulators no list", with("manipulators", R"({"name": "a"})"),
        "manipulators must be a list in [ ], got {\"name\": \"a\"}.");

    row("other version", with("version", "2"), "version must be a whole number between 1 and 1, got 2.");
    row("two resolutions", with("spacing_mm", "2"),
        "the file must have exactly one of the keys spacing_mm, cells_across and objects.");
    row("no duration", with("duration_s", "0"), "duration_s must be a positive number, got 0.");
    row("endless", with("duration_s", "1e9"), "duration_s must be at most 3600 s, got 1e+09.");
    row("duration text", with("duration_s", R"("2 s")"), "duration_s must be a positive number, got \"2 s\".");
    row("unknown material", with("material", R"("jam")"),
        "material names the unknown material \"jam\"; known are: clay, rubber.");
    row("too stiff", with("material", R"({"youngs_modulus_pa": 1e20})"),
        "material.youngs_modulus_pa must be a number between 100 and 1e+12, got 1e+20.");
    row("material key", with("material", R"({"youngs_modulus": 1e6})"),
        "material.youngs_modulus is not a known key; allowed here: preset, density_kg_m3, youngs_modulus_pa, "
        "poisson_ratio, damping_ratio, shape_damping_per_s, friction.");
    row("gravity", with("gravity_m_s2", "9.81"), "gravity_m_s2 must hold 3 numbers, got 9.81.");
    row("floor", with("floor", "{}"), "floor must have the key \"height_mm\".");

    row("faces and box", with("fixtures", R"([{"name": "a", "faces": [1], "box_mm": [0, 0, 0, 1, 1, 1]}])"),
        "fixtures[0] must have either faces or box_mm.");
    row("no faces", with("fixtures", R"([{"name": "a", "faces": []}])"),
        "fixtures[0].faces must hold at least one face.");
    row("half a face", with("fixtures", R"([{"name": "a", "faces": [1.5]}])"),
        "fixtures[0].faces[0] must be a whole number between 0 and 2147483647, got 1.5.");
    row("box inside out", with("fixtures", R"([{"name": "a", "box_mm": [0, 0, 0, 1, -1, 1]}])"),
        "fixtures[0].box_mm must hold the lowest x, y, z and then the highest x, y, z, got [0, 0, 0, 1, -1, 1].");
    row("name twice", with("fixtures", R"([{"name": "a", "faces": [1]}, {"name": "a", "faces": [2]}])"),
        "fixtures[1].name is used twice: \"a\".");

    row("event after the end", with("events", R"([{"time_s": 3, "gravity_m_s2": [0, 0, 0]}])"),
        "events[0].time_s must be a number between 0 and 2, got 3.");
    row("event of nothing", with("events", R"([{"time_s": 1}])"),
        "events[0] must have exactly one of the keys material, remove_fixture, remove_manipulator and gravity_m_s2.");
    row("event of nobody", with("events", R"([{"time_s": 1, "remove_fixture": "left"}])"),
        "events[0].remove_fixture names \"left\", which is not in the recipe.");

    row("out of the folder", with("exports", R"([{"file": "../a.stl"}])"),
        "exports[0].file must be a path inside the output folder, got \"../a.stl\".");
    row("absolute", with("exports", R"([{"file": "/tmp/a.stl"}])"),
        "exports[0].file must be a path inside the output folder, got \"/tmp/a.stl\".");
    row("written twice", with("exports", R"([{"file": "a.stl"}, {"file": "a.stl"}])"),
        "exports[1].file is written twice: \"a.stl\".");
    row("mesh with a width", with("exports", R"([{"file": "a.stl", "width": 10}])"),
        "exports[0].width is not a known key; allowed here: file.");
    row("view", with("exports", R"([{"file": "a.png", "view": "inside"}])"),
        "exports[0].view must be one of back, bottom, front, isometric, left, right, top or a direction of 3 numbers, "
        "got \"inside\".");
    row("null view", with("exports", R"([{"file": "a.png", "view": [0, 0, 0]}])"),
        "exports[0].view must be a direction of 3 numbers that are not all 0, got [0, 0, 0].");
    row("a list", json::array(), "the file must be an object in { }, got [].");
}

void RecipeTest::wrongRecipesAreRefusedWithTheirPlace()
{
    QFETCH(QString, recipe);
    QFETCH(QString, message);
    QCOMPARE(QString::fromStdString(messageForText(recipe.toStdString())), message);
}

void RecipeTest::syntaxErrorsNameLineAndColumn()
{
    const std::string message = messageForText("{\n  \"version\": 1,\n  \"objects\" 5\n}");
    QVERIFY2(message.starts_with("bend.recipe.json: line 3, column 13: unexpected number literal; expected ':'"),
             message.c_str());
}

void RecipeTest::keyGivenTwiceIsRefused()
{
    QCOMPARE(messageForText(R"({"version": 1, "objects": 5, "objects": 6})"),
             std::string("bend.recipe.json: the key \"objects\" is given twice in the same object."));
}

void RecipeTest::hostileNestingIsRefused()
{
    QCOMPARE(messageForText(std::string(1'000'000, '[')),
             std::string("bend.recipe.json: lists and objects are nested more than 100 deep."));
}

void RecipeTest::missingFilesAreNamed()
{
    QVERIFY_EXCEPTION_THROWN(readRecipe("/nowhere/bend.recipe.json", presets), std::runtime_error);
    const std::string message = messageFor(with("part", R"({"file": "missing.step"})"));
    QVERIFY2(message.starts_with("bend.recipe.json: part.file names a file that does not exist: "), message.c_str());
    QVERIFY2(message.find("/missing.step") != std::string::npos, message.c_str());
}

void RecipeTest::everyTruncationIsRefused()
{
    const std::string text = with("exports", R"([{"file": "c.png", "view": [1, 2, -1]}])").dump();
    for (std::size_t length = 0; length < text.size(); ++length)
        QVERIFY2(messageForText(text.substr(0, length)) != "accepted", text.substr(0, length).c_str());
    QCOMPARE(messageForText(text), std::string("accepted"));
}

QTEST_GUILESS_MAIN(RecipeTest)
#include "recipe_test.moc"
