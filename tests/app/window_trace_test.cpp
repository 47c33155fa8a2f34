// What a person does in the window, written as Python while it is done; run, it comes to the same bits.
#include "app/hexadecimal.h"
#include "support/window_on_test.h"
#include "support/workshop.h"
#include "ui/project/project_keeper.h"
#include "ui/run_window.h"
#include "ui/tracing/trace_panel.h"

#include <QClipboard>
#include <QDockWidget>
#include <QPlainTextEdit>
#include <QToolButton>
#include <QtTest>

using namespace knead;
using workshop::Outcome;

class WindowTraceTest : public QObject, WindowOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
        show(m_services);
    }

    void cleanupTestCase() { m_window.reset(); }

    void theMenuShowsIt()
    {
        QVERIFY(find<QDockWidget>("traceDock")->isHidden());
        action("pythonTrace")->trigger();
        QTRY_VERIFY(find<QPlainTextEdit>("trace")->isVisible());
        QVERIFY(text().isEmpty());
        QVERIFY(!find<QToolButton>("copyTrace")->isEnabled());
        openExample("bar.step", 12);
        action("pythonTrace")->trigger(); // in front of the import report
        const std::string opened = document().history().tree().record(0).name;
        QTRY_VERIFY(text().contains("sim.keep()  # " + QString::fromStdString(opened) + '\n'));
        QVERIFY(text().contains("model = knead.read(\"" + example("bar.step")));
    }

    void itFollowsWhatIsUnderWay()
    {
        key(Qt::Key_B);
        QTRY_VERIFY(text().contains("block_1 = sim.add_tool(\"box\", ("));
        key(Qt::Key_Space);
        QTRY_VERIFY(QRegularExpression(R"(sim\.step_to\(\d+\)\n$)").match(text()).hasMatch()); // before anything ends
        drag(QPoint(0, 60));
        QTRY_VERIFY(text().contains("for step, act, *how in [\n"));
        QTRY_VERIFY(text().contains(", block_1.go_to, ("));
        key(Qt::Key_Space);
        settle();
        QTRY_VERIFY(text().contains("]:\n    sim.step_to(step)\n    act(*how)\n"));
        verifyWhole();
        picture("python-trace");
    }

    void undoneItIsTakenBack()
    {
        document().post(SetMaterial{0, soft()});
        QTRY_VERIFY(text().contains("sim.set_material("));
        settle();
        key(Qt::Key_Z, Qt::ControlModifier);
        settle();
        QTRY_VERIFY(!text().contains("sim.set_material("));
        verifyWhole();
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        settle();
        QTRY_VERIFY(text().contains("sim.set_material("));
        verifyWhole();
    }

    void whatIsTakenBackInItsMidstGoes()
    {
        const QString before = text();
        document().beginGesture();
        document().post(SetGravity{Vec3(0, 0, -1)});
        QTRY_VERIFY(text().contains("sim.set_gravity((0, 0, -1))"));
        document().takeBackGesture();
        QTRY_COMPARE(text(), before);
        settle();
    }

    void unseenItCatchesUp()
    {
        find<QDockWidget>("traceDock")->hide();
        const QString before = text();
        const Box box = document().content().box;
        document().select({});
        document().cutAlong(Vec3(box.center().x(), 0, 0), Vec3(1, 0, 0.1));
        QTRY_VERIFY(snapshot().bodies[0].broken != nullptr);
        key(Qt::Key_Space);
        const double end = snapshot().time + 0.05;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time >= end, patience);
        key(Qt::Key_Space);
        settle();
        document().stepOnce();
        settle();
        QCOMPARE(text(), before);
        action("pythonTrace")->trigger();
        QTRY_VERIFY(text().contains("sim.cut(("));
        verifyWhole();
    }

    void itIsCopiedAndSaved()
    {
        find<QToolButton>("copyTrace")->click();
        QCOMPARE(QGuiApplication::clipboard()->text(), text());
        saveTrace("session.py");
        QFile saved(m_shop.qPath("session.py"));
        QVERIFY(saved.open(QIODevice::ReadOnly));
        const QString script = QString::fromUtf8(saved.readAll());
        QCOMPARE(script, text() + "print(sim.state_hash)  # in the session: " + presentHash() + '\n');
    }

    void runItComesToTheSameBits()
    {
#ifdef KNEAD_BUILD_PYTHON
        const Outcome outcome = workshop::runKnead({"python", m_shop.qPath("session.py")});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        QCOMPARE(QString::fromStdString(outcome.out), presentHash() + '\n');
#endif
    }

    void anotherFillingBeginsAnew()
    {
        m_window->features().imports->refill(document().content().spacing * 1.2);
        waitForTasks();
        settle();
        action("pythonTrace")->trigger();
        QTRY_VERIFY(text().contains("block_1 = sim.add_tool(") && !text().contains("sim.cut(("));
        verifyWhole();
        m_window->projects().closeProject();
        QTRY_VERIFY(text().isEmpty());
    }

    /// Its file may hold other parts than it has now.
    void aProjectThatIsBehindIsNotRead()
    {
        const QString part = m_shop.qPath("own.step");
        QVERIFY(QFile::copy(example("bar.step"), part));
        ImportChoices request;
        request.paths = {part.toStdString()};
        request.spacing = SpacingChoice{SpacingChoice::Kind::CellsAlong, 12};
        m_window->open(request);
        waitForTasks();
        settle();
        QVERIFY(QFile::remove(part));
        m_window->projects().saveTo(m_shop.qPath("own.knead"));
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->projects().isModified(), patience);
        action("pythonTrace")->trigger();
        QTRY_VERIFY(text().contains("model = knead.read(\"" + m_shop.qPath("own.knead")));
        saveTrace("now.py");
        QVERIFY(QFile::exists(m_shop.qPath("now.py")));
        document().post(SetMaterial{0, soft()});
        settle();
        saveTrace("behind.py");
        QVERIFY2(problem().contains("save the project first"), qPrintable(problem()));
        QVERIFY(!QFile::exists(m_shop.qPath("behind.py")));
        m_window->projects().save();
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->projects().isModified(), patience);
        saveTrace("behind.py");
        QVERIFY(QFile::exists(m_shop.qPath("behind.py")));
        QTRY_VERIFY(text().contains("sim.set_material("));
    }

private:
    QString text()
    {
        return m_window->features().trace->panel().text();
    }
    void saveTrace(const char* name)
    {
        m_window->features().trace->saveTo(m_shop.qPath(name));
        waitForTasks();
    }
    void settle()
    {
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(m_window.get(), key, modifiers);
    }

    QString presentHash()
    {
        const History& tree = document().history().tree();
        return QString::fromStdString(hexadecimal(tree.record(tree.current()).hash));
    }

    static Material soft()
    {
        Material material;
        material.youngsModulus = 1e5 / 3;
        return material;
    }

    /// What came piece by piece is what is written in one go.
    void verifyWhole()
    {
        const QString whole = QString::fromStdString(m_services.traces.script(document().project(), {}));
        QTRY_COMPARE(text(), whole.left(whole.indexOf("print(sim.state_hash)")));
    }

    /// Drags the block with the mouse, in pixels.
    void drag(const QPoint& way)
    {
        ViewportWidget& view = m_window->viewport();
        const QPoint from = view.widgetPosition(snapshot().tools[0].pose.position)->toPoint();
        QTest::mouseMove(&view, from);
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        for (int i = 1; i <= 12; ++i) {
            QTest::mouseMove(&view, from + way * i / 12);
            seen(); // so that each of them is in a step of its own, however busy the machine is
        }
        QTest::mouseRelease(&view, Qt::LeftButton, {}, from + way);
    }

    workshop::Workshop m_shop;
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowTraceTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_trace_test.moc"
