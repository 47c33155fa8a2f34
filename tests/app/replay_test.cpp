// What was done in a project, repeated on the command line.
#include "app/hexadecimal.h"
#include "core/simulation/moment.h"
#include "io/project/packing.h"
#include "io/project/project_file.h"
#include "support/pressed_part.h"
#include "support/workshop.h"

#include <QtTest>

#include <csignal>

using namespace knead;
using namespace knead::sessions;
using namespace workshop;

namespace {

constexpr const char* bracket = KNEAD_RESOURCES "/examples/bracket.step";

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

class ReplayTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        m_project = packed(pressedPart(bracket, 0.004));
        QVERIFY(m_project.entries[2].hash != m_project.entries[1].hash);
        writeProject(m_shop.path("bracket.knead"), m_project);
    }

    void theSameForAnyNumberOfThreads()
    {
        for (const char* threads : {"1", "2"}) {
            const Outcome outcome =
                workshop::runKnead({"replay", m_shop.qPath("bracket.knead"), "--json", "--threads", threads});
            QVERIFY2(outcome.status == 0, outcome.errors.c_str());
            const json report = json::parse(outcome.out);
            QVERIFY(report.at("same").get<bool>());
            QCOMPARE(report.at("entries").size(), std::size_t{1});
            const json& entry = report.at("entries")[0];
            QCOMPARE(entry.at("entry").get<int>(), 4);
            QCOMPARE(entry.at("name").get<std::string>(), std::string("Push aside"));
            QCOMPARE(entry.at("step").get<std::uint64_t>(), m_project.entries[4].step);
            QCOMPARE(entry.at("repeated_hash"), entry.at("state_hash"));
            QCOMPARE(entry.at("whole_state").get<std::string>(), std::string("same"));
        }
    }

    void allBranchesInATable()
    {
        for (const QStringList& more : {QStringList{}, QStringList{"--from-moments"}}) {
            const Outcome outcome =
                workshop::runKnead(QStringList{"replay", m_shop.qPath("bracket.knead"), "--all"} + more);
            QVERIFY2(outcome.status == 0, outcome.errors.c_str());
            QCOMPARE(lineCount(outcome.out), std::size_t{6});
            QVERIFY2(outcome.out.starts_with("entry  name               "), outcome.out.c_str());
            QCOMPARE(QString::fromStdString(outcome.out).count("  same\n"), 5);
        }
    }

    void anotherStateIsTold()
    {
        Project other = m_project;
        other.entries[3].hash += 1;
        writeProject(m_shop.path("other.knead"), other);
        const Outcome one = workshop::runKnead({"replay", m_shop.qPath("other.knead"), "--entry", "3"});
        QCOMPARE(one.status, 1);
        QVERIFY2(one.out.find("different: ") != std::string::npos, one.out.c_str());
        QVERIFY2(one.errors.starts_with("knead: other.knead: 1 of 1 entries came to another state"),
                 one.errors.c_str());
        QCOMPARE(workshop::runKnead({"replay", m_shop.qPath("other.knead"), "--entry", "4"}).status, 0);
        QCOMPARE(workshop::runKnead({"replay", m_shop.qPath("other.knead"), "--all"}).status, 1);
    }

    void anEditThatMovesNothingIsProvenToo()
    {
        Project other = m_project;
        auto& commands = other.entries[1].commands; // the block that was added
        std::get<AddManipulator>(commands.at(0).command).manipulator.friction = 0.9;
        writeProject(m_shop.path("still.knead"), other);
        const Outcome one = workshop::runKnead({"replay", m_shop.qPath("still.knead"), "--entry", "1"});
        QCOMPARE(one.status, 1);
        QVERIFY2(
            one.out.find("  different: the same positions and velocities, but other materials, tools or forces\n") !=
                std::string::npos,
            one.out.c_str());
        const Outcome report = workshop::runKnead({"replay", m_shop.qPath("still.knead"), "--entry", "1", "--json"});
        const json entry = json::parse(report.out).at("entries").at(0);
        QCOMPARE(entry.at("repeated_hash"), entry.at("state_hash"));
        QCOMPARE(entry.at("whole_state").get<std::string>(), std::string("different"));
        other.entries[1].moment = nullptr;
        writeProject(m_shop.path("thinned.knead"), other);
        const Outcome thinned = workshop::runKnead({"replay", m_shop.qPath("thinned.knead"), "--entry", "1"});
        QCOMPARE(thinned.status, 0);
        QVERIFY2(thinned.out.find("  same positions and velocities; no more was kept\n") != std::string::npos,
                 thinned.out.c_str());
    }

    /// All formats but IGES, whose lists of names OpenCASCADE writes in any order.
    void exportsAreTheSameBytes_data()
    {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"step", "brep", "stl", "obj", "ply", "glb", "gltf", "3mf", "vtp", "png"})
            QTest::newRow(ending) << QString(ending);
    }
    void exportsAreTheSameBytes()
    {
        QFETCH(QString, ending);
        std::vector<std::string> bytes;
        for (const char* threads : {"1", "2"}) {
            const QString name = "part." + ending;
            const Outcome outcome = workshop::runKnead({"replay", m_shop.qPath("bracket.knead"), "--threads", threads,
                                                        "--export", m_shop.qPath("new/folder/") + name});
            QVERIFY2(outcome.status == 0, outcome.errors.c_str());
            QVERIFY2(outcome.out.find("wrote ") != std::string::npos, outcome.out.c_str());
            bytes.push_back(contentOf(m_shop.path("new/folder/") + name.toStdString()));
        }
        QVERIFY(!bytes[0].empty());
        QVERIFY(bytes[0] == bytes[1]);
    }

    void severalFilesOfAnEarlierEntry()
    {
        const Outcome outcome =
            workshop::runKnead({"replay", m_shop.qPath("bracket.knead"), "--entry", "0", "--export",
                                m_shop.qPath("rest.stl"), "--export", m_shop.qPath("rest.igs"), "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        const json report = json::parse(outcome.out);
        QCOMPARE(report.at("files"), (json{m_shop.path("rest.stl"), m_shop.path("rest.igs")}));
        QVERIFY(report.at("exports")[1].at("sound").get<bool>());
        QCOMPARE(lowestZ(m_shop.path("rest.stl")), static_cast<float>(1000 * m_project.model->parts[0].box.min().z()));
    }

    void whatCannotBeReadIsASentence_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* name, const QStringList& arguments, const char* words) {
            QTest::newRow(name) << arguments << words;
        };
        row("unknown entry", {m_shop.qPath("bracket.knead"), "--entry", "5"},
            "bracket.knead has no entry 5; it has 0 to 4.");
        row("no project", {bracket}, "this is not a Knead project.");
        row("damaged", {m_shop.qPath("damaged.knead")}, "the project is damaged: ");
        row("newer", {m_shop.qPath("newer.knead")}, "a newer Knead saved this project");
        row("empty", {m_shop.qPath("empty.knead")}, "has no history yet: there is nothing to repeat.");
        std::string bytes = contentOf(m_shop.path("bracket.knead"));
        std::ofstream(m_shop.path("newer.knead"), std::ios::binary)
            << std::string(bytes).replace(60, 4, std::string("\0\0\0\x07", 4));
        for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 5000; ++i)
            bytes[i] = static_cast<char>(bytes[i] ^ 0x55);
        std::ofstream(m_shop.path("damaged.knead"), std::ios::binary) << bytes;
        writeProject(m_shop.path("empty.knead"), Project{});
    }
    void whatCannotBeReadIsASentence()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        const Outcome outcome = workshop::runKnead(QStringList{"replay"} + arguments);
        QCOMPARE(outcome.status, 2);
        QVERIFY2(outcome.errors.starts_with("knead: "), outcome.errors.c_str());
        QVERIFY2(outcome.errors.find(words.toStdString()) != std::string::npos, outcome.errors.c_str());
        QCOMPARE(lineCount(outcome.errors), std::size_t{1});
        QCOMPARE(outcome.out, std::string());
    }

    void aProjectRunsAsARecipe()
    {
        for (const char* threads : {"1", "2"}) {
            const Outcome outcome = workshop::runKnead(
                {"run", m_shop.qPath("bracket.knead"), "--json", "--threads", threads, "--out", m_shop.qPath("run")});
            QVERIFY2(outcome.status == 0, outcome.errors.c_str());
            const json report = json::parse(outcome.out);
            QCOMPARE(report.at("state_hash").get<std::string>(), hexadecimal(m_project.entries[4].hash));
            QCOMPARE(report.at("tools")[0].at("name").get<std::string>(), std::string("Block 1"));
        }
    }

    void changesOfAProjectCount()
    {
        const auto run = [&](const QStringList& changes) {
            QStringList arguments{"run", m_shop.qPath("bracket.knead"), "--json"};
            for (const QString& change : changes)
                arguments << "--set" << change;
            const Outcome outcome = workshop::runKnead(arguments);
            return outcome.status == 0 ? json::parse(outcome.out) : json{{"error", outcome.errors}};
        };
        const json softer = run({"material.youngs_modulus_pa=1e5"});
        QVERIFY2(softer.contains("objects"), softer.dump().c_str());
        const json finer = run({"spacing_mm=3.5", "duration_steps=20"});
        QVERIFY2(finer.at("objects").get<int>() > softer.at("objects").get<int>(), finer.dump().c_str());
        const json asItWas = run({});
        QVERIFY2(asItWas.at("tools")[0].at("peak_force_n").get<double>() > 0, asItWas.dump().c_str());
        QVERIFY2(softer.at("tools")[0].at("peak_force_n") != asItWas.at("tools")[0].at("peak_force_n"),
                 softer.dump().c_str());
        const json wrong = run({"material.youngs=1"});
        const std::string sentence = wrong.at("error");
        QVERIFY2(sentence.starts_with("knead: bracket.knead with --set: material.youngs is not a known key"),
                 sentence.c_str());
    }

    void aProjectBecomesARecipe()
    {
        const Outcome written =
            workshop::runKnead({"recipe", m_shop.qPath("bracket.knead"), "-o", m_shop.qPath("session.recipe.json")});
        QVERIFY2(written.status == 0, written.errors.c_str());
        const Outcome outcome = workshop::runKnead({"run", m_shop.qPath("session.recipe.json"), "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        QCOMPARE(json::parse(outcome.out).at("state_hash").get<std::string>(), hexadecimal(m_project.entries[4].hash));
        const Outcome shown = workshop::runKnead({"recipe", m_shop.qPath("bracket.knead")});
        QVERIFY(json::parse(shown.out).at("part").at("file").get<std::string>().starts_with('/'));
        const Outcome damaged = workshop::runKnead({"recipe", m_shop.qPath("damaged.knead")});
        QCOMPARE(damaged.status, 2);
        QCOMPARE(lineCount(damaged.errors), std::size_t{1});
    }

    void interruptedItLeavesNoFiles()
    {
        Project endless = m_project;
        endless.entries[4].step += 100'000'000;
        writeProject(m_shop.path("endless.knead"), endless);
        QProcess process;
        process.setProcessEnvironment(serverEnvironment());
        process.start(KNEAD_PROGRAM,
                      {"replay", m_shop.qPath("endless.knead"), "--export", m_shop.qPath("late/part.stl")});
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(workshop::handles(process.processId(), SIGINT), 30'000);
        QTest::qWait(1000); // at work by now
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(10'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 130);
        QVERIFY(m_shop.filesUnder("late").empty());
    }

private:
    Workshop m_shop;
    Project m_project;
};

QTEST_GUILESS_MAIN(ReplayTest)
#include "replay_test.moc"
