#include "core/aggregate/skin_points.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/refine.h"
#include "support/shapes.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace knead;

/// Points that stand for a surface when it is touched: as many as cells can tell apart, however finely a file divides it.
class SkinPointsTest final : public QObject {
    Q_OBJECT

    static Lattice lattice(double spacing)
    {
        Lattice lattice;
        lattice.spacing = spacing;
        lattice.origin = spacing * Vec3(0.13, 0.27, 0.31);
        return lattice;
    }

    static double areaOf(const std::vector<SkinPoint>& points)
    {
        return std::accumulate(points.begin(), points.end(), 0.0,
                               [](double sum, const SkinPoint& point) { return sum + point.area; });
    }

    static double reachOf(const auto& places, const Vec3& direction, const auto& placeOf)
    {
        double reach = -1;
        for (const auto& place : places)
            reach = std::max(reach, placeOf(place).dot(direction));
        return reach;
    }

private slots:
    void thereAreAboutFourForTheSquareOfASpacing_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::newRow("box") << shapes::box(Vec3(1, 0.9, 0.8));
        QTest::newRow("bracket") << shapes::bracket(1, 0.2, 0.5);
        for (const std::uint32_t around : {30U, 100U, 400U}) {
            QTest::addRow("sphere of %u", around) << shapes::sphere(0.5, around);
            QTest::addRow("cylinder of %u", around) << shapes::cylinder(0.4, 1.3, around);
        }
    }
    void thereAreAboutFourForTheSquareOfASpacing()
    {
        QFETCH(TriangleMesh, mesh);
        const double area = massProperties(mesh).area;
        for (const double spacing : {0.09, 0.1, 0.113}) {
            const std::vector<SkinPoint> points = skinPoints(mesh, lattice(spacing));
            const double density = static_cast<double>(points.size()) * spacing * spacing / area;
            QVERIFY2(density > 3 && density < 6, qPrintable(QString::number(density)));
            QVERIFY(std::abs(areaOf(points) - area) < 1e-9 * area);
        }
    }

    /// Faces of a part often lie between two layers of boxes, and where exactly is a matter of rounding.
    void roundingDoublesNothing()
    {
        TriangleMesh mesh = refine(shapes::box(Vec3(1, 0.9, 0.8)), 0.03, 1'000'000);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> noise(-1e-16, 1e-16);
        for (Vec3& vertex : mesh.vertices)
            vertex += Vec3(noise(random), noise(random), noise(random));
        constexpr double spacing = 0.1;
        Lattice aligned;
        aligned.spacing = spacing;
        const std::vector<SkinPoint> points = skinPoints(mesh, aligned);
        const double density = static_cast<double>(points.size()) * spacing * spacing / massProperties(mesh).area;
        QVERIFY2(density > 4 && density < 6, qPrintable(QString::number(density)));
    }

    void treadsOfSmallStepsHaveTheirOwn()
    {
        constexpr double spacing = 0.1;
        TriangleMesh steps = shapes::box(Vec3(1, 1, 0.2));
        const TriangleMesh higher =
            shapes::moved(shapes::box(Vec3(1, 1, 0.2)), {Vec3(1, 0, 0.04), Quaternion::Identity()});
        steps = refine(shapes::together(steps, higher), 0.03, 1'000'000);
        Lattice aligned;
        aligned.spacing = spacing;
        aligned.origin = spacing * Vec3(0.25, 0, -0.05); // one box has a part of both treads
        double low = 0;                                  // area beside the riser, which is at x = 0.5
        for (const SkinPoint& point : skinPoints(steps, aligned))
            if (std::abs(point.place.z() - 0.1) < 1e-9 && point.place.x() > 0.475 && point.place.x() < 0.499)
                low += point.area;
        QVERIFY2(low > 0.004, qPrintable(QString::number(low)));
    }

    /// Or a floor would carry it somewhere else.
    void theMiddleOfAFlatFaceStays()
    {
        const TriangleMesh mesh = refine(shapes::box(Vec3(1, 0.9, 0.8)), 0.03, 1'000'000);
        for (const double spacing : {0.09, 0.1, 0.113}) {
            double area = 0;
            Vec3 moment = Vec3::Zero();
            for (const SkinPoint& point : skinPoints(mesh, lattice(spacing)))
                if (point.place.z() < -0.4 + 1e-9) {
                    area += point.area;
                    moment += point.area * point.place;
                }
            const Vec3 middle = moment / area;
            QVERIFY2(std::hypot(middle.x(), middle.y()) < 0.03 * spacing,
                     qPrintable(QString::number(std::hypot(middle.x(), middle.y()) / spacing)));
        }
    }

    void nothingReachesBeyondThem()
    {
        constexpr double spacing = 0.1;
        const auto isAsFar = [](const TriangleMesh& mesh, const Vec3& direction, double lacks, double orientation = 1) {
            const auto points = skinPoints(mesh, lattice(spacing), orientation);
            const double reach = reachOf(points, direction, [](const SkinPoint& point) { return point.place; });
            return reach > reachOf(mesh.vertices, direction, [](const Vec3& place) { return place; }) - lacks;
        };
        const TriangleMesh box = shapes::box(Vec3(1, 0.9, 0.8));
        const TriangleMesh sphere = shapes::sphere(0.2, 100);
        for (const double x : {-1.0, -0.3, 0.0, 0.4, 1.0})
            for (const double y : {-1.0, -0.2, 0.5})
                for (const double z : {-1.0, 0.1, 1.0}) {
                    const Vec3 direction = Vec3(x, y, z).normalized();
                    QVERIFY(isAsFar(box, direction, 1e-12)); // corners are points
                    QVERIFY(isAsFar(sphere, direction, 0.03 * spacing));
                    QVERIFY(isAsFar(shapes::insideOut(sphere), direction, 0.03 * spacing, -1));
                }
    }

    void bothSidesOfASheetHaveTheirOwn()
    {
        constexpr double spacing = 0.1;
        const auto points = skinPoints(shapes::box(Vec3(1, 1, 0.02)), lattice(spacing));
        double above = 0;
        double below = 0;
        for (const SkinPoint& point : points)
            (point.place.z() > 0 ? above : below) += point.area;
        QVERIFY2(std::abs(above - below) < 0.02 && above > 0.98, qPrintable(QString("%1 %2").arg(above).arg(below)));
    }
};

QTEST_GUILESS_MAIN(SkinPointsTest)
#include "skin_points_test.moc"
