#include "ui/project/autosave.h"

#include <QSignalSpy>
#include <QtTest>

#include <atomic>
#include <stdexcept>

using namespace knead;

namespace {

/// What was asked of KeptWork, and what it holds; it refuses when told to. Read when the thread has nothing to do.
struct Disk {
    Project project;
    WorkState state;
    std::uint64_t revision = 0;
    std::atomic<int> calls = 0;
    std::atomic<bool> isFull = false;
    std::atomic<bool> isSlow = false;
    std::size_t entriesAtFirstMoment = 0; ///< when the first moment came after the rest
    bool hadCurrentMoment = false;        ///< from the beginning
    bool isThere = false;
};

class KeptOnTest final : public KeptWork {
public:
    explicit KeptOnTest(Disk& disk)
        : m_disk(disk)
    {
    }
    RecoveredWork read(TaskControl&) override { return {m_disk.project, m_disk.state, {}}; }
    void begin(const Project& project, const WorkState& state, TaskControl& control) override
    {
        while (m_disk.isSlow)
            QTest::qSleep(1);
        control.throwIfCancelled();
        m_isGoingOn = false;
        m_disk.entriesAtFirstMoment = 0;
        m_disk.hadCurrentMoment = project.entries.at(project.current).moment != nullptr;
        change([&] {
            m_disk.project = project;
            m_disk.state = state;
            m_disk.isThere = true;
        });
        m_isGoingOn = true;
    }
    bool isGoingOn() const override { return m_isGoingOn; }
    void append(const HistoryRecord& record) override
    {
        change([&] {
            m_disk.project.entries.push_back(record);
            m_disk.project.current = static_cast<std::uint32_t>(m_disk.project.entries.size() - 1);
            m_disk.state.gesture.clear();
            ++m_disk.revision;
        });
    }
    void replaceEntry(std::uint32_t entry, const HistoryRecord& record) override
    {
        change([&] {
            m_disk.project.entries.at(entry) = record;
            ++m_disk.revision;
        });
    }
    void replaceMoment(std::uint32_t entry, const HistoryRecord& record) override
    {
        if (m_disk.entriesAtFirstMoment == 0 && record.moment != nullptr)
            m_disk.entriesAtFirstMoment = m_disk.project.entries.size();
        change([&] { m_disk.project.entries.at(entry) = record; });
    }
    void addStart(const ProjectStart& start) override
    {
        change([&] { m_disk.project.starts.push_back(start); });
    }
    void setCurrent(std::uint32_t entry) override
    {
        change([&] { m_disk.project.current = entry; });
    }
    void setView(const ProjectView& view) override
    {
        change([&] { m_disk.project.view = view; });
    }
    void setMarks(const std::vector<ProjectMark>&) override {}
    void setPanels(const std::map<std::string, std::string>& panels) override
    {
        change([&] { m_disk.project.panels = panels; });
    }
    void keepGesture(std::span<const RecordedCommand> commands, std::uint64_t step) override
    {
        change([&] {
            m_disk.state.gesture.assign(commands.begin(), commands.end());
            m_disk.state.step = step;
        });
    }
    std::uint64_t revision() const override { return m_disk.revision; }
    void markSaved(const std::string& file, std::uint64_t revision) override
    {
        change([&] {
            m_disk.state.projectFile = file;
            m_disk.state.isSaved = revision == m_disk.revision;
        });
    }
    void discard() override
    {
        m_disk.isThere = false;
        ++m_disk.calls;
    }

private:
    template <class Change>
    void change(Change change)
    {
        ++m_disk.calls;
        if (m_disk.isFull) {
            m_isGoingOn = false;
            throw std::runtime_error("The disk is full.");
        }
        change();
    }

    Disk& m_disk;
    bool m_isGoingOn = false;
};

HistoryRecord entry(const std::string& name, std::uint32_t parent = 0)
{
    return {.parent = parent, .name = name, .moment = std::make_shared<const std::vector<std::byte>>(3)};
}

} // namespace

class AutosaveTest : public QObject {
    Q_OBJECT

    Disk m_disk;
    Project m_project;
    std::unique_ptr<Autosave> m_autosave;

    void follow()
    {
        for (std::size_t s = m_autosave->knownStarts(); s < m_project.starts.size(); ++s)
            m_autosave->addStart(m_project.starts[s]);
        m_autosave->follow(m_project.entries, m_project.current);
        m_autosave->followPanels(m_project.panels);
    }

    /// The thread has done what it was given.
    void settle() { m_autosave.reset(); }

    bool isKeptAsItIs() const
    {
        const Project& kept = m_disk.project;
        bool isSame = kept.entries.size() == m_project.entries.size() && kept.current == m_project.current &&
                      kept.starts.size() == m_project.starts.size() && kept.panels == m_project.panels;
        for (std::size_t i = 0; isSame && i < kept.entries.size(); ++i)
            isSame = kept.entries[i].name == m_project.entries[i].name &&
                     kept.entries[i].isKey == m_project.entries[i].isKey &&
                     kept.entries[i].moment == m_project.entries[i].moment;
        return isSame;
    }

private slots:
    void init()
    {
        m_disk.project = {};
        m_disk.state = {};
        m_disk.revision = 0;
        m_disk.calls = 0;
        m_disk.isFull = m_disk.isSlow = m_disk.isThere = false;
        m_project = {};
        m_project.starts.resize(1);
        m_project.entries = {entry("Start"), entry("Push")};
        m_project.current = 1;
        ProjectServices services;
        services.keepWork = [this] { return std::make_unique<KeptOnTest>(m_disk); };
        m_autosave = std::make_unique<Autosave>(services);
        m_autosave->begin(m_project, {.projectFile = "a.knead"});
    }

    void cleanup() { m_autosave.reset(); }

    void whatChangesInTheHistoryIsKept()
    {
        m_project.entries.push_back(entry("Again", 1));
        m_project.entries.push_back(entry("And again", 2));
        m_project.current = 3;
        follow();
        m_project.entries[1].name = "Push hard";
        m_project.entries[2].isKey = true;
        m_project.entries[0].moment = nullptr;
        m_project.current = 1;
        follow();
        m_project.starts.emplace_back();
        m_project.entries.push_back(entry("Refill", 1));
        m_project.current = 4;
        m_project.panels["fixtures"] = "[1, 2]";
        follow();
        settle();
        QVERIFY(isKeptAsItIs());
        QCOMPARE(m_disk.state.projectFile, std::string("a.knead"));
    }

    void whatHasNotChangedIsNotWritten()
    {
        for (int i = 0; i < 10; ++i)
            follow();
        settle();
        QCOMPARE(m_disk.calls.load(), 2); // all but the first moment, and that
    }

    void workThatCameWhileSavingIsNotSaved()
    {
        m_autosave->savingBegins();
        m_project.entries.push_back(entry("Meanwhile", 1));
        m_project.current = 2;
        follow();
        m_autosave->saved("b.knead");
        settle();
        QVERIFY(!m_disk.state.isSaved);
        QCOMPARE(m_disk.state.projectFile, std::string("b.knead"));
    }

    void savedWorkIsSaved()
    {
        m_project.entries.push_back(entry("Before", 1));
        m_project.current = 2;
        follow();
        m_autosave->savingBegins();
        m_autosave->saved("b.knead");
        settle();
        QVERIFY(m_disk.state.isSaved);
    }

    void aMomentThatIsThinnedOutOrFoundAgainIsNoWork()
    {
        m_autosave->savingBegins();
        m_project.entries[0].moment = nullptr;
        follow();
        m_project.entries[0].moment = entry("").moment;
        follow();
        m_autosave->saved("b.knead");
        settle();
        QVERIFY(m_disk.state.isSaved);
        QVERIFY(isKeptAsItIs());
    }

    void aNameIsWork()
    {
        m_autosave->savingBegins();
        m_project.entries[0].name = "Beginning";
        follow();
        m_autosave->saved("b.knead");
        settle();
        QVERIFY(!m_disk.state.isSaved);
    }

    /// Work of windows that are gone, which another window may have taken over.
    void whatFailsElsewhereIsToldApart()
    {
        ProjectServices services;
        services.keepWork = [this] { return std::make_unique<KeptOnTest>(m_disk); };
        services.findRecoveries = []() -> std::vector<Recovery> { throw std::runtime_error("It cannot be listed."); };
        services.dropRecovery = [](const Recovery&) { throw std::runtime_error("Another window has it."); };
        m_autosave = std::make_unique<Autosave>(services);
        m_autosave->begin(m_project, {});
        const QSignalSpy failures(m_autosave.get(), &Autosave::failed);
        const QSignalSpy elsewhere(m_autosave.get(), &Autosave::recoveriesFailed);
        m_autosave->find([](const std::vector<Recovery>&) {});
        m_autosave->drop({});
        QTRY_COMPARE(elsewhere.size(), 2);
        QCOMPARE(elsewhere[0][0].toString(), QString("It cannot be listed."));
        QCOMPARE(elsewhere[1][0].toString(), QString("Another window has it."));
        QCOMPARE(failures.size(), 0);
    }

    void whatIsDoneDoesNotWaitForOldMoments()
    {
        constexpr std::uint32_t many = 20;
        for (std::uint32_t i = 2; i < many; ++i)
            m_project.entries.push_back(entry(std::to_string(i), i - 1));
        m_project.current = many - 1;
        m_disk.isSlow = true;
        m_autosave->begin(m_project, {});
        m_project.entries.push_back(entry("New", many - 1));
        m_project.current = many;
        m_project.entries[3].name = "Renamed";
        m_project.entries[4].moment = nullptr;
        follow();
        m_disk.isSlow = false;
        settle();
        QVERIFY(isKeptAsItIs());
        QCOMPARE(m_disk.entriesAtFirstMoment, std::size_t{many + 1});
        QVERIFY(m_disk.hadCurrentMoment);
    }

    void aDiskThatRefusesIsToldOnceAndTriedAgain()
    {
        const QSignalSpy failures(m_autosave.get(), &Autosave::failed);
        m_disk.isFull = true;
        for (const char* name : {"one", "two", "three"}) {
            m_project.entries.push_back(entry(name, 1));
            m_project.current = static_cast<std::uint32_t>(m_project.entries.size() - 1);
            follow();
        }
        QTRY_COMPARE(failures.size(), 1);
        QTest::qWait(50);
        QCOMPARE(failures.size(), 1);
        QCOMPARE(failures[0][0].toString(), QString("The disk is full."));
        m_disk.isFull = false;
        m_autosave->beginAgain(m_project, {});
        m_project.entries.push_back(entry("four", 1));
        m_project.current = 5;
        follow();
        settle();
        QVERIFY(isKeptAsItIs());
    }

    void whatIsDiscardedIsGone()
    {
        m_autosave->discard();
        follow();
        settle();
        QVERIFY(!m_disk.isThere);
    }

    void whatIsTakenOverIsReplaced()
    {
        Disk left;
        left.isThere = true;
        m_autosave->takeOver(std::make_shared<KeptOnTest>(left), m_project, {.projectFile = "c.knead"});
        settle();
        QVERIFY(!m_disk.isThere);
        QVERIFY(left.isThere);
        QCOMPARE(left.state.projectFile, std::string("c.knead"));
        QCOMPARE(left.project.entries.size(), std::size_t{2});
    }
};

QTEST_MAIN(AutosaveTest)
#include "autosave_test.moc"
