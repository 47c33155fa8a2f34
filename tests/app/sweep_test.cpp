#include "support/sweeps.h"

#include <QtTest>

#include <csignal>
#include <map>

using namespace sweeps;

/// Sweeps on this machine. The table is the same however it came about.
class SweepTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void everyRowIsARunOfItsOwn();
    void anyNumberOfJobsGivesTheSameTable();
    void aKilledSweepGoesOn();
    void anInterruptedSweepGoesOn();
    void runsEndWithTheSweep_data();
    void runsEndWithTheSweep();
    void failuresAreRows();
    void whatCannotBeDoneIsRefused();
    void anotherSweepInTheFolderIsRefused_data();
    void anotherSweepInTheFolderIsRefused();
    void anInputThatChangesMeanwhileStopsTheSweep();
    void restartBeginsAnew();
    void damagedResultsAreMadeAgain();
    void exportsAreKeptWhenAskedFor();

private:
    /// Ends with the results of `points` points at least, or when the sweep has ended.
    void waitForResults(QProcess& process, const QString& folder, int points) const;

    Workshop m_shop;
    QString m_recipe;
    std::string m_table; ///< of the twenty points
};

namespace {

/// The results of a row by their columns.
std::map<QString, QString> cellsOf(const std::string& table, std::size_t row)
{
    const std::vector<QStringList> rows = rowsOf(table);
    std::map<QString, QString> cells;
    for (qsizetype i = 0; i < std::min(rows[0].size(), rows[row].size()); ++i)
        cells[rows[0][i]] = rows[row][i];
    return cells;
}

/// Of all threads of a process.
std::vector<pid_t> childrenOf(qint64 process)
{
    std::vector<pid_t> children;
    const QString tasks = "/proc/" + QString::number(process) + "/task";
    for (const QString& task : QDir(tasks).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        std::ifstream file((tasks + "/" + task + "/children").toStdString());
        for (pid_t child = 0; file >> child;)
            children.push_back(child);
    }
    return children;
}

/// One that has ended may still wait for somebody to take notice.
bool isRunning(pid_t process)
{
    const std::string state = contentOf(QString("/proc/%1/stat").arg(process));
    return !state.empty() && state.find(") Z ") == std::string::npos;
}

} // namespace

void SweepTest::initTestCase()
{
    m_recipe = m_shop.write(tinyRecipe());
    const QString folder = m_shop.qPath("reference");
    const Outcome outcome = runKnead(sweepArguments(m_recipe, folder, twentyPoints() + QStringList{"--jobs", "2"}));
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QVERIFY2(outcome.out.starts_with("20 points, 0 finished before, 0 failed\n"), outcome.out.c_str());
    m_table = tableIn(folder);
    QCOMPARE(lineCount(m_table), std::size_t(21));
    QCOMPARE(lineCount(contentOf(folder + "/timing.csv")), std::size_t(21));
    QCOMPARE(m_shop.filesUnder("reference").filter(".stl").size(), 0);
}

void SweepTest::everyRowIsARunOfItsOwn()
{
    for (const std::size_t point : {0, 7, 19}) {
        const std::map<QString, QString> row = cellsOf(m_table, point + 1);
        QCOMPARE(row.at("index").toULongLong(), static_cast<qulonglong>(point));
        const QString stiffness = row.at("material.youngs_modulus_pa");
        const QString size = row.at("manipulators.press.size_mm.0");
        QCOMPARE(size, QString::number(4 + point % 5));
        const Outcome alone =
            runKnead({"run", m_recipe, "--json", "--set", "material.youngs_modulus_pa=" + stiffness, "--set",
                      "manipulators.press.size_mm.0=" + size, "--out", m_shop.qPath("alone")});
        const json report = json::parse(alone.out);
        QCOMPARE(row.at("status"), QString("0"));
        QCOMPARE(row.at("state_hash").toStdString(), report.at("state_hash").get<std::string>());
        QCOMPARE(row.at("objects").toInt(), 81);
        QCOMPARE(row.at("energy_j.elastic").toDouble(), report.at("energy_j").at("elastic").get<double>());
        QCOMPARE(row.at("tools.press.force_n.z").toDouble(), report.at("tools")[0].at("force_n")[2].get<double>());
        QCOMPARE(row.at("bodies.bar.largest_displacement_mm").toDouble(),
                 report.at("bodies")[0].at("largest_displacement_mm").get<double>());
        QVERIFY(!row.contains("wall_s"));
    }
}

void SweepTest::anyNumberOfJobsGivesTheSameTable()
{
    const QString folder = m_shop.qPath("one");
    const QStringList more{"--jobs", "1", "--threads", "2"};
    QCOMPARE(runKnead(sweepArguments(m_recipe, folder, twentyPoints() + more)).status, 0);
    QCOMPARE(tableIn(folder), m_table);
}

void SweepTest::waitForResults(QProcess& process, const QString& folder, int points) const
{
    while (resultsIn(folder) < points && !process.waitForFinished(10)) {}
}

void SweepTest::aKilledSweepGoesOn()
{
    const QString folder = m_shop.qPath("killed");
    const QStringList arguments = sweepArguments(m_recipe, folder, twentyPoints() + QStringList{"--jobs", "2"});
    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM, arguments);
    waitForResults(process, folder, 5);
    process.kill();
    QVERIFY(process.waitForFinished(10'000));
    const int before = resultsIn(folder);
    QVERIFY2(before >= 5 && before < 20, std::to_string(before).c_str());
    QVERIFY(tableIn(folder).empty());
    const QDateTime first = QFileInfo(folder + "/points/00000.json").lastModified();

    const Outcome outcome = runKnead(arguments);
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QVERIFY2(outcome.out.starts_with("20 points, " + std::to_string(before) + " finished before, 0 failed\n"),
             outcome.out.c_str());
    QCOMPARE(tableIn(folder), m_table);
    QCOMPARE(QFileInfo(folder + "/points/00000.json").lastModified(), first);
}

void SweepTest::anInterruptedSweepGoesOn()
{
    const QString folder = m_shop.qPath("interrupted");
    const QStringList arguments = sweepArguments(m_recipe, folder, {"--vary", "spacing_mm=5,4.5,4,3.5,3,2.5"});
    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM, arguments);
    waitForResults(process, folder, 1);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(10'000));
    QCOMPARE(process.exitCode(), 130);
    const std::string said = process.readAllStandardError().toStdString();
    const int done = resultsIn(folder);
    QCOMPARE(said, "knead: interrupted after " + std::to_string(done) +
                       " of 6 points; the same command goes on from there.\n");
    QCOMPARE(runKnead(arguments).status, 0);
    QCOMPARE(lineCount(tableIn(folder)), std::size_t(7));
}

void SweepTest::runsEndWithTheSweep_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("interrupted") << SIGINT;
    QTest::newRow("killed") << SIGKILL;
}

void SweepTest::runsEndWithTheSweep()
{
    QFETCH(int, signal);
    const Workshop shop;
    json recipe = tinyRecipe();
    recipe["duration_s"] = 3600;
    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM,
                  sweepArguments(shop.write(recipe), shop.qPath("out"), {"--jobs", "2", "--vary", "spacing_mm=5,6,7"}));
    std::vector<pid_t> runs;
    QTRY_VERIFY_WITH_TIMEOUT((runs = childrenOf(process.processId())).size() == 2, 30'000);
    ::kill(static_cast<pid_t>(process.processId()), signal);
    QVERIFY(process.waitForFinished(10'000));
    for (const pid_t run : runs)
        QTRY_VERIFY_WITH_TIMEOUT(!isRunning(run), 10'000);
    QCOMPARE(resultsIn(shop.qPath("out")), 0);
}

void SweepTest::failuresAreRows()
{
    const QString folder = m_shop.qPath("failures");
    // A negative spacing is no recipe; a step of a second is not stable.
    const QStringList arguments = sweepArguments(
        m_recipe, folder, {"--zip", "--vary", "spacing_mm=5,-1,5", "--vary", "time_step_s=null,null,0.005"});
    const Outcome outcome = runKnead(arguments);
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.out.starts_with("3 points, 0 finished before, 2 failed\n"), outcome.out.c_str());
    const std::string sentence = "press.recipe.json with --set: spacing_mm must be a positive number, got -1.";
    QVERIFY2(outcome.errors.find("knead: point 1 failed: " + sentence + "\n") != std::string::npos,
             outcome.errors.c_str());
    const std::string table = tableIn(folder);
    QVERIFY2(table.find("\n1,-1,null,2,\"" + sentence + "\",,") != std::string::npos, table.c_str());
    QCOMPARE(cellsOf(table, 1).at("status"), QString("0"));
    QCOMPARE(cellsOf(table, 3).at("status"), QString("1"));

    // Failures are results: they are not made again.
    const Outcome again = runKnead(arguments);
    QCOMPARE(again.status, 1);
    QVERIFY2(again.out.starts_with("3 points, 3 finished before, 2 failed\n"), again.out.c_str());
    QCOMPARE(tableIn(folder), table);
}

void SweepTest::whatCannotBeDoneIsRefused()
{
    const auto refusal = [&](const QStringList& more) {
        const Outcome outcome = runKnead(sweepArguments(m_recipe, m_shop.qPath("none"), more));
        return outcome.status == 2 && lineCount(outcome.errors) == 1 ? outcome.errors : "accepted";
    };
    QCOMPARE(
        refusal({"--vary", "material.young=1e5:1e7:log:20"}),
        "knead: press.recipe.json with --set: material.young is not a known key; allowed here: preset, density_kg_m3, "
        "youngs_modulus_pa, poisson_ratio, damping_ratio, shape_damping_per_s, friction, rubberlike, "
        "second_invariant_share, locking_elongation, yield_stress_pa, hardening_pa, relaxation_time_s, "
        "tensile_strength_pa, elongation_at_break, toughness_j_m2, adhesion_pa, healing_time_s.\n");
    QVERIFY(refusal({"--vary", "spacing_mm=1:2"}).find("this is no range") != std::string::npos);
    QVERIFY(refusal({}).find("--vary is required") != std::string::npos);
    QVERIFY(refusal({"--vary", "spacing_mm=5", "--engine", "cloud"}).starts_with("knead: --engine"));
    QVERIFY(!QFileInfo::exists(m_shop.qPath("none")));

    const Outcome outcome = runKnead(sweepArguments(m_recipe, m_shop.qPath("bar.stl/out"), {"--vary", "spacing_mm=5"}));
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.errors.find("cannot be made; choose another one with --out.") != std::string::npos,
             outcome.errors.c_str());
}

void SweepTest::anotherSweepInTheFolderIsRefused_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("difference");
    QTest::newRow("other values") << QStringList{"--vary", "spacing_mm=5,6"} << "--vary was another";
    QTest::newRow("other settings") << QStringList{"--vary", "spacing_mm=5", "--set", "duration_s=0.02"}
                                    << "--set was another";
    QTest::newRow("exports") << QStringList{"--vary", "spacing_mm=5", "--exports"} << "it had no --exports";
    QTest::newRow("recipe") << QStringList{"--vary", "spacing_mm=5"} << "other.recipe.json has changed since";
    QTest::newRow("part") << QStringList{"--vary", "spacing_mm=5"} << "bar.stl has changed since";
}

void SweepTest::anotherSweepInTheFolderIsRefused()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, difference);
    const Workshop shop;
    const QString recipe = shop.write(tinyRecipe(), "other.recipe.json");
    const QString folder = shop.qPath("out");
    QCOMPARE(runKnead(sweepArguments(recipe, folder, {"--vary", "spacing_mm=5"})).status, 0);
    const std::string table = tableIn(folder);

    if (difference.startsWith("other.recipe.json"))
        std::ofstream(shop.path("other.recipe.json"), std::ios::app) << "\n";
    if (difference.startsWith("bar.stl"))
        std::ofstream(shop.path("bar.stl"), std::ios::app) << "\n";
    const Outcome outcome = runKnead(sweepArguments(recipe, folder, arguments));
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.errors, "knead: " + folder.toStdString() +
                                 ": the sweep in this folder is another one: " + difference.toStdString() +
                                 ". Choose another folder with --out, or begin anew with --restart.\n");
    QCOMPARE(tableIn(folder), table);
}

void SweepTest::anInputThatChangesMeanwhileStopsTheSweep()
{
    const Workshop shop;
    const QString recipe = shop.write(tinyRecipe());
    const QString folder = shop.qPath("out");
    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM, sweepArguments(recipe, folder, {"--jobs", "1", "--vary", "spacing_mm=5,4.5,4,3.5,3"}));
    waitForResults(process, folder, 1);
    std::ofstream(shop.path("press.recipe.json"), std::ios::app) << "\n";
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitCode(), 1);
    const std::string said = process.readAllStandardError().toStdString();
    QVERIFY2(said.starts_with("knead: press.recipe.json was changed while the sweep ran."), said.c_str());
    QVERIFY(resultsIn(folder) < 5);
}

void SweepTest::restartBeginsAnew()
{
    const QString folder = m_shop.qPath("restarted");
    QCOMPARE(runKnead(sweepArguments(m_recipe, folder, {"--vary", "spacing_mm=5,6"})).status, 0);
    std::ofstream((folder + "/notes.txt").toStdString()) << "mine";
    const Outcome outcome = runKnead(sweepArguments(m_recipe, folder, {"--restart", "--yes", "--vary", "spacing_mm=7"}));
    QVERIFY2(outcome.out.starts_with("1 point, 0 finished before, 0 failed\n"), outcome.out.c_str());
    QCOMPARE(lineCount(tableIn(folder)), std::size_t(2));
    QCOMPARE(resultsIn(folder), 1);
    QCOMPARE(contentOf(folder + "/notes.txt"), std::string("mine"));
}

void SweepTest::damagedResultsAreMadeAgain()
{
    const QString folder = m_shop.qPath("damaged");
    const QStringList arguments = sweepArguments(m_recipe, folder, {"--vary", "spacing_mm=5,6"});
    QCOMPARE(runKnead(arguments).status, 0);
    const std::string table = tableIn(folder);
    std::ofstream((folder + "/points/00001.json").toStdString()) << "{\"sweep\": ";
    const Outcome outcome = runKnead(arguments);
    QVERIFY2(outcome.out.starts_with("2 points, 1 finished before, 0 failed\n"), outcome.out.c_str());
    QCOMPARE(tableIn(folder), table);
}

void SweepTest::exportsAreKeptWhenAskedFor()
{
    const QStringList arguments =
        sweepArguments(m_recipe, m_shop.qPath("exported"), {"--exports", "--vary", "duration_s=0.005,0.01"});
    QCOMPARE(runKnead(arguments).status, 0);
    QCOMPARE(m_shop.filesUnder("exported").filter(".stl"),
             (QStringList{"points/00000/bent.stl", "points/00001/bent.stl"}));
    QVERIFY(contentOf(m_shop.qPath("exported/points/00000/bent.stl")) !=
            contentOf(m_shop.qPath("exported/points/00001/bent.stl")));
}

QTEST_GUILESS_MAIN(SweepTest)
#include "sweep_test.moc"
