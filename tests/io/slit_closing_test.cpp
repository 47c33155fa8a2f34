#include "core/geometry/mass_properties.h"
#include "io/brep/slit_closing.h"
#include "support/shapes.h"

#include <QtTest>

using namespace knead;

class SlitClosingTest : public QObject {
    Q_OBJECT

private slots:
    void slitBetweenTrianglesIsClosed();
    void severalSlitsAreClosed();
    void wideHoleStays();
    void closedMeshIsUnchanged();
};

namespace {

/// Splits one edge on one of its sides only, which opens a slit as narrow as `width`.
TriangleMesh withSlit(TriangleMesh mesh, std::size_t triangle, double width)
{
    const TriangleMesh::Triangle t = mesh.triangles[triangle];
    const Vec3 inward = mesh.vertices[t[2]] - 0.5 * (mesh.vertices[t[0]] + mesh.vertices[t[1]]);
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(0.5 * (mesh.vertices[t[0]] + mesh.vertices[t[1]]) + width * inward.normalized());
    mesh.triangles[triangle] = {t[0], middle, t[2]};
    mesh.triangles.push_back({middle, t[1], t[2]});
    return mesh;
}

} // namespace

void SlitClosingTest::slitBetweenTrianglesIsClosed()
{
    const TriangleMesh torus = shapes::torus(0.03, 0.01, 40, 24);
    const TriangleMesh open = withSlit(torus, 100, 1e-5);
    QVERIFY(!isWatertight(open));
    const TriangleMesh closed = closeSlits(open);
    QVERIFY(isWatertight(closed));
    QVERIFY(std::abs(massProperties(closed).volume / massProperties(torus).volume - 1) < 1e-4);
}

void SlitClosingTest::severalSlitsAreClosed()
{
    TriangleMesh mesh = shapes::torus(0.03, 0.01, 40, 24);
    for (const std::size_t triangle : {10U, 11U, 500U, 900U})
        mesh = withSlit(mesh, triangle, 1e-6);
    QVERIFY(isWatertight(closeSlits(mesh)));
}

void SlitClosingTest::wideHoleStays()
{
    TriangleMesh mesh = shapes::torus(0.03, 0.01, 40, 24);
    mesh.triangles.pop_back();
    const TriangleMesh result = closeSlits(mesh);
    QVERIFY(!isWatertight(result));
    QCOMPARE(result.triangles.size(), mesh.triangles.size());
}

void SlitClosingTest::closedMeshIsUnchanged()
{
    const TriangleMesh mesh = shapes::torus(0.03, 0.01, 40, 24);
    QCOMPARE(closeSlits(mesh).triangles, mesh.triangles);
}

QTEST_GUILESS_MAIN(SlitClosingTest)
#include "slit_closing_test.moc"
