#include "io/project/project_file.h"
#include "io/project/project_lock.h"
#include "io/project/recovery.h"
#include "support/full_disk.h"
#include "support/projects_on_test.h"
#include "ui/probes/probe_set.h"
#include "ui/run_window.h"

#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>

#include <atomic>
#include <stdexcept>

using namespace knead;

/// What a person keeps when the disk is full, the file is damaged, or the window is gone.
class WindowRecoveryTest : public QObject, ProjectsOnTest {
    Q_OBJECT

    /// Changes words wherever they are in a file.
    static void spoil(const QString& path, const QByteArray& words)
    {
        QFile file(path);
        QVERIFY(file.open(QFile::ReadWrite));
        QByteArray bytes = file.readAll();
        QVERIFY(bytes.contains(words));
        bytes.replace(words, QByteArray(words.size(), '#'));
        file.seek(0);
        file.write(bytes);
    }

    QString logged() { return find<QPlainTextEdit>("log")->toPlainText(); }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { begin(); }

    void cleanup() { m_window.reset(); }

    void anotherPartIsAnotherProject()
    {
        work();
        saveTo(file("a.knead"));
        openExample("bar.step", 10);
        wait();
        QVERIFY(projects().path().isEmpty());
        QVERIFY(m_window->windowTitle().startsWith("bar.step"));
        QVERIFY(ProjectLock(bytesOf(file("a.knead"))).isHeld()); // nobody works on it any more
        switchGravity();
        newWindow(m_services);
        const std::vector<Recovery> left = findRecoveries();
        QCOMPARE(left.size(), std::size_t{1});
        QVERIFY(left[0].projectFile.empty());
        QCOMPARE(left[0].part, std::string("Bar"));
    }

    void aPlaceThatCannotBeWrittenToIsOneSentence()
    {
        openExample("bar.step", 10);
        projects().saveTo("/proc/nowhere/a.knead");
        QTRY_VERIFY_WITH_TIMEOUT(m_window->banner().sentence().contains("a.knead"), patience);
        QVERIFY(projects().path().isEmpty());
        QCOMPARE(find<QToolButton>("bannerRemedy")->text(), QString("Save as..."));
    }

    void aDamagedProjectIsRescued()
    {
        openExample("bar.step", 10);
        for (const Qt::Key key : {Qt::Key_G, Qt::Key_B}) {
            QTest::keyClick(m_window.get(), key);
            waitForGesture();
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
        drawn();
        picture("damaged");
        clickOn<QToolButton>("bannerRemedy");
        QTRY_VERIFY_WITH_TIMEOUT(find<QMessageBox>("missingBox") != nullptr, patience);
        drawn();
        QCOMPARE(find<QMessageBox>("missingBox")->text(), QString("This could not be brought back:"));
        QVERIFY(!find<QMessageBox>("missingBox")->informativeText().isEmpty());
        QVERIFY(find<QPlainTextEdit>("log")->toPlainText().contains("Not whole: "));
        picture("missing");
        answer("missingBox", QMessageBox::Ok);
        QVERIFY(!document().isEmpty());
        const History& tree = document().history().tree();
        QCOMPARE(tree.current(), static_cast<History::Entry>(tree.records().size() - 1));
        QVERIFY(!snapshot().gravity.isZero()); // what came before the lost entry
        QVERIFY2(!m_window->banner().sentence().contains("damaged"), qPrintable(m_window->banner().sentence()));
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
        const auto isTold = [&] { return m_window->banner().sentence().contains("a.knead"); };
        {
            const FullDisk disk(100'000);
            projects().save();
            QTRY_VERIFY_WITH_TIMEOUT(isTold(), patience);
        }
        QVERIFY(m_window->isWindowModified());
        const Project left = readProject(bytesOf(file("a.knead")));
        QCOMPARE(left.entries[left.current].hash, before);
        saveTo(file("a.knead")); // there is room again
        const Project saved = readProject(bytesOf(file("a.knead")));
        QCOMPARE(saved.entries[saved.current].hash, hash());
    }

    void whatIsDoneWhileSavingIsNotSaved()
    {
        newWindow(servicesWithSlowDisk());
        openExample("bar.step", 10);
        m_isDiskSlow = true;
        projects().saveTo(file("a.knead"));
        QTRY_VERIFY(m_window->tasks().isRunning());
        switchGravity();
        m_isDiskSlow = false;
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
            m_window->projects().offerRecoveries(false);
            QTRY_VERIFY_WITH_TIMEOUT(find<QListWidget>("recoveryList") != nullptr, patience);
            QCOMPARE(find<QListWidget>("recoveryList")->count(), 1);
            drawn();
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
        switchGravity();
        newWindow(m_services);
        m_window->projects().offerRecoveries(false);
        QTRY_VERIFY_WITH_TIMEOUT(find<QListWidget>("recoveryList") != nullptr, patience);
        clickOn<QPushButton>("recoveryRecover");
        QTRY_COMPARE_WITH_TIMEOUT(projects().path(), file("a.knead"), patience);
        QVERIFY(m_window->windowTitle().startsWith("a.knead[*]"));
        QVERIFY(m_window->isWindowModified());
        QVERIFY(!snapshot().gravity.isZero());
    }

    void probesAreRecoveredAndSaved()
    {
        openExample("bar.step", 10);
        switchGravity();
        const auto& probes = m_window->probes().all();
        QVERIFY(probes.empty());
        const FilledBodies bodies = document().content().bodies;
        const Vec3 corner = bodies[0]->mesh.vertices[0];
        m_window->probes().add(*nearestPlace(document().content().box.center(), bodies));
        m_window->probes().add(*nearestPlace(corner, bodies));
        m_window->probes().remove(0);
        const auto verify = [&] {
            const auto& found = m_window->probes().all();
            QCOMPARE(found.size(), std::size_t{1});
            QCOMPARE(found[0].number, 2);
            const FilledBody& body = *document().content().bodies[0];
            QVERIFY((placeOf(found[0].place, body, body.mesh.vertices) - corner).norm() < 1e-9);
            QTRY_VERIFY(!m_window->probes().all()[0].samples.empty());
        };
        verify();
        newWindow(m_services);
        recoverByHand();
        verify();
        saveTo(file("a.knead"));
        m_window->probes().clear();
        openProject(file("a.knead"));
        verify();
        m_window->probes().clear();
        m_window->activateWindow(); // it was not, after the dialog, where no window manager runs
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        switchGravity();
        saveTo(file("a.knead"));
        openProject(file("a.knead"));
        QVERIFY(m_window->probes().all().empty());
        for (const char* spoiled : {"?", "{}", "[1]", R"([{"number":1,"body":7,"place":[0,0,0]}])"}) {
            m_window->probes().remember(spoiled);
            QVERIFY(m_window->probes().all().empty());
        }
    }

    /// In a window that is narrower than the one that was lost.
    void recoveredPartsAreWhollyInTheView()
    {
        m_window->resize(1900, 800);
        rest();
        openExample("bar.step", 10);
        switchGravity();
        QVERIFY(m_window->viewport().showsAll());
        newWindow(m_services);
        recoverByHand();
        rest();
        QVERIFY(m_window->viewport().showsAll());
    }

    void olderWorkDoesNotTakeThePlaceOfANewerFile()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        switchGravity();
        newWindow(m_services); // and the work is left for later
        openProject(file("a.knead"));
        switchGravity();
        switchGravity();
        saveTo(file("a.knead"));
        m_window->close();
        newWindow(m_services);
        recoverByHand();
        QVERIFY(projects().path().isEmpty());
        QVERIFY(m_window->isWindowModified());
        QVERIFY2(m_window->banner().sentence().startsWith("a.knead was written after this work"),
                 qPrintable(m_window->banner().sentence()));
        picture("older than its file");
        QVERIFY(ProjectLock(bytesOf(file("a.knead"))).isHeld());
    }

    void workThatIsNotWholeDoesNotTakeThePlaceOfItsFile()
    {
        openExample("bar.step", 10);
        saveTo(file("a.knead"));
        switchGravity();
        document().history().rename(document().history().tree().current(), "Unlike any other");
        newWindow(m_services);
        spoil(QString::fromStdString(findRecoveries().at(0).folder + "/work.db"), "Unlike any other");
        recoverByHand();
        answer("missingBox", QMessageBox::Ok);
        QVERIFY(projects().path().isEmpty());
        QVERIFY(m_window->isWindowModified());
        QVERIFY2(m_window->banner().sentence().startsWith("a.knead stays as it is"),
                 qPrintable(m_window->banner().sentence()));
    }

    /// As when memory had no room for the last moment and a later version comes to another one.
    void aProjectThatCannotBeShownIsRescued()
    {
        openExample("bar.step", 10);
        switchGravity();
        saveTo(file("a.knead"));
        newWindow(m_services);
        Project project = readProject(bytesOf(file("a.knead")));
        project.entries.back().moment = nullptr;
        project.entries.back().hash ^= 1U;
        writeProject(bytesOf(file("a.knead")), project);
        openProject(file("a.knead"));
        QVERIFY(document().isEmpty());
        QVERIFY2(m_window->banner().sentence().startsWith("a.knead: what was seen last cannot be shown."),
                 qPrintable(m_window->banner().sentence()));
        QCOMPARE(find<QToolButton>("bannerRemedy")->text(), QString("Rescue what is whole"));
        clickOn<QToolButton>("bannerRemedy");
        answer("missingBox", QMessageBox::Ok);
        QVERIFY(!document().isEmpty());
        QVERIFY(projects().path().isEmpty());
        QCOMPARE(document().history().tree().current(), project.entries.back().parent);
    }

    void aProjectOfWhichNothingIsLeftSaysWhatToDo()
    {
        openExample("bar.step", 10);
        switchGravity();
        document().history().rename(document().history().tree().current(), "Unlike any other");
        saveTo(file("a.knead"));
        const auto rescue = [&](const Services& services, const QByteArray& spoilt, const QString& sentence) {
            newWindow(services);
            spoil(file("a.knead"), spoilt);
            openProject(file("a.knead"));
            QCOMPARE(find<QToolButton>("bannerRemedy")->text(), QString("Rescue what is whole"));
            clickOn<QToolButton>("bannerRemedy");
            QTRY_VERIFY2_WITH_TIMEOUT(m_window->banner().sentence().contains(sentence),
                                      qPrintable(m_window->banner().sentence()), patience);
            wait();
            QVERIFY(document().isEmpty());
        };
        Services withoutParts = m_services;
        withoutParts.projects.rescue = [rescued = m_services.projects.rescue](const std::string& path,
                                                                              TaskControl& control) {
            RescuedProject result = rescued(path, control);
            result.project.model = nullptr;
            return result;
        };
        rescue(withoutParts, "Unlike any other", "Open the part that it was made from.");
        rescue(m_services, QByteArray::fromHex("28b52ffd"), // of everything that is packed
               "nothing of this project can be read any more; open a copy of it, or the part that it was made from.");
    }

    void workThatAnotherWindowHasIsNotTakenTwice()
    {
        openExample("bar.step", 10);
        switchGravity();
        newWindow(m_services);
        m_window->projects().offerRecoveries(false);
        QTRY_VERIFY_WITH_TIMEOUT(find<QPushButton>("recoveryRecover") != nullptr, patience);
        {
            const RecoveryFile other(findRecoveries().at(0));
            clickOn<QPushButton>("recoveryRecover");
            wait();
            QVERIFY2(m_window->banner().sentence().contains("nother window"),
                     qPrintable(m_window->banner().sentence()));
            QVERIFY(document().isEmpty());
        }
        recoverByHand(); // the other window has gone
        QVERIFY(!snapshot().gravity.isZero());
    }

    void workThatIsNotWantedIsDropped()
    {
        openExample("bar.step", 10);
        switchGravity();
        newWindow(m_services);
        m_window->projects().offerRecoveries(false);
        QTRY_VERIFY_WITH_TIMEOUT(find<QListWidget>("recoveryList") != nullptr, patience);
        clickOn<QPushButton>("recoveryLater");
        QTRY_VERIFY(find<QListWidget>("recoveryList") == nullptr);
        QTRY_VERIFY(find<QWidget>("waitingWork")->isVisible()); // on the first page, after looking for it
        QCOMPARE(findRecoveries().size(), std::size_t{1});
        QVERIFY(find<QLabel>("waitingNames")->text().contains("Bar"));
        picture("home-waiting");
        clickOn<QPushButton>("homeRecover");
        QTRY_VERIFY_WITH_TIMEOUT(find<QListWidget>("recoveryList") != nullptr, patience);
        clickOn<QPushButton>("recoveryDiscard");
        answer("discardBox", QMessageBox::Discard);
        QTRY_VERIFY(find<QListWidget>("recoveryList") == nullptr);
        QTRY_VERIFY(findRecoveries().empty());
        QTRY_VERIFY(!find<QWidget>("waitingWork")->isVisible());
    }

    void aDiskThatRefusesTheRecoveryIsSaidOnce()
    {
        std::atomic<int> tries = 0;
        std::atomic<bool> isFull = true;
        Services refusing = m_services;
        refusing.projects.keepWork = [&tries, &isFull, keep = m_services.projects.keepWork] {
            ++tries;
            if (isFull)
                throw std::runtime_error("The work cannot be kept for recovery (No space left on device).");
            return keep();
        };
        newWindow(refusing);
        openExample("bar.step", 10);
        QTRY_VERIFY(logged().contains("cannot be kept"));
        picture("recovery refused");
        pushOn(); // work goes on
        saveTo(file("a.knead"));
        QVERIFY(tries >= 1);
        QVERIFY(!logged().contains("kept for recovery again"));
        // It is tried again by and by.
        isFull = false;
        QTRY_VERIFY_WITH_TIMEOUT(logged().contains("The work is kept for recovery again."), patience);
        QVERIFY(tries >= 2);
        QCOMPARE(logged().count("cannot be kept"), 1);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowRecoveryTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "window_recovery_test.moc"
