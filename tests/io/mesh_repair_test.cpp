#include "core/geometry/mass_properties.h"
#include "io/mesh/mesh_repair.h"
#include "support/shapes.h"

#include <QtTest>

using namespace knead;

namespace {

TriangleMesh torus()
{
    return shapes::torus(0.03, 0.01, 40, 24);
}

double volumeOf(const TriangleMesh& mesh)
{
    return massProperties(mesh).volume;
}

TriangleMesh without(TriangleMesh mesh, std::size_t first, std::size_t count)
{
    const auto begin = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first);
    mesh.triangles.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
    mesh.faceOfTriangle.clear();
    return mesh;
}

} // namespace

class MeshRepairTest : public QObject {
    Q_OBJECT

private slots:
    void soundMeshIsUnchanged();
    void doubledTrianglesAreRemoved();
    void turnedTrianglesAreTurnedBack();
    void insideOutSurfaceIsTurned();
    void voidStaysAVoid();
    void insideOutPieceBesideAnotherIsTurned();
    void smallHoleIsClosed();
    void wideHoleStays();
    void doubleSidedSurfaceKeepsOneSide();
    void foldsAreRemoved();
    void allAtOnceIsRepaired();
};

void MeshRepairTest::soundMeshIsUnchanged()
{
    const RepairedMesh result = repaired(torus());
    QVERIFY(result.repairs.empty());
    QCOMPARE(result.mesh.triangles, torus().triangles);
}

void MeshRepairTest::doubledTrianglesAreRemoved()
{
    TriangleMesh mesh = torus();
    mesh.faceOfTriangle.clear();
    for (const std::size_t i : {3U, 50U, 51U})
        mesh.triangles.push_back(mesh.triangles[i]);
    const RepairedMesh result = repaired(mesh);
    QVERIFY(isWatertight(result.mesh));
    QCOMPARE(result.mesh.triangles.size(), torus().triangles.size());
    QCOMPARE(result.repairs.size(), std::size_t(1));
    QCOMPARE(result.repairs.front().english(), std::string("3 triangles were there twice and removed."));
}

void MeshRepairTest::turnedTrianglesAreTurnedBack()
{
    TriangleMesh mesh = torus();
    for (const std::size_t i : {7U, 8U, 9U, 400U})
        std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
    const RepairedMesh result = repaired(mesh);
    QVERIFY(isWatertight(result.mesh));
    QCOMPARE(volumeOf(result.mesh), volumeOf(torus()));
    QCOMPARE(result.repairs.size(), std::size_t(1));
    QCOMPARE(result.repairs.front().english(), std::string("4 triangles faced the wrong way and were turned."));
}

void MeshRepairTest::insideOutSurfaceIsTurned()
{
    const RepairedMesh result = repaired(shapes::insideOut(torus()));
    QVERIFY(volumeOf(result.mesh) > 0);
    QCOMPARE(result.repairs.size(), std::size_t(1));
}

void MeshRepairTest::voidStaysAVoid()
{
    const TriangleMesh hollow =
        shapes::together(shapes::box(Vec3(0.1, 0.1, 0.1)), shapes::insideOut(shapes::box(Vec3(0.02, 0.02, 0.02))));
    const RepairedMesh result = repaired(hollow);
    QVERIFY(result.repairs.empty());
    QVERIFY(std::abs(volumeOf(result.mesh) - (1e-3 - 8e-6)) < 1e-12);
}

void MeshRepairTest::insideOutPieceBesideAnotherIsTurned()
{
    const TriangleMesh block = shapes::box(Vec3(0.02, 0.02, 0.02));
    const RepairedMesh result =
        repaired(shapes::together(block, shapes::moved(shapes::insideOut(block), {Vec3(0.1, 0, 0)})));
    QVERIFY(std::abs(volumeOf(result.mesh) - 16e-6) < 1e-15);
}

void MeshRepairTest::smallHoleIsClosed()
{
    const RepairedMesh result = repaired(without(torus(), 100, 2));
    QVERIFY(isWatertight(result.mesh));
    QVERIFY(std::abs(volumeOf(result.mesh) / volumeOf(torus()) - 1) < 1e-3);
    QCOMPARE(result.repairs.size(), std::size_t(1));
    QVERIFY2(result.repairs.front().english().starts_with("1 small hole was closed, which added 0."),
             result.repairs.front().english().c_str());
}

void MeshRepairTest::wideHoleStays()
{
    const TriangleMesh open = without(shapes::box(Vec3(0.1, 0.1, 0.1)), 0, 2);
    const RepairedMesh result = repaired(open);
    QVERIFY(!isWatertight(result.mesh) && result.repairs.empty());
    QCOMPARE(result.mesh.triangles, open.triangles);
}

void MeshRepairTest::doubleSidedSurfaceKeepsOneSide()
{
    TriangleMesh mesh = torus();
    mesh.faceOfTriangle.clear();
    for (const TriangleMesh::Triangle& t : torus().triangles)
        mesh.triangles.push_back({t[0], t[2], t[1]});
    const RepairedMesh result = repaired(mesh);
    QVERIFY(isWatertight(result.mesh));
    QVERIFY(std::abs(volumeOf(result.mesh) / volumeOf(torus()) - 1) < 1e-12);
}

void MeshRepairTest::foldsAreRemoved()
{
    TriangleMesh mesh = torus();
    mesh.faceOfTriangle.clear();
    const auto tip = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0, 0, 0.05);
    const TriangleMesh::Triangle t = mesh.triangles[10];
    mesh.triangles.push_back({t[0], t[1], tip});
    mesh.triangles.push_back({t[1], t[0], tip});
    QVERIFY(!isWatertight(mesh));
    const TriangleMesh result = withoutFolds(mesh);
    QVERIFY(isWatertight(result));
    QCOMPARE(result.triangles.size(), torus().triangles.size());
}

void MeshRepairTest::allAtOnceIsRepaired()
{
    TriangleMesh mesh = without(shapes::insideOut(torus()), 200, 1);
    mesh.triangles.push_back(mesh.triangles[17]);
    std::swap(mesh.triangles[900][0], mesh.triangles[900][1]);
    const RepairedMesh result = repaired(mesh);
    QVERIFY(isWatertight(result.mesh));
    QVERIFY(std::abs(volumeOf(result.mesh) / volumeOf(torus()) - 1) < 1e-3);
    QCOMPARE(result.repairs.size(), std::size_t(4));
}

QTEST_GUILESS_MAIN(MeshRepairTest)
#include "mesh_repair_test.moc"
