#include "support/window_on_test.h"
#include "ui/run_window.h"

#include <QStatusBar>
#include <QToolButton>

#include <cmath>

using namespace knead;

/// Balance, found on a person's command; and what the window says of walls.
class WindowBalanceTest : public QObject, WindowOnTest {
    Q_OBJECT

    static constexpr double weight = 9.81;  // [m/s^2]
    static constexpr double modulus = 20e6; // [Pa]
    static constexpr double density = 1000; // [kg/m^3]

    /// Of the log.
    QString lastLine() { return m_window->findChild<LogPanel*>()->toPlainText().section('\n', -1); }

    const History& tree() { return document().history().tree(); }

    /// Of the object that is lowest against its place at rest [m].
    double sag()
    {
        double lowest = 0;
        for (const Vec3& displacement : snapshot().bodies[0].displacements())
            lowest = std::min(lowest, displacement.z());
        return -lowest;
    }

    /// The bar of 160 x 20 x 20 mm, light and soft, held at its low end and heavy.
    void hangBar(double cells = 32)
    {
        openExample("bar.step", cells);
        Material soft;
        soft.youngsModulus = modulus;
        soft.poissonRatio = 0.3;
        soft.density = density;
        soft.dampingRatio = 0.05;
        document().post(SetMaterial{0, soft});
        document().post(SetFloor{});
        document().toggleFace(0, endFace());
        QTest::keyClick(m_window.get(), Qt::Key_G);
        seen();
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
        QCOMPARE(snapshot().fixtures.size(), std::size_t{1});
        QVERIFY(!snapshot().gravity.isZero());
    }

    std::uint32_t endFace()
    {
        const TriangleMesh& mesh = document().content().bodies[0]->mesh;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            bool isAtEnd = true;
            for (const std::uint32_t vertex : mesh.triangles[t])
                isAtEnd = isAtEnd && mesh.vertices[vertex].x() < document().content().box.min().x() + 1e-6;
            if (isAtEnd)
                return mesh.faceOfTriangle[t];
        }
        return 0;
    }

    void findBalance()
    {
        QTest::keyClick(m_window.get(), Qt::Key_B, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
    }

private slots:
    void initTestCase()
    {
        if (!hasDisplay())
            KNEAD_SKIP_WITHOUT("display", "The view needs a display: run this test under xvfb-run.");
        prepare();
    }

    void init() { show(m_services); }
    void cleanup() { m_window.reset(); }

    /// rho g A L^4 / 8 E I = 3/2 rho g L^4 / E b^2; with 4 cells across the lattice is 7 % too stiff.
    void aHangingBarSagsAsABeam()
    {
        hangBar();
        const std::size_t entries = tree().records().size();
        findBalance();
        const double expected = 1.5 * density * weight * std::pow(0.16, 4) / (modulus * 0.02 * 0.02);
        QVERIFY2(std::abs(sag() / expected - 1) < 0.1, qPrintable(QString::number(sag() / expected)));
        QCOMPARE(snapshot().energy.kinetic, 0.0);
        QVERIFY(!document().isPlaying());
        QCOMPARE(tree().records().size(), entries + 1);
        QCOMPARE(tree().record(tree().current()).name, std::string("Find balance"));
        QVERIFY(lastLine().contains("In balance: the forces that are left are"));
        QVERIFY(m_window->statusBar()->currentMessage().startsWith("In balance: "));
        picture("balance");
        m_window->features().preferences->setTheme(Theme::Dark);
        picture("balance-dark");
        m_window->features().preferences->setTheme(Theme::Light);

        // It stays there when time runs: within a thousandth of its sag.
        const double still = sag();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.2, patience);
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
        QVERIFY(std::abs(sag() - still) < 1e-3 * still);
    }

    void itIsUndoneAndRedone()
    {
        hangBar();
        findBalance();
        const double found = sag();
        QVERIFY(found > 0);
        action("undo")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled() && sag() == 0, patience);
        action("redo")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled() && sag() > 0, patience);
        QCOMPARE(sag(), found);
    }

    /// Esc, while the simulation's thread is at work: the window draws on, nothing is done and nothing is in the history.
    void itCanBeCancelled()
    {
        hangBar(120);
        const std::size_t entries = tree().records().size();
        QTest::keyClick(m_window.get(), Qt::Key_B, Qt::ControlModifier);
        QVERIFY(m_window->tasks().isRunning());
        QCOMPARE(m_window->tasks().title(), QString("Finding the balance"));
        QTest::keyClick(m_window.get(), Qt::Key_Escape);
        QVERIFY(!m_window->tasks().isRunning());
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
        QCOMPARE(sag(), 0.0);
        QCOMPARE(snapshot().step, std::uint64_t{0});
        QCOMPARE(tree().records().size(), entries);
        QVERIFY(lastLine().contains("cancelled, nothing has changed"));
    }

    void whatIsNotHeldIsSaid()
    {
        openExample("bar.step");
        document().post(SetFloor{});
        QTest::keyClick(m_window.get(), Qt::Key_G);
        seen();
        QTRY_VERIFY_WITH_TIMEOUT(document().isSettled(), patience);
        const std::size_t entries = tree().records().size();
        findBalance();
        QCOMPARE(m_window->banner().sentence(),
                 QString("A body is free to move: hold it, or let time run (dynamic) until it rests on something."));
        QCOMPARE(tree().records().size(), entries);
        picture("balance-free");
        document().toggleFace(0, endFace());
        seen();
        findBalance();
        QVERIFY(lastLine().contains("In balance: "));
        QVERIFY(m_window->banner().sentence().isEmpty());
    }

    void itPausesWhatPlays()
    {
        hangBar();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(snapshot().time > 0.05, patience);
        findBalance();
        QVERIFY(!document().isPlaying());
        QTRY_VERIFY(!snapshot().playing);
        QCOMPARE(snapshot().energy.kinetic, 0.0);
        const auto& records = tree().records();
        QVERIFY(records[records.size() - 2].name.starts_with("Simulate"));
        QCOMPARE(records.back().name, std::string("Find balance"));
    }

    void thinWallsAreSaidOnTheBanner()
    {
        openExample("plate.step", 10);
        QVERIFY2(m_window->banner().sentence().startsWith("Thinnest walls: "),
                 qPrintable(m_window->banner().sentence()));
        QVERIFY(m_window->banner().sentence().contains("too stiff"));
        picture("thin-walls");
        m_window->features().preferences->setTheme(Theme::Dark);
        picture("thin-walls-dark");
        m_window->features().preferences->setTheme(Theme::Light);
        QCOMPARE(find<QToolButton>("bannerRemedy")->text(), QString("Fill finer"));
        QTest::mouseClick(find<QToolButton>("bannerRemedy"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->tasks().isRunning(), patience);
        QVERIFY(document().content().fineness.cellsAcrossWall >= 2 * (1 - 1e-6));
        QVERIFY(m_window->banner().sentence().isEmpty());
    }
};

int main(int argc, char** argv)
{
    prepareGraphics();
    QApplication application(argc, argv);
    WindowBalanceTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "window_balance_test.moc"
