#include "core/geometry/mass_properties.h"
#include "io/importer.h"
#include "support/window_on_test.h"
#include "ui/panels/log_panel.h"
#include "ui/panels/quantity_field.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

using namespace knead;

namespace {

double largestMove(const Frame& from, const Frame& to)
{
    double largest = 0;
    for (std::size_t b = 0; b < from.bodies.size(); ++b)
        for (std::size_t v = 0; v < from.bodies[b]->places.size(); ++v)
            largest = std::max(largest, (from.bodies[b]->places[v] - to.bodies[b]->places[v]).norm());
    return largest;
}

} // namespace

/// The window as a person uses it: files through the window's own way, everything else through keys and mouse.
class WindowTest : public QObject, WindowOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { show(m_services); }

    void cleanup() { m_window.reset(); }

    void anEmptyWindowSaysWhatToDo()
    {
        QVERIFY(find<QWidget>("homePage")->isVisible());
        QVERIFY(!action("play")->isEnabled());
        QVERIFY(find<QWidget>("example_bar") != nullptr);
        picture("home");
    }

    void aBlockDrivenIntoThePartDeformsItAndFeelsIt()
    {
        openExample("bracket.step");
        const FramePointer rest = document().frame();

        QTest::keyClick(m_window.get(), Qt::Key_B);
        QTRY_COMPARE(document().selection().kind, Selection::Kind::Tool);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(snapshot().playing);
        QTRY_VERIFY(action("play")->text() == "Pause");

        QTest::keyPress(&m_window->viewport(), Qt::Key_PageDown);
        const auto pressesHard = [&] { return snapshot().tools[0].force.z() > 0.05; };
        QTRY_VERIFY_WITH_TIMEOUT(pressesHard() && largestMove(*rest, *document().frame()) > 0.02 * document().size(),
                                 patience);
        QTRY_VERIFY(find<QLabel>("forceLabel0") != nullptr);
        drawn();
        picture("pressed");
        QVERIFY(find<QLabel>("toolForce")->text() != "0 N");
        QTest::keyRelease(&m_window->viewport(), Qt::Key_PageDown);
        QTRY_VERIFY(snapshot().ratio > 0);
        QVERIFY(find<QLabel>("ratio")->text().contains('x'));

        // Released, the block holds still while time goes on. QTRY_VERIFY asks once more after it has held, so this
        // waits for a step of its own, however long one takes.
        const auto isStill = [&] {
            const FramePointer before = document().frame();
            return QTest::qWaitFor([&] { return snapshot().step > before->snapshot->step + 1; }, patience) &&
                   snapshot().tools[0].pose.position == before->snapshot->tools[0].pose.position;
        };
        QTRY_VERIFY_WITH_TIMEOUT(isStill(), patience);

        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        QTRY_COMPARE(find<QLabel>("ratio")->text(), QString("Paused"));
        const std::uint64_t step = snapshot().step;
        QTest::keyClick(m_window.get(), Qt::Key_Period);
        QTRY_COMPARE(snapshot().step, step + 1);

        exportedFileHoldsWhatIsSeen();

        QTest::keyClick(m_window.get(), Qt::Key_Backspace);
        QTRY_COMPARE(snapshot().step, std::uint64_t{0});
        QTRY_VERIFY(largestMove(*rest, *document().frame()) < 1e-12);
    }

    void thePerformancePanelSaysWhereTheTimeGoes()
    {
        openExample("bracket.step");
        find<QDockWidget>("performanceDock")->raise();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        const auto milliseconds = [&](int stage) {
            const QString text = find<QLabel>(qPrintable(QString("stage%1").arg(stage)))->text();
            return text.endsWith(" ms") ? text.chopped(3).toDouble() : 0.0;
        };
        const auto connections = static_cast<int>(Stage::connections);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().ratio > 0 && milliseconds(connections) > 0, patience);
        rest();
        picture("performance");
        // What the panel says are the stages of the snapshot, on the way to a frame.
        double all = 0;
        for (std::size_t stage = 0; stage < stageCount; ++stage) {
            QVERIFY(snapshot().stages[stage] >= 0);
            all += milliseconds(static_cast<int>(stage));
        }
        QVERIFY(milliseconds(connections) < all);
        QTRY_VERIFY(find<QLabel>("performanceSummary")->text().contains("steps of"));
        QVERIFY(find<QLabel>("performanceRates")->text().contains("million connections per second"));
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing && document().isSettled());
        openExample("bar.step"); // of which nothing is known yet
        QVERIFY(find<QLabel>("performanceRates")->text().isEmpty());
        QVERIFY(!find<QLabel>("performanceSummary")->text().contains("steps of"));
        QCOMPARE(milliseconds(connections), 0.0);
    }

    void exportedFileHoldsWhatIsSeen()
    {
        if (document().isEmpty())
            openExample("bar.step");
        double written = 0;
        for (std::size_t b = 0; b < document().content().bodies.size(); ++b) {
            TriangleMesh mesh = document().content().bodies[b]->mesh;
            mesh.vertices = document().frame()->bodies[b]->places;
            written += massProperties(mesh).volume;
        }
        QTemporaryDir folder;
        for (const char* name : {"out.stl", "out.obj", "out.ply"}) {
            const QString path = folder.filePath(name);
            m_window->features().exports->exportTo(path);
            QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
            QVERIFY2(problem().isEmpty(), qPrintable(problem()));
            const Model read = importFile(path.toStdString());
            double found = 0;
            for (const Part& part : read.parts)
                found += massProperties(part.mesh).volume;
            QVERIFY(std::abs(found - written) < 1e-3 * written);
        }
    }

    void aBadFileIsOneSentenceAndChangesNothing()
    {
        openExample("bar.step");
        const auto model = document().content().model;
        QTemporaryDir folder;
        const QString path = folder.filePath("bad.step");
        QFile file(path);
        QVERIFY(file.open(QFile::WriteOnly));
        file.write("this is no part");
        file.close();
        m_window->open(QStringList(path));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY(m_window->banner().sentence().contains("bad.step"));
        QVERIFY(find<LogPanel>("log")->toPlainText().contains(m_window->banner().sentence()));
        QCOMPARE(document().content().model, model);
        picture("failure");
    }

    void aDroppedFileOpens()
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(example("bar.step"))});
        QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &drop);
        QTRY_VERIFY_WITH_TIMEOUT(!document().isEmpty(), patience);
        QTRY_VERIFY(find<QWidget>("viewport")->isVisible());
    }

    void cancelledImportLeavesTheDocumentUnchanged()
    {
        Services slow = m_services;
        std::atomic<bool> isSlow = false;
        std::atomic<bool> wasTold = false;
        slow.import = [&, import = m_services.import](const std::vector<std::string>& paths,
                                                      const ImportOptions& options, TaskControl& control) {
            while (isSlow) {
                control.report(0.5, "reading faces");
                wasTold = control.isCancelled();
                control.throwIfCancelled();
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            return import(paths, options, control);
        };
        show(slow);
        openExample("bar.step");
        const auto model = document().content().model;
        isSlow = true;
        m_window->open(QStringList(example("bracket.step")));
        QTRY_VERIFY(find<QLabel>("taskStage")->text().contains("reading faces"));
        QVERIFY(find<QWidget>("taskReading")->isVisible());
        picture("importing");
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(!m_window->tasks().isRunning());
        QTRY_VERIFY(wasTold);
        QTest::qWait(100);
        QCOMPARE(document().content().model, model);
        QVERIFY(!find<QWidget>("taskReading")->isVisible());
        isSlow = false;
    }

    void theWindowAnswersWhileAFileIsRead()
    {
        std::atomic<bool> isReading = true;
        Services slow = m_services;
        slow.import = [&isReading](const std::vector<std::string>&, const ImportOptions&, TaskControl&) -> Model {
            for (int i = 0; isReading && i < patience; ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            throw std::runtime_error("slow.step: nothing in it.");
        };
        show(slow);
        m_window->open(QStringList("slow.step"));
        for (int answers = 0; answers < 11; ++answers) {
            QTest::qWait(10);
            QVERIFY(m_window->tasks().isRunning());
        }
        isReading = false;
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
    }

    void pickedFacesAreHeldAndFreedAgain()
    {
        openExample("bar.step");
        QTest::keyClick(m_window.get(), Qt::Key_X);
        QVERIFY(action("fixFaces")->isChecked());
        const Box box = document().content().box;
        const Vec3 top(box.center().x(), box.center().y(), box.max().z());
        click(top);
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        QVERIFY(!snapshot().fixtures[0].objects.empty());
        for (const ObjectIndex object : snapshot().fixtures[0].objects)
            QVERIFY(snapshot().bodies[0].positions[object].z() > box.max().z() - document().content().spacing);
        QCOMPARE(document().selection().kind, Selection::Kind::Fixture);
        picture("fixed");
        click(top);
        QTRY_VERIFY(snapshot().fixtures.empty());
        click(top);
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        QTest::keyClick(m_window.get(), Qt::Key_Delete);
        QTRY_VERIFY(snapshot().fixtures.empty());
        QVERIFY(document().fixtures().list().empty());
    }

    void viewKeysTurnTheView()
    {
        openExample("bar.step");
        QTest::keyClick(m_window.get(), Qt::Key_7);
        QTRY_VERIFY((m_window->viewport().camera().towardsEye() - Vec3::UnitZ()).norm() < 1e-6);
        QTest::keyClick(m_window.get(), Qt::Key_5);
        QVERIFY(!m_window->viewport().camera().perspective);
        QTest::keyClick(m_window.get(), Qt::Key_O);
        drawn();
        picture("objects");
        QTest::keyClick(m_window.get(), Qt::Key_1, Qt::KeypadModifier);
        QTRY_VERIFY((m_window->viewport().camera().towardsEye() + Vec3::UnitY()).norm() < 1e-6);
    }

    void refillKeepsToolsMaterialAndFixtures()
    {
        openExample("bar.step");
        document().post(SetMaterial{0, {.density = 900, .youngsModulus = 3e5}});
        QTest::keyClick(m_window.get(), Qt::Key_B);
        document().toggleFace(0, 0);
        QTRY_VERIFY(snapshot().tools.size() == 1 && snapshot().fixtures.size() == 1 &&
                    snapshot().materials[0].youngsModulus == 3e5);
        const std::size_t objects = snapshot().objects;
        m_window->features().imports->refill(document().size() / 22);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        QVERIFY(snapshot().objects > objects);
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(snapshot().materials[0].youngsModulus, 3e5);
    }

    void bothThemesApply()
    {
        openExample("bracket.step");
        m_window->features().preferences->setTheme(Theme::Dark);
        drawn();
        const QColor dark = m_window->palette().color(QPalette::Window);
        picture("dark");
        m_window->features().preferences->setTheme(Theme::Light);
        QVERIFY(m_window->palette().color(QPalette::Window).lightness() > dark.lightness() + 100);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_test.moc"
