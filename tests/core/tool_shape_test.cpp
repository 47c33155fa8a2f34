#include "core/geometry/mass_properties.h"
#include "core/mechanics/tool_shape.h"
#include "support/shapes.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace knead;

namespace {

ToolShape shapeOf(ToolKind kind)
{
    ToolShape shape{kind, fittingSize(kind, {0.02, 0.03, 0.05}), nullptr};
    if (kind == ToolKind::part) {
        shape.part = std::make_shared<const ToolPart>(shapes::torus(0.02, 0.006, 64, 32));
        shape.size = shape.part->size();
    }
    return shape;
}

} // namespace

class ToolShapeTest : public QObject {
    Q_OBJECT

private slots:
    void distancesAreThoseOfTheSurfaceThatIsDrawn_data()
    {
        QTest::addColumn<int>("kind");
        for (const ToolKind kind : toolKinds)
            QTest::newRow(std::string(nameOf(kind)).c_str()) << static_cast<int>(kind);
    }
    void distancesAreThoseOfTheSurfaceThatIsDrawn()
    {
        QFETCH(int, kind);
        const ToolShape shape = shapeOf(static_cast<ToolKind>(kind));
        const TriangleMesh mesh = meshOf(shape);
        const MassProperties properties = massProperties(mesh);
        QVERIFY(isWatertight(mesh));
        QVERIFY(properties.volume > 0);
        QVERIFY((properties.box.sizes() - shape.size).norm() < 1e-9);
        QVERIFY(properties.box.center().norm() < 1e-9);
        const SurfaceDistance drawn(mesh);
        // Round forms are drawn with 64 sides, which lie inside by up to twice r (1 - cos(pi / 64)).
        const bool isRound = shape.kind == ToolKind::ball || shape.kind == ToolKind::cylinder;
        const double flat =
            (isRound ? 0.5 * shape.size.maxCoeff() * (1 - std::cos(std::numbers::pi / 64)) * 2.5 : 0) + 1e-12;
        std::mt19937 random(3);
        std::uniform_real_distribution<double> coordinate(-0.04, 0.04);
        for (int i = 0; i < 2000; ++i) {
            const Vec3 point(coordinate(random), coordinate(random), coordinate(random));
            const SurfacePoint here = surfaceOf(shape, point);
            QVERIFY(std::abs(here.normal.norm() - 1) < 1e-12);
            const double expected = drawn.nearest(point).signedDistance;
            QVERIFY2(std::abs(here.distance - expected) <= flat, qPrintable(QString("%1 %2 at %3 %4 %5")
                                                                                .arg(here.distance)
                                                                                .arg(expected)
                                                                                .arg(point.x())
                                                                                .arg(point.y())
                                                                                .arg(point.z())));
            // The normal is where the distance grows.
            const double step = 1e-7;
            const double ahead = surfaceOf(shape, point + step * here.normal).distance;
            if (std::abs(here.distance) > 1e-4 && shape.kind != ToolKind::part)
                QVERIFY(std::abs((ahead - here.distance) / step - 1) < 1e-3);
        }
    }

    void theEdgeOfAWedgePointsDown()
    {
        const ToolShape wedge = shapeOf(ToolKind::wedge);
        const SurfacePoint below = surfaceOf(wedge, {0, 0, -0.03});
        QVERIFY(std::abs(below.distance - 0.005) < 1e-12);
        QVERIFY((below.normal + Vec3::UnitZ()).norm() < 1e-12);
    }

    void anEmptyPartIsRefused() { QVERIFY_THROWS_EXCEPTION(std::runtime_error, ToolPart(TriangleMesh{})); }
};

QTEST_GUILESS_MAIN(ToolShapeTest)
#include "tool_shape_test.moc"
