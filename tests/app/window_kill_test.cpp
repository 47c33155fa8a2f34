#include "core/document/mended_project.h"
#include "io/importer.h"
#include "io/project/packing.h"
#include "io/project/project_file.h"
#include "io/project/recovery.h"
#include "support/fuzz_random.h"
#include "support/stress_window.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <deque>
#include <filesystem>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace knead;

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto mostLost = std::chrono::seconds(5);

/// The process of a window, and what it said until it was killed.
class Child {
public:
    Child(Work work, const QString& folder)
    {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0)
            return;
        m_process = fork();
        if (m_process == 0) {
            dup2(ends[1], STDOUT_FILENO);
            execl("/proc/self/exe", "window_kill_test", workNames[static_cast<int>(work)], folder.toUtf8().constData(),
                  nullptr);
            _exit(127);
        }
        close(ends[1]);
        m_said = ends[0];
        Word first;
        m_isAtWork = read(m_said, &first, sizeof first) == sizeof first;
        m_words.push_back(first);
        m_listener = std::thread([this] {
            Word word;
            while (read(m_said, &word, sizeof word) == sizeof word) {
                m_words.push_back(word);
                ++m_saidOf[static_cast<std::size_t>(word.kind)];
            }
        });
    }

    bool isAtWork() const { return m_isAtWork; }

    /// Until it begins to write its project or an export, or does not for long.
    void waitFor(Word::Kind kind) const
    {
        const std::atomic<int>& count = m_saidOf[static_cast<std::size_t>(kind)];
        const Clock::time_point latest = Clock::now() + std::chrono::seconds(10);
        for (const int before = count; count == before && Clock::now() < latest;)
            std::this_thread::sleep_for(std::chrono::microseconds(100));
    }

    std::deque<Word> kill()
    {
        ::kill(m_process, SIGKILL);
        m_killed = Clock::now();
        waitpid(m_process, nullptr, 0);
        m_listener.join();
        close(m_said);
        return m_words;
    }
    Clock::time_point killed() const { return m_killed; }

private:
    pid_t m_process = -1;
    int m_said = -1;
    bool m_isAtWork = false;
    std::array<std::atomic<int>, 5> m_saidOf{}; ///< by Word::Kind
    std::deque<Word> m_words;
    std::thread m_listener;
    Clock::time_point m_killed;
};

} // namespace

/// A window is killed at random moments while it works, saves, keeps its work for recovery and exports.
class WindowKillTest : public QObject, WindowOnTest {
    Q_OBJECT

    QTemporaryDir m_temporary;
    QString m_folder;
    std::uint64_t m_inFile = 0; ///< of the project that was saved last for sure, see digests::of()
    int m_recoveries = 0;
    int m_cutSavings = 0;
    int m_cutExports = 0;

    std::string file() const { return (m_folder + "/work.knead").toStdString(); }
    std::string exported() const { return (m_folder + "/out.stl").toStdString(); }

    /// A bar with a block above it.
    void makeProject()
    {
        show(m_services);
        openExample("bar.step", 12);
        QTest::keyClick(m_window.get(), Qt::Key_B);
        QTRY_VERIFY(!snapshot().tools.empty());
        m_window->projects().saveTo(QString::fromStdString(file()));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->projects().path().isEmpty(), patience);
        m_inFile = digests::of(readProject(file()));
        m_window->features().exports->exportTo(QString::fromStdString(exported()));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY(std::filesystem::exists(exported()));
        m_window->projects().close();
        m_window.reset();
    }

    /// @return what is in the file
    Project checkFile(const std::deque<Word>& words)
    {
        std::vector<std::uint64_t> allowed{m_inFile};
        for (const Word& word : words) {
            if (word.kind == Word::Kind::saved)
                allowed = {word.hash};
            else if (word.kind == Word::Kind::saving)
                allowed.push_back(word.hash);
        }
        Project project = readProject(file());
        m_inFile = digests::of(project);
        const bool isBeforeOrAfter = std::find(allowed.begin(), allowed.end(), m_inFile) != allowed.end();
        [&] { QVERIFY(isBeforeOrAfter); }();
        return project;
    }

    /// What was there 5 s before it was killed is in the file or in the recovery.
    void checkRecovery(const std::deque<Word>& words, Clock::time_point killed, const Project& saved)
    {
        const std::size_t entriesInFile = saved.entries.size();
        const Word* last = nullptr;
        for (const Word& word : words)
            if (word.kind == Word::Kind::working && Clock::time_point(Clock::duration(word.time)) <= killed - mostLost)
                last = &word;
        const std::vector<Recovery> found = findRecoveries();
        if (found.empty()) {
            QVERIFY(last == nullptr || entriesInFile > last->entries ||
                    (entriesInFile == last->entries && last->isUnderWay == 0));
            return;
        }
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].projectFile, file());
        RecoveredWork work = RecoveryFile(found[0]).read();
        QVERIFY(work.missing.empty());
        QVERIFY(digests::beginAlike(work.project, saved));
        const std::size_t entries = work.project.entries.size();
        const std::uint64_t step =
            work.state.step > 0 ? work.state.step : work.project.entries[work.project.current].step;
        if (last != nullptr)
            QVERIFY2(entries > last->entries || (entries == last->entries && step >= last->step),
                     qPrintable(QString("%1 entries and step %2 of %3 and %4")
                                    .arg(entries)
                                    .arg(step)
                                    .arg(last->entries)
                                    .arg(last->step)));
        const MendedProject mended =
            withGesture(std::move(work.project), work.state, zstandardPacking(), TaskControl::none());
        QVERIFY(mended.missing.empty());
        QCOMPARE(withReachableEntry(mended.project, zstandardPacking(), TaskControl::none()).missing.size(),
                 std::size_t{0});
    }

    /// Whether it was killed between saying the one and the other.
    static bool isCut(const std::deque<Word>& words, Word::Kind begun, Word::Kind ended)
    {
        const auto last = std::find_if(words.rbegin(), words.rend(),
                                       [&](const Word& word) { return word.kind == begun || word.kind == ended; });
        return last != words.rend() && last->kind == begun;
    }

    /// There was one before: that or the next is there, whole.
    void checkExport()
    {
        QVERIFY(std::filesystem::exists(exported()));
        QVERIFY(importFile(exported()).parts.front().watertight);
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
        m_folder = m_temporary.path();
        qputenv("XDG_STATE_HOME", m_folder.toUtf8());
        makeProject();
    }

    void aKillLosesFiveSecondsAtMost_data()
    {
        constexpr int kills = 20;
        QTest::addColumn<int>("work");
        QTest::addColumn<int>("time");  // [ms]
        QTest::addColumn<int>("delay"); // after the beginning of a saving or an export [us]
        fuzz::Random random(17);
        const Work works[] = {Work::all, Work::save, Work::all, Work::save, Work::play};
        for (int i = 0; i < kills; ++i) {
            const Work work = works[i % 5];
            const int least = work == Work::play ? 7000 : 500; // one gesture, which is longer than what may be lost
            const int time = least + static_cast<int>(random.below(i % 5 == 0 ? 9000 : 3000));
            QTest::addRow("kill %d", i + 1) << static_cast<int>(work) << time << static_cast<int>(random.below(15'000));
        }
    }

    void aKillLosesFiveSecondsAtMost()
    {
        QFETCH(int, work);
        QFETCH(int, time);
        QFETCH(int, delay);
        for (const Recovery& recovery : findRecoveries())
            dropRecovery(recovery);
        Child child(static_cast<Work>(work), m_folder);
        QVERIFY(child.isAtWork());
        std::this_thread::sleep_for(std::chrono::milliseconds(time));
        if (work == static_cast<int>(Work::save)) {
            const bool isSaving = time % 2 == 0;
            child.waitFor(isSaving ? Word::Kind::saving : Word::Kind::exporting);
            const int wait = isSaving ? delay : delay / 10; // a small mesh is quick
            std::this_thread::sleep_for(std::chrono::microseconds(wait));
        }
        const std::deque<Word> words = child.kill();
        checkRecovery(words, child.killed(), checkFile(words));
        checkExport();
        m_recoveries += static_cast<int>(findRecoveries().size());
        m_cutSavings += isCut(words, Word::Kind::saving, Word::Kind::saved) ? 1 : 0;
        m_cutExports += isCut(words, Word::Kind::exporting, Word::Kind::exported) ? 1 : 0;
    }

    void manyKillsLeaveSomething()
    {
        qInfo("%d kills left something to recover, %d came while saving, %d while exporting", m_recoveries,
              m_cutSavings, m_cutExports);
        QVERIFY(m_recoveries >= 5);
        QVERIFY(m_cutSavings + m_cutExports > 0);
    }

    /// Of what the last kill left, if it left anything.
    void theNextWindowOffersIt()
    {
        const std::vector<Recovery> left = findRecoveries();
        if (left.empty())
            QSKIP("The last kill came just after a saving.");
        show(m_services);
        m_window->projects().offerRecoveries(false);
        QTRY_VERIFY_WITH_TIMEOUT(find<QDialog>("recoveryDialog") != nullptr, patience);
        QTest::keyClick(find<QDialog>("recoveryDialog"), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty(), patience);
        QVERIFY(m_window->isWindowModified());
        QCOMPARE(m_window->projects().path().toStdString(), file());
        m_window->projects().save();
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isWindowModified(), patience);
        m_window->close();
        m_window.reset();
        QVERIFY(findRecoveries().empty());
        QVERIFY(!readProject(file()).entries.empty());
    }
};

int main(int argc, char** argv)
{
    if (argc == 3 && std::string(argv[1]).starts_with("--"))
        return workForever(argc, argv);
    prepareGraphics();
    QApplication application(argc, argv);
    WindowKillTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_kill_test.moc"
