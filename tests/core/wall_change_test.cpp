#include "support/thread_limit.h"

#include "core/geometry/refine.h"
#include "core/geometry/wall_change.h"
#include "support/shapes.h"

#include <QtTest>

#include <cmath>
#include <functional>

using namespace knead;

namespace {

/// 100 x 40 x 4 mm, fine enough to be dented.
TriangleMesh plate()
{
    return refine(shapes::box(Vec3(0.1, 0.04, 0.004)), 0.003);
}

std::vector<Vec3> placesBy(const TriangleMesh& mesh, const std::function<Vec3(const Vec3&)>& map)
{
    std::vector<Vec3> places;
    for (const Vec3& vertex : mesh.vertices)
        places.push_back(map(vertex));
    return places;
}

/// The top is pressed in about a place, by so much in its middle; the bottom stays.
std::vector<Vec3> dented(const TriangleMesh& mesh, const Vec3& where, double depth)
{
    return placesBy(mesh, [&](const Vec3& p) {
        const double far = Vec3(p.x() - where.x(), p.y() - where.y(), 0).norm() / 0.012;
        return Vec3(p - Vec3(0, 0, p.z() > 0 ? depth * std::exp(-far * far) : 0));
    });
}

class Stopping final : public TaskControl {
public:
    void report(double, std::string_view) override {}
    bool isCancelled() const override { return true; }
};

} // namespace

class WallChangeTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsAsItWasOrOnlyBentIsNotThin()
    {
        const TriangleMesh mesh = plate();
        const WallChange change(mesh);
        QVERIFY(!change.thinnest(mesh.vertices, 0.002));
        const double angle = 1.5;
        const auto bent = placesBy(mesh, [&](const Vec3& p) {
            const double turn = angle * p.x() / 0.1;
            const double radius = 0.1 / angle - p.z();
            return Vec3(radius * std::sin(turn), p.y(), radius * std::cos(turn));
        });
        QVERIFY(!change.thinnest(bent, 0.002));
    }

    void whereASurfaceMeetsItselfIsNoWall()
    {
        const TriangleMesh mesh = plate();
        const WallChange change(mesh);
        const auto flattened =
            placesBy(mesh, [](const Vec3& p) { return Vec3(p.x(), p.y(), p.z() * (p.x() > 0.03 ? 0.001 : 1)); });
        QVERIFY(change.thinnest(flattened, 0));
        const auto found = change.thinnest(flattened, 0.002);
        QVERIFY2(!found || found->thickness > 0.0001, "4 um of a spacing of 2 mm");
    }

    /// Rays from its end along it leave in the dent, far from the other end.
    void aBarDentedAtItsSideIsNoShorter()
    {
        const TriangleMesh mesh = refine(shapes::box(Vec3(0.1, 0.02, 0.02)), 0.002);
        const WallChange change(mesh);
        const auto notched = placesBy(mesh, [](const Vec3& p) {
            const double far = (p.x() - 0.02) / 0.01;
            return Vec3(p - Vec3(0, 0, (p.z() + 0.01) / 0.02 * 0.009 * std::exp(-std::pow(far, 8))));
        });
        const auto found = change.thinnest(notched, 0.001);
        QVERIFY2(!found || found->atRest < 0.021, found ? qPrintable(QString::number(found->atRest)) : "");
    }

    void aWallOfLessThanHalfIsFoundWhereItIsThinnest()
    {
        const TriangleMesh mesh = plate();
        const WallChange change(mesh);
        const Vec3 where(0.02, -0.005, 0);
        QVERIFY(!change.thinnest(dented(mesh, where, 0.0018), 0));
        const auto found = change.thinnest(dented(mesh, where, 0.003), 0);
        QVERIFY(found);
        QVERIFY2(std::abs(found->thickness - 0.001) < 0.0002, qPrintable(QString::number(found->thickness)));
        QVERIFY(std::abs(found->atRest - 0.004) < 1e-6);
        QVERIFY((found->place - where).head<2>().norm() < 0.004);
    }

    /// Fewer than two objects across: told earlier, but not of a plate that was as thin from the start.
    void aWallThinnerThanTheSpacingIsFoundWhenItBecameThat()
    {
        const TriangleMesh mesh = plate();
        const WallChange change(mesh);
        const auto squeezed = [&](double share) {
            return placesBy(mesh, [&](const Vec3& p) { return Vec3(p.x(), p.y(), share * p.z()); });
        };
        QVERIFY(!change.thinnest(squeezed(0.7), 0.002));
        QVERIFY(change.thinnest(squeezed(0.7), 0.003));
        QVERIFY(!change.thinnest(mesh.vertices, 0.005));
        QVERIFY(!change.thinnest(squeezed(0.9), 0.005));
    }

    void facesMayPointInwards()
    {
        const TriangleMesh mesh = shapes::insideOut(plate());
        QVERIFY(WallChange(mesh).thinnest(dented(mesh, Vec3::Zero(), 0.003), 0));
    }

    void itStopsWhenItShould()
    {
        Stopping stopping;
        const TriangleMesh mesh = plate();
        QVERIFY_THROWS_EXCEPTION(Cancelled, WallChange(mesh, stopping));
        QVERIFY_THROWS_EXCEPTION(Cancelled, WallChange(mesh).thinnest(mesh.vertices, 0, stopping));
    }

    void nothingHasNoWalls() { QVERIFY(!WallChange(TriangleMesh()).thinnest({}, 0.001)); }
};

QTEST_GUILESS_MAIN(WallChangeTest)
#include "wall_change_test.moc"
