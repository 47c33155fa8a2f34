// A newly opened part is pressed by one click, with real events.
#include "support/history_on_test.h"
#include "ui/panels/press_button.h"
#include "ui/run_window.h"

#include <QAction>

#include <algorithm>

using namespace knead;

class WindowPressTest : public QObject, HistoryOnTest {
    Q_OBJECT

    QToolButton& button() { return *m_window->findChild<QToolButton*>("pressButton"); }

    /// Of all objects, as a share of the size of the bodies.
    double largestShift()
    {
        double most = 0;
        for (const Snapshot::BodyState& body : snapshot().bodies)
            for (const Vec3& displacement : body.displacements())
                most = std::max(most, displacement.norm());
        return most / document().content().box.diagonal().norm();
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void cleanup() { m_window.reset(); }

    void aClickPressesANewPart()
    {
        show(m_services);
        QVERIFY(!button().isVisible() && !action("pressIt")->isEnabled());
        openExample("bar.step", 16);
        settle();
        QTRY_VERIFY(button().isVisible());
        QVERIFY(action("pressIt")->isEnabled());
        const QRect area(button().mapTo(m_window.get(), QPoint()), button().size());
        QVERIFY(m_window->rect().contains(area));
        picture("press-it");
        const std::size_t entries = tree().records().size();
        QTest::mouseClick(&button(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().playing, patience);
        QVERIFY(!button().isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 1, patience);
        key(Qt::Key_Space);
        settle();
        QCOMPARE(snapshot().tools.size(), std::size_t{1});
        QCOMPARE(snapshot().fixtures.size(), std::size_t{1});
        QVERIFY2(largestShift() > 0.03 && largestShift() < 0.3, qPrintable(QString::number(largestShift())));
        QVERIFY(!button().isVisible());
        picture("pressed");
        QVERIFY(tree().records().size() > entries);
        const auto entry = std::find_if(tree().records().begin(), tree().records().end(),
                                        [](const HistoryRecord& record) { return record.name == "Press it"; });
        QVERIFY(entry != tree().records().end());

        // Back at the start it is offered again.
        while (action("undo")->isEnabled()) {
            undo();
            settle();
        }
        QTRY_VERIFY(button().isVisible());
        QVERIFY(snapshot().tools.empty() && snapshot().fixtures.empty());
    }

    /// Whoever has begun to work on the part is not in need of it.
    void itIsGoneWhenAPersonBegins()
    {
        show(m_services);
        openExample("bracket.step", 12);
        settle();
        QTRY_VERIFY(button().isVisible());
        document().addTool(ToolKind::ball);
        settle();
        QTRY_VERIFY(!button().isVisible());
        QVERIFY(!action("pressIt")->isEnabled());
        undo();
        settle();
        QTRY_VERIFY(button().isVisible());
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowPressTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_press_test.moc"
