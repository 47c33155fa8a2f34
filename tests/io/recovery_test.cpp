#include "io/project/file_lock.h"
#include "io/project/recovery.h"
#include "io/project/recovery_files.h"
#include "support/same_values.h"
#include "support/sample_project.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <QtTest>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include <sys/mount.h>

using namespace knead;

namespace {

std::string complaint(const std::function<void()>& attempt)
{
    try {
        attempt();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return {};
}

} // namespace

/// A RecoveryFile that goes without discard() leaves what a crash leaves; see also ProjectKillTest.
class RecoveryTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_temporary;
    std::string m_folder;
    Project m_project;

    RecoveredWork left() const
    {
        const std::vector<Recovery> found = findRecoveries(m_folder);
        return RecoveryFile(found.at(0)).read();
    }

    bool isEmpty() const
    {
        return std::filesystem::directory_iterator(m_folder) == std::filesystem::directory_iterator();
    }

private slots:
    void init()
    {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_folder = m_temporary->filePath("state/recovery").toStdString();
        m_project = sample::project();
    }

    void nothingIsFoundWhereNothingIs() { QVERIFY(findRecoveries(m_folder).empty()); }

    void everythingThatChangesIsKept()
    {
        {
            RecoveryFile file(m_folder);
            file.begin(m_project, {.projectFile = "/home/ann/a.knead"});
            HistoryRecord record = sample::entry(1, "new");
            record.commands = sample::commands(sample::toolPart(0.5)); // of a part that was not there before
            record.moment = sample::moment(4000, 5);
            file.append(record);
            m_project.entries.push_back(record);
            m_project.entries[2].moment = nullptr; // thinned out
            file.replaceEntry(2, m_project.entries[2]);
            m_project.entries[0].name = "Beginning";
            m_project.entries[0].isKey = true;
            file.replaceEntry(0, m_project.entries[0]);
            m_project.entries[1].moment = sample::moment(100, 6); // made again
            file.replaceEntry(1, m_project.entries[1]);
            m_project.starts.push_back(sample::start(sample::toolPart(0.7)));
            sample::giveSurfaces(m_project.starts.back(), m_project.model);
            file.addStart(m_project.starts.back());
            m_project.current = 1;
            file.setCurrent(1);
            m_project.marks.push_back({4, "here"});
            file.setMarks(m_project.marks);
            m_project.panels["export"] = "{}";
            file.setPanels(m_project.panels);
            m_project.view.hiddenParts = {0, 1};
            file.setView(m_project.view);
        }
        const RecoveredWork work = left();
        QVERIFY(work.missing.empty());
        QVERIFY(same::values(work.project.starts, m_project.starts));
        QCOMPARE(work.project.entries.size(), m_project.entries.size());
        for (std::size_t i = 0; i < m_project.entries.size(); ++i)
            QVERIFY2(same::values(work.project.entries[i], m_project.entries[i]), std::to_string(i).c_str());
        QVERIFY(same::values(work.project, m_project));
        QCOMPARE(work.state.projectFile, std::string("/home/ann/a.knead"));
        QVERIFY(work.state.gesture.empty());
    }

    void aSummarySaysWhatThereIs()
    {
        {
            RecoveryFile file(m_folder);
            file.begin(m_project, {.projectFile = "/home/ann/a.knead"});
            HistoryRecord record = sample::entry(0, "last");
            record.wallTime = 2e9;
            file.append(record);
        }
        const std::vector<Recovery> found = findRecoveries(m_folder);
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].projectFile, std::string("/home/ann/a.knead"));
        QCOMPARE(found[0].part, m_project.model->parts[0].name);
        QCOMPARE(found[0].entries, 5U);
        QCOMPARE(found[0].lastChange, 2e9);
    }

    void theLatestComesFirst()
    {
        for (const double time : {3.0, 5.0, 4.0}) {
            RecoveryFile file(m_folder);
            m_project.entries[0].wallTime = 2e9 + time;
            file.begin(m_project, {});
        }
        const std::vector<Recovery> found = findRecoveries(m_folder);
        QCOMPARE(found.size(), std::size_t{3});
        QVERIFY(found[0].lastChange > found[1].lastChange && found[1].lastChange > found[2].lastChange);
    }

    void workThatAWindowHasIsNotOffered()
    {
        RecoveryFile file(m_folder);
        file.begin(m_project, {});
        QVERIFY(findRecoveries(m_folder).empty());
        file.append(sample::entry(0, "goes on")); // and was not disturbed
        QVERIFY(file.isGoingOn());
    }

    void ofTwoWindowsOneTakesOver()
    {
        RecoveryFile(m_folder).begin(m_project, {});
        const Recovery found = findRecoveries(m_folder).at(0);
        RecoveryFile quicker(found);
        QCOMPARE(complaint([&] { RecoveryFile slower(found); }),
                 std::string("Another window works on this already, or it was discarded: look for it there."));
        QVERIFY(!complaint([&] { dropRecovery(found); }).empty());
        QVERIFY(findRecoveries(m_folder).empty());
        QVERIFY(same::values(quicker.read().project, m_project));
    }

    void lookingForWorkDoesNotKeepOthersFromIt()
    {
        RecoveryFile(m_folder).begin(m_project, {});
        const Recovery found = findRecoveries(m_folder).at(0);
        const auto whileOneLooks = [&](const std::function<void()>& attempt) {
            FileLock looking(recovery_files::lock(found.folder), false);
            QVERIFY(looking.isHeld());
            std::thread soon([&] {
                QTest::qSleep(50);
                looking = FileLock();
            });
            const std::string said = complaint(attempt);
            soon.join();
            QCOMPARE(said, std::string());
        };
        whileOneLooks([&] { RecoveryFile next(found); });
        whileOneLooks([&] { dropRecovery(found); });
        QVERIFY(isEmpty());
    }

    void aSecondCrashLosesNothing()
    {
        RecoveryFile(m_folder).begin(m_project, {.gesture = m_project.entries[1].commands, .step = 77});
        for (int crash = 0; crash < 3; ++crash) {
            RecoveryFile file(findRecoveries(m_folder).at(0));
            const RecoveredWork work = file.read();
            QVERIFY(same::values(work.project, m_project));
            QVERIFY(same::values(work.state.gesture, m_project.entries[1].commands));
            QCOMPARE(work.state.step, std::uint64_t{77});
            if (crash > 0) // the first one came before the window had taken over
                file.begin(work.project, work.state);
        }
    }

    void savedWorkIsNotOffered()
    {
        {
            RecoveryFile file(m_folder);
            file.begin(m_project, {});
            file.markSaved("/home/ann/b.knead", file.revision());
            file.setView({});
        }
        QVERIFY(findRecoveries(m_folder).empty());
        QVERIFY(isEmpty());
    }

    void aMomentIsNoWork()
    {
        {
            RecoveryFile file(m_folder);
            file.begin(m_project, {.isSaved = true});
            m_project.entries[2].moment = nullptr; // thinned out
            file.replaceMoment(2, m_project.entries[2]);
            m_project.entries[1].moment = sample::moment(100, 6); // made again
            file.replaceMoment(1, m_project.entries[1]);
            QVERIFY(same::values(file.read().project, m_project));
        }
        QVERIFY(findRecoveries(m_folder).empty());
        QVERIFY(isEmpty());
    }

    void aNewNameIsWork()
    {
        {
            RecoveryFile file(m_folder);
            file.begin(m_project, {.isSaved = true});
            m_project.entries[2].name = "Renamed";
            file.replaceEntry(2, m_project.entries[2]);
        }
        QVERIFY(same::values(left().project, m_project));
    }

    /// A power failure takes what the disk has not been told to keep.
    void eachCommitIsOnTheDisk()
    {
        const std::string folder = m_temporary->path().toStdString();
        constexpr int full = 2;
        QCOMPARE(recovery_files::open(folder)->execAndGet("PRAGMA synchronous").getInt(), full);
    }

    void aProjectFileThatWasWrittenSinceIsSaid()
    {
        const std::string path = m_temporary->filePath("a.knead").toStdString();
        const auto write = [&](const std::string& text) { std::ofstream(path) << text; };
        write("one");
        RecoveryFile file(m_folder);
        file.begin(m_project, {.projectFile = path});
        QVERIFY(!file.read().state.isFileReplaced);
        write("another");
        QVERIFY(file.read().state.isFileReplaced);
        file.markSaved(path, file.revision());
        QVERIFY(!file.read().state.isFileReplaced);
        std::filesystem::remove(path);
        QVERIFY(!file.read().state.isFileReplaced); // nothing is lost by saving there
    }

    void whatAKillLeftHalfMadeIsRemoved()
    {
        const std::filesystem::path folder = m_folder;
        for (const char* name : {"new-before", "new-Abc123"})
            std::filesystem::create_directories(folder / name);
        std::ofstream(folder / "new-before" / "owner") << "somebody";
        const auto now = std::filesystem::file_time_type::clock::now();
        std::filesystem::last_write_time(folder / "new-before", now - std::chrono::hours(1));
        QVERIFY(findRecoveries(m_folder).empty());
        QVERIFY(!std::filesystem::exists(folder / "new-before"));
        QVERIFY(std::filesystem::exists(folder / "new-Abc123")); // perhaps a window is at it
    }

    void workAfterSavingIsOffered()
    {
        {
            RecoveryFile file(m_folder);
            file.begin(m_project, {.isSaved = true});
            file.markSaved("/home/ann/b.knead", file.revision());
            file.append(sample::entry(0, "more"));
        }
        QCOMPARE(left().state.projectFile, std::string("/home/ann/b.knead"));
        QCOMPARE(left().project.entries.size(), std::size_t{5});
    }

    void workThatCameWhileSavingIsOffered()
    {
        {
            RecoveryFile file(m_folder);
            file.begin(m_project, {});
            const std::uint64_t saved = file.revision();
            file.append(sample::entry(0, "meanwhile"));
            file.markSaved("/home/ann/b.knead", saved);
        }
        QCOMPARE(left().state.projectFile, std::string("/home/ann/b.knead"));
        QCOMPARE(left().project.entries.size(), std::size_t{5});
    }

    void whatIsDiscardedIsGone()
    {
        RecoveryFile file(m_folder);
        file.begin(m_project, {});
        file.discard();
        QVERIFY(isEmpty());
        file.append(sample::entry(0, "nothing comes of it"));
        QVERIFY(isEmpty());
    }

    void aWindowThatDidNothingLeavesNothing()
    {
        {
            const RecoveryFile file(m_folder);
        }
        QVERIFY(findRecoveries(m_folder).empty());
        QVERIFY(isEmpty());
    }

    void aGestureIsKeptWhileItGoesOn()
    {
        const std::vector<RecordedCommand> commands = sample::commands(sample::toolPart(0.3));
        {
            RecoveryFile file(m_folder);
            file.begin(m_project, {});
            const std::span all(commands);
            file.keepGesture(all.first(3), 10);
            file.keepGesture(all.first(9), 30);
            file.keepGesture(all.first(9), 35);
            file.keepGesture(all, 40);
        }
        const WorkState state = left().state;
        QVERIFY(same::values(state.gesture, commands));
        QCOMPARE(state.step, std::uint64_t{40});
    }

    void aGestureThatBecameAnEntryIsNotKeptTwice()
    {
        {
            RecoveryFile file(m_folder);
            file.begin(m_project, {});
            file.keepGesture(sample::commands(sample::toolPart(0.3)), 10);
            file.append(sample::entry(0, "Push"));
        }
        QVERIFY(left().state.gesture.empty());
        QCOMPARE(left().state.step, std::uint64_t{0});
        QCOMPARE(left().project.current, 4U);
    }

    void whatIsDamagedIsRescued()
    {
        RecoveryFile(m_folder).begin(m_project, {});
        const std::string database = findRecoveries(m_folder).at(0).folder + "/work.db";
        std::string bytes = [&] {
            std::ifstream in(database, std::ios::binary);
            return std::string{std::istreambuf_iterator<char>(in), {}};
        }();
        const std::size_t place = bytes.find("Another try");
        QVERIFY(place != std::string::npos);
        bytes[place] = 'a';
        std::ofstream(database, std::ios::binary) << bytes;
        const RecoveredWork work = left();
        QCOMPARE(work.project.entries.size(), std::size_t{3});
        QVERIFY(!work.missing.empty());
    }

    void noiseIsOfferedAndCanBeDropped()
    {
        RecoveryFile(m_folder).begin(m_project, {});
        const Recovery found = findRecoveries(m_folder).at(0);
        std::ofstream(found.folder + "/work.db", std::ios::binary) << std::string(50'000, 'x');
        QCOMPARE(findRecoveries(m_folder).size(), std::size_t{1});
        QVERIFY(!complaint([&] { RecoveryFile(found).read(); }).empty());
        dropRecovery(found);
        QVERIFY(isEmpty());
    }

    /// It has the lock for milliseconds, where a window that works on it keeps it.
    void whatAnotherWindowLooksAtIsFoundToo()
    {
        RecoveryFile(m_folder).begin(m_project, {});
        auto looks = std::make_unique<FileLock>(recovery_files::lock(findRecoveries(m_folder).at(0).folder));
        QVERIFY(looks->isHeld());
        std::vector<Recovery> found;
        std::thread finder([&] { found = findRecoveries(m_folder); });
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        looks.reset();
        finder.join();
        QCOMPARE(found.size(), std::size_t{1});
    }

    /// A disk of 512 KiB, which only root may make.
    void aFullDiskLeavesWhatWasKept()
    {
        std::filesystem::create_directories(m_folder);
        if (mount("tmpfs", m_folder.c_str(), "tmpfs", 0, "size=512k") != 0)
            QSKIP("No disk can be mounted here.");
        std::string sentence;
        bool goesOn = true;
        {
            RecoveryFile file(m_folder);
            file.begin(m_project, {});
            HistoryRecord large = sample::entry(0, "large");
            large.moment = sample::moment(1U << 20U, 8);
            sentence = complaint([&] { file.append(large); });
            goesOn = file.isGoingOn();
            file.append(sample::entry(0, "comes too late"));
        }
        const bool isAsBefore = same::values(left().project, m_project);
        umount(m_folder.c_str());
        QVERIFY2(sentence.starts_with("The work cannot be kept for recovery (No space left on device)."),
                 sentence.c_str());
        QVERIFY(!goesOn);
        QVERIFY(isAsBefore);
    }

    void afterAFailureItBeginsAnew()
    {
        RecoveryFile file(m_folder);
        file.begin(m_project, {});
        struct Stop final : TaskControl {
            void report(double, std::string_view) override {}
            bool isCancelled() const override { return true; }
        } stop;
        QVERIFY_EXCEPTION_THROWN(file.begin({}, {}, stop), Cancelled);
        QVERIFY(same::values(file.read().project, m_project)); // nothing has changed
        file.begin(m_project, {});
        file.append(sample::entry(0, "goes on"));
        QCOMPARE(file.read().project.entries.size(), std::size_t{5});
    }

    void theFolderIsThatOfTheState()
    {
        qputenv("XDG_STATE_HOME", "/some/where");
        QCOMPARE(recoveryFolder(), std::string("/some/where/knead/recovery"));
        qunsetenv("XDG_STATE_HOME");
        qputenv("HOME", "/home/ann");
        QCOMPARE(recoveryFolder(), std::string("/home/ann/.local/state/knead/recovery"));
    }
};

QTEST_GUILESS_MAIN(RecoveryTest)
#include "recovery_test.moc"
