#include "core/geometry/planar_mesh.h"

#include <QtTest>

#include <cmath>
#include <map>
#include <random>
#include <utility>

using namespace knead;
using Vec2 = Eigen::Vector2d;

namespace {

using Sides = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;

PlanarMesh square()
{
    return {{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{0, 1, 2}, {0, 2, 3}}};
}

Sides sidesOf(const PlanarMesh& mesh)
{
    Sides sides;
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            sides.emplace(std::pair(mesh.triangles()[t][i], mesh.triangles()[t][(i + 1) % 3]), t);
    return sides;
}

double areaOf(const PlanarMesh& mesh)
{
    double area = 0;
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
        area += 0.5 * mesh.turnOf(t);
    return area;
}

/// How far a point is inside the circle through the corners of a triangle, as a share of its radius.
double depthInCircle(const PlanarMesh& mesh, std::uint32_t triangle, const Vec2& point)
{
    const auto [i, j, k] = mesh.triangles()[triangle];
    const Vec2 a = mesh.points()[i];
    const Vec2 b = mesh.points()[j] - a;
    const Vec2 c = mesh.points()[k] - a;
    const double d = 2 * (b.x() * c.y() - b.y() * c.x());
    const Vec2 center((c.y() * b.squaredNorm() - b.y() * c.squaredNorm()) / d,
                      (b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) / d);
    return 1 - (point - a - center).norm() / center.norm();
}

} // namespace

class PlanarMeshTest : public QObject {
    Q_OBJECT

private slots:
    void aPointInsideDividesATriangleIntoThree();
    void aPointOnASideDividesBothTriangles();
    void manyPointsLeaveADelaunayMeshOfTheSameArea();
    void aSideThatTwoTrianglesHaveInOneDirectionIsABorder();
};

void PlanarMeshTest::aPointInsideDividesATriangleIntoThree()
{
    PlanarMesh mesh({{0, 0}, {3, 0}, {0, 3}}, {{0, 1, 2}});
    QVERIFY(mesh.isBorder(0, 0) && mesh.isBorder(0, 1) && mesh.isBorder(0, 2));
    const auto changed = mesh.addInside(0);
    QCOMPARE(changed.size(), 3U);
    QCOMPARE(mesh.triangles().size(), 3U);
    QCOMPARE(mesh.points().back(), Vec2(1, 1));
    QCOMPARE(areaOf(mesh), 4.5);
    for (std::uint32_t t = 0; t < 3; ++t)
        QVERIFY(mesh.turnOf(t) > 0 && mesh.isBorder(t, 0) && !mesh.isBorder(t, 1) && !mesh.isBorder(t, 2));
}

void PlanarMeshTest::aPointOnASideDividesBothTriangles()
{
    PlanarMesh mesh = square();
    QVERIFY(!mesh.isBorder(0, 2)); // the diagonal
    mesh.addOnSide(0, 2);
    QCOMPARE(mesh.points().back(), Vec2(1.5, 1.5));
    QCOMPARE(mesh.triangles().size(), 4U);
    QCOMPARE(areaOf(mesh), 9.0);
    QCOMPARE(sidesOf(mesh).size(), 12U);
}

void PlanarMeshTest::manyPointsLeaveADelaunayMeshOfTheSameArea()
{
    PlanarMesh mesh = square();
    std::mt19937 random(7);
    const std::size_t count = 400;
    for (std::size_t i = 0; i < count; ++i) {
        const auto triangle = static_cast<std::uint32_t>(random() % mesh.triangles().size());
        const std::size_t side = random() % 3;
        if (random() % 2 == 0 || mesh.isBorder(triangle, side))
            mesh.addInside(triangle);
        else
            mesh.addOnSide(triangle, side);
    }
    QCOMPARE(mesh.points().size(), 4 + count);
    QCOMPARE(mesh.triangles().size(), 2 + 2 * count);
    QVERIFY(std::abs(areaOf(mesh) - 9) < 1e-9);

    const Sides sides = sidesOf(mesh);
    QCOMPARE(sides.size(), 3 * mesh.triangles().size()); // none is there twice
    int borders = 0;
    for (const auto& [ends, triangle] : sides) {
        const auto other = sides.find({ends.second, ends.first});
        if (other == sides.end()) {
            ++borders;
            continue;
        }
        for (const std::uint32_t corner : mesh.triangles()[other->second])
            if (corner != ends.first && corner != ends.second)
                QVERIFY(depthInCircle(mesh, triangle, mesh.points()[corner]) < 1e-6);
    }
    QCOMPARE(borders, 4); // which stay as they are
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
        QVERIFY(mesh.turnOf(t) > 0);
}

void PlanarMeshTest::aSideThatTwoTrianglesHaveInOneDirectionIsABorder()
{
    const PlanarMesh mesh({{0, 0}, {1, 0}, {0, 1}, {0, 2}, {0, -1}}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}});
    QVERIFY(mesh.isBorder(0, 0) && mesh.isBorder(1, 0) && mesh.isBorder(2, 0));
}

QTEST_APPLESS_MAIN(PlanarMeshTest)
#include "planar_mesh_test.moc"
