#include "ui/panels/force_plot.h"

#include <QElapsedTimer>
#include <QtTest>

#include <functional>

using namespace knead;

/// Forces over time.
class ForcePlotTest : public QObject {
    Q_OBJECT

    /// A tool and a fixture at 30 Hz.
    static ForceRecord recordOf(int samples, const std::function<double(int)>& force)
    {
        ForceRecord record;
        record.curves.resize(2);
        record.curves[1].isTool = false;
        for (int i = 0; i < samples; ++i) {
            record.times.push_back(i / 30.0);
            for (ForceRecord::Curve& curve : record.curves)
                curve.forces.emplace_back(Vec3(0, 0, force(i)));
        }
        record.end = record.times.back();
        return record;
    }

private slots:
    /// Five minutes of a force that comes and goes, as in contact, do not hold the window up.
    void aLongRestlessRecordIsPaintedSwiftly()
    {
        ForcePlot plot;
        plot.resize(900, 300);
        plot.show(recordOf(9000, [](int i) { return i % 2 == 0 ? 1 : 100; }));
        QElapsedTimer clock;
        clock.start();
        (void)plot.grab();
        QVERIFY2(clock.elapsed() < 1000, qPrintable(QString("%1 ms").arg(clock.elapsed())));
    }

    void noPeakIsLost()
    {
        ForcePlot plot;
        plot.resize(900, 300);
        plot.show(recordOf(9000, [](int i) { return i == 4321 ? 100 : 10; }));
        const QPointF peak = plot.placeOf(4321 / 30.0, 70);
        const QImage image = plot.grab().toImage();
        const QColor ground = plot.palette().color(QPalette::Base);
        int painted = 0;
        for (int x = -2; x <= 2; ++x)
            painted += image.pixelColor(peak.toPoint() + QPoint(x, 0)) == ground ? 0 : 1;
        QVERIFY(painted > 0);
    }
};

QTEST_MAIN(ForcePlotTest)
#include "force_plot_test.moc"
