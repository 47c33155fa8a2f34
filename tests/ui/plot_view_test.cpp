#include "ui/panels/plot_view.h"
#include "ui/round_number.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace knead;

/// Lines over time.
class PlotViewTest : public QObject {
    Q_OBJECT

    static int countOf(const QImage& image, const QColor& color)
    {
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, y) == color ? 1 : 0;
        return count;
    }

private slots:
    void stepsAreRound()
    {
        const std::pair<double, double> steps[] = {{1, 1}, {1.1, 2}, {2.5, 5}, {6, 10}, {0.02, 0.02}, {0.03, 0.05}};
        for (const auto& [least, step] : steps)
            QVERIFY(std::abs(roundUp(least) / step - 1) < 1e-12);
    }

    void labelsStandAtRoundNumbers()
    {
        const PlotAxis time = PlotAxis::between(0, 0.35, 5);
        QCOMPARE(time.end, 0.35);
        QCOMPARE(time.labels(), (std::vector<double>{0, 0.1, 0.2, 3 * 0.1}));
        QCOMPARE(time.decimals(), 1);
        const PlotAxis force = PlotAxis::around(-3.2, 7.9, 4);
        QCOMPARE(force.labels(), (std::vector<double>{-5, 0, 5, 10}));
        QCOMPARE(force.decimals(), 0);
    }

    void whatIsUnknownInterruptsALine()
    {
        const QColor red("#ff0000");
        std::vector<QPointF> points;
        for (int i = 0; i <= 100; ++i)
            points.emplace_back(0.01 * i, 1.0);
        PlotView plot;
        plot.resize(400, 200);
        plot.show({{"a", red, points}}, Quantity::Force, "Force");
        const int whole = countOf(plot.grab().toImage(), red);
        for (std::size_t i = 40; i < 60; ++i)
            points[i].setY(std::numeric_limits<double>::quiet_NaN());
        plot.show({{"a", red, points}}, Quantity::Force, "Force");
        const int interrupted = countOf(plot.grab().toImage(), red);
        QVERIFY(whole > 200);
        QVERIFY(interrupted < 0.95 * whole && interrupted > 0.5 * whole);
    }

    /// An hour at 60 Hz: it is one line still, and no peak is lost.
    void manyPointsAreFewLines()
    {
        const QColor red("#ff0000");
        std::vector<QPointF> points;
        for (int i = 0; i < 216'000; ++i)
            points.emplace_back(i / 60.0, 1.0);
        PlotView plot;
        plot.resize(400, 200);
        plot.show({{"a", red, points}}, Quantity::Force, "Force");
        const QImage flat = plot.grab().toImage();
        plot.show({{"a", red, {points.front(), points.back()}}}, Quantity::Force, "Force");
        QVERIFY(std::abs(countOf(flat, red) - countOf(plot.grab().toImage(), red)) < 10);

        points[100'000].setY(0.2);
        plot.show({{"a", red, points}}, Quantity::Force, "Force");
        QElapsedTimer clock;
        clock.start();
        const QImage image = plot.grab().toImage();
        QVERIFY2(clock.elapsed() < 500, qPrintable(QString::number(clock.elapsed())));
        QVERIFY(countOf(image, red) > countOf(flat, red) + 20);
    }

    void nothingAndOnePointAreDrawn()
    {
        PlotView plot;
        plot.resize(300, 150);
        plot.setHint("Nothing yet");
        plot.grab();
        plot.show({{"a", Qt::red, {{0, 0}}}, {"b", Qt::blue, {}}}, Quantity::Length, "Way");
        plot.grab();
        plot.show({{"a", Qt::red, {{0.5, -1e-12}, {0.5, 3e9}}}}, Quantity::Pressure, "Stress");
        plot.grab();
        QCOMPARE(plot.lines().size(), std::size_t{1});
    }

    /// Five minutes of a force that comes and goes, as in contact, do not hold the window up.
    void aLongRestlessRecordIsPaintedSwiftly()
    {
        PlotView plot;
        plot.resize(900, 300);
        std::vector<PlotLine> lines{{.name = "a", .color = Qt::red, .id = 1},
                                    {.name = "b", .color = Qt::blue, .id = 2, .style = Qt::DashLine}};
        for (PlotLine& line : lines)
            for (int i = 0; i < 9000; ++i)
                line.points.emplace_back(i / 30.0, i % 2 == 0 ? 1 : 100);
        plot.show(lines, Quantity::Force, "Force");
        QElapsedTimer clock;
        clock.start();
        (void)plot.grab();
        QVERIFY2(clock.elapsed() < 1000, qPrintable(QString("%1 ms").arg(clock.elapsed())));
    }

    void noPeakIsLost()
    {
        PlotView plot;
        plot.resize(900, 300);
        PlotLine line{.name = "a", .color = Qt::red};
        for (int i = 0; i < 9000; ++i)
            line.points.emplace_back(i / 30.0, i == 4321 ? 100 : 10);
        plot.show({line}, Quantity::Force, "Force");
        const QImage image = plot.grab().toImage();
        const QPointF peak = plot.placeOf({4321 / 30.0, 70});
        const QColor ground = plot.palette().color(QPalette::Base);
        int painted = 0;
        for (int x = -2; x <= 2; ++x)
            painted += image.pixelColor(peak.toPoint() + QPoint(x, 0)) == ground ? 0 : 1;
        QVERIFY(painted > 0);
    }

    void aClickOnANameHidesItsLineAlsoWhenItIsShownAnew()
    {
        const QColor red("#ff0000");
        PlotView plot;
        plot.resize(400, 200);
        PlotLine line{.name = "a", .color = red, .points = {{0, 1}, {1, 1}}, .id = 7};
        plot.show({line}, Quantity::Force, "Force");
        const int shown = countOf(plot.grab().toImage(), red);
        QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.legendArea(0).center().toPoint());
        QVERIFY(plot.isHidden(line));
        plot.show({line}, Quantity::Force, "Force");
        QVERIFY(countOf(plot.grab().toImage(), red) < shown / 2);
        QTest::mouseClick(&plot, Qt::LeftButton, {}, plot.legendArea(0).center().toPoint());
        QVERIFY(!plot.isHidden(line));
    }

    /// The grid has as many lines as there is room for, also when all is of one moment.
    void aSingleMomentIsPaintedSwiftly()
    {
        PlotView plot;
        plot.resize(700, 150);
        for (const double time : {0.0, 0.5, 3600.0}) {
            plot.show({{"a", Qt::red, {{time, 0}}}}, Quantity::Length, "Way");
            QElapsedTimer clock;
            clock.start();
            plot.grab();
            QVERIFY2(clock.elapsed() < 200, qPrintable(QString::number(clock.elapsed())));
        }
    }
};

QTEST_MAIN(PlotViewTest)
#include "plot_view_test.moc"
