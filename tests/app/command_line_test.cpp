#include "support/workshop.h"

#include <QtTest>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <csignal>
#include <fstream>

using namespace workshop;

class CommandLineTest : public QObject {
    Q_OBJECT

private slots:
    void helpExistsEverywhere();
    void versionIsPrinted();
    void wrongUseEndsWithTwoAndOneSentence_data();
    void wrongUseEndsWithTwoAndOneSentence();
    void outputFolderThatCannotBeMadeFails();
    void namesOfFacesComeAlong();
    void interruptLeavesNoFiles();
    void firstRecipeCanBeRun_data();
    void firstRecipeCanBeRun();
    void stillnessIsSaid();
    void bundledExamplesAreReadable();
    void importOptionsAreHeeded();
};

void CommandLineTest::helpExistsEverywhere()
{
    for (const char* command :
         {"", "info", "convert", "run", "sweep", "recipe", "measure", "compare", "replay", "morph"}) {
        QStringList arguments{"--help"};
        if (*command != '\0')
            arguments.prepend(command);
        const Outcome outcome = runKnead(arguments);
        QCOMPARE(outcome.status, 0);
        QVERIFY2(outcome.out.find("Usage:") != std::string::npos, command);
        QVERIFY2(outcome.errors.empty(), outcome.errors.c_str());
    }
}

void CommandLineTest::versionIsPrinted()
{
    const Outcome outcome = runKnead({"--version"});
    QCOMPARE(outcome.status, 0);
    QVERIFY2(outcome.out.starts_with("knead 0."), outcome.out.c_str());
    QCOMPARE(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1);
    for (const QStringList& arguments :
         {QStringList{"--version", "--verbose"}, QStringList{"--verbose", "--version"}}) {
        const Outcome verbose = runKnead(arguments);
        QCOMPARE(verbose.status, 0);
        QVERIFY(verbose.out.starts_with(outcome.out));
        for (const char* word :
             {"OpenCASCADE ", "\nReader of files: ", "knead-cad-worker\n", "\nLandlock: ", "\nseccomp: "})
            QVERIFY2(verbose.out.find(word) != std::string::npos, verbose.out.c_str());
    }
}

void CommandLineTest::wrongUseEndsWithTwoAndOneSentence_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("unknown option") << QStringList{"--nonsense"};
    QTest::newRow("run without a recipe") << QStringList{"run"};
    QTest::newRow("run of nothing") << QStringList{"run", "/nowhere/a.recipe.json"};
    QTest::newRow("run of a folder") << QStringList{"run", "/"};
    QTest::newRow("no threads") << QStringList{"run", "a.recipe.json", "--threads", "0"};
    QTest::newRow("nothing to set") << QStringList{"run", "a.recipe.json", "--set"};
    QTest::newRow("set of nothing") << QStringList{"run", "a.recipe.json", "--set", "spacing_mm"};
    QTest::newRow("too much") << QStringList{"run", "a.recipe.json", "b.recipe.json"};
    QTest::newRow("two commands") << QStringList{"run", "a.recipe.json", "info", "b.step"};
    QTest::newRow("recipe for nothing") << QStringList{"recipe", "/nowhere/a.step"};
    QTest::newRow("measure of nothing") << QStringList{"measure", "/nowhere/a.step"};
    QTest::newRow("measure of what is unknown")
        << QStringList{"measure", KNEAD_RESOURCES "/examples/bar.step", "-m", "girth 1,2,3"};
    QTest::newRow("half a place") << QStringList{"measure", KNEAD_RESOURCES "/examples/bar.step", "-m", "point 1,2"};
    QTest::newRow("entry of a file") << QStringList{"measure", KNEAD_RESOURCES "/examples/bar.step", "--entry", "1"};
    QTest::newRow("compare with nothing") << QStringList{"compare", KNEAD_RESOURCES "/examples/bar.step"};
    QTest::newRow("report of no kind") << QStringList{"compare", KNEAD_RESOURCES "/examples/bar.step",
                                                      KNEAD_RESOURCES "/examples/bar.step", "--report", "a.docx"};
    QTest::newRow("replay of nothing") << QStringList{"replay", "/nowhere/a.knead"};
    QTest::newRow("replay of a folder") << QStringList{"replay", "/"};
    QTest::newRow("replay of all to one file") << QStringList{"replay", "a.knead", "--all", "--export", "a.step"};
    QTest::newRow("replay to no format") << QStringList{"replay", "a.knead", "--export", "a.xyz"};
}

void CommandLineTest::wrongUseEndsWithTwoAndOneSentence()
{
    QFETCH(QStringList, arguments);
    const Outcome outcome = runKnead(arguments);
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.errors.starts_with("knead: "), outcome.errors.c_str());
    QCOMPARE(lineCount(outcome.errors), std::size_t(1));
    QCOMPARE(outcome.out, std::string());
}

void CommandLineTest::outputFolderThatCannotBeMadeFails()
{
    const Workshop shop;
    const Outcome outcome = runKnead({"run", shop.write(pressRecipe()), "--out", shop.qPath("bar.stl/results")});
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.errors.find("cannot be made") != std::string::npos, outcome.errors.c_str());
}

/// From the file through the program that reads it, the one that writes it, and back.
void CommandLineTest::namesOfFacesComeAlong()
{
    const Workshop shop;
    std::ifstream original(KNEAD_RESOURCES "/examples/bracket.step");
    std::string text{std::istreambuf_iterator<char>(original), {}};
    const std::string noName = "ADVANCED_FACE('',";
    for (const char* name : {"seat", "bore", "bore"})
        text.replace(text.find(noName), noName.size(), "ADVANCED_FACE('" + std::string(name) + "',");
    std::ofstream(shop.path("named.step")) << text;
    const auto named = [&](const char* file) {
        return json::parse(runKnead({"info", shop.qPath(file), "--json"}).out).at("parts")[0].at("named_faces");
    };
    const json before = named("named.step");
    QCOMPARE(before.size(), std::size_t{3});
    QCOMPARE(before[0].at("name").get<std::string>(), std::string("seat"));
    const std::string said = runKnead({"info", shop.qPath("named.step")}).out;
    QVERIFY2(said.find("faces \"bore\": ") != std::string::npos, said.c_str());
    const Outcome bent =
        runKnead({"morph", shop.qPath("named.step"), "--twist", "10", "--output", shop.qPath("bent.step")});
    QVERIFY2(bent.status == 0, bent.errors.c_str());
    QVERIFY(named("bent.step") == before);
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

/// Any part moves visibly, and none so far that it is crushed.
void CommandLineTest::firstRecipeCanBeRun_data()
{
    QTest::addColumn<QString>("facets");
    QTest::addColumn<double>("size"); // [mm]
    QTest::addColumn<int>("axis");    // along which the block goes
    const auto row = [](const char* name, const std::string& facets, double size, int axis) {
        QTest::newRow(name) << QString::fromStdString(facets) << size << axis;
    };
    row("bar", boxFacets({0, 0, 0}, {40, 10, 10}), 42.4, 2);
    row("plate", boxFacets({5, -3, 2}, {85, 47, 5}), 94.4, 2);
    row("standing plate", boxFacets({0, 0, 0}, {3, 50, 80}), 94.4, 0);
    row("block", boxFacets({0, 0, 0}, {20, 24, 22}), 38.2, 0);
    row("box with walls", boxFacets({0, 0, 0}, {30, 26, 22}) + boxFacets({3, 3, 3}, {27, 23, 19}, true), 45.4, 2);
}

void CommandLineTest::firstRecipeCanBeRun()
{
    QFETCH(QString, facets);
    QFETCH(double, size);
    QFETCH(int, axis);
    const Workshop shop;
    std::ofstream(shop.path("part.stl")) << "solid part\n" << facets.toStdString() << "endsolid part\n";
    const Outcome written = runKnead({"recipe", shop.qPath("part.stl"), "--output", shop.qPath("first.recipe.json")});
    QVERIFY2(written.status == 0, written.errors.c_str());
    json recipe = json::parse(std::ifstream(shop.path("first.recipe.json")));
    QCOMPARE(recipe.at("part").at("file").get<std::string>(), std::string("part.stl"));
    const json& block = recipe.at("manipulators")[0];
    for (std::size_t i = 0; i < 3; ++i)
        QCOMPARE(block.at("position_mm")[i] != block.at("keyframes")[0].at("position_mm")[i],
                 static_cast<int>(i) == axis);
    recipe["objects"] = 800;
    const Outcome outcome = runKnead({"run", shop.write(recipe), "--out", shop.qPath("out"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    const json report = json::parse(outcome.out);
    QVERIFY2(report.at("tools")[0].at("peak_force_n").get<double>() > 0, "the block reaches the part");
    const double share = report.at("bodies")[0].at("largest_displacement_mm").get<double>() / size;
    QVERIFY2(share > 0.03 && share < 0.3, std::to_string(share).c_str());
    QCOMPARE(shop.filesUnder("out"), (QStringList{"part-pressed.png", "part-pressed.step", "part-pressed.stl"}));
}

/// A recipe that holds all of a part moves nothing, and says so.
void CommandLineTest::stillnessIsSaid()
{
    const Workshop shop;
    json recipe = pressRecipe();
    recipe.erase("exports");
    for (const bool isHeld : {true, false}) {
        if (isHeld)
            recipe["fixtures"][0]["box_mm"] = {-1, -1, -1, 41, 11, 11};
        else
            recipe["fixtures"][0]["box_mm"] = {-1, -1, -1, 2, 11, 11};
        const Outcome outcome = runKnead({"run", shop.write(recipe)});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        QCOMPARE((outcome.out + outcome.errors).find("Nothing moved by more than") != std::string::npos, isHeld);
    }
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
        const Outcome outcome = runKnead({"run", shop.write(recipe)});
        QVERIFY2(outcome.status == 0, (name.toStdString() + ": " + outcome.errors).c_str());
    }
}

void CommandLineTest::importOptionsAreHeeded()
{
    const QString bracket = QString(KNEAD_RESOURCES) + "/examples/bracket.step";
    const Outcome chosen =
        runKnead({"info", bracket, "--json", "--part", "bracket/Bushing", "--unit", "cm", "--no-heal"});
    QVERIFY2(chosen.status == 0, chosen.errors.c_str());
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(chosen.out)).object();
    QCOMPARE(json["unit"].toString(), QString("cm"));
    QCOMPARE(json["missing"].toArray().size(), 0);
    QVERIFY(json["unit_remark"].isNull());
    QCOMPARE(json["parts"].toArray().size(), 1);
    const QJsonObject part = json["parts"][0].toObject();
    QCOMPARE(part["path"].toString(), QString("bracket/Bushing"));
    QCOMPARE(part["hidden"].toBool(true), false);
    QCOMPARE(part["layer"].toString("none"), QString());
    QVERIFY(part["repairs"].isArray());

    const Outcome before =
        runKnead({"info", "--part", "bracket/Bushing", "--unit", "cm", "--no-heal", bracket, "--json"});
    QVERIFY2(before.out == chosen.out, "options may stand before the file");

    const Outcome all = runKnead({"info", bracket, "--json"});
    const QJsonArray parts = QJsonDocument::fromJson(QByteArray::fromStdString(all.out)).object()["parts"].toArray();
    QCOMPARE(parts.size(), 2);
    QVERIFY(std::abs(part["volume_mm3"].toDouble() / parts[1].toObject()["volume_mm3"].toDouble() - 1000) < 1e-6);

    QCOMPARE(runKnead({"info", bracket, "--unit", "parsec"}).status, 2);
    QCOMPARE(runKnead({"info", bracket, "--part", "bracket/Wheel"}).status, 2);
}

QTEST_GUILESS_MAIN(CommandLineTest)
#include "command_line_test.moc"
