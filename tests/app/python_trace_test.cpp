// Sessions as scripts of Python: run, they come to the same bits.
#include "app/cad_process.h"
#include "app/cad_program.h"
#include "app/hexadecimal.h"
#include "io/project/project_file.h"
#include "support/random_lumps.h"
#include "support/workshop.h"

#include <QtTest>

using namespace knead;
using namespace knead::sessions;
using workshop::Outcome;
using workshop::runKnead;

namespace {

/// What is built without the module writes scripts, and runs none.
#ifdef KNEAD_BUILD_PYTHON
constexpr bool hasModule = true;
#else
constexpr bool hasModule = false;
#endif

} // namespace

class PythonTraceTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void theScriptComesToTheSameBits_data();
    void theScriptComesToTheSameBits();
    void whatAPersonDidIsShort();
    void partsOfNoFileComeFromTheProject();
    void argumentsAndStatusAreThoseOfTheScript();
    void withoutPythonOrModuleItSaysSo();
    void whatCannotBeToldIsSaid();
    void aFullDiskIsSaid();

private:
    Outcome traced(const Project& project, const std::string& name, const QStringList& more = {});
    void verifyRun(const std::string& name, std::uint64_t hash);

    workshop::Workshop m_shop;
    std::shared_ptr<const Model> m_model;
};

void PythonTraceTest::initTestCase()
{
    setCadProgram(cadProgramBeside(KNEAD_PROGRAM));
    m_model = std::make_shared<const Model>(importFile(writeLumps(m_shop.path("lumps.3mf"))));
}

/// Saves the project and writes its trace.
Outcome PythonTraceTest::traced(const Project& project, const std::string& name, const QStringList& more)
{
    writeProject(m_shop.path(name + ".knead"), project);
    return runKnead(QStringList{"trace", m_shop.qPath(name + ".knead"), "-o", m_shop.qPath(name + ".py")} + more);
}

/// What the script prints at its end.
void PythonTraceTest::verifyRun(const std::string& name, std::uint64_t hash)
{
    if (!hasModule)
        return;
    const Outcome outcome = runKnead({"python", m_shop.qPath(name + ".py")});
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    QCOMPARE(outcome.out, hexadecimal(hash) + '\n');
}

void PythonTraceTest::theScriptComesToTheSameBits_data()
{
    QTest::addColumn<int>("seed");
    QTest::addColumn<bool>("isRich");
    for (const int seed : {1, 4, 10}) { // 10: a grip is put on a body that was filled anew
        QTest::addRow("plain %d", seed) << seed << false;
        QTest::addRow("rich %d", seed) << seed << true;
    }
}

void PythonTraceTest::theScriptComesToTheSameBits()
{
    QFETCH(int, seed);
    QFETCH(bool, isRich);
    const Scene scene = isRich ? richScene(*m_model) : restingScene(*m_model, lumpSpacing);
    bool isStopped = false; // then, too
    const Document document = randomDocument(scene, static_cast<std::uint64_t>(seed), isStopped, true);
    Project project = projectOf(document, m_model, {0, 1});
    project.import.paths = {m_shop.path("lumps.3mf")};
    const Outcome outcome = traced(project, "lumps");
    QVERIFY2(outcome.status == 0, outcome.errors.c_str());
    verifyRun("lumps", document.simulation.stateHash());
}

/// A drag of many moves is a table, and the rest can be read.
void PythonTraceTest::whatAPersonDidIsShort()
{
    const Project project = pressedPart(KNEAD_RESOURCES "/examples/bracket.step", 0.004);
    QCOMPARE(traced(project, "bracket").status, 0);
    QFile file(m_shop.qPath("bracket.py"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const std::string text = file.readAll().toStdString();
    for (const char* part :
         {"bracket = knead.fill(model.parts[0], spacing=0.004, ", "block_1 = sim.add_tool(\"box\", (",
          "sim.keep()  # Add Block 1\n\nfor step, act, *how in [\n    (0, block_1.go_to, (",
          "]:\n    sim.step_to(step)\n    act(*how)\n", "sim.keep()  # Push aside\n"})
        QVERIFY2(text.find(part) != std::string::npos, text.substr(0, 2000).c_str());
    QVERIFY(text.find("# Material") == std::string::npos); // undone
    QVERIFY(text.find("carry_out") == std::string::npos);
    verifyRun("bracket", project.entries[project.current].hash);
    const Outcome earlier = traced(project, "bracket", {"--entry", "1"});
    QVERIFY2(earlier.status == 0, earlier.errors.c_str());
    verifyRun("bracket", project.entries[1].hash);
}

void PythonTraceTest::partsOfNoFileComeFromTheProject()
{
    bool isStopped = false;
    const Document document = randomDocument(restingScene(*m_model, lumpSpacing), 2, isStopped);
    Project project = projectOf(document, m_model, {0, 1});
    project.import.paths = {m_shop.path("lumps.3mf")};
    project.starts[0].model = std::make_shared<const Model>(*m_model); // deformed since
    QCOMPARE(traced(project, "kept").status, 0);
    verifyRun("kept", document.simulation.stateHash());
}

void PythonTraceTest::argumentsAndStatusAreThoseOfTheScript()
{
    QFile script(m_shop.qPath("arguments.py"));
    QVERIFY(script.open(QIODevice::WriteOnly));
    script.write("import sys, knead\nprint(sys.argv[1:])\nsys.exit(7)\n");
    script.close();
    const Outcome outcome =
        runKnead({"python", script.fileName(), "one", "--help", "-o", "--", "two words", "[1,2]", "[]"});
    if (!hasModule)
        return;
    QCOMPARE(outcome.status, 7);
    QCOMPARE(outcome.out, std::string("['one', '--help', '-o', '--', 'two words', '[1,2]', '[]']\n"));
    QCOMPARE(outcome.errors, std::string());
}

void PythonTraceTest::withoutPythonOrModuleItSaysSo()
{
    qputenv("KNEAD_PYTHON", "/nowhere/python3");
    const Outcome outcome = runKnead({"python", "script.py"});
    qunsetenv("KNEAD_PYTHON");
    QCOMPARE(outcome.status, 2);
    const std::string sentence = hasModule ? "knead: /nowhere/python3 cannot be started (No such file or directory). "
                                             "Install python3, or set KNEAD_PYTHON to where it is.\n"
                                           : "knead: the module for Python is not there: this program was built "
                                             "without it, for which pybind11 and Python's headers are needed.\n";
    QCOMPARE(outcome.errors, sentence);
}

void PythonTraceTest::whatCannotBeToldIsSaid()
{
    const Outcome empty = traced(Project{}, "empty");
    QCOMPARE(empty.status, 2);
    QVERIFY2(empty.errors.find("Nothing was done in the project yet") != std::string::npos, empty.errors.c_str());
    const Project project = pressedPart(KNEAD_RESOURCES "/examples/bracket.step", 0.006);
    const Outcome beyond = traced(project, "bracket", {"--entry", "9"});
    QCOMPARE(beyond.status, 2);
    QVERIFY2(beyond.errors.find("bracket.knead has no entry 9; its last one is 4.") != std::string::npos,
             beyond.errors.c_str());
}

void PythonTraceTest::aFullDiskIsSaid()
{
    QCOMPARE(traced(pressedPart(KNEAD_RESOURCES "/examples/bracket.step", 0.006), "full").status, 0);
    for (const QStringList& arguments :
         {QStringList{"trace", m_shop.qPath("full.knead")}, QStringList{"recipe", m_shop.qPath("full.knead")}}) {
        QProcess process;
        process.setStandardOutputFile("/dev/full");
        process.start(KNEAD_PROGRAM, arguments);
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(process.readAllStandardError().contains("the standard output takes no more"));
    }
}

QTEST_GUILESS_MAIN(PythonTraceTest)
#include "python_trace_test.moc"
