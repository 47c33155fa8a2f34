#include "support/skip.h"
#include "support/slurm_cluster.h"
#include "support/sweeps.h"

#include <QtTest>

#include <csignal>

using namespace sweeps;

/// Sweeps as job arrays of a real Slurm of one node, which is started for this test.
class SweepSlurmTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void withoutSlurmThereIsASentence();
    void theTableIsThatOfThisMachine();
    void anInterruptedSweepTakesUpItsJobs();
    void vanishedTasksAreSubmittedAgain();
    void longSweepsTakeSeveralArrays();
    void refusalsOfSlurmAreASentence();
    void roundsOfACompensationAreJobs();

private:
    QStringList arguments(const QString& folder, const QStringList& more) const
    {
        return sweepArguments(m_recipe, folder, QStringList{"--engine", "slurm"} + more);
    }
    /// Ids of the jobs submitted for a sweep.
    static QStringList jobsIn(const QString& folder);
    /// Starts a sweep, and interrupts it as Ctrl+C does once its jobs are in Slurm.
    Outcome interrupted(const QStringList& sweep, const QString& folder) const;

    SlurmCluster m_cluster;
    QString m_missing; ///< why there is no Slurm
    Workshop m_shop;
    QString m_recipe;
};

QStringList SweepSlurmTest::jobsIn(const QString& folder)
{
    QStringList ids;
    const std::string text = contentOf(folder + "/slurm/jobs.json");
    for (const json& job : json::parse(text.empty() ? "[]" : text))
        ids << QString::fromStdString(job.at("job").get<std::string>());
    return ids;
}

Outcome SweepSlurmTest::interrupted(const QStringList& sweep, const QString& folder) const
{
    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM, sweep);
    while (jobsIn(folder).isEmpty() && !process.waitForFinished(50)) {}
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    process.waitForFinished(30'000);
    return {process.exitCode(), process.readAllStandardOutput().toStdString(),
            process.readAllStandardError().toStdString()};
}

void SweepSlurmTest::initTestCase()
{
    m_recipe = m_shop.write(tinyRecipe());
    m_missing = m_cluster.start();
}

void SweepSlurmTest::withoutSlurmThereIsASentence()
{
    const QByteArray path = qgetenv("PATH");
    qputenv("PATH", "/nowhere");
    const Outcome outcome = runKnead(arguments(m_shop.qPath("no slurm"), {"--vary", "spacing_mm=5"}));
    qputenv("PATH", path);
    QCOMPARE(outcome.status, 1);
    QCOMPARE(outcome.errors,
             std::string(
                 "knead: There is no command sbatch on this machine. --engine slurm is for machines from which jobs of "
                 "Slurm are submitted; leave it out to run here.\n"));
}

void SweepSlurmTest::theTableIsThatOfThisMachine()
{
    if (!m_missing.isEmpty())
        KNEAD_SKIP_WITHOUT("slurm", qPrintable("Slurm cannot be started: " + m_missing));
    const QStringList points{"--vary", "spacing_mm=5,-1,4", "--vary", "material.youngs_modulus_pa=1e5:1e6:log:3"};
    const QString here = m_shop.qPath("here");
    const QString there = m_shop.qPath("the folder's name");
    QCOMPARE(runKnead(sweepArguments(m_recipe, here, points)).status, 1);
    const Outcome outcome = runKnead(arguments(there, points + QStringList{"--threads", "2", "--jobs", "1"}));
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.out.starts_with("9 points, 0 finished before, 3 failed\n"), outcome.out.c_str());
    QCOMPARE(lineCount(tableIn(there)), std::size_t(10));
    QCOMPARE(tableIn(there), tableIn(here));
    QCOMPARE(jobsIn(there).size(), 1);

    // What is there is not submitted again.
    const Outcome again = runKnead(arguments(there, points));
    QVERIFY2(again.out.starts_with("9 points, 9 finished before, 3 failed\n"), again.out.c_str());
    QCOMPARE(jobsIn(there).size(), 1);
}

void SweepSlurmTest::anInterruptedSweepTakesUpItsJobs()
{
    if (!m_missing.isEmpty())
        KNEAD_SKIP_WITHOUT("slurm", qPrintable("Slurm cannot be started: " + m_missing));
    const QString folder = m_shop.qPath("interrupted");
    const QStringList sweep = arguments(folder, {"--vary", "spacing_mm=5,6,7,8", "--slurm-option=--begin=now+5"});
    const Outcome outcome = interrupted(sweep, folder);
    QCOMPARE(outcome.status, 130);
    const QStringList jobs = jobsIn(folder);
    QCOMPARE(jobs.size(), 1);
    QCOMPARE(outcome.errors,
             "knead: interrupted after 0 of 4 points; the same command goes on from there. Its jobs go on in "
             "Slurm; scancel " +
                 jobs[0].toStdString() + " ends them.\n");
    const Outcome again = runKnead(sweep);
    QVERIFY2(again.status == 0, again.errors.c_str());
    QCOMPARE(jobsIn(folder), jobs);
    QCOMPARE(lineCount(tableIn(folder)), std::size_t(5));
}

void SweepSlurmTest::vanishedTasksAreSubmittedAgain()
{
    if (!m_missing.isEmpty())
        KNEAD_SKIP_WITHOUT("slurm", qPrintable("Slurm cannot be started: " + m_missing));
    const QString folder = m_shop.qPath("vanished");
    const QStringList points{"--vary", "spacing_mm=5,6,7"};
    interrupted(arguments(folder, points + QStringList{"--slurm-option=--hold"}), folder);
    const QString job = jobsIn(folder).value(0);
    SlurmCluster::answerOf("scontrol", {"release", job + "_0"});
    QTRY_COMPARE_WITH_TIMEOUT(resultsIn(folder), 1, 30'000);

    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM, arguments(folder, points));
    std::string said; // after ten seconds, that it waits for the tasks that are held
    while (said.find("1 of 3 points, 2 in Slurm") == std::string::npos && !process.waitForFinished(50))
        said += process.readAllStandardError().toStdString();
    QCOMPARE(process.state(), QProcess::Running);
    QCOMPARE(jobsIn(folder), QStringList{job});
    SlurmCluster::answerOf("scancel", {job});
    QVERIFY(process.waitForFinished(60'000));
    QCOMPARE(process.exitCode(), 1);
    said += process.readAllStandardError().toStdString();
    const std::string sentence =
        "The task " + job.toStdString() +
        "_2 of point 2 vanished from Slurm without a result. The same command submits it again.";
    QVERIFY2(said.find("knead: " + sentence + "\n") != std::string::npos, said.c_str());
    QVERIFY2(tableIn(folder).find("\n2,7,," + sentence + ",") != std::string::npos, tableIn(folder).c_str());

    const Outcome again = runKnead(arguments(folder, points));
    QVERIFY2(again.status == 0, again.errors.c_str());
    QVERIFY2(again.out.starts_with("3 points, 1 finished before, 0 failed\n"), again.out.c_str());
    QCOMPARE(jobsIn(folder).size(), 2);
}

/// A thousand results are put there by hand.
void SweepSlurmTest::longSweepsTakeSeveralArrays()
{
    if (!m_missing.isEmpty())
        KNEAD_SKIP_WITHOUT("slurm", qPrintable("Slurm cannot be started: " + m_missing));
    const QString folder = m_shop.qPath("long");
    const QStringList sweep = arguments(folder, {"--vary", "material.youngs_modulus_pa=1e5:2.002e5:lin:1003"});
    interrupted(sweep + QStringList{"--slurm-option=--hold"}, folder);
    const QStringList jobs = jobsIn(folder);
    for (const QString& job : jobs)
        SlurmCluster::answerOf("scontrol", {"release", job + "_0"});
    QTRY_COMPARE_WITH_TIMEOUT(resultsIn(folder), jobs.size(), 30'000);
    for (const QString& job : jobs)
        SlurmCluster::answerOf("scancel", {job});
    json result = json::parse(contentOf(folder + "/points/00000.json"));
    for (const int point : {1000, 1001, 1002})
        QFile::remove(folder + QString("/points/%1.json").arg(point, 5, 10, QChar('0')));
    for (int point = 1; point < 1000; ++point) {
        result["point"] = point;
        std::ofstream((folder + QString("/points/%1.json").arg(point, 5, 10, QChar('0'))).toStdString()) << result;
    }
    QFile::remove(folder + "/points/00003.json");

    const Outcome outcome = runKnead(sweep);
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QVERIFY2(outcome.out.starts_with("1003 points, 999 finished before, 0 failed\n"), outcome.out.c_str());
    QCOMPARE(jobsIn(folder).size(), jobs.size() + 2);
    const auto hashOf = [&](const char* point) {
        return json::parse(contentOf(folder + "/points/" + point + ".json")).at("report").at("state_hash");
    };
    QVERIFY(hashOf("00003") != hashOf("01002"));
    const json alone = json::parse(
        runKnead({"run", m_recipe, "--json", "--set", "material.youngs_modulus_pa=200200", "--set", "exports=null"})
            .out);
    QCOMPARE(hashOf("01002"), alone.at("state_hash"));
}

void SweepSlurmTest::refusalsOfSlurmAreASentence()
{
    if (!m_missing.isEmpty())
        KNEAD_SKIP_WITHOUT("slurm", qPrintable("Slurm cannot be started: " + m_missing));
    const Outcome outcome = runKnead(
        arguments(m_shop.qPath("refused"), {"--vary", "spacing_mm=5", "--slurm-option", "--partition=nowhere"}));
    QCOMPARE(outcome.status, 1);
    QCOMPARE(
        outcome.errors,
        std::string("knead: Slurm refuses the jobs: invalid partition specified: nowhere; Batch job submission "
                    "failed: Invalid partition name specified. Options for sbatch are given with --slurm-option.\n"));
}

/// A bar that is too long by a hundredth. Interrupted in its second round, it takes up the job that goes on.
void SweepSlurmTest::roundsOfACompensationAreJobs()
{
    if (!m_missing.isEmpty())
        KNEAD_SKIP_WITHOUT("slurm", qPrintable("Slurm cannot be started: " + m_missing));
    const json study{{"version", 1},
                     {"part", std::string(KNEAD_RESOURCES) + "/examples/bar.step"},
                     {"tolerance_mm", 0.05},
                     {"spacing_mm", 20},
                     {"mesh_spacing_mm", 10},
                     {"field", {{"file", "longer.csv"}, {"unit", "mm"}}},
                     {"command",
                      {"sh", "-c",
                       "echo round {round}; while [ {round} = 2 ] && [ ! -e {study}/go ]; do sleep 0.1; done; "
                       "awk -F, -v f={field} '/^\\*/ { n = /^\\*NODE/; next } n { print $2 \",\" $3 \",\" $4 \",\" $2 "
                       "/ 100 \",0,0\" > f }' {mesh}"}}};
    const QString folder = m_shop.qPath("compensation");
    const QStringList arguments{"compensate", m_shop.write(study, "study.json"), "--out", folder, "--engine", "slurm"};
    QProcess process;
    process.setProcessEnvironment(serverEnvironment());
    process.start(KNEAD_PROGRAM, arguments);
    while (contentOf(folder + "/round-02/log.txt").empty() && !process.waitForFinished(50)) {}
    const std::string job = contentOf(folder + "/round-02/jobs.json");
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QVERIFY(process.waitForFinished(30'000));
    QCOMPARE(process.exitCode(), 130);
    std::ofstream(m_shop.path("go")) << "";
    const Outcome outcome = runKnead(arguments);
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QVERIFY2(outcome.out.find("2 rounds, 1 finished before\n") != std::string::npos, outcome.out.c_str());
    QCOMPARE(contentOf(folder + "/round-02/jobs.json"), job);
}

QTEST_GUILESS_MAIN(SweepSlurmTest)
#include "sweep_slurm_test.moc"
