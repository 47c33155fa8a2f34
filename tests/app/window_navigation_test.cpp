#include "core/session/history_outline.h"
#include "support/fuzz_random.h"
#include "support/history_on_test.h"
#include "ui/run_window.h"

#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTreeWidget>
#include <QtTest>

#include <algorithm>
#include <map>

using namespace knead;

/// Going anywhere in the history: with its panel, in any order, and when memory is short.
class WindowNavigationTest : public QObject, HistoryOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { openRefilledBar(); }
    void cleanup() { m_window.reset(); }

    void aClickInThePanelGoesThere()
    {
        auto* panel = find<QTreeWidget>("historyTree");
        find<QDockWidget>("historyDock")->raise();
        const auto itemOf = [&](Entry entry) -> QTreeWidgetItem* {
            for (QTreeWidgetItemIterator it(panel); *it != nullptr; ++it)
                if ((*it)->data(0, Qt::UserRole).toUInt() == entry)
                    return *it;
            return nullptr;
        };
        QTRY_VERIFY(itemOf(0) != nullptr);
        const auto clickItem = [&](Entry entry, int column = 0) {
            const QRect row = panel->visualItemRect(itemOf(entry));
            const int x = panel->columnViewportPosition(column) + (column == 0 ? row.left() + 40 : 8);
            QTest::mouseClick(panel->viewport(), Qt::LeftButton, {}, QPoint(x, row.center().y()));
        };
        addBlock();
        settle();
        const Entry withBlock = tree().current();
        const std::uint64_t blockDigest = digest();
        key(Qt::Key_G);
        settle();
        simulate(0.15);
        settle();
        const Entry simulated = tree().current();
        QTRY_VERIFY(itemOf(simulated) != nullptr && itemOf(simulated)->font(0).bold());
        clickItem(withBlock);
        settle();
        QCOMPARE(tree().current(), withBlock);
        QCOMPARE(digest(), blockDigest);
        QTRY_VERIFY(itemOf(withBlock)->font(0).bold() && !itemOf(simulated)->font(0).bold());

        // Something else begins a branch; what was done before moves aside.
        simulate(0.1);
        settle();
        QTRY_VERIFY(itemOf(tree().current()) != nullptr);
        QCOMPARE(itemOf(simulated)->parent(), itemOf(withBlock));
        QCOMPARE(itemOf(tree().current())->parent(), nullptr);
        clickItem(simulated);
        settle();
        QCOMPARE(tree().current(), simulated);

        clickItem(simulated, 1);
        QVERIFY(tree().record(simulated).isKey);
        panel->setCurrentItem(itemOf(simulated), 0);
        panel->setFocus();
        QTest::keyClick(panel, Qt::Key_F2);
        auto* editor = panel->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, "hanging down");
        picture("history");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(tree().record(simulated).name, std::string("hanging down"));
        QTRY_COMPARE(itemOf(simulated)->text(0), QString("hanging down"));
        QVERIFY(find<QLabel>("historyMemory")->text().endsWith(" kB"));
        auto* allowed = find<QSpinBox>("historyMemoryAllowed");
        allowed->setValue(100);
        QCOMPARE(document().history().memoryLimit(), std::size_t{100} << 20U);
        allowed->setValue(512);
        m_window->features().preferences->setTheme(Theme::Dark);
        drawn();
        picture("history-dark");
        m_window->features().preferences->setTheme(Theme::Light);
    }

    void anySequenceOfEditsComesBack_data()
    {
        QTest::addColumn<int>("seed");
        QTest::newRow("1") << 1;
        QTest::newRow("2") << 2;
    }
    void anySequenceOfEditsComesBack()
    {
        QFETCH(int, seed);
        fuzz::Random random(static_cast<std::uint64_t>(seed));
        std::map<Entry, std::uint64_t> digests{{tree().current(), digest()}};
        const Box box = document().content().box;
        int goings = 0;
        for (int i = 0; i < 60; ++i) {
            const std::size_t what = random.below(15);
            switch (what) {
            case 0:
                key(Qt::Key_B);
                break;
            case 1:
                key(Qt::Key_Delete);
                break;
            case 2:
                key(Qt::Key_G);
                break;
            case 3:
                document().toggleFace(0, static_cast<std::uint32_t>(random.below(6)));
                break;
            case 4:
                document().post(SetMaterial{0, {.youngsModulus = 1e5 * static_cast<double>(1 + random.below(9))}});
                break;
            case 5:
                key(Qt::Key_N);
                break;
            case 6:
                key(Qt::Key_Period);
                break;
            case 7:
            case 8:
                key(Qt::Key_Space);
                QTest::qWait(static_cast<int>(random.below(120)));
                key(Qt::Key_Space);
                break;
            case 9:
                if (random.below(4) == 0) {
                    m_window->features().imports->refill(document().size() / static_cast<double>(8 + random.below(6)));
                    QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
                }
                break;
            case 10:
                document().goToEntry(static_cast<Entry>(random.below(tree().records().size())));
                ++goings;
                break;
            case 11:
                branchSomewhere(random);
                ++goings;
                break;
            default:
                for (std::size_t times = 1 + random.below(3); times > 0; --times)
                    random.below(3) == 0 ? redo() : undo();
                ++goings;
            }
            if (random.below(3) == 0)
                continue; // at once something else
            const std::uint64_t now = digest();
            if (QTest::currentTestFailed())
                return;
            const auto [known, isNew] = digests.emplace(tree().current(), now);
            QVERIFY2(known->second == now,
                     qPrintable(QString("%1: entry %2, after %3").arg(i).arg(tree().current()).arg(what)));
        }
        for (const auto& [entry, before] : digests) {
            document().goToEntry(entry);
            QCOMPARE(digest(), before);
        }
        verifyStraightRun();
        verifyPanel();
        qInfo("%zu entries, %zu seen, %d goings, %zu bytes", tree().records().size(), digests.size(), goings,
              tree().memory());
    }

    void thinnedEntriesAreFoundAgainAndAGoingCanBeCancelled()
    {
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        simulate(0.3);
        const std::uint64_t first = digest();
        const Entry thinned = tree().current();
        document().post(SetGravity{Vec3(0, 0, 5)});
        settle();
        std::vector<HistoryRecord> records = tree().records();
        for (Entry entry = 1; entry < records.size(); ++entry)
            if (entry != tree().current())
                records[entry].moment = nullptr;
        Project project = document().project();
        project.entries = records;
        document().open(prepareProject(project, m_services.packing, TaskControl::none()));
        const std::uint64_t last = digest();
        undo();
        QVERIFY(m_window->tasks().isRunning());
        m_window->tasks().cancel();
        settle();
        QCOMPARE(digest(), last);
        QCOMPARE(tree().current(), project.current);
        QVERIFY(!tree().record(thinned).moment);
        undo();
        QVERIFY(m_window->tasks().isRunning());
        QCOMPARE(digest(), first);
        QCOMPARE(tree().current(), thinned);
        QVERIFY(tree().record(thinned).moment != nullptr);
    }

    void whatIsDoneOnAWayThatIsCancelledHappensWhereOneStays()
    {
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        simulate(0.3);
        settle();
        document().post(SetGravity{Vec3(0, 0, 5)});
        settle();
        forgetMoments();
        const Entry last = tree().current();
        undo();
        QVERIFY(m_window->tasks().isRunning());
        key(Qt::Key_B);
        document().post(SetMaterial{0, {.youngsModulus = 7e5}});
        QVERIFY(snapshot().tools.empty());
        m_window->tasks().cancel();
        settle();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(snapshot().materials[0].youngsModulus, 7e5);
        QCOMPARE(present().parent, last);
    }

    void whatIsGrabbedOnAWayIsNotHeldForEver()
    {
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        addBlock();
        simulate(0.3);
        key(Qt::Key_F);
        rest();
        document().post(SetGravity{Vec3(0, 0, 5)});
        settle();
        forgetMoments();
        const Entry last = tree().current();
        ViewportWidget& view = m_window->viewport();
        const QPoint place = view.widgetPosition(snapshot().tools[0].pose.position)->toPoint();
        undo();
        QVERIFY(document().isGoing());
        QTest::mousePress(&view, Qt::LeftButton, {}, place);
        QTest::mouseMove(&view, place + QPoint(20, 0));
        settle();
        QTest::mouseMove(&view, place + QPoint(40, 0));
        QTest::mouseRelease(&view, Qt::LeftButton, {}, place + QPoint(40, 0));
        document().post(SetMaterial{0, {.youngsModulus = 7e5}});
        settle();
        QCOMPARE(snapshot().materials[0].youngsModulus, 7e5);
        QCOMPARE(present().parent, tree().record(last).parent);
    }

    void aHundredEntriesOfALargeBodyStayWithinMemoryWhileTheWindowAnswers()
    {
        m_window->features().imports->refill(spacingOfObjects(27'000));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY(snapshot().objects > 20'000);
        settle();
        constexpr std::size_t memory = std::size_t{48} << 20U;
        document().history().setMemory(memory);
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        QElapsedTimer clock;
        qint64 longest = 0;
        for (int i = 0; i < 100; ++i) {
            document().stepOnce();
            document().finishGesture();
            clock.start();
            QTest::qWait(10);
            longest = std::max(longest, clock.elapsed());
            QVERIFY(tree().memory() <= memory);
        }
        settle();
        QVERIFY(tree().records().size() >= 100);
        QVERIFY(tree().memory() <= memory);
        const std::uint64_t end = digest();
        for (int i = 0; i < 5; ++i)
            undo();
        settle();
        for (int i = 0; i < 5; ++i)
            redo();
        QCOMPARE(digest(), end);
        document().history().setMemory(History::defaultMemory);
        qInfo("%zu entries, %zu bytes, the window answered within %lld ms", tree().records().size(), tree().memory(),
              longest);
    }

    void anEntryIsOneMoreRowHoweverManyThereAre()
    {
        constexpr std::size_t many = 3000;
        document().post(SetGravity{Vec3(0, 0, -9.81)});
        settle();
        Project project = document().project();
        for (std::size_t i = project.entries.size(); i < many; ++i) {
            project.entries.push_back(project.entries.back());
            project.entries.back().parent = static_cast<Entry>(i - 1);
        }
        project.current = many - 1;
        document().open(prepareProject(project, m_services.packing, TaskControl::none()));
        settle();
        auto* panel = find<QTreeWidget>("historyTree");
        find<QDockWidget>("historyDock")->raise();
        QTRY_COMPARE(panel->topLevelItemCount(), static_cast<int>(many));
        int changes = 0;
        const auto count = [&changes] { ++changes; };
        connect(panel->model(), &QAbstractItemModel::dataChanged, this, count);
        connect(panel->model(), &QAbstractItemModel::rowsInserted, this, count);
        connect(panel->model(), &QAbstractItemModel::modelReset, this, [&changes] { changes += 1000; });
        document().post(SetGravity{Vec3(0, 0, 5)});
        settle();
        QTRY_COMPARE(panel->topLevelItemCount(), static_cast<int>(many + 1));
        document().history().rename(many - 2, "up there");
        QTRY_COMPARE(panel->topLevelItem(many - 2)->text(0), QString("up there"));
        QVERIFY2(changes < 20, qPrintable(QString::number(changes)));
        QVERIFY(panel->topLevelItem(many)->font(0).bold() && !panel->topLevelItem(many - 1)->font(0).bold());
    }

    void whatIsDoneOnTheWayHappensThere()
    {
        addBlock();
        settle();
        undo();
        key(Qt::Key_G); // before the simulation is there
        settle();
        QTRY_VERIFY(!snapshot().gravity.isZero());
        QVERIFY(snapshot().tools.empty());
        settle();
        QCOMPARE(presentName(), QString("Gravity on"));
        QCOMPARE(present().parent, Entry{1});
        QVERIFY(!action("redo")->isEnabled());
        document().goToEntry(2);
        settle();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
    }

private:
    /// As when the memory for undo is full: what lies behind is found by repeating it, which takes a while.
    void forgetMoments()
    {
        Project project = document().project();
        for (Entry entry = 1; entry < project.current; ++entry)
            project.entries[entry].moment = nullptr;
        document().open(prepareProject(project, m_services.packing, TaskControl::none()));
        settle();
    }

    /// Whatever is under way.
    void branchSomewhere(fuzz::Random& random)
    {
        const auto entry = static_cast<Entry>(random.below(tree().records().size()));
        const HistoryRecord& record = tree().record(entry);
        const std::uint64_t begin = std::min(record.step, tree().record(record.parent).step);
        document().branchAt(entry, begin + random.below(record.step - begin + 1));
    }

    /// The panel lists the entries as they hang together.
    void verifyPanel()
    {
        auto* panel = find<QTreeWidget>("historyTree");
        find<QDockWidget>("historyDock")->raise();
        const std::vector<Entry> wanted = entriesOf(outlineOf(tree()));
        const auto listed = [panel] {
            std::vector<Entry> entries;
            for (QTreeWidgetItemIterator it(panel); *it != nullptr; ++it)
                entries.push_back((*it)->data(0, Qt::UserRole).toUInt());
            return entries;
        };
        QTRY_COMPARE(listed(), wanted);
    }

    static std::vector<Entry> entriesOf(const std::vector<OutlineRow>& rows)
    {
        std::vector<Entry> entries;
        for (const OutlineRow& row : rows) {
            entries.push_back(row.entry);
            for (const auto& branch : row.branches)
                for (const Entry entry : entriesOf(branch))
                    entries.push_back(entry);
        }
        return entries;
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowNavigationTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_navigation_test.moc"
