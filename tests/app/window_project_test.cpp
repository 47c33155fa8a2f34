#include "io/project/project_file.h"
#include "io/project/project_lock.h"
#include "io/project/recovery.h"
#include "support/projects_on_test.h"
#include "ui/panels/timeline_axis.h"
#include "ui/project/thumbnails.h"
#include "ui/run_window.h"

#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>

#include <stdexcept>

using namespace knead;

/// Projects as a person has them: saved, opened again, left unsaved, locked.
class WindowProjectTest : public QObject, ProjectsOnTest {
    Q_OBJECT

    void drop(const QString& path)
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &enter);
        QDropEvent event(QPointF(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &event);
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { begin(); }

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
        rest();
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

    void fixedFacesComeBack()
    {
        openExample("bar.step", 10);
        QTest::keyClick(m_window.get(), Qt::Key_X);
        const Box box = document().content().box;
        click(Vec3(box.center().x(), box.center().y(), box.max().z()));
        QTRY_COMPARE(document().fixtures().list().size(), std::size_t{1});
        waitForGesture();
        const FaceFixture before = document().fixtures().list()[0];
        QCOMPARE(before.faces.size(), std::size_t{1});
        for (const bool isCrash : {true, false}) {
            if (!isCrash)
                saveTo(file("a.knead"));
            newWindow(m_services);
            if (isCrash)
                recoverByHand();
            else
                openProject(file("a.knead"));
            QCOMPARE(document().fixtures().list().size(), std::size_t{1});
            QCOMPARE(document().fixtures().list()[0].faces, before.faces);
            QCOMPARE(document().fixtures().list()[0].name, before.name);
        }
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
        for (const auto button : {QMessageBox::Save, QMessageBox::Discard, QMessageBox::Cancel})
            QVERIFY(!QKeySequence::mnemonic(find<QMessageBox>("saveQuestion")->button(button)->text()).isEmpty());
        drawn();
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
        openAndRefill("bar.step", 10);
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
        switchGravity();
        openProject(file("a.knead")); // as after Discard
        QCOMPARE(hash(), saved);
        QCOMPARE(projects().path(), file("a.knead"));
        QVERIFY(!m_window->isWindowModified());
    }

    /// Nobody shall look for what was never kept.
    void anOpenedProjectSaysThatItHasNoFilm()
    {
        openExample("bar.step", 10);
        auto* axis = find<TimelineAxis>("timelineAxis");
        QVERIFY(!axis->lacksFilm());
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.1, patience);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        waitForGesture();
        QTRY_VERIFY(axis->timeline().end > 0.05 && !axis->lacksFilm());
        saveTo(file("a.knead"));
        newWindow(m_services);
        openProject(file("a.knead"));
        axis = find<TimelineAxis>("timelineAxis");
        QTRY_VERIFY(axis->timeline().end > 0.05);
        QVERIFY(axis->lacksFilm());
        QTRY_VERIFY(action("filmPlay")->property("whyDisabled").toString().contains("no film"));
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

    void undoingMarksTheTitleToo()
    {
        openExample("bar.step", 10);
        switchGravity();
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
        newWindow(m_services); // before anything else could be done
        QTRY_VERIFY(!thumbnails::of(file("a.knead")).isNull());
        drawn();
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
        drop(file("a.knead"));
        QTRY_COMPARE_WITH_TIMEOUT(projects().path(), file("a.knead"), patience);
    }

    void whatIsNotSavedIsAskedAboutBeforeAnotherOpens()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        switchGravity();
        const std::uint64_t mine = hash();
        drop(example("bracket.step"));
        answer("saveQuestion", QMessageBox::Cancel);
        QCOMPARE(hash(), mine);
        QVERIFY(!m_window->tasks().isRunning());
        drop(example("bracket.step"));
        answer("saveQuestion", QMessageBox::Save);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->windowTitle().startsWith("bracket.step"), patience);
        const Project saved = readProject(bytesOf(file("a.knead")));
        QCOMPARE(saved.entries[saved.current].hash, mine);
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

    void cancellingASavingChangesNothing()
    {
        newWindow(servicesWithSlowDisk());
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        const std::uint64_t before = hash();
        pushOn();
        m_isDiskSlow = true;
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(find<QLabel>("taskStage")->text().contains("waiting for the disk"));
        picture("saving");
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(!m_window->tasks().isRunning());
        QTest::qWait(200);
        const Project left = readProject(bytesOf(file("a.knead")));
        QCOMPARE(left.entries[left.current].hash, before);
        QVERIFY(m_window->isWindowModified());
        m_isDiskSlow = false;
        saveTo(file("a.knead"));
        const Project saved = readProject(bytesOf(file("a.knead")));
        QCOMPARE(saved.entries[saved.current].hash, hash());
    }

    void savingAgainSavesWhatWasDoneMeanwhile()
    {
        newWindow(servicesWithSlowDisk());
        openExample("bar.step", 10);
        m_isDiskSlow = true;
        projects().saveTo(file("a.knead"));
        QTRY_VERIFY(m_window->tasks().isRunning());
        switchGravity();
        QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ControlModifier);
        projects().saveTo(file("b.knead"));
        m_isDiskSlow = false;
        QTRY_COMPARE_WITH_TIMEOUT(projects().path(), file("b.knead"), patience);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isWindowModified(), patience);
        for (const char* name : {"a.knead", "b.knead"}) {
            const Project saved = readProject(bytesOf(file(name)));
            QCOMPARE(saved.entries[saved.current].hash, hash());
        }
    }

    void closingWaitsForASaving()
    {
        newWindow(servicesWithSlowDisk());
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        m_isDiskSlow = true;
        projects().saveTo(file("b.knead"));
        QTRY_VERIFY(m_window->tasks().isRunning());
        m_window->close();
        QVERIFY(m_window->isVisible());
        m_isDiskSlow = false;
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->isVisible(), patience);
        QVERIFY(!readProject(bytesOf(file("b.knead"))).entries.empty());
    }

    /// Whoever opened a file from elsewhere than a dialog.
    void theFirstDialogBeginsBesideWhatWasOpened()
    {
        for (const char* key : {"folder", "projectFolder"})
            QSettings().remove(key);
        QVERIFY(QFile::copy(example("bar.step"), file("bar.step")));
        m_window->open(QStringList(file("bar.step")));
        waitForTasks();
        QVERIFY(!document().isEmpty());
        projects().saveAs();
        QTRY_VERIFY(find<QFileDialog>("saveDialog") != nullptr);
        QCOMPARE(find<QFileDialog>("saveDialog")->directory(), QDir(QFileInfo(file("bar.step")).absolutePath()));
        find<QFileDialog>("saveDialog")->reject();
    }

    void aNameOfAnotherKindGetsTheEnding()
    {
        openExample("bar.step", 10);
        for (const bool isThere : {false, true}) {
            projects().saveAs();
            QTRY_VERIFY(find<QFileDialog>("saveDialog") != nullptr);
            emit find<QFileDialog>("saveDialog")->fileSelected(file("part.step"));
            find<QFileDialog>("saveDialog")->reject();
            QTRY_VERIFY(find<QFileDialog>("saveDialog") == nullptr);
            QTRY_COMPARE_WITH_TIMEOUT(projects().path(), file("part.step.knead"), patience);
            QCOMPARE(m_window->banner().sentence().contains("is there already"), isThere);
        }
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
