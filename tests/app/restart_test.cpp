#include "app/sweep/slurm_commands.h"
#include "support/sweeps.h"

#include <QtTest>

#include <array>
#include <fstream>

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

using knead::isJobId;
using knead::jobsIn;
using knead::SlurmJob;
using namespace sweeps;

namespace {

/// What the program shows on a terminal when a person types a word there as soon as it asks.
std::string onTerminal(const QStringList& arguments, const std::string& word)
{
    std::vector<std::string> texts{KNEAD_PROGRAM};
    for (const QString& argument : arguments)
        texts.push_back(argument.toStdString());
    std::vector<char*> words;
    for (std::string& text : texts)
        words.push_back(text.data());
    words.push_back(nullptr);
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0) {
        execv(KNEAD_PROGRAM, words.data());
        _exit(127);
    }
    std::string shown;
    bool hasAnswered = false;
    std::array<char, 1024> block{};
    for (ssize_t count = 0; (count = read(terminal, block.data(), block.size())) > 0;) { // until its end
        shown.append(block.data(), static_cast<std::size_t>(count));
        if (!hasAnswered && shown.find("[y/N] ") != std::string::npos) {
            const std::string line = word + "\n";
            hasAnswered = write(terminal, line.data(), line.size()) > 0;
        }
    }
    waitpid(child, nullptr, 0);
    close(terminal);
    return shown;
}

} // namespace

/// What is thrown away, and what stands in command lines, is not left to chance.
class RestartTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { m_recipe = m_shop.write(tinyRecipe()); }
    void restartAsksWhereSomebodyIs();
    void onlyNumbersAreJobs();

private:
    Workshop m_shop;
    QString m_recipe;
};

/// On a terminal, and only when there is something to throw away.
void RestartTest::restartAsksWhereSomebodyIs()
{
    const QString folder = m_shop.qPath("asked");
    const QStringList first = sweepArguments(m_recipe, folder, {"--restart", "--vary", "spacing_mm=5"});
    QCOMPARE(runKnead(first).status, 0); // there is nothing yet
    const Outcome script = runKnead(first);
    QCOMPARE(script.status, 2);
    QCOMPARE(script.errors, "knead: " + folder.toStdString() +
                                ": --restart throws away what is in this folder, and there is nobody to be asked; say "
                                "--restart --yes, or choose another folder with --out.\n");
    const auto answer = [&](const std::string& word) {
        return onTerminal(sweepArguments(m_recipe, folder, {"--restart", "--vary", "spacing_mm=6"}), word);
    };
    const std::string refused = answer("n");
    QVERIFY2(refused.find("and begin anew? [y/N]") != std::string::npos, refused.c_str());
    QVERIFY2(refused.find("nothing was thrown away") != std::string::npos, refused.c_str());
    QVERIFY(tableIn(folder).find("\n0,5,") != std::string::npos);
    const std::string agreed = answer("y");
    QVERIFY2(agreed.find("1 point, 0 finished before, 0 failed") != std::string::npos, agreed.c_str());
    QVERIFY(tableIn(folder).find("\n0,6,") != std::string::npos);
}

/// The file that jobs are kept in may have been changed from outside, and they stand in command lines.
void RestartTest::onlyNumbersAreJobs()
{
    for (const char* id : {"1", "12345678"})
        QVERIFY2(isJobId(id), id);
    for (const char* id :
         {"", "-1", "1 2", "1;reboot", "--user=ann", "../../etc", "12_3", "1\n", "123456789012345678901"})
        QVERIFY2(!isJobId(id), id);
    std::ofstream(m_shop.path("jobs.json")) << R"([{"job": "17", "base": 1000}, {"job": "--user=ann", "base": 0},
        {"job": 18, "base": 0}, {"job": "19", "base": -1}, {"job": "20"}, 7, {"job": "../21", "base": 2}])";
    const std::vector<SlurmJob> jobs = jobsIn(m_shop.path("jobs.json"));
    QCOMPARE(jobs.size(), 1U);
    QCOMPARE(jobs[0].id, std::string("17"));
    QCOMPARE(jobs[0].base, 1000U);
    std::ofstream(m_shop.path("jobs.json")) << "no JSON";
    QVERIFY(jobsIn(m_shop.path("jobs.json")).empty());
}

QTEST_GUILESS_MAIN(RestartTest)
#include "restart_test.moc"
