// What a person did in the window, repeated on the command line: the same bits, the same files.
#include "app/hexadecimal.h"
#include "io/project/project_file.h"
#include "support/window_on_test.h"
#include "support/workshop.h"
#include "ui/run_window.h"

#include <QtTest>

using namespace knead;
using workshop::json;
using workshop::Outcome;

namespace {

std::string contentOf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

class WindowReplayTest : public QObject, WindowOnTest {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
        show(m_services);
        doThings();
        save();
    }

    void cleanupTestCase() { m_window.reset(); }

    void theSameHashOnAnyNumberOfThreads()
    {
        for (const char* threads : {"1", "2"}) {
            const Outcome outcome = workshop::runKnead({"replay", m_project, "--all", "--json", "--threads", threads});
            QVERIFY2(outcome.status == 0, (outcome.errors + outcome.out).c_str());
            const json report = json::parse(outcome.out);
            QCOMPARE(report.at("entries").size(), document().history().tree().records().size());
            QVERIFY(report.at("same").get<bool>());
            for (const json& entry : report.at("entries"))
                QCOMPARE(entry.at("whole_state").get<std::string>(), std::string("same"));
        }
    }

    void theSameBytesAsTheWindowWrites_data()
    {
        QTest::addColumn<QString>("ending");
        for (const char* ending : {"step", "stl", "3mf"})
            QTest::newRow(ending) << QString(ending);
    }
    void theSameBytesAsTheWindowWrites()
    {
        QFETCH(QString, ending);
        m_window->features().exports->exportTo(m_shop.qPath("window.") + ending);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        const std::string shown = contentOf(m_shop.path("window.") + ending.toStdString());
        QVERIFY(!shown.empty());
        for (const char* threads : {"1", "2"}) {
            const QString file = m_shop.qPath("replayed.") + ending;
            const Outcome outcome = workshop::runKnead({"replay", m_project, "--threads", threads, "--export", file});
            QVERIFY2(outcome.status == 0, outcome.errors.c_str());
            QVERIFY(contentOf(file.toStdString()) == shown);
        }
    }

    void theSameHashAsARecipe()
    {
        for (const char* threads : {"1", "2"}) {
            const Outcome outcome = workshop::runKnead({"run", m_project, "--json", "--threads", threads});
            QVERIFY2(outcome.status == 0, outcome.errors.c_str());
            QCOMPARE(json::parse(outcome.out).at("state_hash").get<std::string>(), presentHash());
        }
        const QString recipe = m_shop.qPath("session.recipe.json");
        const Outcome written = workshop::runKnead({"recipe", m_project, "-o", recipe});
        QVERIFY2(written.status == 0, written.errors.c_str());
        const json said = json::parse(contentOf(recipe.toStdString()));
        QCOMPARE(QFileInfo(QString::fromStdString(said.at("part").at("file"))).fileName(), QString("bar.step"));
        QVERIFY2(said.at("events").dump().find("\"faces\":[") != std::string::npos, said.at("events").dump().c_str());
        QVERIFY2(said.at("events").dump().find("\"path\":[") != std::string::npos, said.at("events").dump().c_str());
        const Outcome outcome = workshop::runKnead({"run", recipe, "--json"});
        QVERIFY2(outcome.status == 0, outcome.errors.c_str());
        QCOMPARE(json::parse(outcome.out).at("state_hash").get<std::string>(), presentHash());
    }

private:
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience); }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(m_window.get(), key, modifiers); }

    std::string presentHash()
    {
        const History& tree = document().history().tree();
        return hexadecimal(tree.record(tree.current()).hash);
    }

    void waitFor(double seconds)
    {
        const double end = snapshot().time + seconds;
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time >= end, patience);
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
            seen();
        }
        QTest::mouseRelease(&view, Qt::LeftButton, {}, from + way);
    }

    /// A face is fixed, a block is pressed into the bar and dragged while time runs; undo, another branch.
    void doThings()
    {
        openExample("bar.step", 12);
        key(Qt::Key_X);
        const Box box = document().content().box;
        click(Vec3(box.center().x(), box.center().y(), box.max().z()));
        QTRY_COMPARE(snapshot().fixtures.size(), std::size_t{1});
        key(Qt::Key_X);
        key(Qt::Key_B);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        key(Qt::Key_1, Qt::KeypadModifier);
        key(Qt::Key_F);
        rest();
        key(Qt::Key_Space);
        waitFor(0.05);
        drag(QPoint(0, 60));
        drag(QPoint(50, 10));
        waitFor(0.05);
        key(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        settle();
        key(Qt::Key_Z, Qt::ControlModifier);
        settle();
        key(Qt::Key_G);
        QTRY_VERIFY(!snapshot().gravity.isZero());
        key(Qt::Key_Space);
        QTest::keyPress(&m_window->viewport(), Qt::Key_PageDown);
        waitFor(0.1);
        QTest::keyRelease(&m_window->viewport(), Qt::Key_PageDown);
        key(Qt::Key_Space);
        QTRY_VERIFY(!snapshot().playing);
        settle();
        QVERIFY(snapshot().tools[0].peakForce > 0);
    }

    void save()
    {
        m_project = m_shop.qPath("session.knead");
        const Project project = document().project();
        QVERIFY(project.entries.size() > 6);
        writeProject(m_project.toStdString(), project);
    }

    workshop::Workshop m_shop;
    QString m_project;
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowReplayTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_replay_test.moc"
