#include "support/workshop.h"

#include <QImage>
#include <QtTest>

#include <cmath>
#include <fstream>
#include <numbers>
#include <vector>

using namespace workshop;

/// Whole runs: what recipes ask for happens.
class RecipeRunTest : public QObject {
    Q_OBJECT

private slots:
    void runWritesExactlyTheExports();
    void runReportsWhatTheRecipeSaid();
    void settingsAreThoseOfAnEditedRecipe();
    void exportsAreAsAsked();
    void anyNumberOfThreadsGivesTheSameBits();
    void eventsHappen();
    void wedgesCutABarInTwo();
    void pressedClayStaysPressed();
    void clayPressedDeepLeavesAsItsFaces();
    void rigidBodiesFlyAsTheyStarted();
    void toolsMayBePartsFromFiles();
    void partsAreBroughtTogetherAndGlued();
    void regionsAndTimeStepsReachTheSimulation();
    void whatIsShorterThanAFrameIsSimulated();
    void partsAreBentByNumberFirst();
    void bendsThatFoldAreRefused();
    void publishedScenesAreRepeated();
    void commandsThatMakeNoSenseAreWarnedOf();
    void numbersOfALaterFillingFitThatOneOnly();
    void recipesThatDoNotFitThePartAreRefused_data();
    void recipesThatDoNotFitThePartAreRefused();
};

void RecipeRunTest::runWritesExactlyTheExports()
{
    const Workshop shop;
    const Outcome outcome = runKnead({"run", shop.write(pressRecipe()), "--out", shop.qPath("new/results")});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QCOMPARE(shop.filesUnder("new/results"), (QStringList{"bent.stl", "pictures/bent.png"}));
    const QImage picture(shop.qPath("new/results/pictures/bent.png"));
    QCOMPARE(picture.size(), QSize(120, 90));
    // The bar lay on z = 0; its free end is pressed below that.
    const float lowest = lowestZ(shop.path("new/results/bent.stl"));
    QVERIFY2(lowest < -0.5F && lowest > -10, std::to_string(lowest).c_str());
}

void RecipeRunTest::runReportsWhatTheRecipeSaid()
{
    const Workshop shop;
    const Outcome outcome = runKnead({"run", shop.write(pressRecipe()), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    // 17 x 5 x 5 nodes of the lattice
    QCOMPARE(report.at("objects").get<int>(), 425);
    QVERIFY(report.at("connections").get<int>() > 425);
    const double step = report.at("time_step_s");
    QVERIFY(std::abs(report.at("simulated_s").get<double>() - 0.2) <= step);
    QVERIFY(std::abs(report.at("steps").get<double>() * step - 0.2) <= step);
    QVERIFY(report.at("wall_s").get<double>() > 0);
    QVERIFY(report.at("energy_j").at("tool_work").get<double>() > 0);
    QVERIFY(report.at("energy_j").at("elastic").get<double>() > 0);
    QCOMPARE(report.at("tools").size(), std::size_t(1));
    const json& tool = report.at("tools")[0];
    QCOMPARE(tool.at("name").get<std::string>(), std::string("press"));
    QVERIFY2(tool.at("force_n")[2].get<double>() > 0, "the bar pushes the block up");
    QVERIFY(tool.at("peak_force_n").get<double>() >= tool.at("force_n")[2].get<double>());
    const json& stress = report.at("bodies")[0].at("von_mises_stress");
    QVERIFY(stress.at("largest_pa").get<double>() > 0);
    QVERIFY(stress.at("error_share").get<double>() > 0 && stress.at("error_share").get<double>() < 1);
    QCOMPARE(report.at("files"), (json{shop.path("out/bent.stl"), shop.path("out/pictures/bent.png")}));
}

void RecipeRunTest::settingsAreThoseOfAnEditedRecipe()
{
    const Workshop shop;
    json recipe = pressRecipe();
    const QString before = shop.write(recipe, "before.recipe.json");
    recipe.erase("exports");
    recipe["duration_s"] = 0.05;
    recipe["manipulators"][0]["size_mm"][0] = 8;
    recipe["material"]["youngs_modulus_pa"] = 2e5;
    const json edited = json::parse(runKnead({"run", shop.write(recipe), "--json"}).out);
    const Outcome set = runKnead({"run", "--set", "duration_s=0.05", "--set", "manipulators.press.size_mm.0=8", "--set",
                                  "exports=null", before, "--set",
                                  "material={\"youngs_modulus_pa\": 1e5, \"damping_ratio\": "
                                  "0.2, \"shape_damping_per_s\": 40}",
                                  "--set", "material.youngs_modulus_pa=2e5", "--json"});
    QVERIFY2(set.status == 0, set.errors.c_str());
    QCOMPARE(json::parse(set.out).at("state_hash"), edited.at("state_hash"));
    QCOMPARE(json::parse(set.out).at("files"), json::array());
}

void RecipeRunTest::exportsAreAsAsked()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe["exports"] = json::parse(R"([{"file": "bent.stl", "text": true}, {"file": "bent.vtp"}])");
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    // The file has what the report says of the body.
    const json report = json::parse(outcome.out);
    const json& inFile = report.at("exports")[1].at("parts")[0].at("von_mises_stress");
    const json& inBody = report.at("bodies")[0].at("von_mises_stress");
    QVERIFY(inFile.at("largest_pa").get<double>() > 0);
    QCOMPARE(inFile.at("largest_pa"), inBody.at("largest_pa"));
    QCOMPARE(inFile.at("error_share"), inBody.at("error_share"));
    QCOMPARE(report.at("exports")[0].at("parts")[0].at("von_mises_stress").at("largest_pa"), json(0.0));
    const auto contentOf = [&](const char* name) {
        std::ifstream file(shop.path(name), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    QVERIFY(contentOf("out/bent.stl").starts_with("solid "));
    const std::string vtp = contentOf("out/bent.vtp");
    for (const char* field :
         {"displacement [m]", "equivalent strain", "von Mises stress [Pa]", "von Mises stress error [Pa]", "part"})
        QVERIFY2(vtp.find("Name=\"" + std::string(field) + "\"") != std::string::npos, field);
}

void RecipeRunTest::anyNumberOfThreadsGivesTheSameBits()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["duration_s"] = 0.05;
    const QString path = shop.write(recipe);
    std::vector<json> hashes;
    for (const char* threads : {"1", "2", "4"})
        hashes.push_back(json::parse(runKnead({"run", path, "--json", "--threads", threads}).out).at("state_hash"));
    QCOMPARE(hashes[0].get<std::string>().size(), std::size_t(16));
    QCOMPARE(hashes[1], hashes[0]);
    QCOMPARE(hashes[2], hashes[0]);
}

void RecipeRunTest::eventsHappen()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["gravity_m_s2"] = {0, 0, -9.81};
    recipe["events"] = json::parse(R"([{"time_s": 0.02, "remove_manipulator": "press"},
        {"time_s": 0.02, "remove_fixture": "end"}, {"time_s": 0.04, "material": {"youngs_modulus_pa": 5e4}}])");
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    // Free fall for 0.18 s: kinetic energy m (g t)^2 / 2 with m = 4.4 g, vibration comes on top.
    const double fall = 0.5 * 1100 * 4e-6 * std::pow(9.81 * 0.18, 2);
    QVERIFY(report.at("energy_j").at("kinetic").get<double>() > 0.9 * fall);
    QCOMPARE(report.at("tools").size(), std::size_t(1));
}

void RecipeRunTest::wedgesCutABarInTwo()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["material"]["tensile_strength_pa"] = 5000;
    recipe["fixtures"] = json::array();
    // Edges across the bar, a little beside the middle of an object, that pass each other by 0.4 mm.
    recipe["manipulators"] = json::parse(R"([
        {"name": "upper", "kind": "wedge", "size_mm": [14, 14, 14], "position_mm": [20.3, 5, 17.5],
         "rotation_deg": [0, 0, 90], "keyframes": [{"time_s": 0.15, "position_mm": [20.3, 5, 11.8]}]},
        {"name": "lower", "kind": "wedge", "size_mm": [14, 14, 14], "position_mm": [20.3, 5, -7.5],
         "rotation_deg": [180, 0, 90], "keyframes": [{"time_s": 0.15, "position_mm": [20.3, 5, -1.8]}]}])");
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QVERIFY2(report.at("broken").get<int>() > 0, outcome.out.c_str());
    QVERIFY2(report.at("components").get<int>() >= 2, outcome.out.c_str());
    QVERIFY(report.at("energy_j").at("fracture").get<double>() > 0);

    const Outcome read = runKnead({"run", shop.write(recipe)});
    QVERIFY2(read.out.find(" connections broke, ") != std::string::npos, read.out.c_str());
}

void RecipeRunTest::pressedClayStaysPressed()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe["floor"] = {{"height_mm", 0}};
    recipe["fixtures"] = json::array();
    recipe["duration_s"] = 0.4;
    recipe["manipulators"] =
        json::parse(R"([{"name": "press", "kind": "ball", "size_mm": 12, "position_mm": [20, 5, 17],
        "keyframes": [{"time_s": 0.15, "position_mm": [20, 5, 12]}, {"time_s": 0.3, "position_mm": [20, 5, 20]}]}])");
    recipe["exports"] = json::parse(R"([{"file": "pressed.stl"}])");
    const auto plasticWork = [&](const json& material) {
        recipe["material"] = material;
        const Outcome outcome = runKnead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
        return outcome.status == 0 ? json::parse(outcome.out).at("energy_j") : json{{"error", outcome.errors}};
    };
    const json clay = plasticWork({{"preset", "modeling-clay"}, {"poisson_ratio", 0.4}});
    QVERIFY2(clay.contains("plastic"), clay.dump().c_str());
    QVERIFY2(clay.at("plastic").get<double>() > 0.2 * clay.at("tool_work").get<double>(), clay.dump().c_str());
    const json rubber = plasticWork("natural-rubber");
    QCOMPARE(rubber.at("plastic").get<double>(), 0.0);
}

/// A ball goes two thirds of the thickness into the lump, which is filled anew on the way, and once more by an event.
void RecipeRunTest::clayPressedDeepLeavesAsItsFaces()
{
    const Workshop shop;
    json recipe = json::parse(R"({"version": 1, "spacing_mm": 3, "material": {"preset": "modeling-clay"},
        "manipulators": [{"name": "ball", "kind": "ball", "size_mm": 16, "position_mm": [30, 20, 32.5],
            "keyframes": [{"time_s": 0.3, "position_mm": [30, 20, 16]}, {"time_s": 0.5, "position_mm": [30, 20, 40]}]}],
        "gravity_m_s2": [0, 0, -9.81], "floor": {"height_mm": 0, "friction": 0.8}, "duration_s": 0.6,
        "events": [{"time_s": 0.55, "refill": {"spacing_mm": 2.5}}], "exports": [{"file": "deep.step"}]})");
    recipe["part"] = {{"file", KNEAD_RESOURCES "/examples/lump.step"}};
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QVERIFY2(report.at("refills").get<int>() >= 3, outcome.out.c_str());
    QVERIFY(report.at("objects").get<int>() > 4000); // 2761 at 3 mm
    QVERIFY(report.at("quality").at("imbalance_share").get<double>() < 0.03);
    QVERIFY(report.at("bodies")[0].at("largest_displacement_mm").get<double>() > 12); // from the opened part
    const json& part = report.at("exports")[0].at("parts")[0];
    QCOMPARE(part.at("form").get<std::string>(), std::string("smooth faces"));
    QCOMPARE(part.at("faces").at("after").get<int>(), 18);
    QVERIFY(part.at("closed").get<bool>() && part.at("valid").get<bool>());
    const json& volume = part.at("volume_m3");
    QVERIFY2(std::abs(volume.at("file").get<double>() / volume.at("rest").get<double>() - 1) < 2e-3,
             volume.dump().c_str());
    QVERIFY(std::abs(volume.at("file").get<double>() / volume.at("skin").get<double>() - 1) < 1e-3);
}

void RecipeRunTest::rigidBodiesFlyAsTheyStarted()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe["fixtures"] = json::array();
    recipe["manipulators"] = json::array();
    recipe["exports"] = json::parse(R"([{"file": "flown.stl"}])");
    recipe["bodies"] = {{"bar", {{"kind", "rigid"}, {"velocity_mm_s", {0, 0, -100}}}}};
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    const float fallen = static_cast<float>(100 * report.at("simulated_s").get<double>());
    QVERIFY(std::abs(lowestZ(shop.path("out/flown.stl")) + fallen) < 1e-3F);
    QCOMPARE(report.at("energy_j").at("elastic").get<double>(), 0.0);
    const json& body = report.at("bodies")[0];
    QCOMPARE(body.at("name").get<std::string>(), std::string("bar"));
    QVERIFY(std::abs(body.at("mean_displacement_mm")[2].get<double>() + fallen) < 1e-3);
    QVERIFY(std::abs(body.at("largest_displacement_mm").get<double>() - fallen) < 1e-3);
}

void RecipeRunTest::toolsMayBePartsFromFiles()
{
    const Workshop shop;
    json recipe = pressRecipe();
    // The bar itself, standing on its end on another bar; its middle is 20 mm above its lower end.
    recipe["manipulators"] = json::parse(R"([{"name": "press", "kind": "part", "part_file": "bar.stl",
        "position_mm": [35, 5, 31], "rotation_deg": [0, 90, 0],
        "keyframes": [{"time_s": 0.1, "position_mm": [35, 5, 27]}]}])");
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json tool = json::parse(outcome.out).at("tools")[0];
    QVERIFY2(tool.at("force_n")[2].get<double>() > 0, outcome.out.c_str());
    QCOMPARE(tool.at("torque_nm").size(), std::size_t(3));
    QVERIFY2(lowestZ(shop.path("out/bent.stl")) < -0.5F, "the free end is pressed down");
}

void RecipeRunTest::partsAreBroughtTogetherAndGlued()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["fixtures"] = json::array();
    recipe["manipulators"] = json::array();
    recipe["material"]["adhesion_pa"] = 1e5;
    // A second bar lies on the first one, which is glue; gravity pulls it upwards.
    recipe["extra_parts"] = json::parse(R"([{"file": "bar.stl", "name": "upper", "position_mm": [0, 0, 10]}])");
    recipe["bodies"] = json::parse(R"({"upper": {"velocity_mm_s": [0, 0, -20]}})");
    recipe["bodies"]["bar"] = {{"kind", "glue"}};
    recipe["gravity_m_s2"] = {0, 0, 5};
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QCOMPARE(report.at("objects").get<int>(), 2 * 425);
    QVERIFY2(report.at("joints").get<int>() > 0, outcome.out.c_str());
    QCOMPARE(report.at("components").get<int>(), 1);
}

void RecipeRunTest::regionsAndTimeStepsReachTheSimulation()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["duration_s"] = 0.02;
    const double step = json::parse(runKnead({"run", shop.write(recipe), "--json"}).out).at("time_step_s");
    recipe["regions"] = json::parse(R"([{"name": "hard end", "box_mm": [30, -1, -1, 41, 11, 11],
                                         "material": {"youngs_modulus_pa": 4e5}}])");
    const double harder = json::parse(runKnead({"run", shop.write(recipe), "--json"}).out).at("time_step_s");
    QVERIFY2(harder < 0.6 * step, "four times the stiffness halves the step");

    recipe["mass_scaling_time_step_s"] = step;
    const json scaled = json::parse(runKnead({"run", shop.write(recipe), "--json"}).out);
    QVERIFY2(scaled.at("added_mass").get<double>() > 0, scaled.dump().c_str());
    QVERIFY(scaled.at("time_step_s").get<double>() > 0.9 * step);

    recipe["time_step_s"] = step / 8;
    QCOMPARE(json::parse(runKnead({"run", shop.write(recipe), "--json"}).out).at("time_step_s").get<double>(),
             step / 8);
}

/// Implicit steps of a frame would step over all of it.
void RecipeRunTest::whatIsShorterThanAFrameIsSimulated()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["duration_s"] = 0.005;
    recipe["integrator"] = "implicit-euler";
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QVERIFY(report.at("steps").get<int>() >= 1);
    QVERIFY(std::abs(report.at("simulated_s").get<double>() - 0.005) < 1e-4);
    recipe["integrator"] = "automatic";
    QVERIFY(json::parse(runKnead({"run", shop.write(recipe), "--json"}).out).at("steps").get<int>() > 10);
}

/// The example: nothing moves once the tube is bent, which leaves with true tori.
void RecipeRunTest::partsAreBentByNumberFirst()
{
    const Workshop shop;
    const Outcome outcome =
        runKnead({"run", KNEAD_RESOURCES "/examples/bent-tube.recipe.json", "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    const json& part = report.at("exports")[0].at("parts")[0];
    QVERIFY(part.at("sound").get<bool>());
    const double volume = std::numbers::pi * (0.01 * 0.01 - 0.008 * 0.008) * 0.2;
    QVERIFY(std::abs(part.at("volume_m3").at("file").get<double>() / volume - 1) < 1e-6);
    std::ifstream file(shop.path("out/tube-bent.step"));
    const std::string step(std::istreambuf_iterator<char>(file), {});
    std::size_t tori = 0;
    for (std::size_t at = step.find("TOROIDAL_SURFACE"); at != std::string::npos;
         at = step.find("TOROIDAL_SURFACE", at + 1))
        ++tori;
    QCOMPARE(tori, std::size_t(2));
    QVERIFY(step.find("B_SPLINE_SURFACE") == std::string::npos);
}

void RecipeRunTest::bendsThatFoldAreRefused()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe["deform"] = json::parse(
        R"([{"kind": "bend", "axis": [1, 0, 0], "side": [0, 0, 1], "from_mm": 10, "to_mm": 20, "radius_mm": 2}])");
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--out", shop.qPath("out")});
    QVERIFY(outcome.status != 0);
    QVERIFY2(outcome.errors.find("would fold the material") != std::string::npos, outcome.errors.c_str());
}

void RecipeRunTest::publishedScenesAreRepeated()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe["spacing_mm"] = 2;
    recipe.update(json::parse(R"({"arrangement": "published", "integrator": "forward-euler",
        "vicinity": "half-partition", "structural_friction": 0.2, "duration_s": 0.02,
        "material": {"youngs_modulus_pa": 3000, "damping_ratio": 0.3}})"));
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QCOMPARE(report.at("objects").get<int>(), 20 * 5 * 5);
    // Every pair of neighbors in a block of 20 x 5 x 5: 13 directions, each with its own count.
    const int along = 19 * 25 + 2 * (20 * 4 * 5);
    const int acrossFaces = 2 * (2 * 19 * 4 * 5) + 2 * (20 * 4 * 4);
    const int acrossSpace = 4 * (19 * 4 * 4);
    QCOMPARE(report.at("connections").get<int>(), along + acrossFaces + acrossSpace);
}

void RecipeRunTest::commandsThatMakeNoSenseAreWarnedOf()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["duration_s"] = 0.02;
    recipe["events"] = {{{"time_s", 0}, {"body_kind", {{"body", "bar"}, {"kind", "rigid"}}}},
                        {{"time_s", 0.01}, {"renormalize", {{"body", "bar"}}}}};
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--json"});
    QCOMPARE(outcome.status, 0);
    QVERIFY2(outcome.errors.find("A rigid body has no stress to lose.") != std::string::npos, outcome.errors.c_str());
}

/// They mean nothing at the start, so that only the run itself can tell.
void RecipeRunTest::numbersOfALaterFillingFitThatOneOnly()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe["events"] = {
        {{"time_s", 0.05}, {"renormalize", {{"objects", {1}}, {"objects_in_body", 22}, {"filled_anew", true}}}}};
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--out", shop.qPath("out")});
    QVERIFY(outcome.status != 0);
    QVERIFY2(
        outcome.errors.find("events[0] names objects of a body that was filled anew with 22, and here it is filled "
                            "with the first 425. Name a box instead, or keep the spacing and what is done before.") !=
            std::string::npos,
        outcome.errors.c_str());
}

void RecipeRunTest::recipesThatDoNotFitThePartAreRefused_data()
{
    QTest::addColumn<QString>("change");
    QTest::addColumn<QString>("words");
    QTest::newRow("body") << R"({"body_materials": {"lid": {}}})"
                          << "names the body \"lid\"; the part has: \"";
    QTest::newRow("faces") << R"({"fixtures": [{"name": "end", "faces": [0]}]})"
                           << "is a mesh without CAD faces";
    QTest::newRow("nothing there") << R"({"fixtures": [{"name": "end", "box_mm": [90, 0, 0, 91, 1, 1]}]})"
                                   << "the fixture \"end\" holds nothing";
    QTest::newRow("region of nothing")
        << R"({"regions": [{"name": "core", "box_mm": [90, 0, 0, 91, 1, 1], "material": {}}]})"
        << "the region \"core\" holds nothing";
    QTest::newRow("rigid nobody") << R"({"bodies": {"lid": {"kind": "rigid"}}})"
                                  << "bodies names the body \"lid\"; the part has: \"";
    QTest::newRow("change of nothing")
        << R"({"events": [{"time_s": 0.1, "renormalize": {"box_mm": [9, 9, 99, 9, 9, 99]}}]})"
        << "events[0] holds nothing";
    QTest::newRow("tool that is no part")
        << R"({"manipulators": [{"name": "a", "kind": "part", "part_file": "press.recipe.json", "position_mm": [0, 0, 0]}]})"
        << "press.recipe.json";
}

void RecipeRunTest::recipesThatDoNotFitThePartAreRefused()
{
    QFETCH(QString, change);
    QFETCH(QString, words);
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.update(json::parse(change.toStdString()));
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--out", shop.qPath("out")});
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.errors.find(words.toStdString()) != std::string::npos, outcome.errors.c_str());
    QVERIFY(shop.filesUnder("out").empty());
}

QTEST_GUILESS_MAIN(RecipeRunTest)
#include "recipe_run_test.moc"
