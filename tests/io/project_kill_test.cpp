#include "io/files/safe_file.h"
#include "io/project/project_file.h"
#include "io/project/recovery.h"
#include "support/deep.h"
#include "support/killed_child.h"
#include "support/same_values.h"
#include "support/sample_project.h"

#include <QtTest>

#include <filesystem>
#include <span>

using namespace knead;
using namespace knead::killed;

namespace {

/// The project after a number of savings.
Project projectAfter(std::uint32_t savings)
{
    static const Project base = sample::project();
    Project project = base;
    project.marks[0].text = std::to_string(savings);
    project.entries[0].moment = sample::moment(20'000 + 100 * (savings % 7), savings);
    return project;
}

/// The entry that is the n-th to be kept.
HistoryRecord entryNumber(std::uint32_t n)
{
    HistoryRecord record = sample::entry(0, "entry " + std::to_string(n));
    record.commands = sample::commands(projectAfter(0).starts[0].scene.manipulators[1].part);
    record.moment = sample::moment(10'000 + 3000 * (n % 5), n);
    return record;
}

// --- what children do until they are killed -------------------------------------------------------------------------------

/// Says each number before and after the saving with it.
[[noreturn]] void saveForever(const std::string& path)
{
    for (std::uint32_t n = 1;; ++n) {
        const Project project = projectAfter(n);
        say(n);
        writeProject(path, project);
        say(n);
    }
}

/// Each gesture while it goes on, then the entry that it becomes.
[[noreturn]] void keepForever(RecoveryFile& file, std::uint32_t next)
{
    for (std::uint32_t n = next;; ++n) {
        const HistoryRecord record = entryNumber(n);
        const std::span commands(record.commands);
        say(n);
        file.keepGesture(commands.first(commands.size() / 2), n);
        file.keepGesture(commands, n + 1);
        file.append(record);
        say(n);
    }
}

[[noreturn]] void autosaveForever(const std::string& folder)
{
    RecoveryFile file(folder);
    const Project project = projectAfter(0);
    file.begin(project, {});
    keepForever(file, static_cast<std::uint32_t>(project.entries.size()));
}

/// Takes over what another one left, as a person does after a crash, and goes on.
[[noreturn]] void recoverForever(const std::string& folder)
{
    RecoveryFile file(findRecoveries(folder).at(0));
    const RecoveredWork work = file.read();
    file.begin(work.project, work.state);
    keepForever(file, static_cast<std::uint32_t>(work.project.entries.size()));
}

int child(const std::string& work, const std::string& where)
{
    if (work == "--save")
        saveForever(where);
    if (work == "--autosave")
        autosaveForever(where);
    if (work == "--recover")
        recoverForever(where);
    return 2;
}

} // namespace

/// Work survives a kill at any moment.
class ProjectKillTest : public QObject {
    Q_OBJECT
private slots:
    void aFileIsTheOldOrTheNewOne()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("saved.knead").toStdString();
        fuzz::Random random(31);
        int between = 0;
        for (int trial = 0; trial < loadOf(60, 200); ++trial) {
            writeProject(path, projectAfter(0));
            Child child({"--save", path});
            if (trial % 2 == 0)
                QVERIFY(child.waitForEnd());
            waitAWhile(random);
            const Said said = child.kill();
            const Project project = readProject(path);
            const auto is = [&](std::uint32_t n) { return same::values(project, projectAfter(n)); };
            QVERIFY2(is(said.ended) || is(said.begun), std::to_string(trial).c_str());
            between += said.isCut() ? 1 : 0;
        }
        QVERIFY(between > loadOf(6, 20)); // many were killed while they saved
    }

    void whatKilledOnesHadBegunIsRemoved()
    {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("saved.knead").toStdString();
        const auto files = [&] {
            return std::distance(std::filesystem::directory_iterator(folder.path().toStdString()), {});
        };
        writeProject(path, projectAfter(0));
        for (fuzz::Random random(33); files() < 2;) {
            Child child({"--save", path});
            child.waitForEnd();
            waitAWhile(random);
            child.kill();
        }
        const SafeFile another(path); // is being written
        QCOMPARE(files(), 3);
        writeProject(path, projectAfter(0));
        QCOMPARE(files(), 2);
    }

    void aRecoveryHasAllThatWasKept()
    {
        const QTemporaryDir folder;
        const std::string where = folder.path().toStdString();
        fuzz::Random random(32);
        int between = 0;
        for (int trial = 0; trial < loadOf(30, 100); ++trial) {
            Child first({"--autosave", where});
            QVERIFY(first.waitForEnd());
            waitAWhile(random);
            const Said atFirst = first.kill();
            QVERIFY(isKept(where, atFirst));
            Child second({"--recover", where}); // and crashes again, perhaps before it has taken over all of it
            if (trial % 2 == 0)
                QVERIFY(second.waitForEnd());
            waitAWhile(random);
            Said atSecond = second.kill();
            between += (atFirst.isCut() ? 1 : 0) + (atSecond.isCut() || atSecond.begun == 0 ? 1 : 0);
            if (atSecond.begun == 0)
                atSecond = atFirst;
            else if (atSecond.ended == 0)
                atSecond.ended = atSecond.begun - 1;
            QVERIFY2(isKept(where, atSecond), std::to_string(trial).c_str());
            dropRecovery(findRecoveries(where).at(0));
            QVERIFY(findRecoveries(where).empty());
        }
        QVERIFY(between > loadOf(12, 40)); // many were killed while they kept something
    }

private:
    /// None, the first half or all of those that the next entry has.
    static bool isGestureBefore(std::uint32_t next, const WorkState& state)
    {
        const std::vector<RecordedCommand> all = entryNumber(next).commands;
        const std::vector<RecordedCommand> half(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2));
        return (state.gesture.empty() && state.step == 0) ||
               (same::values(state.gesture, half) && state.step == next) ||
               (same::values(state.gesture, all) && state.step == next + 1);
    }

    /// One recovery, with all entries up to those that were kept, and what was under way.
    static bool isKept(const std::string& folder, const Said& said)
    {
        const std::vector<Recovery> found = findRecoveries(folder);
        if (found.size() != 1)
            return false;
        RecoveryFile file(found[0]);
        const RecoveredWork work = file.read();
        Project expected = projectAfter(0);
        while (expected.entries.size() < work.project.entries.size())
            expected.entries.push_back(entryNumber(static_cast<std::uint32_t>(expected.entries.size())));
        expected.current = static_cast<std::uint32_t>(expected.entries.size() - 1);
        const std::size_t count = work.project.entries.size();
        return work.missing.empty() && same::values(work.project, expected) &&
               isGestureBefore(static_cast<std::uint32_t>(count), work.state) &&
               (count == said.ended + 1 || count == said.begun + 1);
    }
};

int main(int argc, char** argv)
{
    if (argc == 3 && std::string(argv[1]).starts_with("--"))
        return child(argv[1], argv[2]);
    QCoreApplication application(argc, argv);
    ProjectKillTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "project_kill_test.moc"
