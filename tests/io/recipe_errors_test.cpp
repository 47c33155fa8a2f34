#include "core/model/length_units.h"
#include "support/recipe_texts.h"

#include <QtTest>

using namespace knead;
using namespace knead::recipe_texts;

class RecipeErrorsTest : public QObject {
    Q_OBJECT

private slots:
    void wrongRecipesAreRefusedWithTheirPlace_data();
    void wrongRecipesAreRefusedWithTheirPlace();
    void syntaxErrorsNameLineAndColumn();
    void mistakesNameTheirLine();
    void keyGivenTwiceIsRefused();
    void hostileNestingIsRefused();
    void missingFilesAreNamed();
    void everyTruncationIsRefused();
};

void RecipeErrorsTest::wrongRecipesAreRefusedWithTheirPlace_data()
{
    QTest::addColumn<QString>("recipe");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const json& recipe, const char* message) {
        const QString line = QString(message).startsWith("the file ") ? "" : ", line 1";
        QTest::newRow(name) << QString::fromStdString(recipe.dump()) << "bend.recipe.json" + line + ": " + message;
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
        "manipulators[0].size is not a known key; allowed here: name, kind, size_mm, part_file, part_number, "
        "friction, speed_limit_mm_s, force_limit_n, adhesion_pa, rolls_freely, position_mm, rotation_deg, "
        "rotation_wxyz, keyframes, motion.");
    row("block that rolls",
        withManipulator(R"({"name": "a", "size_mm": [1, 2, 3], "position_mm": [0, 0, 0], "rolls_freely": true})"),
        "manipulators[0].rolls_freely must be false where the tool is neither a ball nor a cylinder, got true.");
    row("unknown kind", withManipulator(R"({"name": "a", "kind": "cone"})"),
        "manipulators[0].kind must be one of box, ball, cylinder, wedge, plate, part, got \"cone\".");
    row("ball with edges", withManipulator(R"({"name": "a", "kind": "ball", "size_mm": [1, 2, 3]})"),
        "manipulators[0].size_mm must be a positive number, got [1, 2, 3].");
    row("cylinder with edges", withManipulator(R"({"name": "a", "kind": "cylinder", "size_mm": [1, 2, 3]})"),
        "manipulators[0].size_mm must hold 2 numbers, got [1, 2, 3].");
    row("flat cylinder", withManipulator(R"({"name": "a", "kind": "cylinder", "size_mm": [1, 0]})"),
        "manipulators[0].size_mm must hold 2 positive numbers, got [1, 0].");
    row("part with a size", withManipulator(R"({"name": "a", "kind": "part", "size_mm": [1, 2, 3]})"),
        "manipulators[0].size_mm does not belong to the kind part; its file says how large it is.");
    row("part without a file", withManipulator(R"({"name": "a", "kind": "part"})"),
        "manipulators[0] must have the key \"part_file\".");
    row("box from a file", withManipulator(R"({"name": "a", "size_mm": [1, 2, 3], "part_file": "bar.stl"})"),
        "manipulators[0].part_file belongs to manipulators of the kind part only.");
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
        "the file must have exactly one of the keys spacing_mm, cells_across, cells_across_wall and objects.");
    row("no duration", with("duration_s", "0"), "duration_s must be a positive number, got 0.");
    row("endless", with("duration_s", "1e9"), "duration_s must be at most 3600 s, got 1e+09.");
    row("duration text", with("duration_s", R"("2 s")"), "duration_s must be a positive number, got \"2 s\".");
    row("unknown material", with("material", R"("jam")"),
        "material names the unknown material \"jam\"; known are: clay, rubber.");
    row("too stiff", with("material", R"({"youngs_modulus_pa": 1e20})"),
        "material.youngs_modulus_pa must be a number between 100 and 1e+12, got 1e+20.");
    row("material key", with("material", R"({"youngs_modulus": 1e6})"),
        "material.youngs_modulus is not a known key; allowed here: preset, density_kg_m3, youngs_modulus_pa, "
        "poisson_ratio, damping_ratio, shape_damping_per_s, friction, rubberlike, second_invariant_share, "
        "locking_elongation, yield_stress_pa, hardening_pa, "
        "relaxation_time_s, "
        "tensile_strength_pa, elongation_at_break, toughness_j_m2, adhesion_pa, healing_time_s.");
    row("gravity", with("gravity_m_s2", "9.81"), "gravity_m_s2 must hold 3 numbers, got 9.81.");
    row("floor", with("floor", "{}"), "floor must have the key \"height_mm\".");

    row("faces and box", with("fixtures", R"([{"name": "a", "faces": [1], "box_mm": [0, 0, 0, 1, 1, 1]}])"),
        "fixtures[0] must have exactly one of the keys faces, box_mm and objects.");
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
    row("plane without a direction",
        with("events", R"([{"time_s": 1, "cut": {"point_mm": [0, 0, 0], "normal": [0, 0, 0]}}])"),
        "events[0].cut.normal must not be 0: it says which way the plane faces.");
    row("event of nothing", with("events", R"([{"time_s": 1}])"),
        "events[0] must have exactly one of the keys material, remove_fixture, remove_manipulator, gravity_m_s2, "
        "renormalize, body_kind, floor, integrator, pace, add_fixture, move_fixture, add_manipulator, "
        "move_manipulator, "
        "place_manipulator, reshape_manipulator, add_load, change_load, remove_load, find_balance_s, refill, cut, "
        "deform_by_physics, reset, "
        "keep_moment.");
    row("two events in one", with("events", R"([{"time_s": 1, "renormalize": {}, "gravity_m_s2": [0, 0, 0]}])"),
        "events[0] must have only one of the keys gravity_m_s2 and renormalize.");
    row("box of gravity", with("events", R"([{"time_s": 1, "gravity_m_s2": [0, 0, 0], "box_mm": [0, 0, 0, 1, 1, 1]}])"),
        "events[0].box_mm belongs to a change of material only.");
    row("annealing backwards", with("events", R"([{"time_s": 1, "renormalize": {"duration_s": -1}}])"),
        "events[0].renormalize.duration_s must be a number between 0 and 3600, got -1.");
    row("kind of no body", with("events", R"([{"time_s": 1, "body_kind": {"kind": "rigid"}}])"),
        "events[0].body_kind must have the key \"body\".");
    row("unknown kind of body", with("bodies", R"({"lid": {"kind": "stiff"}})"),
        "bodies.lid.kind must be one of deformable, rigid, glue, got \"stiff\".");
    row("speed of light", with("bodies", R"({"lid": {"velocity_mm_s": [0, 0, 3e11]}})"),
        "bodies.lid.velocity_mm_s must hold 3 numbers no larger than 100000, got [0, 0, 3e+11].");
    row("bodies as a list", with("bodies", R"([{"kind": "rigid"}])"),
        "bodies must be an object in { }, got [{\"kind\": \"rigid\"}].");
    row("integrator", with("integrator", R"("euler")"),
        "integrator must be one of semi-implicit-euler, forward-euler, implicit-euler, automatic, got \"euler\".");
    row("vicinity", with("vicinity", "1"),
        "vicinity must be one of uniform-grid, half-partition, median-partition, brute-force, got 1.");
    row("time step", with("time_step_s", "0"), "time_step_s must be a number between 1e-09 and 1, got 0.");
    row("mass scaling", with("mass_scaling_time_step_s", "2"),
        "mass_scaling_time_step_s must be a number between 1e-09 and 1, got 2.");
    row("published without a spacing", with("arrangement", R"("published")"),
        "arrangement is \"published\", which needs spacing_mm.");
    row("structural friction", with("structural_friction", "3"),
        "structural_friction must be a number between 0 and 2, got 3.");
    row("region without material", with("regions", R"([{"name": "a", "box_mm": [0, 0, 0, 1, 1, 1]}])"),
        "regions[0] must have the key \"material\".");
    row("region twice", with("regions", R"([{"name": "a", "faces": [1], "material": "clay"},
        {"name": "a", "faces": [2], "material": "clay"}])"),
        "regions[1].name is used twice: \"a\".");
    row("extra part", with("extra_parts", R"([{"position_mm": [0, 0, 1]}])"),
        "extra_parts[0] must have the key \"file\".");
    row("event of nobody", with("events", R"([{"time_s": 1, "remove_fixture": "left"}])"),
        "events[0].remove_fixture names \"left\", which is not in the recipe.");

    row("out of the folder", with("exports", R"([{"file": "../a.stl"}])"),
        "exports[0].file must be a path inside the output folder, got \"../a.stl\".");
    row("absolute", with("exports", R"([{"file": "/tmp/a.stl"}])"),
        "exports[0].file must be a path inside the output folder, got \"/tmp/a.stl\".");
    row("written twice", with("exports", R"([{"file": "a.stl"}, {"file": "a.stl"}])"),
        "exports[1].file is written twice: \"a.stl\".");
    row("mesh with a width", with("exports", R"([{"file": "a.stl", "width": 10}])"),
        "exports[0].width is not a known key; allowed here: file, unit, tolerance_mm, ap214, text, report.");
    row("view", with("exports", R"([{"file": "a.png", "view": "inside"}])"),
        "exports[0].view must be one of back, bottom, front, isometric, left, right, top or a direction of 3 numbers, "
        "got \"inside\".");
    row("null view", with("exports", R"([{"file": "a.png", "view": [0, 0, 0]}])"),
        "exports[0].view must be a direction of 3 numbers that are not all 0, got [0, 0, 0].");
    const auto withEvent = [](const char* event) {
        json recipe = smallest();
        recipe["events"] = json::array({json::parse(event)});
        return recipe;
    };
    row("when", withEvent(R"({"reset": true})"), "events[0] must have either time_s or step.");
    row("both", withEvent(R"({"step": 1, "time_s": 1, "reset": true})"), "events[0] must have either time_s or step.");
    row("half a step", withEvent(R"({"step": 1.5, "reset": true})"),
        "events[0].step must be a whole number between 0 and 1099511627776, got 1.5.");
    row("no reset", withEvent(R"({"step": 1, "reset": false})"), "events[0].reset must be true.");
    row("moved nothing", withEvent(R"({"step": 1, "move_manipulator": {"name": "a", "hold": true}})"),
        "events[0].move_manipulator.name names \"a\", which is not in the recipe.");
    row("not moved", withEvent(R"({"step": 1, "move_manipulator": {"name": "a"}})"),
        "events[0].move_manipulator must have exactly one of the keys hold, velocity_mm_s, go_to, keyframes.");
    row("moved twice", withEvent(R"({"step": 1, "move_manipulator": {"name": "a", "hold": true, "path": []}})"),
        "events[0].move_manipulator must have only one of the keys path and hold.");
    row("path in time", withEvent(R"({"time_s": 1, "move_manipulator": {"name": "a", "path": [[0, 1, 2, 3]]}})"),
        "events[0].move_manipulator.path needs an event with a step; say keyframes for times.");
    row("short row", withEvent(R"({"step": 1, "move_manipulator": {"name": "a", "path": [[0, 1, 2]]}})"),
        "events[0].move_manipulator.path[0] must hold a step and x, y, z, perhaps with w, x, y, z of a rotation, "
        "got [0, 1, 2].");
    row("path backwards", withEvent(R"({"step": 1, "move_manipulator": {"name": "a",
        "path": [[3, 1, 2, 3], [2, 1, 2, 3]]}})"),
        "events[0].move_manipulator.path[1][0] must not be less than in the row before it, got 2.");
    row("no rotation", withEvent(R"({"step": 1, "place_manipulator": {"name": "a", "position_mm": [0, 0, 0],
        "rotation_wxyz": [1, 1, 0, 0]}})"),
        "events[0].place_manipulator.rotation_wxyz must hold w, x, y, z of a quaternion of length 1, got [1, 1, 0, "
        "0].");
    row("two rotations", withEvent(R"({"step": 1, "place_manipulator": {"name": "a", "position_mm": [0, 0, 0],
        "rotation_wxyz": [1, 0, 0, 0], "rotation_deg": [0, 0, 0]}})"),
        "events[0].place_manipulator must have only one of the keys rotation_deg and rotation_wxyz.");
    row("steps backwards", with("events", R"([{"step": 5, "keep_moment": ""}, {"step": 4, "keep_moment": ""}])"),
        "events[1].step must not be less than that of the event before it, got 4.");
    row("objects without their number", with("fixtures", R"([{"name": "a", "objects": [1]}])"),
        "fixtures[0] must have both of the keys objects and objects_in_body, or none.");
    row("objects backwards", with("fixtures", R"([{"name": "a", "objects": [[7, 9], 8], "objects_in_body": 20}])"),
        "fixtures[0].objects[1] must go on upwards, below objects_in_body, got 8.");
    row("objects of later", with("fixtures", R"([{"name": "a", "objects": [8], "objects_in_body": 20,
        "filled_anew": true}])"),
        "fixtures[0].filled_anew belongs to events: at the start nothing has been filled anew.");
    row("a later filling of nothing", withEvent(R"({"step": 1, "renormalize": {"body": "a", "filled_anew": true}})"),
        "events[0].renormalize.filled_anew belongs to objects.");
    row("added twice", with("events", R"([{"step": 1, "add_fixture": {"name": "a", "faces": [1]}},
        {"step": 1, "add_fixture": {"name": "a", "faces": [1]}}])"),
        "events[1].add_fixture.name is used twice: \"a\".");
    row("two durations", with("duration_steps", "9"),
        "the file must have only one of the keys duration_s and duration_steps.");
    row("file and files", with("part", R"({"file": "bar.stl", "files": ["bar.stl"]})"),
        "part must have either file or files.");
    row("unknown unit", with("part", R"({"file": "bar.stl", "unit": "parsec"})"),
        QString::fromStdString("part.unit must be one of " + lengthUnitNames() + ", got \"parsec\".").toUtf8());

    row("a list", json::array(), "the file must be an object in { }, got [].");
}

void RecipeErrorsTest::wrongRecipesAreRefusedWithTheirPlace()
{
    QFETCH(QString, recipe);
    QFETCH(QString, message);
    QCOMPARE(QString::fromStdString(messageForText(recipe.toStdString())), message);
}

void RecipeErrorsTest::syntaxErrorsNameLineAndColumn()
{
    const std::string message = messageForText("{\n  \"version\": 1,\n  \"objects\" 5\n}");
    QVERIFY2(message.starts_with("bend.recipe.json: line 3, column 13: unexpected number literal; expected ':'"),
             message.c_str());
}

void RecipeErrorsTest::mistakesNameTheirLine()
{
    const std::string text =
        "{\n\"version\": 1,\n\n\"part\": {\n  \"file\": \"bar.stl\"},\n\"objects\": 500,\n\"duration_s\": 2,\n"
        "\"gravity_m_s2\": [0, 0\n], \"events\": [\n{\"time_s\": 3\n, \"renormalize\":\n{}}]}";
    const auto replaced = [&](const std::string& what, const std::string& by) {
        return messageForText(std::string(text).replace(text.find(what), what.size(), by));
    };
    const std::string gravity = messageForText(text);
    QVERIFY2(gravity.starts_with("bend.recipe.json, line 8: gravity_m_s2 must hold 3 numbers"), gravity.c_str());
    const std::string time = replaced("[0, 0\n]", "[0, 0, 0\n]");
    QVERIFY2(time.starts_with("bend.recipe.json, line 10: events[0].time_s must be"), time.c_str());
    const std::string file = replaced("bar.stl", "no.stl");
    QVERIFY2(file.starts_with("bend.recipe.json, line 5: part.file names"), file.c_str());
    const std::string objects = replaced("500,", "5\n,");
    QVERIFY2(objects.starts_with("bend.recipe.json, line 6: objects must be"), objects.c_str());
}

void RecipeErrorsTest::keyGivenTwiceIsRefused()
{
    QCOMPARE(messageForText(R"({"version": 1, "objects": 5, "objects": 6})"),
             std::string("bend.recipe.json: the key \"objects\" is given twice in the same object."));
}

void RecipeErrorsTest::hostileNestingIsRefused()
{
    QCOMPARE(messageForText(std::string(1'000'000, '[')),
             std::string("bend.recipe.json: lists and objects are nested more than 100 deep."));
}

void RecipeErrorsTest::missingFilesAreNamed()
{
    QVERIFY_EXCEPTION_THROWN(readRecipe("/nowhere/bend.recipe.json", presets), std::runtime_error);
    const std::string message = messageFor(with("part", R"({"file": "missing.step"})"));
    QVERIFY2(message.starts_with("bend.recipe.json, line 1: part.file names a file that does not exist: "),
             message.c_str());
    QVERIFY2(message.find("/missing.step") != std::string::npos, message.c_str());
    const std::string extra = messageFor(with("extra_parts", R"([{"file": "no.step"}])"));
    QVERIFY2(extra.starts_with("bend.recipe.json, line 1: extra_parts[0].file names a file that does not exist: "),
             extra.c_str());
    const std::string tool = messageFor(withManipulator(R"({"name": "a", "kind": "part", "part_file": "no.step"})"));
    QVERIFY2(tool.starts_with("bend.recipe.json, line 1: manipulators[0].part_file names a file that does not exist: "),
             tool.c_str());
}

void RecipeErrorsTest::everyTruncationIsRefused()
{
    const std::string text = with("exports", R"([{"file": "c.png", "view": [1, 2, -1]}])").dump();
    for (std::size_t length = 0; length < text.size(); ++length)
        QVERIFY2(messageForText(text.substr(0, length)) != "accepted", text.substr(0, length).c_str());
    QCOMPARE(messageForText(text), std::string("accepted"));
}

QTEST_GUILESS_MAIN(RecipeErrorsTest)
#include "recipe_errors_test.moc"
