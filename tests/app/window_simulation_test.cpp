#include "support/window_on_test.h"
#include "ui/panels/quantity_field.h"
#include "ui/panels/timeline_axis.h"
#include "ui/run_window.h"

#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLabel>
#include <QToolButton>

#include <cmath>

using namespace knead;

/// How time runs, as a person sets it, and what is offered when a simulation had to stop.
class WindowSimulationTest : public QObject, WindowOnTest {
    Q_OBJECT

    void choose(const char* name, const QString& text)
    {
        auto* choice = find<QComboBox>(name);
        QVERIFY2(choice->findText(text) >= 0, qPrintable(text));
        choice->setCurrentText(text);
        emit choice->activated(choice->currentIndex());
    }

    void type(const char* field, const QString& text)
    {
        auto* edit = find<QuantityField>(field);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }

    static constexpr double tooFast = 20; // [m/s] for soft material, but less than its thickness in a step

    /// Soft material, with a block that is driven into it much too fast.
    void makeTrouble()
    {
        openExample("bar.step");
        Material soft;
        soft.youngsModulus = 3e5;
        soft.density = 1000;
        soft.dampingRatio = 0;
        document().post(SetMaterial{0, soft});
        document().post(SetIntegrator{Integrator::semiImplicitEuler});
        document().addTool(ToolKind::box);
        QTRY_COMPARE(snapshot().tools.size(), std::size_t{1});
        const ToolState tool = snapshot().tools[0];
        document().post(ReshapeManipulator{tool.id, tool.size, tool.friction, tooFast, 1e9, tool.kind, tool.part});
        document().post(SetManipulatorMotion{tool.id, DriveAt{Vec3(0, 0, -tooFast), Vec3::Zero()}});
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(!snapshot().health.ok, patience);
        QTRY_VERIFY(m_window->banner().sentence().contains("stopped"));
    }

    const TimelineAxis& axis() { return *find<TimelineAxis>("timelineAxis"); }

    /// Of all pictures [s].
    double lastFilmed()
    {
        double last = 0;
        for (const Timeline::Picture& picture : document().timeline().pictures)
            last = std::max(last, picture.frame->time);
        return last;
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init()
    {
        show(m_services);
        find<QDockWidget>("simulationDock")->raise();
    }

    void cleanup() { m_window.reset(); }

    void slowMotionIsSlow()
    {
        openExample("bar.step");
        choose("simulationSpeed", "1/10 of real time");
        QElapsedTimer clock;
        clock.start();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.1, patience);
        QVERIFY2(clock.elapsed() > 900, qPrintable(QString::number(clock.elapsed())));
        QTRY_VERIFY(find<QLabel>("ratio")->text().contains("0.1x as chosen"));
        picture("slow-motion");
        choose("simulationSpeed", "Real time");
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().ratio > 0.3, patience);
        // Speed is of the window: what was simulated is one entry, from play to pause.
        const std::size_t before = document().history().tree().records().size();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_COMPARE(document().history().tree().records().size(), before + 1);
        // A document that is opened next runs at the same speed.
        choose("simulationSpeed", "1/4 of real time");
        openExample("bar.step");
        QCOMPARE(document().speed(), 0.25);
    }

    void gravityHasASizeAndADirection()
    {
        openExample("bar.step");
        choose("gravityPreset", "Moon");
        QTRY_COMPARE(snapshot().gravity, Vec3(0, 0, -1.62));
        QTRY_VERIFY(action("gravity")->isChecked());
        type("gravityX", "0,5 m/s2");
        QTRY_COMPARE(snapshot().gravity, Vec3(0.5, 0, -1.62));
        QTRY_COMPARE(find<QComboBox>("gravityPreset")->currentIndex(), -1);
        // The switch turns off and on what was there.
        action("gravity")->trigger();
        QTRY_VERIFY(snapshot().gravity.isZero());
        action("gravity")->trigger();
        QTRY_COMPARE(snapshot().gravity, Vec3(0.5, 0, -1.62));
        type("gravityZ", "1 g");
        QTRY_COMPARE(snapshot().gravity.z(), 9.80665);
        action("undo")->trigger();
        QTRY_COMPARE(snapshot().gravity.z(), -1.62);
        QTRY_COMPARE(find<QuantityField>("gravityZ")->text(), QString("-1.62 m/s²"));
        type("gravityY", "fast");
        QVERIFY(find<QuantityField>("gravityY")->hasProblem());
        QCOMPARE(snapshot().gravity.y(), 0.0);
        picture("gravity");
    }

    void dampingOfAllBodiesIsOneEntry()
    {
        openExample("bracket.step");
        const std::size_t before = document().history().tree().records().size();
        const std::vector<Material> materials = snapshot().materials;
        QCOMPARE(materials.size(), std::size_t{2});
        type("allDampingRatio", "0.2");
        QTRY_VERIFY(snapshot().materials[0].dampingRatio == 0.2 && snapshot().materials[1].dampingRatio == 0.2);
        QTRY_COMPARE(document().history().tree().records().size(), before + 1);
        document().post(SetMaterial{1, materials[1]});
        QTRY_COMPARE(find<QuantityField>("allDampingRatio")->text(), QString());
        QCOMPARE(find<QuantityField>("allDampingRatio")->placeholderText(), QString("different"));
    }

    void threadsAreChosenAndRemembered()
    {
        unsigned limit = 99;
        Services services = m_services;
        services.limitThreads = [&limit](unsigned threads) { limit = threads; };
        show(services);
        auto* choice = find<QComboBox>("threads");
        if (choice->count() < 2)
            QSKIP("This machine has one core.");
        choice->setCurrentIndex(1);
        emit choice->activated(1);
        QCOMPARE(limit, 1U);
        limit = 99;
        show(services);
        QCOMPARE(limit, 1U);
        QCOMPARE(find<QComboBox>("threads")->currentText(), QString("1"));
        emit find<QComboBox>("threads")->activated(0);
        QCOMPARE(limit, 0U);

        // The preferences say the same, and are not undone by another one.
        Preferences chosen = readPreferences();
        QCOMPARE(chosen.threads, 0);
        chosen.threads = 1;
        m_window->features().preferences->set(chosen);
        QCOMPARE(find<QComboBox>("threads")->currentIndex(), 1);
        m_window->features().preferences->setTheme(Theme::Dark);
        m_window->features().preferences->setTheme(Theme::Light);
        QCOMPARE(limit, 1U);
        emit find<QComboBox>("threads")->activated(0);
        QCOMPARE(readPreferences().threads, 0);
    }

    void troubleOffersItsRemedy()
    {
        makeTrouble();
        auto* remedy = find<QToolButton>("bannerRemedy");
        QTRY_VERIFY(remedy->isVisible());
        QVERIFY(find<QToolButton>("bannerOther")->isVisible());
        QCOMPARE(find<QToolButton>("bannerOther")->text(), QString("Reset"));
        picture("trouble");
        if (snapshot().health.trouble == Trouble::squashed) {
            QCOMPARE(remedy->text(), QString("Fill finer"));
            const double spacing = document().content().spacing;
            QTest::mouseClick(remedy, Qt::LeftButton);
            QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
            QVERIFY(document().content().spacing < 0.8 * spacing);
        } else {
            QCOMPARE(remedy->text(), QString("Slower tools"));
            QTest::mouseClick(remedy, Qt::LeftButton);
            QTRY_VERIFY(snapshot().tools.size() == 1 && snapshot().tools[0].speedLimit == tooFast / 2);
        }
        QTRY_VERIFY(snapshot().health.ok);
        QTRY_COMPARE(snapshot().time, 0.0);
        QTRY_VERIFY(m_window->banner().sentence().isEmpty());
    }

    void troubleWithoutToolsOffersDamping()
    {
        openExample("bar.step");
        Material soft;
        soft.youngsModulus = 1e4;
        soft.poissonRatio = 0.4;
        soft.density = 2000;
        soft.dampingRatio = 0.1;
        document().post(SetMaterial{0, soft});
        type("gravityZ", "-10000 m/s2");
        QTRY_COMPARE(snapshot().gravity.z(), -10000.0);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(!snapshot().health.ok, patience);
        QVERIFY2(snapshot().health.trouble == Trouble::runaway, snapshot().health.message.english().c_str());
        auto* remedy = find<QToolButton>("bannerRemedy");
        QTRY_VERIFY(remedy->isVisible());
        QCOMPARE(remedy->text(), QString("More damping"));
        QVERIFY(m_window->banner().sentence().contains("Lower gravity or raise the damping ratio, then reset."));
        QTest::mouseClick(remedy, Qt::LeftButton);
        QTRY_COMPARE(snapshot().materials[0].dampingRatio, 0.2);
        QTRY_COMPARE(snapshot().time, 0.0);
        QTRY_VERIFY(snapshot().health.ok && m_window->banner().sentence().isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
        const auto& records = document().history().tree().records();
        QCOMPARE(records[records.size() - 2].name, std::string("More damping"));
        QCOMPARE(records.back().name, std::string("Reset"));
    }

    void troubleCanBeReset()
    {
        makeTrouble();
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
        const double ran = lastFilmed();
        QVERIFY2(document().film().underWay().empty(), "all that was seen belongs to what was done");
        QTRY_COMPARE(axis().timeline().present, std::max(ran, snapshot().time));
        QTest::mouseClick(find<QToolButton>("bannerOther"), Qt::LeftButton);
        QTRY_VERIFY(snapshot().health.ok);
        QTRY_COMPARE(snapshot().time, 0.0);
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
        // The reset itself takes no time, and has no pictures.
        const auto tree = document().history().tree();
        QVERIFY(document().film().framesOf(tree.current()).empty());
        QTRY_COMPARE(axis().timeline().ticks.back().entry, tree.current());
        const auto& ticks = axis().timeline().ticks;
        QCOMPARE(ticks.back().at, ticks[ticks.size() - 2].at);
        QCOMPARE(snapshot().tools[0].speedLimit, tooFast);
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowSimulationTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_simulation_test.moc"
