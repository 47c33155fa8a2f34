#include <nlohmann/json.hpp>

#include <QDirIterator>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using nlohmann::json;

namespace {

struct Outcome {
    int status = -1;
    std::string out;
    std::string errors;
};

/// Environment without a display, as on a server.
QProcessEnvironment serverEnvironment()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(name);
    return environment;
}

Outcome knead(const QStringList& arguments)
{
    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM, arguments);
    if (!process.waitForFinished(120'000) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), process.readAllStandardOutput().toStdString(),
            process.readAllStandardError().toStdString()};
}

/// A bar of 40 x 10 x 10 mm with a corner at the origin, as an STL text.
std::string barText()
{
    const std::array<std::array<unsigned, 3>, 12> triangles{{{0, 2, 3},
                                                             {0, 3, 1},
                                                             {4, 5, 7},
                                                             {4, 7, 6},
                                                             {0, 1, 5},
                                                             {0, 5, 4},
                                                             {2, 6, 7},
                                                             {2, 7, 3},
                                                             {0, 4, 6},
                                                             {0, 6, 2},
                                                             {1, 3, 7},
                                                             {1, 7, 5}}};
    std::ostringstream text;
    text << "solid bar\n";
    for (const auto& triangle : triangles) {
        text << "facet normal 0 0 0\nouter loop\n";
        for (const unsigned corner : triangle)
            text << "vertex " << (corner & 1U) * 40 << ' ' << (corner >> 1U & 1U) * 10 << ' ' << (corner >> 2U) * 10
                 << '\n';
        text << "endloop\nendfacet\n";
    }
    text << "endsolid bar\n";
    return text.str();
}

/// Pushes the middle of a bar held at its lower end x = 0.
json pressRecipe()
{
    return json::parse(R"({
        "version": 1, "part": {"file": "bar.stl"}, "spacing_mm": 2.5, "duration_s": 0.2,
        "material": {"youngs_modulus_pa": 1e5, "damping_ratio": 0.2, "shape_damping_per_s": 40},
        "fixtures": [{"name": "end", "box_mm": [-1, -1, -1, 2, 11, 11]}],
        "manipulators": [{"name": "press", "size_mm": [6, 12, 6], "position_mm": [35, 5, 14],
                          "keyframes": [{"time_s": 0.1, "position_mm": [35, 5, 10]}]}],
        "exports": [{"file": "bent.stl"}, {"file": "pictures/bent.png", "width": 120, "height": 90}]})");
}

class Workshop {
public:
    Workshop() { std::ofstream(path("bar.stl")) << barText(); }

    std::string path(const std::string& name) const { return m_folder.filePath(name.c_str()).toStdString(); }
    QString qPath(const std::string& name) const { return m_folder.filePath(name.c_str()); }

    QString write(const json& recipe, const std::string& name = "press.recipe.json") const
    {
        std::ofstream(path(name)) << recipe.dump();
        return qPath(name);
    }

    QStringList filesUnder(const std::string& folder) const
    {
        QStringList names;
        QDirIterator files(qPath(folder), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (files.hasNext())
            names << QDir(qPath(folder)).relativeFilePath(files.next());
        names.sort();
        return names;
    }

private:
    QTemporaryDir m_folder;
};

/// Lowest z of a binary STL [mm].
float lowestZ(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    file.seekg(80);
    std::uint32_t count = 0;
    file.read(reinterpret_cast<char*>(&count), sizeof count);
    float lowest = INFINITY;
    for (std::uint32_t i = 0; i < count; ++i) {
        std::array<float, 12> numbers{};
        file.read(reinterpret_cast<char*>(numbers.data()), sizeof numbers);
        file.seekg(2, std::ios::cur);
        for (const std::size_t z : {5, 8, 11})
            lowest = std::min(lowest, numbers.at(z));
    }
    return lowest;
}

std::size_t lineCount(const std::string& text)
{
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

} // namespace

class CommandLineTest : public QObject {
    Q_OBJECT

private slots:
    void helpExistsEverywhere();
    void versionIsPrinted();
    void wrongUseEndsWithTwoAndOneSentence_data();
    void wrongUseEndsWithTwoAndOneSentence();
    void runWritesExactlyTheExports();
    void runReportsWhatTheRecipeSaid();
    void anyNumberOfThreadsGivesTheSameBits();
    void eventsHappen();
    void wedgesCutABarInTwo();
    void pressedClayStaysPressed();
    void rigidBodiesFlyAsTheyStarted();
    void toolsMayBePartsFromFiles();
    void partsAreBroughtTogetherAndGlued();
    void regionsAndTimeStepsReachTheSimulation();
    void publishedScenesAreRepeated();
    void commandsThatMakeNoSenseAreWarnedOf();
    void recipesThatDoNotFitThePartAreRefused_data();
    void recipesThatDoNotFitThePartAreRefused();
    void outputFolderThatCannotBeMadeFails();
    void interruptLeavesNoFiles();
    void firstRecipeCanBeRun();
    void bundledExamplesAreReadable();
};

void CommandLineTest::helpExistsEverywhere()
{
    for (const char* command : {"", "info", "convert", "run", "recipe"}) {
        QStringList arguments{"--help"};
        if (*command != '\0')
            arguments.prepend(command);
        const Outcome outcome = knead(arguments);
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.out.find("Usage:") != std::string::npos, command);
        QVERIFY2(outcome.errors.empty(), outcome.errors.c_str());
    }
}

void CommandLineTest::versionIsPrinted()
{
    const Outcome outcome = knead({"--version"});
    QCOMPARE(outcome.status, 0);
    QVERIFY2(outcome.out.starts_with("knead 0."), outcome.out.c_str());
}

void CommandLineTest::wrongUseEndsWithTwoAndOneSentence_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("unknown option") << QStringList{"--nonsense"};
    QTest::newRow("run without a recipe") << QStringList{"run"};
    QTest::newRow("run of nothing") << QStringList{"run", "/nowhere/a.recipe.json"};
    QTest::newRow("run of a folder") << QStringList{"run", "/"};
    QTest::newRow("no threads") << QStringList{"run", "a.recipe.json", "--threads", "0"};
    QTest::newRow("too much") << QStringList{"run", "a.recipe.json", "b.recipe.json"};
    QTest::newRow("two commands") << QStringList{"run", "a.recipe.json", "info", "b.step"};
    QTest::newRow("recipe for nothing") << QStringList{"recipe", "/nowhere/a.step"};
}

void CommandLineTest::wrongUseEndsWithTwoAndOneSentence()
{
    QFETCH(QStringList, arguments);
    const Outcome outcome = knead(arguments);
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.errors.starts_with("knead: "), outcome.errors.c_str());
    QCOMPARE(lineCount(outcome.errors), std::size_t(1));
    QCOMPARE(outcome.out, std::string());
}

void CommandLineTest::runWritesExactlyTheExports()
{
    const Workshop shop;
    const Outcome outcome = knead({"run", shop.write(pressRecipe()), "--out", shop.qPath("new/results")});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QCOMPARE(shop.filesUnder("new/results"), (QStringList{"bent.stl", "pictures/bent.png"}));
    const QImage picture(shop.qPath("new/results/pictures/bent.png"));
    QCOMPARE(picture.size(), QSize(120, 90));
    // The bar lay on z = 0; its free end is pressed below that.
    const float lowest = lowestZ(shop.path("new/results/bent.stl"));
    QVERIFY2(lowest < -0.5F && lowest > -10, std::to_string(lowest).c_str());
}

void CommandLineTest::runReportsWhatTheRecipeSaid()
{
    const Workshop shop;
    const Outcome outcome = knead({"run", shop.write(pressRecipe()), "--out", shop.qPath("out"), "--json"});
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
    QCOMPARE(report.at("files"), (json{shop.path("out/bent.stl"), shop.path("out/pictures/bent.png")}));
}

void CommandLineTest::anyNumberOfThreadsGivesTheSameBits()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["duration_s"] = 0.05;
    const QString path = shop.write(recipe);
    std::vector<json> hashes;
    for (const char* threads : {"1", "2", "4"})
        hashes.push_back(json::parse(knead({"run", path, "--json", "--threads", threads}).out).at("state_hash"));
    QCOMPARE(hashes[0].get<std::string>().size(), std::size_t(16));
    QCOMPARE(hashes[1], hashes[0]);
    QCOMPARE(hashes[2], hashes[0]);
}

void CommandLineTest::eventsHappen()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["gravity_m_s2"] = {0, 0, -9.81};
    recipe["events"] = json::parse(R"([{"time_s": 0.02, "remove_manipulator": "press"},
        {"time_s": 0.02, "remove_fixture": "end"}, {"time_s": 0.04, "material": {"youngs_modulus_pa": 5e4}}])");
    const Outcome outcome = knead({"run", shop.write(recipe), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    // Free fall for 0.18 s: kinetic energy m (g t)^2 / 2 with m = 4.4 g, vibration comes on top.
    const double fall = 0.5 * 1100 * 4e-6 * std::pow(9.81 * 0.18, 2);
    QVERIFY(report.at("energy_j").at("kinetic").get<double>() > 0.9 * fall);
    QCOMPARE(report.at("tools").size(), std::size_t(1));
}

void CommandLineTest::wedgesCutABarInTwo()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["material"] = {{"youngs_modulus_pa", 1e5},
                          {"damping_ratio", 0.2},
                          {"shape_damping_per_s", 20},
                          {"tensile_strength_pa", 2e4},
                          {"friction", 0.1}};
    recipe["fixtures"] = json::parse(R"([{"name": "left", "box_mm": [-1, -1, -1, 6, 11, 11]},
                                         {"name": "right", "box_mm": [34, -1, -1, 41, 11, 11]}])");
    recipe["manipulators"] = json::parse(R"([
        {"name": "upper", "kind": "wedge", "size_mm": [14, 10, 14], "position_mm": [20, 5, 17.5], "friction": 0,
         "rotation_deg": [0, 0, 90], "keyframes": [{"time_s": 0.15, "position_mm": [20, 5, 11.2]}]},
        {"name": "lower", "kind": "wedge", "size_mm": [14, 10, 14], "position_mm": [20, 5, -7.5], "friction": 0,
         "rotation_deg": [180, 0, 90], "keyframes": [{"time_s": 0.15, "position_mm": [20, 5, -1.2]}]}])");
    const Outcome outcome = knead({"run", shop.write(recipe), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QVERIFY2(report.at("broken").get<int>() > 0, outcome.out.c_str());
    QVERIFY2(report.at("components").get<int>() >= 2, outcome.out.c_str());
    QVERIFY(report.at("energy_j").at("fracture").get<double>() > 0);

    const Outcome read = knead({"run", shop.write(recipe)});
    QVERIFY2(read.out.find(" connections broke, ") != std::string::npos, read.out.c_str());
}

void CommandLineTest::pressedClayStaysPressed()
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
        const Outcome outcome = knead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
        return outcome.status == 0 ? json::parse(outcome.out).at("energy_j") : json{{"error", outcome.errors}};
    };
    const json clay = plasticWork({{"preset", "modeling-clay"}, {"poisson_ratio", 0.4}});
    QVERIFY2(clay.contains("plastic"), clay.dump().c_str());
    QVERIFY2(clay.at("plastic").get<double>() > 0.2 * clay.at("tool_work").get<double>(), clay.dump().c_str());
    const json rubber = plasticWork("natural-rubber");
    QCOMPARE(rubber.at("plastic").get<double>(), 0.0);
}

void CommandLineTest::rigidBodiesFlyAsTheyStarted()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe["fixtures"] = json::array();
    recipe["manipulators"] = json::array();
    recipe["exports"] = json::parse(R"([{"file": "flown.stl"}])");
    const std::string name =
        json::parse(knead({"info", shop.qPath("bar.stl"), "--json"}).out).at("parts")[0].at("name");
    recipe["bodies"] = {{name, {{"kind", "rigid"}, {"velocity_mm_s", {0, 0, -100}}}}};
    const Outcome outcome = knead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    const float fallen = static_cast<float>(100 * report.at("simulated_s").get<double>());
    QVERIFY(std::abs(lowestZ(shop.path("out/flown.stl")) + fallen) < 1e-3F);
    QCOMPARE(report.at("energy_j").at("elastic").get<double>(), 0.0);
}

void CommandLineTest::toolsMayBePartsFromFiles()
{
    const Workshop shop;
    json recipe = pressRecipe();
    // The bar itself, standing on its end on another bar; its middle is 20 mm above its lower end.
    recipe["manipulators"] = json::parse(R"([{"name": "press", "kind": "part", "part_file": "bar.stl",
        "position_mm": [35, 5, 31], "rotation_deg": [0, 90, 0],
        "keyframes": [{"time_s": 0.1, "position_mm": [35, 5, 27]}]}])");
    const Outcome outcome = knead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json tool = json::parse(outcome.out).at("tools")[0];
    QVERIFY2(tool.at("force_n")[2].get<double>() > 0, outcome.out.c_str());
    QCOMPARE(tool.at("torque_nm").size(), std::size_t(3));
    QVERIFY2(lowestZ(shop.path("out/bent.stl")) < -0.5F, "the free end is pressed down");
}

void CommandLineTest::partsAreBroughtTogetherAndGlued()
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
    const std::string lower =
        json::parse(knead({"info", shop.qPath("bar.stl"), "--json"}).out).at("parts")[0].at("name");
    recipe["bodies"][lower] = {{"kind", "glue"}};
    recipe["gravity_m_s2"] = {0, 0, 5};
    const Outcome outcome = knead({"run", shop.write(recipe), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QCOMPARE(report.at("objects").get<int>(), 2 * 425);
    QVERIFY2(report.at("joints").get<int>() > 0, outcome.out.c_str());
    QCOMPARE(report.at("components").get<int>(), 1);
}

void CommandLineTest::regionsAndTimeStepsReachTheSimulation()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["duration_s"] = 0.02;
    const double step = json::parse(knead({"run", shop.write(recipe), "--json"}).out).at("time_step_s");
    recipe["regions"] = json::parse(R"([{"name": "hard end", "box_mm": [30, -1, -1, 41, 11, 11],
                                         "material": {"youngs_modulus_pa": 4e5}}])");
    const double harder = json::parse(knead({"run", shop.write(recipe), "--json"}).out).at("time_step_s");
    QVERIFY2(harder < 0.6 * step, "four times the stiffness halves the step");

    recipe["mass_scaling_time_step_s"] = step;
    const json scaled = json::parse(knead({"run", shop.write(recipe), "--json"}).out);
    QVERIFY2(scaled.at("added_mass").get<double>() > 0, scaled.dump().c_str());
    QVERIFY(scaled.at("time_step_s").get<double>() > 0.9 * step);

    recipe["time_step_s"] = step / 8;
    QCOMPARE(json::parse(knead({"run", shop.write(recipe), "--json"}).out).at("time_step_s").get<double>(), step / 8);
}

void CommandLineTest::publishedScenesAreRepeated()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe["spacing_mm"] = 2;
    recipe.update(json::parse(R"({"arrangement": "published", "integrator": "forward-euler",
        "vicinity": "half-partition", "structural_friction": 0.2, "duration_s": 0.02,
        "material": {"youngs_modulus_pa": 3000, "damping_ratio": 0.3}})"));
    const Outcome outcome = knead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QCOMPARE(report.at("objects").get<int>(), 20 * 5 * 5);
    // Every pair of neighbors in a block of 20 x 5 x 5: 13 directions, each with its own count.
    const int along = 19 * 25 + 2 * (20 * 4 * 5);
    const int acrossFaces = 2 * (2 * 19 * 4 * 5) + 2 * (20 * 4 * 4);
    const int acrossSpace = 4 * (19 * 4 * 4);
    QCOMPARE(report.at("connections").get<int>(), along + acrossFaces + acrossSpace);
}

void CommandLineTest::commandsThatMakeNoSenseAreWarnedOf()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    recipe["duration_s"] = 0.02;
    const std::string name =
        json::parse(knead({"info", shop.qPath("bar.stl"), "--json"}).out).at("parts")[0].at("name");
    recipe["events"] = {{{"time_s", 0}, {"body_kind", {{"body", name}, {"kind", "rigid"}}}},
                        {{"time_s", 0.01}, {"renormalize", {{"body", name}}}}};
    const Outcome outcome = knead({"run", shop.write(recipe), "--json"});
    QCOMPARE(outcome.status, 0);
    QVERIFY2(outcome.errors.find("A rigid body has no stress to lose.") != std::string::npos, outcome.errors.c_str());
}

void CommandLineTest::recipesThatDoNotFitThePartAreRefused_data()
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

void CommandLineTest::recipesThatDoNotFitThePartAreRefused()
{
    QFETCH(QString, change);
    QFETCH(QString, words);
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.update(json::parse(change.toStdString()));
    const Outcome outcome = knead({"run", shop.write(recipe), "--out", shop.qPath("out")});
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.errors.find(words.toStdString()) != std::string::npos, outcome.errors.c_str());
    QVERIFY(shop.filesUnder("out").empty());
}

void CommandLineTest::outputFolderThatCannotBeMadeFails()
{
    const Workshop shop;
    const Outcome outcome = knead({"run", shop.write(pressRecipe()), "--out", shop.qPath("bar.stl/results")});
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.errors.find("cannot be made") != std::string::npos, outcome.errors.c_str());
}

void CommandLineTest::interruptLeavesNoFiles()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe["duration_s"] = 3000;
    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM, {"run", shop.write(recipe), "--out", shop.qPath("out")});
    // The folder is made when the simulation is about to begin.
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(shop.qPath("out/pictures")), 30'000);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(10'000));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 130);
    QVERIFY(shop.filesUnder("out").empty());
}

void CommandLineTest::firstRecipeCanBeRun()
{
    const Workshop shop;
    const Outcome written = knead({"recipe", shop.qPath("bar.stl"), "--output", shop.qPath("first.recipe.json")});
    QVERIFY2(written.status == 0, written.errors.c_str());
    json recipe = json::parse(std::ifstream(shop.path("first.recipe.json")));
    QCOMPARE(recipe.at("part").at("file").get<std::string>(), std::string("bar.stl"));
    recipe["objects"] = 300;
    const Outcome outcome = knead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QVERIFY2(json::parse(outcome.out).at("tools")[0].at("peak_force_n").get<double>() > 0,
             "the block reaches the part");
    QCOMPARE(shop.filesUnder("out"), (QStringList{"bar-pressed.png", "bar-pressed.stl"}));
}

/// The examples run for seconds; here they are read and filled, and a hundredth of a second is simulated.
void CommandLineTest::bundledExamplesAreReadable()
{
    const Workshop shop;
    const QDir examples(KNEAD_RESOURCES "/examples");
    const QStringList names = examples.entryList({"*.recipe.json"});
    QVERIFY(names.size() >= 3);
    for (const QString& name : names) {
        json recipe = json::parse(std::ifstream(examples.filePath(name).toStdString()));
        recipe["part"]["file"] = examples.filePath(recipe["part"]["file"].get<std::string>().c_str()).toStdString();
        recipe["duration_s"] = 0.01;
        recipe.erase("events");
        recipe.erase("exports");
        const Outcome outcome = knead({"run", shop.write(recipe)});
        QVERIFY2(outcome.status == 0, (name.toStdString() + ": " + outcome.errors).c_str());
    }
}

QTEST_GUILESS_MAIN(CommandLineTest)
#include "command_line_test.moc"
