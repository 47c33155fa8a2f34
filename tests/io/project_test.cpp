#include "core/simulation/simulation.h"
#include "io/project/project_file.h"
#include "support/same_values.h"
#include "support/sample_project.h"
#include "support/scenes.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <QtTest>

#include <csignal>
#include <filesystem>

#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>

using namespace knead;

namespace {

/// Files stay as small as this while it lives: what a full disk is like to those who write.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &m_before); }

private:
    rlimit m_before{};
};

class CancelledAt final : public TaskControl {
public:
    explicit CancelledAt(int question)
        : m_left(question)
    {
    }
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return m_left-- <= 0; }

private:
    mutable int m_left;
};

class Progress final : public TaskControl {
public:
    void report(double fraction, std::string_view) override
    {
        isForward = isForward && fraction >= last && fraction <= 1;
        last = fraction;
    }
    bool isCancelled() const override { return false; }

    bool isForward = true;
    double last = 0;
};

} // namespace

class ProjectTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    std::string path(const std::string& name) const
    {
        return m_folder.filePath(QString::fromStdString(name)).toStdString();
    }

    QByteArray content(const std::string& name) const
    {
        QFile file(QString::fromStdString(path(name)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    std::size_t filesInFolder() const
    {
        return static_cast<std::size_t>(std::distance(
            std::filesystem::directory_iterator(m_folder.path().toStdString()), std::filesystem::directory_iterator()));
    }

    /// What saving says; empty when it does not complain.
    static std::string complaint(const std::string& path, const Project& project)
    {
        try {
            writeProject(path, project);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return {};
    }

    static bool isAboutTheDisk(const std::string& sentence)
    {
        return sentence.starts_with("disk.knead: the file cannot be written (") &&
               sentence.ends_with("); choose another place or make room.");
    }

private slots:
    void whatEntriesAreCalledComesBackInAnyLanguage()
    {
        Project project = sample::project();
        const Message words = Message("EntryNames", "Move %1").with(Message("EntryNames", "the tool"));
        project.entries[1].words = words;
        project.entries[1].name = words.english();
        writeProject(path("words.knead"), project);
        const Project read = readProject(path("words.knead"));
        QVERIFY(same::values(read, project));
        QVERIFY(read.entries[1].words == words);
        QVERIFY(read.entries[0].words.empty());
        QCOMPARE(read.entries[0].label().english(), project.entries[0].name);
        QVERIFY(rescueProject(path("words.knead")).project.entries[1].words == words);
        std::filesystem::remove(path("words.knead"));
    }

    /// Also where an earlier version gave an entry another name, whose words it does not know.
    void filesOfEarlierVersionsHaveNamesAlone()
    {
        Project project = sample::project();
        project.entries[1].words = Message("EntryNames", "Move %1").with("Block 1");
        project.entries[1].name = "given by hand";
        writeProject(path("names.knead"), project);
        QVERIFY(readProject(path("names.knead")).entries[1].words.empty());
        {
            SQLite::Database database(path("names.knead"), SQLite::OPEN_READWRITE);
            database.exec("DROP TABLE entry_words");
        }
        const Project read = readProject(path("names.knead"));
        project.entries[1].words = {};
        QVERIFY(same::values(read, project));
        QCOMPARE(read.entries[1].label(), Message::verbatim("given by hand"));
        std::filesystem::remove(path("names.knead"));
    }

    void everythingComesBackToTheLastBit()
    {
        const Project project = sample::project();
        Progress saving;
        writeProject(path("full.knead"), project, saving);
        QVERIFY(saving.isForward && saving.last > 0.9);
        Progress opening;
        const Project again = readProject(path("full.knead"), opening);
        QVERIFY(opening.isForward && opening.last > 0.7);
        QVERIFY(same::values(*again.model, *project.model));
        QVERIFY(same::values(again.starts, project.starts));
        QVERIFY(same::values(again.entries, project.entries));
        QVERIFY(same::values(again, project));
    }

    void whatWasSharedIsShared()
    {
        writeProject(path("shared.knead"), sample::project());
        const Project again = readProject(path("shared.knead"));
        QVERIFY(again.model->parts[0].exact->bytes == again.model->parts[1].exact->bytes);
        QVERIFY(again.starts[0].scene.bodies[0].aggregate == again.starts[1].scene.bodies[0].aggregate);
        const auto& added = std::get<AddManipulator>(again.entries[1].commands[8].command);
        QVERIFY(added.manipulator.part != nullptr);
        QVERIFY(added.manipulator.part == again.starts[0].scene.manipulators[1].part);
    }

    /// Deformed since they were opened. Programs that do not know them must not show others.
    void startsWithPartsOfTheirOwnKeepThem()
    {
        Project project = sample::project();
        Model deformed = *project.model;
        deformed.parts[0].volume *= 2;
        deformed.parts.push_back(deformed.parts[0]);
        project.starts.push_back(project.starts[1]);
        project.starts[1].model = project.starts[2].model = std::make_shared<const Model>(deformed);
        for (const std::size_t start : {1U, 2U})
            sample::giveSurfaces(project.starts[start], project.starts[start].model);
        project.view.hiddenParts = {1, static_cast<std::size_t>(deformed.parts.size() - 1)};
        RecipeField field{.file = "/home/ann/warp \"1\".frd",
                          .choice = {.step = 3, .name = "DISP", .unit = "inch", .isInPlace = true},
                          .factor = -1.0 / 3};
        field.kept = {{"Lid", {1, 2, 7}}};
        field.fade = 0.01 / 3;
        field.locked = {false, true, false};
        project.starts[1].deformations = {
            {.bodies = {"Lid", "a/b"},
             .what = NumberDeformation{.kind = NumberKind::shear, .to = 1.0 / 7, .shift = 0.1, .eases = true},
             .kFactor = 1.0 / 3},
            {.bodies = {}, .what = field, .isApart = true}};
        writeProject(path("deformed.knead"), project);
        const Project again = readProject(path("deformed.knead"));
        QVERIFY(same::values(again, project));
        QVERIFY(!again.starts[0].model && again.starts[1].model == again.starts[2].model);
        QVERIFY(shownModel(again) == again.model);
        SQLite::Database database(path("deformed.knead"));
        QCOMPARE(database.execAndGet("PRAGMA user_version").getInt(), 2);
        writeProject(path("plain.knead"), sample::project());
        SQLite::Database plain(path("plain.knead"));
        QCOMPARE(plain.execAndGet("PRAGMA user_version").getInt(), 1);
    }

    /// Without it another part would be shown.
    void whichPartsAStartHasIsNotGuessed()
    {
        Project project = sample::project();
        project.starts[1].model = project.model;
        writeProject(path("guess.knead"), project);
        {
            SQLite::Database database(path("guess.knead"), SQLite::OPEN_READWRITE);
            database.exec("DELETE FROM start_models WHERE id = 1");
        }
        try {
            readProject(path("guess.knead"));
            QFAIL("it was read");
        } catch (const DamagedProject& damage) {
            QVERIFY2(std::string(damage.what()).find("start state 1 (row 1 of the table start_models is missing)") !=
                         std::string::npos,
                     damage.what());
        }
    }

    void anEmptyProjectComesBack()
    {
        writeProject(path("empty.knead"), {});
        QVERIFY(same::values(readProject(path("empty.knead")), Project{}));
    }

    /// The purpose of exactness: what is simulated afterwards has the same bits.
    void aScenePlayedFromAFileGivesTheSameBits()
    {
        Project project;
        Model model;
        model.parts.resize(1);
        project.model = std::make_shared<const Model>(model);
        Scene scene = scenes::cantilever({12, 3, 3}, 0.004, {}, Vec3(0, 0, -9.81));
        const auto part = sample::toolPart(0.02);
        Manipulator press = sample::partManipulator(part);
        press.pose.position = Vec3(0.02, 0, 0.03);
        press.motion = DriveAt{Vec3(0, 0, -0.5)};
        scene.manipulators = {press};
        project.starts = {{scene, {0}}};
        writeProject(path("played.knead"), project);
        Simulation before(scene);
        Simulation after(readProject(path("played.knead")).starts[0].scene);
        for (int step = 0; step < 300; ++step) {
            before.step();
            after.step();
        }
        QVERIFY(before.health().ok);
        QCOMPARE(after.stateHash(), before.stateHash());
    }

    void anyDatabaseToolShowsWhatIsInIt()
    {
        writeProject(path("open.knead"), sample::project());
        SQLite::Database database(path("open.knead"), SQLite::OPEN_READONLY);
        QCOMPARE(database.execAndGet("PRAGMA integrity_check").getString(), std::string("ok"));
        QCOMPARE(database.execAndGet("SELECT name FROM parts WHERE id = 0").getString(), std::string("Würfel 立方体"));
        QCOMPARE(database.execAndGet("SELECT count(*) FROM entries").getInt(), 4);
        QCOMPARE(database.execAndGet("SELECT commands ->> '$[4].command' FROM entries WHERE id = 1").getString(),
                 std::string("set-gravity"));
        QCOMPARE(database.execAndGet("SELECT material ->> '$.friction' FROM bodies WHERE id = 1").getDouble(), 0.4);
    }

    void longBlobsOfSeveralPiecesComeBack()
    {
        Project project = sample::project();
        project.entries[0].moment = sample::moment((17U << 20U) + 5, 7);
        project.entries[1].moment = sample::moment(8U << 20U, 8);
        writeProject(path("long.knead"), project);
        QVERIFY(same::values(readProject(path("long.knead")), project));
    }

    void savingAgainReplacesTheFile()
    {
        Project project = sample::project();
        writeProject(path("again.knead"), project);
        project.entries.pop_back();
        project.marks.clear();
        writeProject(path("again.knead"), project);
        QVERIFY(same::values(readProject(path("again.knead")), project));
    }

    void permissionsAndLinksStay()
    {
        const std::size_t files = filesInFolder();
        writeProject(path("mine.knead"), {});
        std::filesystem::permissions(path("mine.knead"), std::filesystem::perms(0600));
        std::filesystem::create_symlink("mine.knead", path("link.knead"));
        writeProject(path("link.knead"), sample::project());
        QVERIFY(std::filesystem::is_symlink(path("link.knead")));
        QCOMPARE(std::filesystem::status(path("mine.knead")).permissions(), std::filesystem::perms(0600));
        QCOMPARE(readProject(path("mine.knead")).entries.size(), std::size_t{4});
        QCOMPARE(filesInFolder(), files + 2);
    }

    void aFullDiskLeavesTheOldFile_data()
    {
        QTest::addColumn<int>("bytes");
        for (const int bytes : {0, 4000, 40'000, 200'000})
            QTest::newRow(std::to_string(bytes).c_str()) << bytes;
    }

    void aFullDiskLeavesTheOldFile()
    {
        QFETCH(int, bytes);
        Project project = sample::project();
        writeProject(path("disk.knead"), project);
        const QByteArray before = content("disk.knead");
        const std::size_t files = filesInFolder();
        project.entries[0].moment = sample::moment(1U << 20U, 7);
        std::string sentence;
        {
            const FullDisk disk(static_cast<rlim_t>(bytes));
            sentence = complaint(path("disk.knead"), project);
        }
        QVERIFY2(isAboutTheDisk(sentence), sentence.c_str());
        QCOMPARE(content("disk.knead"), before);
        QCOMPARE(filesInFolder(), files);
    }

    /// A disk of 256 KiB, which only root may make.
    void aDiskThatIsReallyFullLeavesTheOldFile()
    {
        const std::string disk = path("disk");
        std::filesystem::create_directory(disk);
        if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=256k") != 0)
            QSKIP("No disk can be mounted here.");
        Project project = sample::project();
        writeProject(disk + "/disk.knead", project);
        const QByteArray before = content("disk/disk.knead");
        project.entries[0].moment = sample::moment(1U << 20U, 7);
        const std::string sentence = complaint(disk + "/disk.knead", project);
        const QByteArray after = content("disk/disk.knead");
        const auto files = std::distance(std::filesystem::directory_iterator(disk), {});
        mount(nullptr, disk.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr);
        const std::string readOnly = complaint(disk + "/disk.knead", project);
        umount(disk.c_str());
        QCOMPARE(sentence,
                 std::string("disk.knead: the file cannot be written (No space left on device); choose another "
                             "place or make room."));
        QCOMPARE(after, before);
        QCOMPARE(files, 1);
        QCOMPARE(readOnly, std::string("disk.knead: the file is read-only; save the project under another name."));
    }

    void cancellingLeavesTheOldFile()
    {
        const Project project = sample::project();
        writeProject(path("cancel.knead"), project);
        const QByteArray before = content("cancel.knead");
        const std::size_t files = filesInFolder();
        int question = 0;
        for (bool isDone = false; !isDone; ++question) {
            CancelledAt control(question);
            try {
                writeProject(path("cancel.knead"), {}, control);
                isDone = true;
            } catch (const Cancelled&) {
                QCOMPARE(content("cancel.knead"), before);
                QCOMPARE(filesInFolder(), files);
            }
        }
        QVERIFY(question > 3);
        CancelledAt atOnce(0);
        QVERIFY_EXCEPTION_THROWN(readProject(path("cancel.knead"), atOnce), Cancelled);
    }

    void whatIsReadOnlyStays()
    {
        writeProject(path("precious.knead"), sample::project());
        const QByteArray before = content("precious.knead");
        std::filesystem::permissions(path("precious.knead"), std::filesystem::perms(0444));
        QCOMPARE(complaint(path("precious.knead"), {}),
                 std::string("precious.knead: the file is read-only; save the project under another name."));
        QCOMPARE(content("precious.knead"), before);
    }

    void placesThatTakeNoFileAreNamed()
    {
        QVERIFY(QString::fromStdString(complaint(path("nowhere/a.knead"), {}))
                    .startsWith("a.knead: the file cannot be written (No such file or directory)"));
        QVERIFY(
            QString::fromStdString(complaint("/proc/a.knead", {})).startsWith("a.knead: the file cannot be written"));
        QVERIFY(QString::fromStdString(complaint(m_folder.path().toStdString(), {})).contains("folder of this name"));
    }

    /// Names that mean something in addresses or texts.
    void namesOfFilesMayBeAnything()
    {
        const Project project = sample::project();
        for (const char* name :
             {"a b.knead", "50%25 ?mode=rw#1.knead", "Würfel 立方体.knead", "'quoted\".knead", ".knead"}) {
            writeProject(path(name), project);
            QVERIFY2(same::values(readProject(path(name)), project), name);
        }
    }
};

QTEST_GUILESS_MAIN(ProjectTest)
#include "project_test.moc"
