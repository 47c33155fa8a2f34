#include "support/workshop.h"

#include <QtTest>

#include <csignal>

using namespace workshop;

namespace {

const std::string examples = std::string(KNEAD_RESOURCES) + "/examples/";

/// A bar that sags by 8 mm at its end and grows, and sags more where it is bent upward already:
///   u(Y) = (-2 s Y.z / 160, 0.004 Y.y, s + 0.05 Y.z),  s = 8 (Y.x / 160)^2, in mm
/// of the nodes of a mesh. In round 2 it waits where it is told to hold.
constexpr const char* warp = R"(if [ "$3" = 2 ] && [ -e "$4/hold" ]; then echo $$ > "$4/held"; exec sleep 600; fi
exec awk -v field="$2" 'BEGIN { FS = ","; print "X,Y,Z,DX,DY,DZ" > field }
    /^\*/ { isNode = /^\*NODE/; next }
    isNode { s = 8 * ($2 / 160)^2
             printf "%.12g,%.12g,%.12g,%.12g,%.12g,%.12g\n", $2, $3, $4, -2 * s * $4 / 160, 0.004 * $3, s + 0.05 * $4 > field }' "$1"
)";

/// A compensation of the warp.
json studyOfWarp()
{
    return {{"version", 1},
            {"part", examples + "bar.step"},
            {"tolerance_mm", 0.4},
            {"rounds", 4},
            {"spacing_mm", 10},
            {"command", {"sh", "{study}/warp.sh", "{mesh}", "{field}", "{round}", "{study}"}},
            {"field", {{"file", "warped.csv"}, {"unit", "mm"}}},
            {"mesh_spacing_mm", 10}};
}

/// Bends a bar by a grip and lets it go.
json bendingRecipe()
{
    json recipe = json::parse(R"({
        "version": 1, "spacing_mm": 5, "material": {"preset": "plasticine"},
        "analysis": "static", "load_steps": 8, "duration_s": 1,
        "fixtures": [{"name": "vice", "faces": [0]}, {"name": "grip", "faces": [1], "velocity_mm_s": [0, 0, -50]}],
        "events": [{"time_s": 0.75, "remove_fixture": "grip"}]})");
    recipe["part"]["file"] = examples + "bar.step";
    return recipe;
}

std::string contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : "";
}

/// Largest deviations of the rounds [mm].
std::vector<double> deviationsIn(const QString& folder)
{
    std::vector<double> deviations;
    std::istringstream lines(contentOf(folder + "/rounds.csv"));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line))
        deviations.push_back(QString::fromStdString(line).section(',', 2, 2).toDouble());
    return deviations;
}

/// The largest deviation is down to 5 % of the first within four rounds.
bool isCompensated(const QString& folder)
{
    const std::vector<double> deviations = deviationsIn(folder);
    for (std::size_t i = 0; i < deviations.size(); ++i)
        qInfo("round %zu: %.4f mm", i + 1, deviations[i]);
    return deviations.size() > 1 && deviations.size() <= 4 &&
           *std::min_element(deviations.begin(), deviations.end()) <= 0.05 * deviations[0];
}

} // namespace

/// Compensations as a person starts them.
class CompensateTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void aWarpIsCompensated();
    void aKilledCompensationGoesOn();
    void anotherStudyInTheFolderIsRefused();
    void moreRoundsGoOn();
    void whatComesOutMayBeScanned();
    void springbackOfARecipeIsCompensated();
    void theBracketOfTheExamplesIsCompensated();
    void whatGoesWrongIsASentence_data();
    void whatGoesWrongIsASentence();
    void studiesAreReadStrictly_data();
    void studiesAreReadStrictly();

private:
    Outcome compensate(const QString& study, const QString& folder, const QStringList& more = {}) const
    {
        return runKnead(QStringList{"compensate", study, "--out", folder} + more);
    }

    Workshop m_shop;
    QString m_study;
    QString m_folder; ///< of the warp, compensated
};

void CompensateTest::initTestCase()
{
    std::ofstream(m_shop.path("warp.sh")) << warp;
    m_study = m_shop.write(studyOfWarp(), "study.json");
    m_folder = m_shop.qPath("reference");
    const Outcome outcome = compensate(m_study, m_folder);
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QVERIFY2(outcome.out.find("0 finished before\n") != std::string::npos, outcome.out.c_str());
    QVERIFY2(outcome.errors.find("knead: round 1: largest deviation 9.") != std::string::npos, outcome.errors.c_str());
}

void CompensateTest::aWarpIsCompensated()
{
    QVERIFY(isCompensated(m_folder));
    QVERIFY(deviationsIn(m_folder)[1] > 0.4); // one round was not enough
    for (const char* file :
         {"part.step", "mesh.inp", "warped.csv", "log.txt", "round.json", "deviations.csv", "deviations.vtu"})
        QVERIFY2(QFile::exists(m_folder + "/round-02/" + file), file);
    QVERIFY(contentOf(m_folder + "/rounds.svg").find("<polyline") != std::string::npos);
    const json report = json::parse(contentOf(m_folder + "/compensated.step.report.json"));
    QVERIFY2(report.at("sound").get<bool>(), report.dump().c_str());
    const Outcome info = runKnead({"info", m_folder + "/compensated.step", "--json"});
    const json part = json::parse(info.out).at("parts")[0];
    QVERIFY2(part.at("valid").get<bool>() && part.at("name") == "Bar", info.out.c_str());
    QCOMPARE(part.at("faces").get<int>(), 6);
}

void CompensateTest::aKilledCompensationGoesOn()
{
    const QString folder = m_shop.qPath("killed");
    std::ofstream(m_shop.path("hold")) << "";
    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM, {"compensate", m_study, "--out", folder});
    while (contentOf(m_shop.qPath("held")).find('\n') == std::string::npos && !process.waitForFinished(20)) {}
    const int command = std::stoi("0" + contentOf(m_shop.qPath("held")));
    QVERIFY(command > 0);
    process.kill();
    QVERIFY(process.waitForFinished(10'000));
    QTRY_VERIFY_WITH_TIMEOUT(::kill(command, 0) != 0, 10'000); // it ended with the program
    QFile::remove(m_shop.qPath("hold"));
    QVERIFY(!QFile::exists(folder + "/compensated.step"));
    const QDateTime first = QFileInfo(folder + "/round-01/round.json").lastModified();

    const Outcome outcome = compensate(m_study, folder);
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QVERIFY2(outcome.out.find(" rounds, 1 finished before\n") != std::string::npos, outcome.out.c_str());
    QCOMPARE(QFileInfo(folder + "/round-01/round.json").lastModified(), first);
    QCOMPARE(contentOf(folder + "/rounds.csv"), contentOf(m_folder + "/rounds.csv"));
    QCOMPARE(contentOf(folder + "/round-02/round.json"), contentOf(m_folder + "/round-02/round.json"));
}

void CompensateTest::anotherStudyInTheFolderIsRefused()
{
    json study = studyOfWarp();
    study["factor"] = 0.5;
    const Outcome outcome = compensate(m_shop.write(study, "other.json"), m_folder);
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.errors, "knead: " + m_folder.toStdString() +
                                 ": the compensation in this folder is of another study: its \"factor\" was another. "
                                 "Choose another folder with --out, or begin anew with --restart.\n");
}

void CompensateTest::moreRoundsGoOn()
{
    json study = studyOfWarp();
    study["rounds"] = 1;
    study["spacing_mm"] = 20;
    const QString folder = m_shop.qPath("more");
    const Outcome first = compensate(m_shop.write(study, "one.json"), folder);
    QCOMPARE(first.status, 1);
    QVERIFY2(first.errors.find("and not within 0.4 mm. More \"rounds\" go on from there.\n") != std::string::npos,
             first.errors.c_str());
    study["rounds"] = 2;
    compensate(m_shop.write(study, "one.json"), folder);
    QCOMPARE(deviationsIn(folder).size(), std::size_t{2});
}

/// The bar sags by 5 mm at its end, and is measured as a mesh.
void CompensateTest::whatComesOutMayBeScanned()
{
    std::ofstream table(m_shop.path("sag.csv"));
    table << "X,Y,Z,DX,DY,DZ\n";
    for (int x = -40; x <= 200; x += 20)
        for (int y = -20; y <= 40; y += 20)
            for (int z = -20; z <= 40; z += 20)
                table << x << ',' << y << ',' << z << ",0,0," << -5.0 * x * x / (160.0 * 160.0) << '\n';
    table.close();
    json study = studyOfWarp();
    study["rounds"] = 2;
    study["tolerance_mm"] = 0.01;
    study["command"] = {KNEAD_PROGRAM, "morph", "{part}", "--field", "{study}/sag.csv", "--output", "{field}"};
    study["field"] = {{"file", "scan.stl"}, {"in_place", true}};
    study.erase("mesh_spacing_mm");
    const QString folder = m_shop.qPath("scanned");
    compensate(m_shop.write(study, "scanned.json"), folder);
    const std::vector<double> deviations = deviationsIn(folder);
    QCOMPARE(deviations.size(), std::size_t{2});
    QVERIFY2(std::abs(deviations[0] - 5) < 0.3, qPrintable(QString::number(deviations[0])));
    QVERIFY2(deviations[1] < 0.2 * deviations[0], qPrintable(QString::number(deviations[1])));
}

void CompensateTest::springbackOfARecipeIsCompensated()
{
    m_shop.write(bendingRecipe(), "bend.recipe.json");
    const json study{{"version", 1},
                     {"part", examples + "bar.step"},
                     {"recipe", "bend.recipe.json"},
                     {"tolerance_mm", 0.5},
                     {"rounds", 4},
                     {"spacing_mm", 10}};
    const QString folder = m_shop.qPath("springback");
    const Outcome outcome = compensate(m_shop.write(study, "springback.json"), folder);
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QVERIFY(isCompensated(folder));
}

/// By the shrinkage that CalculiX finds.
void CompensateTest::theBracketOfTheExamplesIsCompensated()
{
    const QString folder = m_shop.qPath("bracket");
    const Outcome outcome = compensate(QString::fromStdString(examples + "warped-bracket/study.json"), folder);
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QVERIFY(isCompensated(folder));
    const json report = json::parse(contentOf(folder + "/compensated.step.report.json"));
    QVERIFY2(report.at("sound").get<bool>(), report.dump().c_str());
}

void CompensateTest::whatGoesWrongIsASentence_data()
{
    QTest::addColumn<QString>("changes");
    QTest::addColumn<QString>("sentence");
    const auto shell = [](const char* script) { return QString(R"({"command": ["sh", "-c", "%1"]})").arg(script); };
    QTest::newRow("failure") << shell("echo; echo no license >&2; exit 3")
                             << "Round 1: the command failed with exit status 3; it printed last: no license (";
    QTest::newRow("no field") << shell("true") << "Round 1: the command left no file warped.csv; it printed nothing. (";
    QTest::newRow("empty field") << shell(": > {field}") << "Round 1: the command left an empty file warped.csv; ";
    QTest::newRow("hangs") << R"({"command": ["sleep", "600"], "time_limit_s": 0.5})"
                           << "Round 1: the command took longer than the 0.5 s that \"time_limit_s\" gives it; ";
    QTest::newRow("no such program") << R"({"command": ["no-such-solver"]})"
                                     << "no-such-solver cannot be started: No such file or directory";
    QTest::newRow("crash") << shell("kill -SEGV $$") << "Round 1: the command crashed (memory access); ";
    QTest::newRow("another unit") << R"({"field": {"file": "warped.csv", "unit": "m"}})"
                                  << "; say its unit in \"field\", or let the command leave the part where it is.";
    QTest::newRow("no such face") << R"({"faces": {"Bar": [6]}})"
                                  << "\"faces\" names face 6 of Bar, which has 6; ";
}

void CompensateTest::whatGoesWrongIsASentence()
{
    QFETCH(QString, changes);
    QFETCH(QString, sentence);
    json study = studyOfWarp();
    study.update(json::parse(changes.toStdString()));
    study["spacing_mm"] = 20;
    const Outcome outcome =
        compensate(m_shop.write(study, "wrong.json"), m_shop.qPath("wrong"), {"--restart", "--yes"});
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.errors.find(sentence.toStdString()) != std::string::npos, outcome.errors.c_str());
    QCOMPARE(lineCount(outcome.errors), std::size_t{1});
    QVERIFY(!QFile::exists(m_shop.qPath("wrong/compensated.step")));
}

void CompensateTest::studiesAreReadStrictly_data()
{
    QTest::addColumn<QString>("changes");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("unknown key") << R"({"round": 3})"
                                 << "round is not a known key; allowed here: version, part, ";
    QTest::newRow("no tolerance") << R"({"tolerance_mm": 0})"
                                  << "tolerance_mm must be a positive number, got 0.";
    QTest::newRow("both ways") << R"({"recipe": "warp.sh"})"
                               << "must have exactly one of the keys recipe and command.";
    QTest::newRow("neither") << R"({"command": []})"
                             << "must have exactly one of the keys recipe and command.";
    QTest::newRow("folders")
        << R"({"field": "a/b.csv"})"
        << "field must be the name of a file in the folder of the round, without folders, got \"a/b.csv\".";
    QTest::newRow("unit") << R"({"field": {"file": "b.csv", "unit": "elle"}})"
                          << "field.unit must be one of ";
    QTest::newRow("no part") << R"({"part": "nothing.step"})"
                             << "part";
    QTest::newRow("no face") << R"({"faces": {"Bar": []}})"
                             << "must name a face; leave the part out where none counts.";
    QTest::newRow("twice") << R"({"files": ["warp.sh", ")" + m_shop.qPath("warp.sh") + R"("]})"
                           << "has the name of another one; all of them go into one folder.";
}

void CompensateTest::studiesAreReadStrictly()
{
    QFETCH(QString, changes);
    QFETCH(QString, sentence);
    json study = studyOfWarp();
    study.update(json::parse(changes.toStdString()));
    const Outcome outcome = compensate(m_shop.write(study, "strict.json"), m_shop.qPath("strict"));
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.errors.find(sentence.toStdString()) != std::string::npos, outcome.errors.c_str());
    QCOMPARE(lineCount(outcome.errors), std::size_t{1});
    QVERIFY(!QFile::exists(m_shop.qPath("strict")));
}

QTEST_GUILESS_MAIN(CompensateTest)
#include "compensate_test.moc"
