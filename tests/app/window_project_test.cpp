#include "io/project/project_file.h"
#include "io/project/project_lock.h"
#include "io/project/recovery.h"
#include "support/window_on_test.h"
#include "ui/project/project_keeper.h"
#include "ui/project/recent_files.h"
#include "ui/run_window.h"

#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <stdexcept>

#include <sys/resource.h>

using namespace knead;

/// Projects as a person has them: saved, opened again, left unsaved, locked, damaged, recovered.
class WindowProjectTest : public QObject, WindowOnTest {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    QString file(const char* name) const { return m_folder->filePath(name); }
    static std::string bytesOf(const QString& path) { return QFile::encodeName(path).toStdString(); }
    ProjectKeeper& projects() { return m_window->projects(); }
    std::uint64_t hash()
    {
        const History& tree = document().history().tree();
        return tree.record(tree.current()).hash;
    }

    bool isIdle()
    {
        return !m_window->tasks().isRunning() && document().history().isSettled() && !document().isGoing();
    }
    void wait() { QTRY_VERIFY_WITH_TIMEOUT(isIdle(), patience); }

    /// A block pushed into the bracket, with keys.
    void work()
    {
        openExample("bracket.step", 12);
        pushOn();
    }

    void pushOn()
    {
        if (snapshot().tools.empty()) {
            QTest::keyClick(m_window.get(), Qt::Key_B);
            QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        }
        document().select({Selection::Kind::Tool, snapshot().tools[0].id});
        const double time = snapshot().time;
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTest::keyPress(&m_window->viewport(), Qt::Key_PageDown);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > time + 0.3, patience);
        QTest::keyRelease(&m_window->viewport(), Qt::Key_PageDown);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        QTest::qWait(1200); // a gesture may be gone on with for a second
        wait();
    }

    void openProject(const QString& path)
    {
        m_window->open(QStringList(path));
        wait();
    }

    void saveTo(const QString& path)
    {
        projects().saveTo(path);
        QTRY_VERIFY_WITH_TIMEOUT(isIdle() && projects().path() == path && !projects().isModified(), patience);
    }

    void newWindow(const Services& services)
    {
        m_window.reset(); // as a crash would, but for what is on its way to the disk
        show(services);
    }

    template <class Widget>
    void clickOn(const char* name)
    {
        auto* widget = find<Widget>(name);
        QVERIFY2(widget != nullptr, name);
        QTRY_VERIFY(widget->isVisible());
        QTest::mouseClick(widget, Qt::LeftButton);
    }

    /// Answers the message that is asked.
    void answer(const char* name, QMessageBox::StandardButton button)
    {
        QTRY_VERIFY2(find<QMessageBox>(name) != nullptr && find<QMessageBox>(name)->isVisible(), name);
        QTest::mouseClick(find<QMessageBox>(name)->button(button), Qt::LeftButton);
        QTRY_VERIFY(find<QMessageBox>(name) == nullptr);
        m_window->activateWindow(); // there may be no window manager that does it
    }

    std::vector<std::vector<Vec3>> statesOfSteps(int steps)
    {
        std::vector<std::vector<Vec3>> states;
        for (int i = 0; i < steps; ++i) {
            const std::uint64_t step = snapshot().step;
            document().stepOnce();
            [&] { QTRY_COMPARE_WITH_TIMEOUT(snapshot().step, step + 1, patience); }();
            for (const auto& body : snapshot().bodies)
                states.push_back(body.positions);
        }
        return states;
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            QSKIP("The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        qputenv("XDG_STATE_HOME", m_folder->path().toUtf8());
        recent_files::clear();
        show(m_services);
    }

    void cleanup() { m_window.reset(); }

    void whatIsSavedComesBackToTheBit()
    {
        work();
        // Look from elsewhere, by hand.
        QTest::mousePress(&m_window->viewport(), Qt::MiddleButton, {}, QPoint(300, 200));
        QTest::mouseMove(&m_window->viewport(), QPoint(380, 240));
        QTest::mouseRelease(&m_window->viewport(), Qt::MiddleButton, {}, QPoint(380, 240));
        action("perspective")->trigger();
        QVERIFY(m_window->isWindowModified());
        QVERIFY(m_window->windowTitle().startsWith("bracket.step[*]"));

        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(find<QFileDialog>("saveDialog") != nullptr);
        auto* name = find<QFileDialog>("saveDialog")->findChild<QLineEdit*>("fileNameEdit");
        QVERIFY(name != nullptr);
        QTRY_VERIFY(name->isVisible());
        QCOMPARE(name->text(), QString("bracket.knead"));
        picture("save");
        name->setText(file("my bracket")); // the ending comes by itself
        QTest::keyClick(name, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(projects().path(), file("my bracket.knead"), patience);
        wait();
        QVERIFY(!m_window->isWindowModified());
        QVERIFY(m_window->windowTitle().startsWith("my bracket.knead[*]"));

        const std::uint64_t saved = hash();
        const Camera camera = m_window->viewport().camera();
        const std::size_t entries = document().history().tree().records().size();
        const std::vector<std::vector<Vec3>> later = statesOfSteps(20);

        newWindow(m_services);
        openProject(file("my bracket.knead"));
        QVERIFY2(!document().isEmpty(), qPrintable(m_window->banner().sentence()));
        QCOMPARE(hash(), saved);
        QCOMPARE(document().history().tree().records().size(), entries);
        QVERIFY((m_window->viewport().camera().eye() - camera.eye()).norm() < 1e-9);
        QVERIFY(!m_window->viewport().camera().perspective);
        QVERIFY(!action("perspective")->isChecked());
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QVERIFY(!m_window->isWindowModified());
        QVERIFY(statesOfSteps(20) == later); // goes on to the same bits
        QTest::qWait(300);
        picture("opened project");
    }

    void hiddenPartsStayHidden()
    {
        openExample("bracket.step", 10);
        QTest::keyClick(m_window.get(), Qt::Key_H);
        QCOMPARE(m_window->viewport().options().hiddenParts.size(), std::size_t{1});
        saveTo(file("a.knead"));
        newWindow(m_services);
        openProject(file("a.knead"));
        QCOMPARE(m_window->viewport().options().hiddenParts.size(), std::size_t{1});
    }

    void whatIsNotSavedIsAskedAbout()
    {
        openExample("bar.step", 10);
        wait();
        saveTo(file("a.knead"));
        QTest::keyClick(m_window.get(), Qt::Key_G);
        QTRY_VERIFY(m_window->isWindowModified());

        m_window->close();
        QTRY_VERIFY(find<QMessageBox>("saveQuestion") != nullptr);
        QTest::qWait(100);
        picture("save question");
        answer("saveQuestion", QMessageBox::Cancel);
        QVERIFY(m_window->isVisible());
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTest::keyClick(m_window.get(), Qt::Key_Q, Qt::ControlModifier);
        answer("saveQuestion", QMessageBox::Save);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), patience);
        m_window.reset();
        const Project saved = readProject(bytesOf(file("a.knead")));
        QVERIFY(!saved.entries.back().commands.empty());
        QVERIFY(findRecoveries().empty()); // a clean end leaves nothing
    }

    void whatIsNotWantedIsGone()
    {
        openExample("bar.step", 10);
        QTest::keyClick(m_window.get(), Qt::Key_G);
        QTRY_VERIFY(m_window->isWindowModified());
        m_window->close();
        answer("saveQuestion", QMessageBox::Discard);
        QTRY_VERIFY(!m_window->isVisible());
        m_window.reset();
        QVERIFY(findRecoveries().empty());
    }

    void workBeforeARefillComesBackToo()
    {
        openExample("bar.step", 10); // opened and refilled
        document().undo();
        wait();
        const std::uint64_t first = hash();
        const std::size_t objects = snapshot().objects;
        document().redo();
        wait();
        saveTo(file("a.knead"));
        QVERIFY(snapshot().objects != objects);
        newWindow(m_services);
        openProject(file("a.knead"));
        document().undo();
        wait();
        QTRY_COMPARE_WITH_TIMEOUT(snapshot().objects, objects, patience);
        QCOMPARE(hash(), first);
        QVERIFY(m_window->isWindowModified());
    }

    void aProjectOpensInItsOwnWindowAgain()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        const std::uint64_t saved = hash();
        QTest::keyClick(m_window.get(), Qt::Key_G);
        QTest::qWait(1200);
        wait();
        openProject(file("a.knead")); // as after Discard
        QCOMPARE(hash(), saved);
        QCOMPARE(projects().path(), file("a.knead"));
        QVERIFY(!m_window->isWindowModified());
    }

    void anotherPartIsAnotherProject()
    {
        work();
        saveTo(file("a.knead"));
        openExample("bar.step", 10);
        wait();
        QVERIFY(projects().path().isEmpty());
        QVERIFY(m_window->windowTitle().startsWith("bar.step"));
        QVERIFY(ProjectLock(bytesOf(file("a.knead"))).isHeld()); // nobody works on it any more
        QTest::keyClick(m_window.get(), Qt::Key_G);
        QTest::qWait(1200);
        wait();
        newWindow(m_services);
        const std::vector<Recovery> left = findRecoveries();
        QCOMPARE(left.size(), std::size_t{1});
        QVERIFY(left[0].projectFile.empty());
        QCOMPARE(left[0].part, std::string("Bar"));
    }

    void savingWhileTimeRunsGoesOn()
    {
        openExample("bar.step", 10);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.1, patience);
        projects().saveTo(file("a.knead"));
        QTRY_COMPARE_WITH_TIMEOUT(projects().path(), file("a.knead"), patience);
        QVERIFY(snapshot().playing);
        QTRY_VERIFY(m_window->isWindowModified());
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        const Project saved = readProject(bytesOf(file("a.knead")));
        QVERIFY(saved.entries[saved.current].time >= 0.1);
    }

    void aPlaceThatCannotBeWrittenToIsOneSentence()
    {
        openExample("bar.step", 10);
        projects().saveTo("/proc/nowhere/a.knead");
        QTRY_VERIFY_WITH_TIMEOUT(m_window->banner().sentence().contains("a.knead"), patience);
        QVERIFY(projects().path().isEmpty());
        QCOMPARE(find<QToolButton>("bannerRemedy")->text(), QString("Save as..."));
    }

    void undoingMarksTheTitleToo()
    {
        openExample("bar.step", 10);
        QTest::keyClick(m_window.get(), Qt::Key_G);
        QTest::qWait(1200);
        wait();
        saveTo(file("a.knead"));
        QVERIFY(!m_window->isWindowModified());
        document().undo();
        wait();
        QTRY_VERIFY(m_window->isWindowModified());
    }

    void aWindowThatDidNothingClosesAtOnce()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        newWindow(m_services);
        openProject(file("a.knead"));
        m_window->close();
        QVERIFY(!m_window->isVisible());
    }

    void recentFilesAreOffered()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        newWindow(m_services);
        QTest::qWait(100);
        picture("home with recent files");
        clickOn<QPushButton>("recent_a.knead");
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty(), patience);
        QCOMPARE(projects().path(), file("a.knead"));
        QCOMPARE(find<QMenu>("recentMenu")->actions().front()->text(), QString("a.knead"));
    }

    void aDroppedProjectOpens()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        newWindow(m_services);
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file("a.knead"))});
        QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &enter);
        QDropEvent drop(QPointF(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &drop);
        QTRY_COMPARE_WITH_TIMEOUT(projects().path(), file("a.knead"), patience);
    }

    void aProjectOfAnotherWindowOpensAsACopy()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        newWindow(m_services);
        {
            const ProjectLock other(bytesOf(file("a.knead")));
            openProject(file("a.knead"));
            QVERIFY(document().isEmpty());
            QVERIFY2(m_window->banner().sentence().contains("another window"),
                     qPrintable(m_window->banner().sentence()));
            picture("locked");
            QCOMPARE(find<QToolButton>("bannerRemedy")->text(), QString("Open a copy"));
            clickOn<QToolButton>("bannerRemedy");
            QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty(), patience);
            QVERIFY(projects().path().isEmpty());
        }
        // And this window keeps others out.
        openProject(file("a.knead"));
        QTRY_COMPARE(projects().path(), file("a.knead"));
        QVERIFY_EXCEPTION_THROWN(ProjectLock(bytesOf(file("a.knead"))), std::runtime_error);
    }

    void aDamagedProjectIsRescued()
    {
        openExample("bar.step", 10);
        for (const Qt::Key key : {Qt::Key_G, Qt::Key_B}) {
            QTest::keyClick(m_window.get(), key);
            QTest::qWait(1200);
            wait();
        }
        saveTo(file("a.knead"));
        const std::string last = readProject(bytesOf(file("a.knead"))).entries.back().name;
        newWindow(m_services);
        QFile damaged(file("a.knead"));
        QVERIFY(damaged.open(QFile::ReadWrite));
        QByteArray bytes = damaged.readAll();
        const qsizetype place = bytes.lastIndexOf(QByteArray::fromStdString(last));
        QVERIFY(place > 0);
        bytes[place] = '#';
        damaged.seek(0);
        damaged.write(bytes);
        damaged.close();

        openProject(file("a.knead"));
        QVERIFY(document().isEmpty());
        QVERIFY2(m_window->banner().sentence().contains("damaged"), qPrintable(m_window->banner().sentence()));
        QCOMPARE(find<QToolButton>("bannerRemedy")->text(), QString("Rescue what is whole"));
        QTest::qWait(100);
        picture("damaged");
        clickOn<QToolButton>("bannerRemedy");
        QTRY_VERIFY_WITH_TIMEOUT(find<QMessageBox>("missingBox") != nullptr, patience);
        QTest::qWait(100);
        picture("missing");
        answer("missingBox", QMessageBox::Ok);
        QVERIFY(!document().isEmpty());
        QVERIFY(document().history().tree().records().size() >= 2);
        QVERIFY(m_window->banner().sentence().isEmpty());
        QVERIFY(projects().path().isEmpty()); // the damaged file stays as it is
        QVERIFY(m_window->isWindowModified());
        QCOMPARE(find<QWidget>("mainWindow"), nullptr);
    }

    void aNewerProjectIsOneSentence()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        newWindow(m_services);
        QFile newer(file("a.knead"));
        QVERIFY(newer.open(QFile::ReadWrite));
        newer.seek(60); // the version in the head of the database
        newer.write(QByteArray::fromHex("00000fff"));
        newer.close();
        openProject(file("a.knead"));
        QVERIFY(document().isEmpty());
        QVERIFY2(m_window->banner().sentence().contains("newer Knead"), qPrintable(m_window->banner().sentence()));
        QVERIFY(!find<QToolButton>("bannerRemedy")->isVisible());
    }

    void aReadOnlyFileIsSavedElsewhere()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        QFile::setPermissions(file("a.knead"), QFile::ReadOwner);
        QTest::keyClick(m_window.get(), Qt::Key_G);
        QTRY_VERIFY(m_window->isWindowModified());
        projects().save();
        QTRY_VERIFY_WITH_TIMEOUT(m_window->banner().sentence().contains("read-only"), patience);
        QVERIFY(m_window->isWindowModified());
        clickOn<QToolButton>("bannerRemedy");
        QTRY_VERIFY(find<QFileDialog>("saveDialog") != nullptr);
        find<QFileDialog>("saveDialog")->reject();
        saveTo(file("b.knead"));
        QVERIFY(!readProject(bytesOf(file("b.knead"))).entries.empty());
    }

    /// Nothing fits on the disk: files may be 100 kB long at most.
    void aFullDiskLeavesTheFileThatWas()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        const std::uint64_t before = hash();
        pushOn();
        rlimit limit{};
        getrlimit(RLIMIT_FSIZE, &limit);
        const rlimit small{100'000, limit.rlim_max};
        signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &small);
        projects().save();
        const auto isTold = [&] { return m_window->banner().sentence().contains("a.knead"); };
        [&] { QTRY_VERIFY_WITH_TIMEOUT(isTold(), patience); }();
        setrlimit(RLIMIT_FSIZE, &limit);
        QVERIFY(isTold());
        QVERIFY(m_window->isWindowModified());
        const Project left = readProject(bytesOf(file("a.knead")));
        QCOMPARE(left.entries[left.current].hash, before);
        saveTo(file("a.knead")); // there is room again
        const Project saved = readProject(bytesOf(file("a.knead")));
        QCOMPARE(saved.entries[saved.current].hash, hash());
    }

    void cancellingASavingChangesNothing()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        const std::uint64_t before = hash();
        pushOn();
        Services slow = m_services;
        projects().save();
        QTRY_VERIFY(m_window->tasks().isRunning());
        m_window->tasks().cancel();
        QTest::qWait(300);
        const Project left = readProject(bytesOf(file("a.knead")));
        QVERIFY(left.entries[left.current].hash == before || left.entries[left.current].hash == hash());
        QVERIFY(m_window->isWindowModified());
        saveTo(file("a.knead"));
    }

    void whatIsDoneWhileSavingIsNotSaved()
    {
        std::atomic<bool> goes = false;
        Services slow = m_services;
        slow.projects.write = [&goes, write = m_services.projects.write](const std::string& path,
                                                                         const Project& project, TaskControl& control) {
            while (!goes)
                QTest::qSleep(5);
            write(path, project, control);
        };
        newWindow(slow);
        openExample("bar.step", 10);
        projects().saveTo(file("a.knead"));
        QTRY_VERIFY(m_window->tasks().isRunning());
        QTest::keyClick(m_window.get(), Qt::Key_G);
        QTRY_VERIFY(document().history().isSettled());
        goes = true;
        QTRY_COMPARE_WITH_TIMEOUT(projects().path(), file("a.knead"), patience);
        QTRY_VERIFY(m_window->isWindowModified());
        newWindow(m_services); // and a crash now
        QCOMPARE(findRecoveries().size(), std::size_t{1});
        QCOMPARE(findRecoveries()[0].projectFile, bytesOf(file("a.knead")));
    }

    void unsavedWorkIsOfferedAfterACrash()
    {
        work();
        const std::uint64_t left = hash();
        for (int crash = 0; crash < 2; ++crash) {
            newWindow(m_services);
            m_window->offerRecoveries();
            QTRY_VERIFY_WITH_TIMEOUT(find<QListWidget>("recoveryList") != nullptr, patience);
            QCOMPARE(find<QListWidget>("recoveryList")->count(), 1);
            QTest::qWait(100);
            picture("recovery");
            clickOn<QPushButton>("recoveryRecover");
            QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty(), patience);
            wait();
            QCOMPARE(hash(), left);
            QVERIFY(m_window->isWindowModified());
        }
        saveTo(file("saved.knead"));
        m_window->close();
        QVERIFY(!m_window->isVisible());
        m_window.reset();
        QVERIFY(findRecoveries().empty());
        const Project saved = readProject(bytesOf(file("saved.knead")));
        QCOMPARE(saved.entries[saved.current].hash, left);
    }

    void recoveredWorkGoesBackToItsProject()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        QTest::keyClick(m_window.get(), Qt::Key_G);
        QTest::qWait(1200);
        wait();
        newWindow(m_services);
        m_window->offerRecoveries();
        QTRY_VERIFY_WITH_TIMEOUT(find<QListWidget>("recoveryList") != nullptr, patience);
        clickOn<QPushButton>("recoveryRecover");
        QTRY_COMPARE_WITH_TIMEOUT(projects().path(), file("a.knead"), patience);
        QVERIFY(m_window->windowTitle().startsWith("a.knead[*]"));
        QVERIFY(m_window->isWindowModified());
        QVERIFY(!snapshot().gravity.isZero());
    }

    void workThatIsNotWantedIsDropped()
    {
        openExample("bar.step", 10);
        QTest::keyClick(m_window.get(), Qt::Key_G);
        QTest::qWait(1200);
        wait();
        newWindow(m_services);
        m_window->offerRecoveries();
        QTRY_VERIFY_WITH_TIMEOUT(find<QListWidget>("recoveryList") != nullptr, patience);
        clickOn<QPushButton>("recoveryLater");
        QTRY_VERIFY(find<QListWidget>("recoveryList") == nullptr);
        QCOMPARE(findRecoveries().size(), std::size_t{1});
        action("recover")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(find<QListWidget>("recoveryList") != nullptr, patience);
        clickOn<QPushButton>("recoveryDiscard");
        answer("discardBox", QMessageBox::Discard);
        QTRY_VERIFY(find<QListWidget>("recoveryList") == nullptr);
        QTRY_VERIFY(findRecoveries().empty());
    }

    void aDiskThatRefusesTheRecoveryIsSaidOnce()
    {
        std::atomic<int> tries = 0;
        Services refusing = m_services;
        refusing.projects.keepWork = [&tries]() -> std::unique_ptr<KeptWork> {
            ++tries;
            throw std::runtime_error("The work cannot be kept for recovery (No space left on device).");
        };
        newWindow(refusing);
        openExample("bar.step", 10);
        QTRY_VERIFY(m_window->banner().sentence().contains("cannot be kept"));
        picture("recovery refused");
        pushOn(); // work goes on
        saveTo(file("a.knead"));
        QVERIFY(tries >= 1);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowProjectTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_project_test.moc"
