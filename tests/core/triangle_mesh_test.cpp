#include "core/geometry/mass_properties.h"
#include "core/geometry/triangle_mesh.h"
#include "support/shapes.h"

#include <QtTest>

#include <random>

using namespace knead;

namespace {

/// Every triangle with three vertices of its own, as in an STL file, each moved by up to `noise` per axis.
TriangleMesh soup(const TriangleMesh& mesh, double noise)
{
    TriangleMesh result;
    std::minstd_rand random(11);
    const auto jitter = [&] { return noise * (2.0 * (random() % 10007) / 10006 - 1); };
    result.faceOfTriangle = mesh.faceOfTriangle;
    for (const TriangleMesh::Triangle& triangle : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(result.vertices.size());
        for (const std::uint32_t vertex : triangle)
            result.vertices.push_back(mesh.vertices[vertex] + Vec3(jitter(), jitter(), jitter()));
        result.triangles.push_back({first, first + 1, first + 2});
    }
    return result;
}

} // namespace

class TriangleMeshTest : public QObject {
    Q_OBJECT

private slots:
    void weldingASoupClosesIt_data()
    {
        QTest::addColumn<double>("noise");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("equal vertices, no tolerance") << 0.0 << 0.0;
        QTest::newRow("equal vertices") << 0.0 << 1e-6;
        QTest::newRow("vertices a little apart") << 1e-7 << 1e-6;
        QTest::newRow("tolerance near the edge length") << 0.004 << 0.02;
    }
    void weldingASoupClosesIt()
    {
        QFETCH(double, noise);
        QFETCH(double, tolerance);
        const TriangleMesh torus = shapes::torus(3, 1, 40, 20);
        const TriangleMesh broken = soup(torus, noise);
        QVERIFY(!isWatertight(broken));
        const TriangleMesh welded = weld(broken, tolerance);
        QVERIFY(isWatertight(welded));
        QCOMPARE(welded.vertices.size(), torus.vertices.size());
        QCOMPARE(welded.triangles.size(), torus.triangles.size());
    }

    void verticesFurtherApartStayApart()
    {
        const TriangleMesh torus = shapes::torus(3, 1, 40, 20);
        QVERIFY(!isWatertight(weld(soup(torus, 1e-4), 1e-6)));
    }

    void collapsedTrianglesGoAndFacesStay()
    {
        // A box so flat that its four long sides collapse: two triangles each of top and bottom remain.
        const TriangleMesh welded = weld(shapes::box(Vec3(1, 1, 1e-9)), 1e-6);
        QCOMPARE(welded.vertices.size(), std::size_t{4});
        QCOMPARE(welded.faceOfTriangle, (std::vector<std::uint32_t>{4, 4, 5, 5}));
        QCOMPARE(welded.triangles.size(), std::size_t{4});
    }

    void resultDoesNotDependOnWhereTheGridFalls()
    {
        for (const double shift : {0.0, 1e-6, 3.3e-6, 7.9e-6}) {
            const TriangleMesh moved = shapes::moved(shapes::box(Vec3(1, 1, 1)), {Vec3(shift, -shift, 2 * shift)});
            QCOMPARE(weld(soup(moved, 4e-7), 2e-6).vertices.size(), std::size_t{8});
        }
    }
};

QTEST_GUILESS_MAIN(TriangleMeshTest)
#include "triangle_mesh_test.moc"
