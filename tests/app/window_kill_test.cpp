#include "core/document/mended_project.h"
#include "io/importer.h"
#include "io/project/packing.h"
#include "io/project/project_file.h"
#include "io/project/recovery.h"
#include "support/fuzz_random.h"
#include "support/window_on_test.h"
#include "ui/project/project_keeper.h"
#include "ui/run_window.h"

#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <deque>
#include <filesystem>
#include <iterator>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace knead;

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto mostLost = std::chrono::seconds(5);

/// What the window says of itself, over and over.
struct Word {
    enum class Kind : std::uint32_t { working, saving, saved } kind = Kind::working;
    std::uint32_t entries = 0; ///< of the history
    std::uint32_t current = 0;
    std::uint32_t isUnderWay = 0; ///< something is done that is not in them
    std::uint64_t step = 0;
    std::uint64_t hash = 0; ///< of the current entry
    std::int64_t time = 0;  ///< of the steady clock [ns]
};

// --- what the window does until it is killed ------------------------------------------------------------------------------

/// What the window does: a bit of everything; nothing but letting time run; or saving and exporting without a pause.
enum class Work { all, play, save };
constexpr const char* workNames[] = {"--work", "--play", "--save"};

/// A window that works without end, driven by timers.
class Worker : public QObject, WindowOnTest {
public:
    explicit Worker(const QString& folder)
        : m_folder(folder)
    {
    }

    void begin(Work work)
    {
        prepare();
        qputenv("XDG_STATE_HOME", m_folder.toUtf8());
        m_services.projects.write = [write = m_services.projects.write](const std::string& path, const Project& project,
                                                                        TaskControl& control) {
            sayOfSaving(Word::Kind::saving, project);
            write(path, project, control);
            sayOfSaving(Word::Kind::saved, project);
        };
        show(m_services);
        m_window->open(QStringList(m_folder + "/work.knead"));
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty() && !m_window->tasks().isRunning(), patience);
        every(20, [this] { say(); });
        if (work == Work::all)
            workOnAll();
        else if (work == Work::save)
            saveAndExport();
        document().play();
        say();
    }

private:
    void workOnAll()
    {
        every(700, [this] { push(); });
        every(2300, [this] { document().togglePlay(); });
        every(1900, [this] { m_window->projects().save(); });
        every(3100, [this] { m_window->exportTo(m_folder + "/out.stl"); });
    }

    void saveAndExport()
    {
        every(700, [this] { push(); });
        every(30, [this] {
            if (m_window->tasks().isRunning())
                return;
            if ((m_isExportNext = !m_isExportNext))
                m_window->projects().save();
            else
                m_window->exportTo(m_folder + "/out.stl");
        });
    }

    void every(int milliseconds, const std::function<void()>& action)
    {
        auto* timer = new QTimer(this);
        connect(timer, &QTimer::timeout, this, action);
        timer->start(milliseconds);
    }

    /// Down and up in turns; the tool is there.
    void push()
    {
        document().select({Selection::Kind::Tool, 0});
        const auto key = m_isDown ? Qt::Key_PageUp : Qt::Key_PageDown;
        QTest::keyRelease(&m_window->viewport(), m_isDown ? Qt::Key_PageDown : Qt::Key_PageUp);
        QTest::keyPress(&m_window->viewport(), key);
        m_isDown = !m_isDown;
    }

    static void sayOfSaving(Word::Kind kind, const Project& project)
    {
        tell({.kind = kind, .hash = project.entries[project.current].hash});
    }

    static void tell(Word word)
    {
        word.time = Clock::now().time_since_epoch().count();
        [[maybe_unused]] const auto written = write(STDOUT_FILENO, &word, sizeof word);
    }

    void say()
    {
        const DocumentHistory& history = document().history();
        if (!history.isSettled() || document().isGoing())
            return;
        Word word;
        word.entries = static_cast<std::uint32_t>(history.tree().records().size());
        word.current = history.tree().current();
        word.isUnderWay = document().isAnythingUnderWay() ? 1 : 0;
        word.step = snapshot().step;
        word.hash = history.tree().record(word.current).hash;
        tell(word);
    }

    QString m_folder;
    bool m_isDown = false;
    bool m_isExportNext = false;
};

int workForever(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    Worker worker(argv[2]);
    const auto* name = std::find(std::begin(workNames), std::end(workNames), std::string(argv[1]));
    worker.begin(static_cast<Work>(name - std::begin(workNames)));
    return QApplication::exec();
}

// --- and what its parent does ---------------------------------------------------------------------------------------------

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
            while (read(m_said, &word, sizeof word) == sizeof word)
                m_words.push_back(word);
        });
    }

    bool isAtWork() const { return m_isAtWork; }

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
    std::uint64_t m_inFile = 0; ///< hash of what was saved last for sure
    int m_recoveries = 0;
    int m_cutSavings = 0;

    std::string file() const { return (m_folder + "/work.knead").toStdString(); }

    /// A bar with a block above it.
    void makeProject()
    {
        show(m_services);
        openExample("bar.step", 12);
        QTest::keyClick(m_window.get(), Qt::Key_B);
        QTRY_VERIFY(!snapshot().tools.empty());
        m_window->projects().saveTo(QString::fromStdString(file()));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->projects().path().isEmpty(), patience);
        const History& tree = document().history().tree();
        m_inFile = tree.record(tree.current()).hash;
        m_window->projects().close();
        m_window.reset();
    }

    /// @return how many entries are in the file
    std::size_t checkFile(const std::deque<Word>& words)
    {
        std::vector<std::uint64_t> allowed{m_inFile};
        for (const Word& word : words) {
            if (word.kind == Word::Kind::saved)
                allowed = {word.hash};
            else if (word.kind == Word::Kind::saving)
                allowed.push_back(word.hash);
        }
        const Project project = readProject(file());
        m_inFile = project.entries[project.current].hash;
        const bool isBeforeOrAfter = std::find(allowed.begin(), allowed.end(), m_inFile) != allowed.end();
        [&] { QVERIFY(isBeforeOrAfter); }();
        return project.entries.size();
    }

    /// What was there 5 s before it was killed is in the file or in the recovery.
    void checkRecovery(const std::deque<Word>& words, Clock::time_point killed, std::size_t entriesInFile)
    {
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

    static bool isCutSaving(const std::deque<Word>& words)
    {
        const auto last = std::find_if(words.rbegin(), words.rend(),
                                       [](const Word& word) { return word.kind != Word::Kind::working; });
        return last != words.rend() && last->kind == Word::Kind::saving;
    }

    /// It is whole, or not there.
    void checkExport()
    {
        const std::string path = (m_folder + "/out.stl").toStdString();
        if (std::filesystem::exists(path))
            QVERIFY(importFile(path).parts.front().watertight);
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            QSKIP("The view needs a display: run this test under xvfb-run.");
        prepare();
        m_folder = m_temporary.path();
        qputenv("XDG_STATE_HOME", m_folder.toUtf8());
        makeProject();
    }

    void aKillLosesFiveSecondsAtMost_data()
    {
        constexpr int kills = 20;
        QTest::addColumn<int>("work");
        QTest::addColumn<int>("time"); // [ms]
        fuzz::Random random(17);
        const Work works[] = {Work::all, Work::save, Work::all, Work::save, Work::play};
        for (int i = 0; i < kills; ++i) {
            const Work work = works[i % 5];
            const int least = work == Work::play ? 7000 : 500; // one gesture, which is longer than what may be lost
            const int time = least + static_cast<int>(random.below(i % 5 == 0 ? 9000 : 3000));
            QTest::addRow("kill %d", i + 1) << static_cast<int>(work) << time;
        }
    }

    void aKillLosesFiveSecondsAtMost()
    {
        QFETCH(int, work);
        QFETCH(int, time);
        for (const Recovery& recovery : findRecoveries())
            dropRecovery(recovery);
        Child child(static_cast<Work>(work), m_folder);
        QVERIFY(child.isAtWork());
        std::this_thread::sleep_for(std::chrono::milliseconds(time));
        const std::deque<Word> words = child.kill();
        const std::size_t entries = checkFile(words);
        checkRecovery(words, child.killed(), entries);
        checkExport();
        m_recoveries += static_cast<int>(findRecoveries().size());
        m_cutSavings += isCutSaving(words) ? 1 : 0;
    }

    void manyKillsLeaveSomething()
    {
        qInfo("%d kills left something to recover, %d came while saving", m_recoveries, m_cutSavings);
        QVERIFY(m_recoveries >= 5);
    }

    /// Of what the last kill left, if it left anything.
    void theNextWindowOffersIt()
    {
        const std::vector<Recovery> left = findRecoveries();
        if (left.empty())
            QSKIP("The last kill came just after a saving.");
        show(m_services);
        m_window->offerRecoveries();
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
