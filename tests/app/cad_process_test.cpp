#include "app/cad_process.h"
#include "app/cad_program.h"
#include "io/importer.h"
#include "io/project/project_file.h"
#include "io/worker/confinement.h"
#include "io/worker/isolated_import.h"
#include "support/same_values.h"
#include "support/sample_project.h"
#include "support/skip.h"
#include "support/step_machine.h"

#include <QtTest>
#include <SQLiteCpp/SQLiteCpp.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>

#include <sys/resource.h>
#include <unistd.h>

using namespace knead;

namespace {

const std::string program = cadProgramBeside(KNEAD_PROGRAM);
/// More than any of this takes, also beside much other work on a slow machine.
constexpr ImportLimits plenty{.memory = 0, .processorTime = 0, .wallTime = 600};
constexpr double patience = 4; // s for those that hang: time enough for them to start and to say what they do

std::string example(const std::string& name)
{
    return std::string(KNEAD_RESOURCES) + "/examples/" + name;
}

bool mentions(const std::string& sentence, const std::string& words)
{
    return sentence.find(words) != std::string::npos;
}

/// Cancelled once it has seen a stage.
class CancelAt final : public TaskControl {
public:
    explicit CancelAt(std::string stage)
        : m_stage(std::move(stage))
    {
    }

    void report(double, std::string_view stage) override { m_isCancelled = m_isCancelled || stage == m_stage; }
    bool isCancelled() const override { return m_isCancelled; }

private:
    std::string m_stage;
    bool m_isCancelled = false;
};

class StageNames final : public TaskControl {
public:
    void report(double fraction, std::string_view stage) override
    {
        names.emplace(stage);
        isForward = isForward && fraction >= last;
        last = fraction;
    }
    bool isCancelled() const override { return false; }

    std::set<std::string> names;
    double last = 0;
    bool isForward = true;
};

/// Files stay as small as this while it lives: what a full disk is like to those who write.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_before);
        rlimit limit = m_before;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &m_before); }

private:
    rlimit m_before{};
};

} // namespace

/// Reading in a process of its own, with the program itself, and with stand-ins that go astray.
class CadProcessTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    std::string file(const std::string& name, const std::string& content)
    {
        const std::string path = m_folder.filePath(QString::fromStdString(name)).toStdString();
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }

    /// A program that does what a shell script says instead of reading.
    std::string standIn(const std::string& script)
    {
        const std::string path = file("stand-in.sh", "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(path, std::filesystem::perms::owner_all);
        return path;
    }

    /// What the import of a good file says when `reader` does it.
    std::string failureOf(const std::string& reader, const ImportLimits& limits, const ImportOptions& options = {})
    {
        try {
            importIsolated(reader, example("bracket.step"), options, limits, TaskControl::none());
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return {};
    }

private slots:
    void exportIsWrittenWholeOrNotAtAll()
    {
        QTemporaryDir folder;
        const std::string path = folder.filePath("räumlich 'out'.step").toStdString();
        setCadProgram(program);
        ExportJob job;
        const Model model = importFile(example("bracket.step"));
        job.tree = model.tree;
        for (const Part& part : model.parts)
            job.parts.push_back({.part = part});
        const ExportReport report = exportInChild(path, job, TaskControl::none());
        QVERIFY(report.isSound());
        QCOMPARE(report.bytes, std::filesystem::file_size(path));
        const auto content = [&] {
            QFile file(QString::fromStdString(path));
            file.open(QIODevice::ReadOnly);
            return file.readAll();
        };
        const QByteArray before = content();
        const auto stays = [&](const std::function<void()>& attempt, const char* words) {
            std::string sentence;
            try {
                attempt();
            } catch (const std::exception& error) {
                sentence = error.what();
            }
            const QStringList names = QDir(folder.path()).entryList(QDir::Files | QDir::Hidden);
            return mentions(sentence, words) && content() == before && names.size() == 1;
        };
        CancelAt cancel("writing faces");
        QVERIFY(stays([&] { exportInChild(path, job, cancel); }, "cancelled"));
        QVERIFY(stays(
            [&] {
                const FullDisk full(20'000);
                exportInChild(path, job, TaskControl::none());
            },
            "no more"));
        QVERIFY(
            stays([&] { exportInChild(folder.filePath("no/such/out.step").toStdString(), job, TaskControl::none()); },
                  "cannot be written"));
        QVERIFY(stays([&] { exportInChild(folder.filePath("out.xyz").toStdString(), job, TaskControl::none()); },
                      "smooth faces go into"));
        // Killed at the last moment: all of it is written, and nobody was told.
        setCadProgram(standIn("'" + program + "' \"$@\"\nkill -KILL $$"));
        QVERIFY(stays([&] { exportInChild(path, job, TaskControl::none()); }, "the writer crashed"));
        setCadProgram(program);
    }

    void initTestCase() { setCadProgram(program); }

    void aProjectIsReadAfterATrial()
    {
        const std::string path = m_folder.filePath("räumlich 'sound'.knead").toStdString();
        const Project written = sample::project();
        writeProject(path, written);
        StageNames stages;
        QVERIFY(same::values(readProjectAfterTrial(path, stages), written));
        QVERIFY(stages.isForward);
        QVERIFY(stages.last > 0.5); // past the trial
        QVERIFY(same::values(rescueProjectAfterTrial(path, TaskControl::none()).project, written));
        CancelAt cancel("opening the history");
        QVERIFY_THROWS_EXCEPTION(Cancelled, readProjectAfterTrial(path, cancel));
    }

    /// The window offers to bring back a part of it, as where it was read here alone.
    void aDamagedProjectIsSaidToBeThat()
    {
        const std::string path = m_folder.filePath("damaged.knead").toStdString();
        writeProject(path, sample::project());
        {
            SQLite::Database database(path, SQLite::OPEN_READWRITE);
            database.exec("DELETE FROM bodies");
        }
        const auto complaint = [&](const auto& read) {
            try {
                read(path, TaskControl::none());
            } catch (const DamagedProject& damage) {
                return damage.message();
            }
            return Message();
        };
        QVERIFY(!complaint(readProject).empty());
        QCOMPARE(complaint(readProjectAfterTrial).english(), complaint(readProject).english());
        QVERIFY(!rescueProjectAfterTrial(path, TaskControl::none()).missing.empty());
        QVERIFY_THROWS_EXCEPTION(Problem, readProjectAfterTrial(path + ".not", TaskControl::none()));
    }

    /// Whatever a project does to its reader, it does to one of its own.
    void aProjectThatEndsItsReaderCostsASentence_data()
    {
        QTest::addColumn<QString>("script");
        QTest::addColumn<QString>("words");
        QTest::newRow("crash") << "kill -SEGV $$"
                               << "the reader crashed";
        QTest::newRow("killed at the last moment") << "'%1' \"$@\"\nkill -KILL $$"
                                                   << "the reader crashed";
        QTest::newRow("says nothing") << "exit 0"
                                      << "Nothing was";
    }

    void aProjectThatEndsItsReaderCostsASentence()
    {
        QFETCH(QString, script);
        QFETCH(QString, words);
        const std::string path = m_folder.filePath("sound.knead").toStdString();
        writeProject(path, sample::project());
        setCadProgram(standIn(script.replace("%1", QString::fromStdString(program)).toStdString()));
        std::string sentence;
        try {
            readProjectAfterTrial(path, TaskControl::none());
        } catch (const Problem& problem) {
            sentence = problem.what();
        }
        setCadProgram(program);
        QVERIFY2(mentions(sentence, "sound.knead") && mentions(sentence, words.toStdString()), sentence.c_str());
    }

    void theModelIsThatOfTheReader()
    {
        StageNames stages;
        const Model model = importInChild(example("bracket.step"), {}, stages);
        const Model direct = importFile(example("bracket.step"));
        QCOMPARE(model.file, direct.file);
        QCOMPARE(model.format, direct.format);
        QCOMPARE(model.parts.size(), direct.parts.size());
        for (std::size_t i = 0; i < model.parts.size(); ++i) {
            QCOMPARE(model.parts[i].path, direct.parts[i].path);
            QVERIFY(model.parts[i].mesh.vertices == direct.parts[i].mesh.vertices);
            QVERIFY(model.parts[i].mesh.triangles == direct.parts[i].mesh.triangles);
            QVERIFY(model.parts[i].volume == direct.parts[i].volume);
        }
        QVERIFY(stages.names.contains("making shapes") && stages.names.contains("measuring parts"));
        QVERIFY(stages.isForward);
        QCOMPARE(stages.last, 1.0);
    }

    /// From its first word on, while it reads.
    void theReaderIsLockedIn()
    {
        class StatusOfChild final : public TaskControl {
        public:
            void report(double, std::string_view) override
            {
                std::ifstream children("/proc/thread-self/children");
                std::string child;
                if (status.empty() && children >> child) {
                    std::ifstream file("/proc/" + child + "/status");
                    status = {std::istreambuf_iterator<char>(file), {}};
                }
            }
            bool isCancelled() const override { return false; }

            std::string status;
        } control;
        QCOMPARE(importInChild(example("bar.step"), {}, control).parts.size(), 1U);
        QVERIFY2(mentions(control.status, "NoNewPrivs:\t1\n"), control.status.c_str());
        QCOMPARE(mentions(control.status, "Seccomp:\t2\n"), confinementHere().filtersCalls);
        QVERIFY2(mentions(control.status, "Name:\tknead-cad-worke\n"), control.status.c_str());
    }

    void filesBesideAnAssemblyAreRead()
    {
        QTemporaryDir folder;
        QVERIFY(writeMachine(folder.path()));
        const std::string path = folder.filePath("machine.stp").toStdString();
        QCOMPARE(importInChild(path, {}, TaskControl::none()).parts.size(), 3U);
    }

    void aFileBehindALinkIsRead()
    {
        const std::string link = m_folder.filePath("link.step").toStdString();
        std::filesystem::create_symlink(example("bar.step"), link);
        QCOMPARE(importInChild(link, {}, TaskControl::none()).parts.size(), 1U);
    }

    void theProgramIsFoundInAnInstalledTree()
    {
        QTemporaryDir root;
        const std::string bin = root.filePath("bin/knead").toStdString();
        QVERIFY(QDir(root.path()).mkpath("bin") && QDir(root.path()).mkpath("libexec/knead"));
        QCOMPARE(cadProgramBeside(bin), root.filePath("bin/knead-cad-worker").toStdString());
        const std::string installed = root.filePath("libexec/knead/knead-cad-worker").toStdString();
        std::ofstream(installed) << "program";
        QCOMPARE(cadProgramBeside(bin), installed);
    }

    void optionsReachTheReader()
    {
        ImportOptions coarse;
        coarse.linearDeflection = 1e-3;
        coarse.angularDeflection = 1;
        const auto triangles = [](const ImportOptions& options) {
            return importInChild(example("handle.step"), options, TaskControl::none()).parts[0].mesh.triangles.size();
        };
        QVERIFY(triangles(coarse) < triangles({}));
    }

    void refusalsOfTheReaderArriveAsTheyAre()
    {
        const std::string path = file("cut.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=POINT();\n");
        try {
            importInChild(path, {}, TaskControl::none());
            QFAIL("A file that is cut off was read.");
        } catch (const std::runtime_error& error) {
            QVERIFY2(mentions(error.what(), "cut.step: the STEP file ends before its last line"), error.what());
        }
    }

    void aCrashIsASentence_data()
    {
        QTest::addColumn<QString>("script");
        QTest::addColumn<QString>("words");
        QTest::newRow("segv") << "echo '400000 making shapes' >&3; kill -SEGV $$"
                              << "bracket.step: the reader crashed while making shapes (memory access). Nothing was "
                                 "imported";
        QTest::newRow("abort") << "kill -ABRT $$"
                               << "bracket.step: the reader crashed (internal error).";
        QTest::newRow("fpe") << "kill -FPE $$"
                             << "crashed (arithmetic)";
        QTest::newRow("killed") << "kill -KILL $$"
                                << "ended from outside, perhaps because the machine ran out of memory";
        QTest::newRow("status") << "exit 3"
                                << "the reader ended without a result";
        QTest::newRow("empty result") << "exit 0"
                                      << "the reader's result is damaged";
        QTest::newRow("garbage") << "head -c 100000 /dev/urandom >&4; head -c 100000 /dev/urandom >&3"
                                 << "the reader's result is damaged";
        QTest::newRow("endless line") << "head -c 10000000 /dev/zero >&3; exit 3"
                                      << "ended without a result";
    }

    void aCrashIsASentence()
    {
        QFETCH(QString, script);
        QFETCH(QString, words);
        const std::string sentence = failureOf(standIn(script.toStdString()), plenty);
        QVERIFY2(mentions(sentence, words.toStdString()), sentence.c_str());
    }

    /// Names, colors and assemblies are worth a second try without them; a process that was ended is not.
    void aCrashIsFollowedByThePlainReader()
    {
        const std::string plainOnly =
            R"(case "$3" in *'"onlyShapes":true'*) exec )" + program + R"( "$@" ;; *) kill -SEGV $$ ;; esac)";
        const Model model =
            importIsolated(standIn(plainOnly), example("bracket.step"), {}, plenty, TaskControl::none());
        const Model usual = importIsolated(program, example("bracket.step"), {}, plenty, TaskControl::none());
        QCOMPARE(model.parts.size(), usual.parts.size());
        for (std::size_t i = 0; i < model.parts.size(); ++i)
            QVERIFY(model.parts[i].canBeFilled() && model.parts[i].volume == usual.parts[i].volume);
        QCOMPARE(model.warnings.size(), usual.warnings.size() + 1);
        QVERIFY2(mentions(model.warnings.back().english(), "without names, colors and assemblies"),
                 model.warnings.back().english().c_str());

        for (const auto& [signal, tries] : {std::pair("KILL", 1), std::pair("ABRT", 2)}) {
            const std::string note = file("starts", "");
            failureOf(standIn("echo started >>" + note + "; kill -" + signal + " $$"), plenty);
            std::ifstream starts(note);
            QCOMPARE(std::count(std::istreambuf_iterator<char>(starts), {}, '\n'), tries);
        }
    }

    void aHangIsASentence_data()
    {
        QTest::addColumn<QString>("script");
        QTest::addColumn<QString>("words");
        QTest::newRow("pipe closed") << "exec 3>&-; sleep 100"
                                     << "and was ended";
        QTest::newRow("sleeps") << "echo '100000 reading the file' >&3; sleep 100"
                                << "while reading the file and was ended. Nothing was imported";
        QTest::newRow("talks for ever") << "while :; do echo '500000 making shapes' >&3; done"
                                        << "while making shapes";
    }

    void aHangIsASentence()
    {
        QFETCH(QString, script);
        QFETCH(QString, words);
        const std::string sentence = failureOf(standIn(script.toStdString()), {.wallTime = patience});
        QVERIFY2(mentions(sentence, "bracket.step: reading took longer than 4 s " + words.toStdString()),
                 sentence.c_str());
    }

    void aMissingProgramIsASentence() { QVERIFY(mentions(failureOf("/no/such/program", plenty), "cannot be started")); }

    void processorTimeIsLimited()
    {
        ImportOptions endless;
        endless.linearDeflection = 1e-8;
        endless.angularDeflection = 1e-3;
        const std::string sentence = failureOf(program, {.processorTime = 1, .wallTime = 300}, endless);
        QVERIFY2(mentions(sentence, "reading took longer than 1 s while making triangles"), sentence.c_str());
    }

    void memoryIsLimited()
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("The address space of a sanitized process cannot be limited.");
#endif
        ImportOptions greedy;
        greedy.linearDeflection = 1e-7;
        greedy.angularDeflection = 5e-3;
        const std::string sentence = failureOf(program, {.memory = 300U << 20U, .wallTime = 300}, greedy);
        QVERIFY2(mentions(sentence, "bracket.step: the file asks for more memory than"), sentence.c_str());
    }

    void limitsFollowTheFileUnlessAPersonSaysOtherwise()
    {
        const std::string large = file("large.stl", std::string(8U << 20U, ' '));
        const ImportLimits small = limitsFor(example("bar.step"));
        const ImportLimits more = limitsFor(large);
        QVERIFY(small.processorTime >= 120 && more.processorTime >= small.processorTime + 200);
        QVERIFY(small.wallTime > small.processorTime && more.memory > small.memory);
        ImportOptions chosen;
        chosen.timeLimit = 5;
        chosen.memoryLimit = 1e9;
        const ImportLimits own = limitsFor(large, chosen);
        QCOMPARE(own.processorTime, 5.0);
        QCOMPARE(own.memory, std::uint64_t(1'000'000'000));
    }

    void aFullDiskIsASentence()
    {
        const FullDisk disk(1000);
        const std::string sentence = failureOf(program, plenty);
        QVERIFY2(mentions(sentence, "bracket.step: the folder for temporary files takes no more"), sentence.c_str());
    }

    void aMissingTemporaryFolderIsASentence()
    {
        const QByteArray before = qgetenv("TMPDIR");
        qputenv("TMPDIR", "/no/such/folder");
        const std::string sentence = failureOf(program, plenty);
        before.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
        QVERIFY2(mentions(sentence, "set TMPDIR"), sentence.c_str());
    }

    void cancellingEndsTheProcess()
    {
        const std::string note = m_folder.filePath("pid").toStdString();
        const std::string reader = standIn("echo $$ >" + note + "; echo '100000 reading the file' >&3; sleep 100");
        CancelAt control("reading the file");
        QVERIFY_EXCEPTION_THROWN(importIsolated(reader, example("bar.step"), {}, plenty, control), Cancelled);
        pid_t process = 0;
        std::ifstream(note) >> process;
        QVERIFY(process > 0);
        QCOMPARE(kill(process, 0), -1);
        QCOMPARE(errno, ESRCH);
    }

    /// A worker whose parent is gone does not go on.
    void nothingIsLeftBehind()
    {
        const std::filesystem::path folder = m_folder.filePath("temporary").toStdString();
        std::filesystem::create_directory(folder);
        const QByteArray before = qgetenv("TMPDIR");
        qputenv("TMPDIR", folder.c_str());
        importInChild(example("bar.step"), {}, TaskControl::none());
        failureOf(standIn("kill -SEGV $$"), plenty);
        before.isNull() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
        QVERIFY(std::filesystem::is_empty(folder));
    }

    void severalFilesBecomeOneModel()
    {
        const std::vector<std::string> paths{example("bar.step"), example("bracket.step"), example("handle.step")};
        const Model model = importInChildren(paths, {}, TaskControl::none());
        std::size_t parts = 0;
        for (const std::string& path : paths)
            parts += importFile(path).parts.size();
        QCOMPARE(model.parts.size(), parts);
        QCOMPARE(model.tree.children.size(), std::size_t{3});
        QCOMPARE(model.tree.children[1].name, std::string("bracket"));
        QVERIFY(model.parts.back().path.starts_with("handle/"));
        QVERIFY(model.missing.empty());
    }

    void oneBadFileOfSeveralIsMissing()
    {
        const std::string bad = file("bad.step", "this is no part");
        const Model model = importInChildren({bad, example("bar.step")}, {}, TaskControl::none());
        QCOMPARE(model.parts.size(), std::size_t{1});
        QCOMPARE(model.missing.size(), std::size_t{1});
        QVERIFY(mentions(model.missing[0].english(), "bad.step"));
        QVERIFY_EXCEPTION_THROWN(importInChildren({bad, bad}, {}, TaskControl::none()), std::runtime_error);
    }

    /// Names as people give them.
    void anyNameOpens_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("spaces, letters, quotes")
            << QString::fromUtf8("a name, ünïcödé 立方体 & 'quote' \"two\" #%.step");
        QTest::newRow("250 characters") << QString(245, 'n') + ".step";
        QTest::newRow("like an option") << "--help.step";
        QTest::newRow("new line") << "two\nlines.step";
        QTest::newRow("shell") << "$(touch x); rm -rf y.step";
    }

    void anyNameOpens()
    {
        QFETCH(QString, name);
        QVERIFY(QFile::copy(QString::fromStdString(example("bar.step")), m_folder.filePath(name)));
        const std::string path = m_folder.filePath(name).toStdString();
        const Model model = importInChild(path, {}, TaskControl::none());
        QCOMPARE(model.file, path);
        QCOMPARE(model.parts.size(), std::size_t{1});
        QVERIFY(!model.tree.name.empty());
    }

    void whatIsNoFileIsRefused_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("words");
        QTest::newRow("loop") << "loop"
                              << "cannot be opened";
        QTest::newRow("folder") << "folder"
                                << "this is a folder";
        QTest::newRow("missing") << "missing"
                                 << "does not exist";
        QTest::newRow("device") << "device"
                                << "not an ordinary file";
        QTest::newRow("unreadable") << "unreadable"
                                    << "cannot be opened";
    }

    void whatIsNoFileIsRefused()
    {
        QFETCH(QString, kind);
        QFETCH(QString, words);
        const std::filesystem::path path = m_folder.filePath(kind + ".step").toStdString();
        if (kind == "loop")
            std::filesystem::create_symlink(path, path);
        else if (kind == "folder")
            std::filesystem::create_directory(path);
        else if (kind == "device")
            std::filesystem::create_symlink("/dev/zero", path);
        else if (kind == "unreadable") {
            if (geteuid() == 0)
                QSKIP("Root may read every file.");
            std::filesystem::permissions(file("unreadable.step", "x"), std::filesystem::perms::none);
        }
        try {
            importInChild(path, {}, TaskControl::none());
            QFAIL("It was read.");
        } catch (const std::runtime_error& error) {
            QVERIFY2(mentions(error.what(), (kind + ".step: ").toStdString()), error.what());
            QVERIFY2(mentions(error.what(), words.toStdString()), error.what());
        }
    }

    /// Every file of the corpus that is known to make readers crash, hang or lie.
    void badFilesOfTheCorpusAreSurvived_data()
    {
        QTest::addColumn<QString>("path");
        const QDir folder(qEnvironmentVariable("KNEAD_CORPUS") + "/bad");
        if (qEnvironmentVariableIsEmpty("KNEAD_CORPUS"))
            QTest::newRow("no corpus") << QString();
        else
            for (const QFileInfo& bad : folder.entryInfoList(QDir::Files))
                if (bad.suffix() != "tsv")
                    QTest::newRow(qPrintable(bad.fileName())) << bad.filePath();
    }

    void badFilesOfTheCorpusAreSurvived()
    {
        QFETCH(QString, path);
        if (path.isEmpty())
            KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
        try {
            const Model model =
                importIsolated(program, path.toStdString(), {},
                               {.memory = 4ULL << 30U, .processorTime = 30, .wallTime = 90}, TaskControl::none());
            QVERIFY(!model.parts.empty());
            for (const Part& part : model.parts)
                QVERIFY(part.box.isEmpty() || part.box.sizes().maxCoeff() < 1e5);
        } catch (const std::runtime_error& error) {
            const std::string sentence = error.what();
            QVERIFY2(mentions(sentence, QFileInfo(path).fileName().toStdString() + ": "), error.what());
            QVERIFY2(!mentions(sentence, "reading took longer than"), error.what());
        }
    }

    void cancellingTheLargestFileIsFeltAtOnce_data()
    {
        QTest::addColumn<QString>("stage");
        for (const char* stage : {"reading the file", "making shapes", "measuring parts"})
            QTest::newRow(stage) << stage;
    }

    void cancellingTheLargestFileIsFeltAtOnce()
    {
        QFETCH(QString, stage);
        if (qEnvironmentVariableIsEmpty("KNEAD_CORPUS"))
            KNEAD_SKIP_WITHOUT("corpus", "The environment variable KNEAD_CORPUS names no corpus folder.");
        const std::string path =
            qEnvironmentVariable("KNEAD_CORPUS").toStdString() + "/open/o37_big_soarm_assembled.step";
        CancelAt control(stage.toStdString());
        QVERIFY_EXCEPTION_THROWN(importIsolated(program, path, {}, plenty, control), Cancelled);
    }
};

QTEST_GUILESS_MAIN(CadProcessTest)
#include "cad_process_test.moc"
