#include "core/geometry/mass_properties.h"
#include "io/brep/tessellation.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <QtTest>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace knead;
using std::numbers::pi;

namespace {

constexpr Tessellation coarse{.deflection = 2e-4, .angle = 0.4};

TriangleMesh fittedMesh(const TopoDS_Shape& shape)
{
    tessellate(shape, coarse);
    return collectTriangles(shape, coarse, VertexPlace::volumeTrue);
}

} // namespace

class VolumeFitTest : public QObject {
    Q_OBJECT

private slots:
    void fewTrianglesHoldTheVolume_data();
    void fewTrianglesHoldTheVolume();
    void flatFacesStayWhereTheyAre();
    void flatFacesStayFlatWhereFilletsMeetThem();
    void verticesStayWithinTheDeflection();
    void noTriangleTurnsOver();
};

void VolumeFitTest::fewTrianglesHoldTheVolume_data()
{
    QTest::addColumn<TopoDS_Shape>("shape");
    QTest::addColumn<double>("volume"); // [mm^3]
    QTest::newRow("cylinder") << BRepPrimAPI_MakeCylinder(3, 10).Shape() << pi * 90;
    QTest::newRow("cone") << BRepPrimAPI_MakeCone(5, 2, 10).Shape() << pi * 130;
    QTest::newRow("sphere") << BRepPrimAPI_MakeSphere(5).Shape() << 500 * pi / 3;
    QTest::newRow("torus") << BRepPrimAPI_MakeTorus(20, 4).Shape() << 2 * pi * pi * 320;
}

void VolumeFitTest::fewTrianglesHoldTheVolume()
{
    QFETCH(TopoDS_Shape, shape);
    QFETCH(double, volume);
    const TriangleMesh onFaces = tessellate(shape, coarse);
    const TriangleMesh fitted = fittedMesh(shape);
    QCOMPARE(fitted.triangles, onFaces.triangles);
    QVERIFY(isWatertight(fitted));
    const double before = 1e9 * massProperties(onFaces).volume / volume - 1;
    const double after = 1e9 * massProperties(fitted).volume / volume - 1;
    QVERIFY2(before < -5e-3, qPrintable(QString::number(before))); // else there is nothing to show
    QVERIFY2(std::abs(after) < 8e-4, qPrintable(QString::number(after)));
}

void VolumeFitTest::flatFacesStayWhereTheyAre()
{
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(3, 10).Shape();
    const TriangleMesh mesh = fittedMesh(cylinder);
    for (const Vec3& vertex : mesh.vertices)
        QVERIFY(std::min(std::abs(vertex.z()), std::abs(vertex.z() - 0.010)) < 1e-15);
}

/// The rounded edges of a box of 20 x 20 x 20 mm; their border has the normal of the flat faces.
void VolumeFitTest::flatFacesStayFlatWhereFilletsMeetThem()
{
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(20, 20, 20).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer edges(box, TopAbs_EDGE); edges.More(); edges.Next())
        fillet.Add(4, TopoDS::Edge(edges.Current()));
    const TriangleMesh onFaces = tessellate(fillet.Shape(), coarse);
    const TriangleMesh fitted = collectTriangles(fillet.Shape(), coarse, VertexPlace::volumeTrue);
    QVERIFY(massProperties(fitted).volume > massProperties(onFaces).volume);
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(fillet.Shape(), TopAbs_FACE, faces);
    int flatTriangles = 0;
    for (std::size_t t = 0; t < fitted.triangles.size(); ++t) {
        const BRepAdaptor_Surface surface(TopoDS::Face(faces(static_cast<int>(fitted.faceOfTriangle[t]) + 1)));
        if (surface.GetType() != GeomAbs_Plane)
            continue;
        ++flatTriangles;
        for (const std::uint32_t v : fitted.triangles[t]) {
            const Vec3 place = 1e3 * fitted.vertices[v];
            QVERIFY(surface.Plane().Distance({place.x(), place.y(), place.z()}) < 1e-9);
        }
    }
    QVERIFY(flatTriangles >= 12);
}

void VolumeFitTest::verticesStayWithinTheDeflection()
{
    const TriangleMesh mesh = fittedMesh(BRepPrimAPI_MakeTorus(20, 4).Shape());
    double farthest = 0;
    for (const Vec3& vertex : mesh.vertices)
        farthest = std::max(farthest, std::abs(std::hypot(vertex.head<2>().norm() - 0.020, vertex.z()) - 0.004));
    QVERIFY(farthest > 0);
    QVERIFY(farthest < coarse.deflection);
}

/// A pipe whose wall is thinner than its triangles are far from it.
void VolumeFitTest::noTriangleTurnsOver()
{
    const TopoDS_Shape pipe =
        BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(10, 5).Shape(), BRepPrimAPI_MakeCylinder(9.99, 5).Shape()).Shape();
    const TriangleMesh onFaces = tessellate(pipe, coarse);
    const TriangleMesh fitted = collectTriangles(pipe, coarse, VertexPlace::volumeTrue);
    QCOMPARE(fitted.triangles, onFaces.triangles);
    const auto cross = [](const TriangleMesh& mesh, const TriangleMesh::Triangle& t) -> Vec3 {
        return (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
    };
    for (const TriangleMesh::Triangle& t : fitted.triangles)
        QVERIFY(cross(fitted, t).dot(cross(onFaces, t)) > 0);
}

QTEST_GUILESS_MAIN(VolumeFitTest)
#include "volume_fit_test.moc"
