#include "core/aggregate/fill.h"
#include "core/aggregate/spacing_choice.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>
#include <numbers>

using namespace knead;

using Kind = SpacingChoice::Kind;

class SpacingChoiceTest : public QObject {
    Q_OBJECT

private slots:
    void everyKindOfChoiceGivesItsSpacing()
    {
        const FillingSize size = sizeWithWalls(shapes::box(Vec3(0.004, 0.05, 0.1)));
        QCOMPARE(spacingFor({Kind::Length, 0.003}, size), 0.003);
        QCOMPARE(spacingFor({Kind::CellsAlong, 50}, size), 0.002);
        QVERIFY(std::abs(spacingFor({Kind::CellsAcrossWall, 4}, size) / 0.001 - 1) < 1e-9);
        const double spacing = spacingFor({Kind::Objects, 20'000}, size);
        QVERIFY(std::abs(estimatedObjects(size, spacing) / 20'000 - 1) < 1e-9);
    }

    void estimateIsNearWhatFillingMakes()
    {
        const TriangleMesh mesh = shapes::moved(shapes::box(Vec3(0.004, 0.05, 0.1)), shapes::tilt(0.5));
        const FillingSize size = sizeOf(mesh);
        for (const double spacing : {0.001, 0.002})
            QVERIFY(std::abs(static_cast<double>(fill(mesh, {.spacing = spacing}).size()) /
                                 estimatedObjects(size, spacing) -
                             1) < 0.1);
    }

    void severalBodiesAreTakenTogether()
    {
        FillingSize all;
        for (const double thickness : {0.02, 0.004, 0.03})
            all.add(sizeWithWalls(shapes::moved(shapes::box(Vec3(thickness, 0.1, 0.1)), {Vec3(10 * thickness, 0, 0)})));
        QVERIFY(std::abs(all.volume / (0.054 * 0.01) - 1) < 1e-12);
        QVERIFY(std::abs(all.thinnestWall / 0.004 - 1) < 1e-9);
        QVERIFY(std::abs(all.box.sizes().x() - (0.315 - 0.038)) < 1e-12);
    }

    void thinWallsAreWarnedOf()
    {
        const FillingSize size = sizeWithWalls(shapes::box(Vec3(0.0006, 0.3, 0.2)));
        const SpacingAssessment coarse = assessSpacing(0.0015, size);
        QVERIFY(std::abs(coarse.cellsAcrossWall - 0.4) < 1e-9);
        // 0.3 x 0.2 x 0.0006 m^3 in cells of 0.3 mm are 1.3 million, and 1000 x 667 x 2 at the faces.
        QCOMPARE(coarse.warning.english(),
                 std::string("Thinnest walls: 0.4 cells across 0.6 mm; bending of such walls comes out many times too "
                             "stiff. Fill with a spacing of 0.3 mm for 2 cells, about 2.7 million objects."));
        QCOMPARE(assessSpacing(0.0006 / 1.75, size).warning.english(), std::string());
        QVERIFY(!assessSpacing(0.0006 / 1.74, size).warning.empty());
    }

    /// A plate of 4 mm with chamfers along one end and fillets along the other, both of 1.5 mm, is no thinner for them.
    void edgesAreNoThinWalls()
    {
        constexpr double thickness = 0.004;
        constexpr double cut = 0.0015;
        std::vector<Eigen::Vector2d> corners{{0, cut}, {cut, 0}};
        const auto addFillet = [&](const Eigen::Vector2d& center, double from) {
            for (int i = 0; i <= 8; ++i) {
                const double angle = from + 0.5 * std::numbers::pi * i / 8;
                corners.push_back(center + cut * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
            }
        };
        addFillet({0.06 - cut, cut}, -0.5 * std::numbers::pi);
        addFillet({0.06 - cut, thickness - cut}, 0);
        corners.insert(corners.end(), {{cut, thickness}, {0, thickness - cut}});
        const double thinnest = sizeWithWalls(shapes::prism(corners, 0.04)).thinnestWall;
        QVERIFY2(std::abs(thinnest / thickness - 1) < 0.01, std::to_string(thinnest).c_str());
    }

    void errorsOfBendingFallWithTheCells()
    {
        QVERIFY(std::isinf(bendingErrorOf(0.99)));
        QCOMPARE(bendingErrorOf(1), 0.9);
        QCOMPARE(bendingErrorOf(1.3), 0.4);
        QCOMPARE(bendingErrorOf(1.75), 0.15);
        QCOMPARE(bendingErrorOf(6), 0.15);
    }

    void memoryGrowsWithTheObjects()
    {
        const FillingSize size = sizeWithWalls(shapes::box(Vec3(0.1, 0.1, 0.1)));
        const SpacingAssessment million = assessSpacing(0.001, size);
        QVERIFY(million.objects > 1e6 && million.objects < 1.1e6);
        QVERIFY(million.bytes > 4e8 && million.bytes < 8e8);
    }
};

QTEST_GUILESS_MAIN(SpacingChoiceTest)
#include "spacing_choice_test.moc"
