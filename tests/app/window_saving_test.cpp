#include "io/project/project_file.h"
#include "io/project/recovery.h"
#include "support/projects_on_test.h"
#include "ui/run_window.h"

#include <QTimer>

#include <utility>

using namespace knead;

/// What is saved when other things happen at the same time, and where.
class WindowSavingTest : public QObject, ProjectsOnTest {
    Q_OBJECT

    QString m_home = QDir::currentPath();

    std::size_t entries() { return document().history().tree().records().size(); }
    static std::size_t entriesIn(const QString& path) { return readProject(bytesOf(path)).entries.size(); }

    void pressSave() { QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ControlModifier); }

    /// What is written while the disk is slow waits for it, whatever is cancelled.
    Services servicesThatCannotBeStopped()
    {
        Services services = m_services;
        services.projects.write = [this, write = m_services.projects.write](
                                      const std::string& path, const Project& project, TaskControl& /*control*/) {
            const bool waits = m_isDiskSlow && !m_isWaiting.exchange(true);
            while (waits && m_isDiskSlow)
                QTest::qSleep(5);
            write(path, project, TaskControl::none());
        };
        return services;
    }
    std::atomic<bool> m_isWaiting = false;

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init()
    {
        m_isWaiting = false;
        begin();
    }

    void cleanup()
    {
        m_isDiskSlow = false;
        m_window.reset();
        QDir::setCurrent(m_home);
    }

    void aProjectOpenedByARelativePathIsSavedWhereItIs()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        newWindow(m_services);
        QDir::setCurrent(m_folder->path());
        openProject("a.knead");
        QCOMPARE(projects().path(), file("a.knead"));
        switchGravity();
        pressSave();
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isWindowModified(), patience);
        openProject("./a.knead"); // once more, in the window that has it
        QVERIFY2(problem().isEmpty(), qPrintable(problem()));

        switchGravity();
        const std::size_t left = entries();
        newWindow(m_services);
        QVERIFY(QDir().mkdir(file("elsewhere")));
        QDir::setCurrent(file("elsewhere"));
        recoverByHand();
        QCOMPARE(projects().path(), file("a.knead"));
        m_window->activateWindow(); // the dialog is gone
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        pressSave();
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isWindowModified(), patience);
        QCOMPARE(entriesIn(file("a.knead")), left);
        QVERIFY(!QFile::exists("a.knead"));
    }

    void aLinkToTheOpenFileIsSavedTo()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        QVERIFY(QFile::link(file("a.knead"), file("link.knead")));
        switchGravity();
        saveTo(file("link.knead"));
        QCOMPARE(entriesIn(file("a.knead")), entries());
    }

    void savingComesAfterALongWayBack()
    {
        openAndRefill("bar.step", 10);
        saveTo(file("a.knead"));
        newWindow(m_services);
        openProject(file("a.knead"));
        // In one go: the way over the refill begins, with progress, when the saving is about to.
        QTest::keyClick(m_window.get(), Qt::Key_G);
        document().undo();
        document().undo();
        pressSave();
        QTRY_VERIFY_WITH_TIMEOUT(entries() == 3 && isIdle() && !m_window->isWindowModified(), patience);
        const Project saved = readProject(bytesOf(file("a.knead")));
        QCOMPARE(saved.entries.size(), std::size_t{3});
        QCOMPARE(saved.current, 0U);
    }

    void whatWasSavedBeforeIsNotDiscarded()
    {
        newWindow(servicesWithSlowDisk());
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        switchGravity();
        const std::size_t saved = entries();
        m_isDiskSlow = true;
        pressSave();
        QTRY_VERIFY(m_window->tasks().isRunning());
        switchGravity(); // of no use
        m_window->close();
        answer("saveQuestion", QMessageBox::Discard);
        QVERIFY(m_window->isVisible()); // waits for the disk
        m_isDiskSlow = false;
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), patience);
        m_window.reset();
        QCOMPARE(entriesIn(file("a.knead")), saved);
        QVERIFY(findRecoveries().empty());
    }

    void whatIsDoneDuringTheLastSavingIsAskedAbout()
    {
        newWindow(servicesWithSlowDisk());
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        switchGravity();
        QTest::keyClick(m_window.get(), Qt::Key_Space); // mere time is not asked about
        m_isDiskSlow = true;
        m_window->close();
        answer("saveQuestion", QMessageBox::Save);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->tasks().isRunning(), patience);
        QVERIFY(!document().isPlaying());
        switchGravity();
        m_isDiskSlow = false;
        answer("saveQuestion", QMessageBox::Save); // that too
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), patience);
        const std::size_t all = entries();
        m_window.reset();
        QCOMPARE(entriesIn(file("a.knead")), all);
    }

    void theFirstEditIsNotSaved()
    {
        bool isDone = false;
        connect(&projects(), &ProjectKeeper::changed, m_window.get(), [&] {
            if (document().isEmpty() || std::exchange(isDone, true))
                return;
            QTest::keyClick(m_window.get(), Qt::Key_G); // before the first moment is packed
            document().finishGesture();
        });
        m_window->open(QStringList(example("bar.step")));
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty(), patience);
        QTRY_VERIFY_WITH_TIMEOUT(entries() == 2, patience);
        QVERIFY(m_window->isWindowModified());
        m_window->close();
        answer("saveQuestion", QMessageBox::Cancel);
        newWindow(m_services);
        QCOMPARE(findRecoveries().size(), std::size_t{1});
    }

    void aCancelledSavingDoesNotEndAfterTheNext()
    {
        newWindow(servicesThatCannotBeStopped());
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        switchGravity();
        m_isDiskSlow = true;
        pressSave();
        QTRY_VERIFY(m_isWaiting);
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(!m_window->tasks().isRunning());
        switchGravity();
        pressSave();
        QTest::qWait(200);
        QVERIFY(m_window->isWindowModified());
        m_isDiskSlow = false;
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isWindowModified(), patience);
        QTest::qWait(200); // the other one would have ended by now
        QCOMPARE(entriesIn(file("a.knead")), entries());
    }

    /// Names and marks are no reason to lose what is under way.
    void gesturesAreKeptWhileEntriesAreRenamed()
    {
        openExample("bar.step", 10);
        wait();
        const auto* watch = projects().findChild<QTimer*>(); // a gesture has just been asked for
        QVERIFY(watch != nullptr);
        connect(watch, &QTimer::timeout, m_window.get(), [this] {
            DocumentHistory& history = document().history();
            history.rename(0, QString::fromStdString(history.tree().record(0).name));
        });
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTest::qWait(4500);
        newWindow(m_services);
        const std::vector<Recovery> left = findRecoveries();
        QCOMPARE(left.size(), std::size_t{1});
        QVERIFY(RecoveryFile(left[0]).read(TaskControl::none()).state.step > 0);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowSavingTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_saving_test.moc"
